/* MCB: one motor behind one slave; STOP is the control word "shutdown". JOIN is the search for the length of frames. In
 * the config state a reset is not told. */
#define MOTORS 1
#define NEEDS_JOIN false
#define KNOWS_RESET false
#define SAYS_RESET false
#define BLIND true
#define START_FAULTS 0    /* reads go before a START; if they are lost it expires */
#define LOOKS_FIRST true   /* what is on already is not started */
#include "stop.pml"

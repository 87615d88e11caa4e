/* The older protocol: every frame stands alone, a board that was reset says so by itself, and a STOP goes out on any
 * line. JOIN is GET_BOARD_INFO, by which a recovery ends. */
#define MOTORS 2
#define NEEDS_JOIN false
#define KNOWS_RESET false
#define SAYS_RESET true
#define BLIND true
#define START_FAULTS 0    /* reads go before a START; if they are lost it expires */
#define LOOKS_FIRST false
#include "stop.pml"

/* MCP over ASPEP: a board that is not connected swallows requests, so a link has to be joined (BEACON, PING); the PING's
 * answer tells of a reset. Without a link STOPs are sent behind a BEACON and a PING without waiting for answers. */
#define MOTORS 2
#define NEEDS_JOIN true
#define KNOWS_RESET true
#define SAYS_RESET false
#define BLIND true
#define START_FAULTS FAULTS
#define LOOKS_FIRST false
#include "stop.pml"

// Drive for boards that speak MCP over ASPEP. It joins the link (aspep::Controller) with the pieces of work that want
// something of the board (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop of every motor > identification > heartbeat > state poll > wishes that act > wishes that read > watched registers
//
// After every connection: version, state of every motor, datalog stopped, the rest of the identification; only then
// anything else. No motion, no write and no acknowledgement is ever sent that a wish of this session did not ask for;
// the heartbeat of a drive with a watchdog moves nothing.
#pragma once

#include "drive/protocol_table.h"

#include <memory>

namespace drive {

std::unique_ptr<Drive> makeMcpDrive(const LineOptions &line, Search search = Search::No);

} // namespace drive

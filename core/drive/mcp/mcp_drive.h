// Drive for boards that speak MCP over ASPEP. It joins the link (aspep::Controller) with the pieces of work that want
// something of the board (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop of every motor > identification > heartbeat > state poll > wishes that act > wishes that read > watched registers
//
// After every connection: version, state of every motor, datalog stopped, the rest of the identification; only then
// anything else. No motion, no write and no acknowledgement is ever sent that a wish of this session did not ask for;
// the heartbeat of a drive with a watchdog moves nothing.
#pragma once

#include "drive/drive.h"

#include <memory>

namespace drive {

struct McpDriveConfig {
    std::uint32_t baud = 1843200;
    Duration payloadPause = std::chrono::microseconds(1500); ///< header to payload, on the wire
    bool hasty =
        false; ///< another protocol is tried next: into silence a second of Beacons is enough
    Duration patience{}; ///< added to the time-out of every reply
    Duration reconnectEvery =
        std::chrono::milliseconds(500); ///< after a lost link, until disconnect()
};

std::unique_ptr<Drive> makeMcpDrive(const McpDriveConfig &config);

} // namespace drive

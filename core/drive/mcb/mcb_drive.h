// Drive for servo drives that speak MCB on SPI. It joins the link (mcb::Master) with the pieces of work that want
// something of the drive (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop > identification > state poll > wishes that act > wishes that read > watched registers
//
// After every connection: which registers there are, who it is, what bounds it; only then anything else. No motion and no
// write is ever sent that a wish of this session did not ask for, but the return to the config state of a drive that is
// found cycling. Output is exchanges: as many bytes come in as go out, and handleReady() tells the ready line where there
// is one.
#pragma once

#include "drive/protocol_table.h"

#include <memory>

namespace drive {

std::unique_ptr<Drive> makeMcbDrive(const LineOptions &line, Search search = Search::No);

} // namespace drive

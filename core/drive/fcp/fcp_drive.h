// Drive for boards of the older serial protocol, in both its dialects. It joins the link (fcp::Client) with the pieces of
// work that want something of the board (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop of every motor > identification > state poll > wishes that act > wishes that read > watched registers
//
// After every connection the board is identified with reads alone; only then anything else. Every frame names its motor.
// Boards of this protocol send nothing by themselves: what is drawn is read over and over, as often as the line gives.
#pragma once

#include "drive/protocol_table.h"
#include "fcp/protocol.h"

#include <memory>
#include <optional>

namespace drive {

/// @param dialect  that the user chose; empty: found out
std::unique_ptr<Drive> makeFcpDrive(
    const LineOptions &line, std::optional<fcp::Dialect> dialect = {});

} // namespace drive

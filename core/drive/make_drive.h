// The drive for a line, by the protocol that is spoken on it.
#pragma once

#include "drive/drive.h"
#include "drive/protocol.h"

#include <memory>

namespace drive {

struct LineOptions {
    Protocol protocol = Protocol::Auto;
    std::uint32_t baud = 1843200; ///< of the open port; time-outs and stream sizes follow from it
    Duration patience{}; ///< added to the time-out of every reply
    /// Of Protocol::Auto: what was spoken there before, and is tried first.
    std::optional<Protocol> spoken{};
};

std::unique_ptr<Drive> makeDrive(const LineOptions &options);

} // namespace drive

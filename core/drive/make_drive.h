// The drive for a line, without naming its protocol: today every line speaks the same one.
#pragma once

#include "drive/drive.h"

#include <memory>

namespace drive {

/// @param baud  the speed the port is open at; time-outs and stream sizes follow from it
/// @param patience  what is added to the time-out of every reply
std::unique_ptr<Drive> makeDrive(std::uint32_t baud, Duration patience = {});

} // namespace drive

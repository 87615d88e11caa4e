// Pole pairs by a tachometer. A board without an encoder counts electrical turns, and tells the speed of a rotor of as
// many pole pairs as it believes in; what the shaft does besides says how many there are. Pure.
#pragma once

#include "base/result.h"
#include "drive/event.h"

#include <string>

namespace lab {

struct PolePairs {
    int count = 0;
    double measured = 0.0; ///< near it
};

/// @param status  of a motor that runs at a constant speed
/// @param tachometer_rpm  what the shaft does meanwhile, whichever way
/// @return  or why they do not follow, in a sentence without a full stop
Result<PolePairs, std::string> polePairsBy(
    const drive::Identified &board, const drive::MotorStatus &status, double tachometer_rpm);

} // namespace lab

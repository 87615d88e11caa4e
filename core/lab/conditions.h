// What the runner has to know of any plan: where the motor is brought first, which speeds the plan itself asks for, what the
// user allows, and what is recorded.
#pragma once

#include "drive/wish.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace lab {

using std::chrono::milliseconds;

struct Conditions {
    int firstRpm = 0; ///< signed
    milliseconds approach{500}; ///< the ramp there, and the way back
    double leastRpm = 0.0, mostRpm = 0.0; ///< that are asked for
    double margin_rpm = 0.0; ///< that the speed may go beyond
    drive::UserLimits user; ///< the user's caps; 0: what the board tells
    std::vector<drive::RegisterId> recorded; ///< to be recorded
    milliseconds length{}; ///< of its course
    /// As `approach`, where it brakes and nothing says that the bus takes what comes back.
    milliseconds gently() const { return std::max(approach, milliseconds(3000)); }
};

} // namespace lab

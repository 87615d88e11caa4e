// What the runner has to know of any plan: where the motor is brought first, which speeds the plan itself asks for, what the
// user allows, what is recorded, and which registers it borrows.
#pragma once

#include "lab/course.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

namespace lab {

using std::chrono::milliseconds;

/// What the motor does when the course begins.
enum class Beginning : std::uint8_t {
    AtSpeed, ///< it turns at the first speed
    AtRest, ///< driven, without any current asked for; it stood before
    WhileStarting, ///< in its start-up, which the course ends; it stood before
};

struct Conditions {
    Beginning beginning = Beginning::AtSpeed;
    int firstRpm = 0; ///< signed
    milliseconds approach{500}; ///< the ramp there, and the way back
    double leastRpm = 0.0, mostRpm = 0.0; ///< that are asked for
    double margin_rpm = 0.0; ///< that the speed may go beyond
    drive::UserLimits user; ///< the user's caps; 0: what the board tells
    std::vector<drive::RegisterId> recorded; ///< to be recorded
    milliseconds length{}; ///< of its course
    /// Written before the motor is started, while it rests; afterwards they are what they were.
    std::vector<drive::RegisterWrite> lent = {};
    /// References of a motor that turns which are 0 before, because they are afterwards.
    std::vector<drive::RegisterId> zeroBefore = {};
    /// As `approach`, where it brakes and nothing says that the bus takes what comes back.
    milliseconds gently() const { return std::max(approach, milliseconds(3000)); }
};

} // namespace lab

// What an experiment asks of a motor, and what the runner has to know before: where the motor is brought first, which
// speeds the plan itself asks for, what the user allows, what is recorded, and which registers it borrows. A machine
// without I/O or bounds, which are the runner's.
#pragma once

#include "drive/wish.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lab {

using std::chrono::milliseconds;

/// What the motor does when the course begins.
enum class Beginning : std::uint8_t {
    AtSpeed, ///< it turns at the first speed
    AtRest, ///< driven, without any current asked for; it stood before
    WhileStarting, ///< in its start-up, which the course ends; it stood before
};

/// A speed that has not come to rest so long after its ramp swings: a course that needs no more begins then.
inline constexpr Duration kSwingsAfter = std::chrono::milliseconds(3750);

/// The ramp to the first speed, and the way back.
inline constexpr milliseconds kApproach{500};

struct Conditions {
    Beginning beginning = Beginning::AtSpeed;
    int firstRpm = 0; ///< signed
    milliseconds approach = kApproach; ///< the ramp there, and the way back
    double leastRpm = 0.0, mostRpm = 0.0; ///< that are asked for
    double margin_rpm = 0.0; ///< that the speed may go beyond
    double undershoot_rpm = 0.0; ///< so far below the lower of them it goes at least
    drive::UserLimits user; ///< the user's caps; 0: what the board tells
    std::vector<drive::RegisterId> recorded; ///< to be recorded
    milliseconds length{}; ///< of its course
    /// Written before the motor is started, while it rests; afterwards they are what they were.
    std::vector<drive::RegisterWrite> lent = {};
    /// References of a motor that turns which are 0 before, because they are afterwards.
    std::vector<drive::RegisterId> zeroBefore = {};
    /// Its set-points are to leave with every exchange of the line, which can begin while the motor rests.
    bool travels = false;
    /// The speed has to rest there first. Without it a course begins as well where the speed loop makes the speed
    /// swing.
    bool steady = true;
    /// As `approach`, where it brakes and nothing says that the bus takes what comes back.
    milliseconds gently() const { return std::max(approach, milliseconds(3000)); }
};

/// What can be asked of a drive, without who asked.
using Ask = decltype(drive::Wish::what);

class Course {
public:
    struct Moment {
        TimePoint now;
        /// Newest speed, and Iq over the newest packet; where the speed swung when the course began, its mean until
        /// then.
        std::optional<double> rpm, amps;
        bool answered = true; ///< what was asked for last
        std::optional<double> position_rad = {}; ///< of the shaft, as it was read last
        /// How far the bus has gone from what it was to its bound, by a reading since that answer.
        std::optional<double> busRise = {};
    };

    Course() = default;
    Course(const Course &) = delete;
    Course &operator=(const Course &) = delete;
    virtual ~Course() = default;

    /// Looked at with every packet of samples, every answer, and when due() is there.
    /// @return  what is to be asked now, a speed or a torque; nothing: it waits
    virtual std::optional<Ask> next(const Moment &moment) = 0;
    virtual TimePoint due() const = 0;
    virtual bool over() const = 0;
    /// Why it is over although it could not be carried out, without a full stop; empty: it could.
    virtual std::string problem() const { return {}; }
};

} // namespace lab

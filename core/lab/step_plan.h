// What a series of speed steps is to do, and the few facts of the board that it takes: plain values. The plan is written
// into the recording of a series, so that the file alone says what was wanted.
//
// Order of a series: the motor is brought to `from` (started if it stood), then `repeat` times stepped to `to` and back,
// each speed held for `hold`; then it is as it was before: at its old set-point, or stopped.
#pragma once

#include "base/result.h"
#include "drive/event.h"
#include "record/entry.h"

#include <chrono>
#include <string>

namespace lab {

using std::chrono::milliseconds;

struct StepPlan {
    int motor = 1;
    int fromRpm = 0, toRpm = 0; ///< mechanical, signed
    int repeat = 1; ///< steps up and as many down
    milliseconds hold{500}; ///< of each speed
    milliseconds approach{500}; ///< the ramp to `from`, and the way back
    double maxRpm = 0.0, maxAmps = 0.0; ///< the user's caps; 0: what the board tells
    bool operator==(const StepPlan &) const = default;
};

/// Registers of the motor that a series needs. 0: the board has none.
struct StepRegisters {
    drive::RegisterId reference = 0, current = 0; ///< Iq, wanted and measured
    drive::RegisterId speed = 0, angle = 0; ///< of the main sensor
    drive::RegisterId bus = 0, temperature = 0; ///< polled
};

/// What is known of the board before anything moves.
struct StepBoard {
    StepRegisters registers;
    std::shared_ptr<const catalog::Catalog> catalog;
    drive::MotorLimits limits; ///< of the motor
    std::vector<drive::RegisterId> setPoint; ///< drive::startRegisters()
    drive::RegisterId gain = 0, gainExponent = 0; ///< of the speed loop's proportional part
    double tickHz = 0.0, linkBytesPerSecond = 0.0;

    /// One sample every so many control periods, so that this many signals take no more than a share of the link.
    unsigned fastEvery(std::size_t signalCount, double share) const;
};

/// A plan and where it is to be carried out.
struct StepExperiment {
    StepPlan plan;
    StepBoard board;
};

/// The whole time that a plan takes at most, the start of the motor left out.
milliseconds lengthOf(const StepPlan &plan);

/// Why the plan cannot be carried out as it stands, in a sentence; empty if it can.
std::string objectionTo(const StepPlan &plan, const drive::MotorLimits &limits);

/// The registers of this motor; or why no steps can be measured with this board, in a sentence.
Result<StepBoard, std::string> stepBoardOf(const drive::Identified &board, int motor);

/// What the speed loop adds to the reference of Iq at once for each rpm of a step: A/rpm. 0: not known.
/// @param gain, exponent  numbers of the registers above, as read
double jumpPerRpm(const StepBoard &board, double gain, double exponent);

/// The plan as an entry of a recording, and back; empty for any other entry, or one that is no plan.
record::Happening entryOf(const StepExperiment &experiment, double jumpPerRpm);
struct RecordedPlan {
    StepPlan plan;
    std::string reference, current, speed, angle; ///< names of signals; empty: none
    double polePairs = 0.0, speedStepRpm = 0.0;
    double jumpPerRpm = 0.0; ///< A/rpm; 0: not known
};
std::optional<RecordedPlan> recordedPlan(const record::Happening &happening);

} // namespace lab

// An experiment: a plan of any kind and the motor that it is for; and how it ended. Plain values, which may cross
// threads.
#pragma once

#include "base/time.h"
#include "lab/course.h"
#include "lab/current_step_plan.h"
#include "lab/load_plan.h"
#include "lab/position_plan.h"
#include "lab/power_plan.h"
#include "lab/response_plan.h"
#include "lab/rest_plan.h"
#include "lab/spin_plan.h"
#include "lab/step_plan.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lab {

using Plan = std::variant<StepPlan, SpinPlan, ResponsePlan, RestPlan, CurrentStepPlan, PowerPlan,
    LoadPlan, PositionPlan>;

struct Experiment {
    Plan plan;
    Subject subject;
};

/// Why it cannot be carried out as it stands, in a sentence without a full stop; empty if it can.
std::string objectionTo(const Experiment &experiment);
/// Why it does not begin with a motor that turns; empty: it may.
/// @param before_rpm  its set-point
std::string objectionWhileTurning(const Experiment &experiment, double before_rpm);
/// Some turn it forwards, others backwards: each begins at rest.
bool inBothDirections(const std::vector<Experiment> &all);
Conditions conditionsOf(const Experiment &experiment);
/// The whole time that it takes at most, the start of the motor left out.
milliseconds lengthOf(const Experiment &experiment);
std::unique_ptr<Course> courseOf(const Experiment &experiment);
/// What the board is to record, or to send with each exchange; nothing where it does neither.
drive::Stream streamOf(const Experiment &experiment);
/// What is read meanwhile: bus and temperature, and where nothing is streamed the signals.
drive::Watch watchOf(const Experiment &experiment);

/// The plan as an entry of its recording. @param regulator  that closes the speed loop; its gains are 0 if not known
recorded::Happening entryOf(const Experiment &experiment, const SpeedRegulator &regulator);

/// How it ended.
enum class End : std::uint8_t {
    Complete,
    Refused, ///< the board or the drive did not do what was asked; nothing is left moving that stood before
    Aborted, ///< the envelope was broken, or the board reported a fault
    Interrupted, ///< it was stopped, disarmed or taken over; or several in a row did not go on
    Lost, ///< the link or the port went
};

/// The speed reference of a motor that rests as before: its board goes on showing the last one that was in force, until
/// the next start. That goes where it went before.
struct ShownReference {
    std::string name; ///< of the register
    double before_rpm = 0.0, now_rpm = 0.0;
    bool operator==(const ShownReference &) const = default;
};

struct Outcome {
    End end = End::Complete;
    /// Why it ended, and what is not as it was before; without a full stop. Empty: nothing to say.
    std::string reason;
    TimePoint at{}; ///< when it ended; the session says it
    bool swings = false; ///< it ended before it began: the speed did not come to rest
    bool leaves = false; ///< something is not as it was before, or may not be
    std::optional<ShownReference> shows = {}; ///< empty: not known, or `reason` says more
    bool operator==(const Outcome &) const = default;
};

/// Several in a row, when one more is over: with what is to be said of those before it. They go on only where all came
/// to their end and nothing is left on the board, because the next one would begin with that.
/// @param before  how it stood until then  @param more  there is a next one
Outcome inRow(const Outcome &before, const Outcome &last, bool more);
/// One more thing that is to be said of its end.
void addReason(Outcome &outcome, const std::string &reason);
/// What shows another value than before, without a full stop; empty: nothing.
std::string shownText(const Outcome &outcome);

/// The same as an entry of its recording.
recorded::Happening entryOfEnd(const Outcome &outcome);
inline constexpr const char *kEndEntry = "experiment ended";

} // namespace lab

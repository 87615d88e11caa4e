// What happened while an experiment was recorded, its signals, and when it drove the motor, as a recording has them.
// Fields are read as what they should be: files are foreign.
#pragma once

#include "base/text.h"
#include "capture/capture.h"
#include "recorded/entry.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lab {

using capture::Nanos;

/// By their time.
using Happenings = std::vector<std::pair<Nanos, recorded::Happening>>;

/// A finite number of a magnitude below 1e9; empty if it is anything else.
std::optional<double> numberOf(const recorded::Happening &happening, std::string_view key);

/// Nothing reached the board any more. One that is out of step for a moment goes on with what it was told.
bool endsLink(const recorded::Happening &what);

/// Without what was asked for and not sent, or refused: it moved nothing, whether or not it was asked for again.
Happenings carriedOut(const Happenings &all);

/// The signal of this name that was recorded at the control rate; nullptr: none, or the name is empty.
const capture::Channel *fastChannel(const capture::Capture &capture, const std::string &name);
/// The same of values that were read one after the other, or came with each exchange. The same register has another
/// channel in another unit: before a current's scale was told it is in digits.
const capture::Channel *polledChannel(
    const capture::Capture &capture, const std::string &name, std::string_view unit);

/// When a motor was driven in an experiment: from the first act that drives it so to whatever came then.
struct DrivenSpan {
    Nanos from = 0, to = 0;
    bool over = false; ///< the recording has the experiment's end
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
};

/// A torque, or a current.
bool drivesByTorque(const recorded::Happening &what);

/// A speed at once, as steps are, and one that is held.
bool setsSpeedAtOnce(const recorded::Happening &what);

/// @param at  behind the plan's entry
/// @param last  when nothing says that it ended
/// @param drives  whether an act does
/// @return  empty if it was never driven so
std::optional<DrivenSpan> drivenSpan(int motor, Happenings::const_iterator at,
    Happenings::const_iterator end, Nanos last,
    const std::function<bool(const recorded::Happening &)> &drives = drivesByTorque);

/// Says of what was measured that the experiment ended early, or the recording before it.
/// @param over, reason  as of a DrivenSpan
void noteEnd(std::vector<std::string> &notes, bool over, const std::string &reason);

} // namespace lab

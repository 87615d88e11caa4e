// The speed loop of a board in the units of experiments: what its registers hold, what a digit of them is worth, how
// gains are written into them, and by which steps they are proved. The command line and the window take all of it from
// here.
#pragma once

#include "drive/wish.h"
#include "lab/evaluation/tuning.h"

#include <functional>
#include <optional>

namespace lab {

struct SpeedLoop {
    int proportional = 0, integral = 0; ///< digits, as the board holds them
    GainDigits digits;
    SpeedRegulator regulator; ///< the same in A/rpm
};

/// The number that a register holds; empty: not known.
using Numbers = std::function<std::optional<double>(drive::RegisterId)>;

/// The registers that tell it; empty: the board has no such gains.
std::vector<drive::RegisterId> gainRegisters(const Subject &subject);
/// @param period_s  of the loop; 0: not known, the usual one
/// @return  empty: not all of them are known
std::optional<SpeedLoop> speedLoopOf(
    const Subject &subject, const Numbers &numbers, double period_s);

/// With other gains.
SpeedLoop withGains(SpeedLoop loop, int proportional, int integral);

/// The same response with a quarter of the gains, of its own or else of the board's: a loop that swings by itself tells
/// nothing.
/// @return  empty: they are as small as they get
std::optional<ResponsePlan> calmer(ResponsePlan plan, const SpeedLoop &loop);

/// Both gains as one write.
std::vector<drive::RegisterWrite> gainWrites(
    const Subject &subject, int proportional, int integral);

/// Steps that prove gains: around where the response is measured, and small, so that no limit of the current is in
/// them.
StepPlan proofStepsFor(const Subject &subject, const drive::UserLimits &caps);

} // namespace lab

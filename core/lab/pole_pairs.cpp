#include "lab/pole_pairs.h"

#include "base/text.h"
#include "lab/subject.h"

#include <cmath>

namespace lab {

Result<PolePairs, std::string> polePairsBy(
    const drive::Identified &board, const drive::MotorStatus &status, double tachometer_rpm)
{
    constexpr double kMostPairs = 100.0, kWhole = 0.2; // of a pair: 1 % of twenty
    const auto at = static_cast<std::size_t>(status.motor - 1);
    const double believed = at < board.limits.size() ? board.limits[at].polePairs : 0.0;
    if (!(believed > 0.0))
        return fail(std::string("this board does not tell which pole pairs it counts by"));
    if (at < board.identity.speedSignals.size() && byEncoder(board.identity.speedSignals[at]))
        return fail(std::string("an encoder tells this board the turns of its rotor, which say "
                                "nothing of pole pairs"));
    const double told_rpm = std::abs(status.speedRpm.value_or(0.0));
    if (status.state != drive::MotorState::Running || !(told_rpm > 0.0))
        return fail(std::string("the motor does not turn: let it run at a constant speed"));
    const double measured = believed * told_rpm / std::abs(tachometer_rpm);
    const double count = std::round(measured);
    if (!(count >= 1.0 && count <= kMostPairs && std::abs(measured - count) <= kWhole))
        return fail(decimalText(told_rpm, 4) + " rpm of the board, which counts by "
            + decimalText(believed, 3) + " pole pairs, and " + decimalText(tachometer_rpm, 4)
            + " rpm of the shaft make " + decimalText(measured, 3)
            + ", which is no whole number: read both again, at a constant speed");
    return PolePairs{static_cast<int>(count), measured};
}

} // namespace lab

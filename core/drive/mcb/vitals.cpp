#include "drive/mcb/vitals.h"

#include "base/text.h"
#include "drive/mcb/identification.h"

namespace drive {

std::vector<RegisterId> McbVitals::idsToRead()
{
    m_errorAsked = false;
    std::vector<RegisterId> ids{mcbIdOf(mcbreg::kStatus)};
    if (m_board.readable(mcbreg::kVelocityNow))
        ids.push_back(mcbIdOf(mcbreg::kVelocityNow));
    return ids;
}

std::vector<RegisterId> McbVitals::idsBehind()
{
    const auto word = numberOf(mcbIdOf(mcbreg::kStatus));
    const bool fault = word && hasFault(mcbStateOf(static_cast<std::uint16_t>(*word)).state)
        && m_board.readable(mcbreg::kLastError);
    return fault && !std::exchange(m_errorAsked, true) ? std::vector{mcbIdOf(mcbreg::kLastError)}
                                                       : std::vector<RegisterId>();
}

std::optional<MotorStatus> McbVitals::statusOf(int) const
{
    const auto word = numberOf(mcbIdOf(mcbreg::kStatus));
    if (!word)
        return std::nullopt;
    const McbState state = mcbStateOf(static_cast<std::uint16_t>(*word));
    MotorStatus status;
    status.state = state.state;
    status.rawState = state.bits;
    status.stateName = state.name;
    if (const auto velocity = numberOf(mcbIdOf(mcbreg::kVelocityNow))) {
        status.speedRpm = *velocity * kSecondsPerMinute;
        // These drives have no observer: it is the speed of their encoder.
        status.speedMeasured = true;
    }
    if (hasFault(state.state)) {
        const auto code =
            static_cast<std::int32_t>(numberOf(mcbIdOf(mcbreg::kLastError)).value_or(0.0));
        const std::string fault = "ERROR_0x" + hexDigits(static_cast<std::uint32_t>(code), 8);
        (state.state == MotorState::FaultNow ? status.faultsNow : status.faultsPast) = {fault};
    }
    return status;
}

} // namespace drive

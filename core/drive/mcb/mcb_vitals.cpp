#include "drive/mcb/mcb_vitals.h"

#include "drive/mcb/mcb_catalog.h"
#include "drive/mcb/mcb_identification.h"
#include "drive/mcb/mcb_messages.h"
#include "drive/values.h"

#include <algorithm>

namespace drive {

namespace {

constexpr double kSecondsPerMinute = 60.0;
constexpr int kErrorDigits = 8;

bool isFault(MotorState state)
{
    return state == MotorState::FaultNow || state == MotorState::FaultOver;
}

} // namespace

void McbVitals::restart(TimePoint now)
{
    m_reader.clear();
    m_round.clear();
    m_news.clear();
    m_due = now;
    m_fastUntil = now;
    m_errorAsked = m_moving = false;
}

void McbVitals::hurry(TimePoint now)
{
    m_fastUntil = now + kHurry;
    if (m_due)
        m_due = now;
}

std::optional<McbRequest> McbVitals::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        if (!m_due || now < *m_due)
            return std::nullopt;
        m_round.clear();
        m_errorAsked = false;
        std::vector<RegisterId> ids{mcbIdOf(mcbreg::kStatus)};
        if (m_board.readable(mcbreg::kVelocityNow))
            ids.push_back(mcbIdOf(mcbreg::kVelocityNow));
        m_reader.start(ids);
        m_roundAsked = now;
    }
    return m_reader.nextRequest();
}

void McbVitals::takeResponse(const McbAnswer &answer, TimePoint now)
{
    if (m_reader.finished())
        return; // begun anew while it was asked
    Reading reading = m_reader.takeResponse(answer, m_board, now);
    if (reading.status == ReadStatus::Ok)
        m_round[reading.id] = std::move(reading.value);
    afterAnswer(now);
}

void McbVitals::takeNoResponse(std::optional<bool>, TimePoint now)
{
    if (m_reader.finished())
        return;
    m_reader.takeNoResponse();
    afterAnswer(now);
}

void McbVitals::afterAnswer(TimePoint now)
{
    if (!m_reader.finished())
        return;
    const auto status = m_round.find(mcbIdOf(mcbreg::kStatus));
    const auto *word =
        status != m_round.end() ? std::get_if<std::int64_t>(&status->second) : nullptr;
    if (word != nullptr && isFault(mcbStateOf(static_cast<std::uint16_t>(*word)).state)
        && m_board.readable(mcbreg::kLastError) && !std::exchange(m_errorAsked, true))
        return m_reader.start({mcbIdOf(mcbreg::kLastError)});
    publish(now);
}

void McbVitals::publish(TimePoint now)
{
    const auto find = [this](std::uint16_t address) {
        const auto at = m_round.find(mcbIdOf(address));
        return at == m_round.end() ? std::optional<double>() : asNumber(at->second);
    };
    if (const auto word = find(mcbreg::kStatus)) {
        const McbState state = mcbStateOf(static_cast<std::uint16_t>(*word));
        MotorStatus status;
        status.at = now;
        status.state = state.state;
        status.rawState = state.bits;
        status.stateName = state.name;
        if (const auto velocity = find(mcbreg::kVelocityNow)) {
            status.speedRpm = *velocity * kSecondsPerMinute;
            // These drives have no observer: it is the speed of their encoder.
            status.speedMeasured = true;
        }
        if (isFault(state.state)) {
            const auto code = static_cast<std::int32_t>(find(mcbreg::kLastError).value_or(0.0));
            const std::string fault =
                "ERROR_" + hexText(static_cast<std::uint32_t>(code), kErrorDigits);
            (state.state == MotorState::FaultNow ? status.faultsNow : status.faultsPast) = {fault};
        }
        m_moving = state.state == MotorState::Starting || state.state == MotorState::Stopping;
        m_askedAt = m_roundAsked;
        m_news.push_back(std::move(status));
    }
    const Duration period = m_moving || now < m_fastUntil ? kFastPeriod : kPeriod;
    m_due = std::max(m_roundAsked + period, now + (now - m_roundAsked));
}

} // namespace drive

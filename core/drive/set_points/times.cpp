#include "drive/set_points/times.h"

#include "drive/set_point_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drive {

namespace {

constexpr std::size_t kMostWished = 1000;
constexpr double kUnderWay_s = 0.1; ///< that samples may take from a board to here
constexpr double kLeap_s = 1.0; ///< of what one sample tells and the next
constexpr double kStretch_s = 1.0; ///< clocks drift apart by some 0.1 ms in it, at worst
constexpr double kFrame = 12.0; ///< bytes of a packet beside its samples
constexpr double kFastBytes = 2.0, kSlowBytes = 4.0;

} // namespace

void SampleAxis::heard(double arrived_s, double sampled_s)
{
    const double late = arrived_s - sampled_s;
    if (!std::isfinite(late))
        return;
    // The clock here leapt, or its reader stood still and hears the next ones in time.
    if (std::abs(late - std::exchange(m_late, late)) > kLeap_s)
        m_least = m_before = std::nullopt;
    if (!m_least || arrived_s - m_since > kStretch_s) {
        m_before = m_least;
        m_least = late;
        m_since = arrived_s;
    }
    m_least = std::min(*m_least, late);
}

double SampleAxis::of(double seconds) const
{
    const double ahead = ahead_s();
    return m_before && std::abs(ahead) > kUnderWay_s ? seconds + ahead : seconds;
}

double SampleAxis::ahead_s() const
{
    return m_least ? -std::min(*m_least, m_before.value_or(*m_least)) : 0.0;
}

void SetPointTimes::onWish(const Wish &wish)
{
    using Kind = SentSetPoint::Kind;
    std::optional<SetPointNews> wished;
    if (const auto wanted = setPointOf(wish.what)) {
        const bool speed = wanted->feature == Feature::SpeedRamp;
        wished = SentSetPoint{.kind = speed ? Kind::Speed : Kind::Current,
            .motor = wanted->motor,
            .value = wanted->first,
            .ramp = wanted->duration};
    } else if (const auto *position = std::get_if<PositionRamp>(&wish.what)) {
        wished = SentSetPoint{.kind = Kind::Position,
            .motor = position->motor,
            .value = position->radians,
            .ramp = position->duration};
    } else if (const auto *command = std::get_if<Command>(&wish.what)) {
        const bool ramp = command->action == MotorAction::StopRamp;
        if (command->action == MotorAction::Start)
            m_motors[command->motor].state = MotorState::Unknown; // until it is read again
        else if (ramp || command->action == MotorAction::StopMotor)
            wished = SetPointsEnd{.motor = command->motor, .held = ramp};
    } else if (const auto *write = std::get_if<Write>(&wish.what)) {
        const bool kept = std::ranges::all_of(write->writes, [&](const auto &one) {
            const auto *info = m_catalog ? m_catalog->find(one.id) : nullptr;
            return info != nullptr && info->effect == catalog::Effect::Kept;
        });
        if (!kept)
            wished = SetPointsEnd{};
    }
    if (!wished || m_wished.size() >= kMostWished)
        return;
    std::visit([&](auto &news) { news.wish = wish.id; }, *wished);
    m_wished.insert_or_assign(wish.id, *wished);
}

std::optional<SetPointNews> SetPointTimes::onEvent(const Event &event, TimePoint now)
{
    if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
        heard(*block, now);
    } else if (const auto *board = std::get_if<Identified>(&event)) {
        m_bytesPerSecond = board->streaming.linkBytesPerSecond;
        m_catalog = board->catalog;
    } else if (const auto *started = std::get_if<StreamStarted>(&event)) {
        if (started->layout.originSeconds != m_layout.originSeconds)
            m_axis.forget();
        m_layout = started->layout;
    } else if (const auto *outcome = std::get_if<Ended>(&event)) {
        return ended(*outcome, now);
    } else if (const auto *told = std::get_if<MotorStatus>(&event)) {
        return status(*told);
    } else if (const auto *link = std::get_if<LinkChanged>(&event)) {
        if (link->state != LinkState::Lost && link->state != LinkState::Closed
            && link->reason != LinkReason::BoardReset)
            return std::nullopt;
        m_motors.clear();
        return endAt(0, link->state == LinkState::Connected ? now : m_received);
    }
    return std::nullopt;
}

std::optional<SetPointNews> SetPointTimes::ended(const Ended &ended, TimePoint now)
{
    auto wished = m_wished.extract(ended.id);
    if (wished.empty() || ended.outcome == Outcome::NotSent)
        return std::nullopt;
    const bool sure = ended.outcome == Outcome::Ok;
    const TimePoint left = sure ? m_sentBefore : m_sent;
    SetPointNews news = wished.mapped();
    if (auto *sent = std::get_if<SentSetPoint>(&news)) {
        if (ended.outcome == Outcome::Refused)
            return std::nullopt;
        const auto motor = m_motors.find(sent->motor);
        sent->sure = sure;
        sent->runs = motor == m_motors.end() || motor->second.state == MotorState::Running
            || motor->second.state == MotorState::Unknown;
        sent->ahead_s = m_axis.ahead_s();
        sent->seconds = onAxis(left);
        sent->within_s = toSeconds(now - left);
        return news;
    }
    auto &end = std::get<SetPointsEnd>(news);
    const bool write = end.motor == 0; // of several registers: a part of them may be there
    if (ended.outcome == Outcome::Refused && !write)
        return std::nullopt;
    end.held = end.held && sure;
    end.seconds = onAxis(left);
    end.within_s = toSeconds(now - left);
    return news;
}

/// A motor that was driven and is not follows nothing; since when, the readings tell.
std::optional<SetPointNews> SetPointTimes::status(const MotorStatus &status)
{
    const auto driven = [](MotorState state) {
        return state == MotorState::Unknown || state == MotorState::Starting
            || state == MotorState::Running;
    };
    Motor &motor = m_motors[status.motor];
    const bool ends = driven(motor.state) && !driven(status.state);
    motor.state = status.state;
    const TimePoint asked = status.asked != TimePoint{} ? status.asked : status.at;
    const TimePoint last =
        std::exchange(motor.drivenAt, driven(status.state) ? asked : TimePoint{});
    if (!ends || last == TimePoint{})
        return std::nullopt;
    return endAt(status.motor, last);
}

void SetPointTimes::heard(const capture::SampleBlock &block, TimePoint now)
{
    // Where a tick only measures time, it is that of the clock here.
    if (block.stream != m_layout.id || !m_layout.ticksAreControlPeriods || block.count == 0
        || !(m_layout.tickHz > 0.0) || !(m_bytesPerSecond > 0.0))
        return;
    double bytes = kFrame + kFastBytes * static_cast<double>(block.fast.size());
    for (const capture::SlowGroup &group : block.slow)
        bytes += kSlowBytes * static_cast<double>(group.values.size());
    const double end = static_cast<double>(block.firstTick)
        + static_cast<double>(block.count) * static_cast<double>(m_layout.fastStep);
    m_axis.heard(toSeconds(now.time_since_epoch()) - bytes / m_bytesPerSecond,
        m_layout.originSeconds + end / m_layout.tickHz);
}

} // namespace drive

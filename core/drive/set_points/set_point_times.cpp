#include "drive/set_points/set_point_times.h"

#include "base/overloaded.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

constexpr std::size_t kMostWished = 1000;
constexpr double kStretch_s = 1.0; ///< clocks drift apart by some 0.1 ms in it, at worst
constexpr double kFrame = 12.0; ///< bytes of a packet beside its samples
constexpr double kFastBytes = 2.0, kSlowBytes = 4.0;

} // namespace

void SampleAxis::heard(double arrived_s, double sampled_s)
{
    const double late = arrived_s - sampled_s;
    if (!std::isfinite(late))
        return;
    if (!m_least || arrived_s - m_since > kStretch_s) {
        m_before = m_least;
        m_least = late;
        m_since = arrived_s;
    }
    m_least = std::min(*m_least, late);
}

double SampleAxis::ahead_s() const
{
    return m_least ? -std::min(*m_least, m_before.value_or(*m_least)) : 0.0;
}

void SetPointTimes::onWish(const Wish &wish)
{
    using Kind = SentSetPoint::Kind;
    SentSetPoint wished;
    wished.wish = wish.id;
    const bool known = std::visit(Overloaded{
                                      [&](const SpeedRamp &ramp) {
                                          wished.motor = ramp.motor;
                                          wished.value = ramp.rpm;
                                          wished.ramp = ramp.duration;
                                          return true;
                                      },
                                      [&](const TorqueRamp &ramp) {
                                          wished.kind = Kind::Current;
                                          wished.motor = ramp.motor;
                                          wished.value = ramp.amps;
                                          wished.ramp = ramp.duration;
                                          return true;
                                      },
                                      [&](const CurrentReference &reference) {
                                          wished.kind = Kind::Current;
                                          wished.motor = reference.motor;
                                          wished.value = reference.iqAmps;
                                          return true;
                                      },
                                      [&](const PositionRamp &ramp) {
                                          wished.kind = Kind::Position;
                                          wished.motor = ramp.motor;
                                          wished.value = ramp.radians;
                                          wished.ramp = ramp.duration;
                                          return true;
                                      },
                                      [](const auto &) { return false; },
                                  },
        wish.what);
    if (known && m_wished.size() < kMostWished)
        m_wished[wish.id] = wished;
}

std::optional<SentSetPoint> SetPointTimes::onEvent(const Event &event, TimePoint now)
{
    if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
        heard(*block, now);
    } else if (const auto *board = std::get_if<Identified>(&event)) {
        m_bytesPerSecond = board->streaming.linkBytesPerSecond;
    } else if (const auto *started = std::get_if<StreamStarted>(&event)) {
        if (started->layout.originSeconds != m_layout.originSeconds)
            m_axis.forget();
        m_layout = started->layout;
    } else if (const auto *ended = std::get_if<Ended>(&event)) {
        auto wished = m_wished.extract(ended->id);
        const bool there = ended->outcome == Outcome::Ok || ended->outcome == Outcome::Unknown;
        if (wished.empty() || !there)
            return std::nullopt;
        SentSetPoint sent = wished.mapped();
        const TimePoint left = ended->outcome == Outcome::Ok ? m_sentBefore : m_sent;
        sent.ahead_s = m_axis.ahead_s();
        sent.seconds = toSeconds(left.time_since_epoch()) + sent.ahead_s;
        sent.within_s = toSeconds(now - left);
        return sent;
    }
    return std::nullopt;
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

// The path has no corners: neither speed nor acceleration jump at its ends.
#include "simulation/firmware/position_control.h"

#include "simulation/maths/fixed_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr std::int64_t kReached = 65536 / 360; ///< a degree
constexpr double kFarthest_rad = 1e6;

int shiftOf(std::int16_t exponent) { return std::clamp<int>(exponent, 0, 31); }

} // namespace

PositionControl::Digits PositionControl::digitsOf(double rad)
{
    const double cut = std::isfinite(rad) ? std::clamp(rad, -kFarthest_rad, kFarthest_rad) : 0.0;
    return std::llround(cut * 65536.0 / (2.0 * std::numbers::pi));
}

void PositionControl::move(Digits now, Digits target, int ticks)
{
    m_from = m_state == State::Ready ? now : reference();
    m_target = target;
    m_ticks = std::max(ticks, 0);
    m_done = 0;
    m_state = m_ticks == 0 ? State::Following : State::Moving;
}

PositionControl::Digits PositionControl::reference() const
{
    if (m_done >= m_ticks)
        return m_target;
    const double t = static_cast<double>(m_done) / m_ticks;
    const double share = t * t * t * (10.0 - t * (15.0 - 6.0 * t));
    return m_from + std::llround(static_cast<double>(m_target - m_from) * share);
}

std::int16_t PositionControl::step(Digits now, std::int32_t limit, const Tuning &t)
{
    if (m_state == State::Ready) {
        m_from = m_target = now;
        return 0;
    }
    m_done = std::min(m_done + 1, m_ticks);
    const std::int64_t error = std::clamp<std::int64_t>(reference() - now, -32767, 32767);
    if (m_state == State::Moving && m_done == m_ticks && std::abs(error) < kReached)
        m_state = State::Reached;
    const std::int64_t most = std::int64_t{limit} << shiftOf(t.positionKiDiv);
    m_integral = t.positionKi == 0
        ? 0
        : std::clamp<std::int64_t>(m_integral + t.positionKi * error, -most, most);
    const std::int64_t proportional = (t.positionKp * error) >> shiftOf(t.positionKpDiv);
    const std::int64_t derivative =
        (t.positionKd * (error - m_lastError)) >> shiftOf(t.positionKdDiv);
    m_lastError = error;
    const std::int64_t sum = proportional + (m_integral >> shiftOf(t.positionKiDiv)) + derivative;
    return saturate16(std::clamp<std::int64_t>(sum, -limit, limit));
}

} // namespace simulation

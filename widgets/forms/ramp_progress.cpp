#include "widgets/forms/ramp_progress.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kNear = 0.02; ///< of the target: the motor counts as arrived
constexpr Milliseconds kReadingAge{400}; ///< how late a polled set-point may be

} // namespace

void RampProgress::begin(
    double target, Milliseconds duration, double step, Milliseconds now, const Sight &sight)
{
    m_target = target;
    m_duration = duration;
    m_step = step;
    m_from = sight.measured.value_or(0.0); // the set-point of a motor that rests is a left-over
    if (sight.moving())
        m_from = sight.reference.value_or(m_from);
    m_fromKnown = sight.reference.has_value();
    m_begun = now;
    m_elapsed = {};
    m_phase = sight.moving() ? Phase::Ramping : Phase::Waiting;
}

void RampProgress::replaced()
{
    if (running())
        m_phase = Phase::Replaced;
}

double RampProgress::fraction() const
{
    if (m_phase == Phase::None || m_phase == Phase::Waiting)
        return 0.0;
    if (m_phase == Phase::Arrived || m_phase == Phase::Following || m_duration.count() == 0)
        return 1.0;
    return std::min(1.0, double(m_elapsed.count()) / double(m_duration.count()));
}

/// Neither between the ends of the ramp nor, once its time is over, at the target.
bool RampProgress::offTheRamp(const Sight &sight) const
{
    if (!sight.reference)
        return false;
    const double slack = 1.5 * m_step;
    if (m_elapsed > m_duration + kReadingAge)
        return std::abs(*sight.reference - m_target) > slack;
    return m_fromKnown
        && (*sight.reference < std::min(m_from, m_target) - slack
            || *sight.reference > std::max(m_from, m_target) + slack);
}

void RampProgress::update(Milliseconds now, const Sight &sight)
{
    if (!running())
        return;
    if (!sight.answering) {
        m_phase = Phase::LinkLost;
        return;
    }
    if (m_phase == Phase::Waiting) {
        if (!sight.moving())
            return;
        m_phase = Phase::Ramping; // the firmware begins it with the end of its start
        m_begun = now;
        m_from = sight.measured.value_or(m_from);
        m_fromKnown = false;
    }
    if (!sight.moving()) {
        m_phase = Phase::MotorStopped;
        return;
    }
    m_elapsed = now - m_begun;
    if (offTheRamp(sight)) {
        m_phase = Phase::Replaced;
        return;
    }
    if (m_elapsed < m_duration || !sight.reference
        || std::abs(*sight.reference - m_target) > 0.5 * m_step)
        return;
    const double tolerance = std::max(2.0 * m_step, kNear * std::abs(m_target));
    const bool there = sight.measured && std::abs(*sight.measured - m_target) <= tolerance;
    m_phase = there ? Phase::Arrived : Phase::Following;
}

} // namespace widgets

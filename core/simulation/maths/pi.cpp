// Products in 64 bits, so that an error beyond 16 bits saturates instead of changing its sign.
#include "simulation/maths/pi.h"

namespace simulation {

namespace {

constexpr int kMostPiShift = 31;

} // namespace

Pi::Pi(Gains gains)
    : m_gains(gains)
{
    setKpShift(gains.kpShift);
    setKiShift(gains.kiShift);
}

std::int16_t Pi::step(std::int32_t error)
{
    const std::int32_t proportional = saturate32(std::int64_t{m_gains.kp} * error);
    if (m_gains.ki == 0) {
        m_integral = 0;
    } else {
        const std::int32_t increment = saturate32(std::int64_t{m_gains.ki} * error);
        const std::int32_t sum = saturate32(std::int64_t{m_integral} + increment);
        m_integral = std::min(std::max(sum, m_integralLimits.lower), m_integralLimits.upper);
    }
    const std::int64_t out =
        std::int64_t{proportional >> m_gains.kpShift} + (m_integral >> m_gains.kiShift);
    const std::int64_t cut = std::min<std::int64_t>(
        std::max<std::int64_t>(out, m_outputLimits.lower), m_outputLimits.upper);
    m_integral = saturate32(std::int64_t{m_integral} + (cut - out));
    return static_cast<std::int16_t>(cut);
}

void Pi::setKpShift(int shift) { m_gains.kpShift = std::clamp(shift, 0, kMostPiShift); }

void Pi::setKiShift(int shift)
{
    m_gains.kiShift = std::clamp(shift, 0, kMostPiShift);
    const std::int32_t limit = saturate32(std::int64_t{kDigitsMax} << m_gains.kiShift);
    m_integralLimits = {-limit, limit};
}

void Pi::follow(Gains gains)
{
    m_gains.kp = gains.kp;
    m_gains.ki = gains.ki;
    setKpShift(gains.kpShift);
    if (std::clamp(gains.kiShift, 0, kMostPiShift) != m_gains.kiShift)
        setKiShift(gains.kiShift);
}

void Pi::setOutputLimits(Limits limits)
{
    m_outputLimits = {saturate16(limits.lower), saturate16(limits.upper)};
}

} // namespace simulation

// The error is the room that is left to the target: positive room wants no current, and the output never is positive.
#include "simulation/firmware/flux_weakening.h"

namespace simulation {

namespace {

constexpr int kWeakeningShift = 5; ///< of 32 control periods
constexpr int kWeakeningBits = 8;

} // namespace

void FluxWeakening::clear()
{
    m_q = m_d = 0;
    m_loop.clear();
}

void FluxWeakening::watch(Qd voltage)
{
    m_q += (voltage.q * (1 << kWeakeningBits) - m_q) >> kWeakeningShift;
    m_d += (voltage.d * (1 << kWeakeningBits) - m_d) >> kWeakeningShift;
}

Qd FluxWeakening::step(Qd wanted, std::int32_t currentLimit, std::int32_t demagnetising,
    const Tuning &tuning, Signals &out)
{
    const auto square = [](std::int64_t x) { return x * x; };
    const std::int32_t length =
        squareRoot(square(m_q >> kWeakeningBits) + square(m_d >> kWeakeningBits));
    out.fluxWeakeningBus = static_cast<std::int16_t>(length * 1000 / kDigitsMax);
    const std::int32_t target = tuning.fluxBus * kDigitsMax / 1000;
    m_loop.follow({tuning.fluxKp, tuning.fluxKi, tuning.fluxKpDiv, tuning.fluxKiDiv});
    m_loop.setOutputLimits({-demagnetising, 0});
    const std::int32_t integral = saturate32(std::int64_t{demagnetising} << m_loop.kiShift());
    m_loop.setIntegralLimits({-integral, 0});
    const std::int32_t d = m_loop.step(target - length);
    Qd driven{wanted.q, static_cast<std::int16_t>(std::min<std::int32_t>(wanted.d, d))};
    if (driven.d < wanted.d || d < 0) {
        const std::int32_t room = squareRoot(square(currentLimit) - square(driven.d));
        driven.q = static_cast<std::int16_t>(std::clamp<std::int32_t>(driven.q, -room, room));
    }
    return driven;
}

} // namespace simulation

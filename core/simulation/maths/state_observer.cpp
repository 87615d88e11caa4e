// Sums in 64 bits, saturated to 32: a wrong gain makes the observer useless, never undefined.
#include "simulation/maths/state_observer.h"

namespace simulation {

namespace {

constexpr std::int32_t kDigitsPerRadian = 10430; // 65536 / 2 pi
constexpr std::int32_t kTurnRange = 1043038; // a hundred times as much: what F3 makes room for

} // namespace

StateObserver::StateObserver(ObserverConstants constants)
    : m_constants(constants)
    , m_turnShift(0)
{
    m_constants.f1Shift = std::clamp(m_constants.f1Shift, 0, kMaxShift);
    m_constants.f2Shift = std::clamp(m_constants.f2Shift, 0, kMaxShift);
    for (std::int32_t room = kTurnRange >> m_constants.f2Shift;
         room != 0 && m_turnShift < kMaxShift; room /= 2)
        ++m_turnShift;
    m_turnGain = (1 << (m_constants.f2Shift + m_turnShift)) / kDigitsPerRadian;
}

void StateObserver::clear()
{
    m_alpha = {};
    m_beta = {};
    m_current = {};
    m_bemf = {};
    m_voltage = {};
}

void StateObserver::setGains(std::int16_t gain1, std::int16_t gain2)
{
    m_constants.gain1 = gain1;
    m_constants.gain2 = gain2;
}

std::int16_t StateObserver::unscaled(std::int32_t &value, int shift) const
{
    const std::int32_t limit = kDigitsMax << shift;
    value = std::clamp(value, -limit, limit);
    return static_cast<std::int16_t>(value >> shift);
}

void StateObserver::stepAxis(
    Axis &axis, std::int16_t measured, std::int16_t voltage, std::int64_t turned) const
{
    const std::int64_t bemf = unscaled(axis.bemf, m_constants.f2Shift);
    const std::int64_t current = unscaled(axis.current, m_constants.f1Shift);
    const std::int64_t error = saturate16(current - measured);
    axis.current = saturate32(axis.current - m_constants.c1 * current + m_constants.gain1 * error
        + std::int64_t{m_constants.c5} * voltage - m_constants.c3 * bemf);
    axis.bemf = saturate32(axis.bemf + m_constants.gain2 * error + turned);
}

void StateObserver::step(const ObserverInput &input, std::int16_t speed_dpp)
{
    m_bemf = {
        unscaled(m_alpha.bemf, m_constants.f2Shift), unscaled(m_beta.bemf, m_constants.f2Shift)};
    const auto volts = [&](std::int16_t last, std::int16_t now) {
        const std::int32_t mean = (last + now) >> 1;
        return static_cast<std::int16_t>((std::int64_t{input.bus} * mean) >> 16);
    };
    const std::int16_t alpha_v = volts(m_voltage.alpha, input.voltage.alpha);
    const std::int16_t beta_v = volts(m_voltage.beta, input.voltage.beta);
    m_voltage = input.voltage;
    // (E cos, -E sin) turns by: alpha' = speed beta, beta' = -speed alpha
    const auto turned = [&](std::int16_t other) {
        return std::int64_t{other >> m_turnShift} * m_turnGain * speed_dpp;
    };
    stepAxis(m_alpha, input.current.alpha, alpha_v, turned(m_bemf.beta));
    stepAxis(m_beta, input.current.beta, beta_v, -turned(m_bemf.alpha));
    m_current = {saturate16(m_alpha.current >> m_constants.f1Shift),
        saturate16(m_beta.current >> m_constants.f1Shift)};
}

} // namespace simulation

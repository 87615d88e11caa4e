// Products in 64 bits: constants come from registers and may be anything.
#include "simulation/firmware/feed_forward.h"

#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr int kAverageShift = 7, kMoreBits = 8;
constexpr int kInductanceShift = 4;

std::int16_t share(std::int64_t product, std::uint16_t bus)
{
    return bus == 0 ? std::int16_t{0} : saturateSymmetric(product / bus);
}

} // namespace

void FeedForward::design(const PlantParameters &plant, double hfHz, Tuning &tuning)
{
    // rad/s of a digit of speed, times digits of modulation of a volt, times digits of the bus
    const double each = 2.0 * std::numbers::pi * hfHz / 65536.0 * std::numbers::sqrt3 * kDigitsMax
        * 65536.0 / plant.inverter.busRange_v;
    const double perHenry = each / plant.inverter.digitsPerAmp() * (1 << kInductanceShift);
    const auto whole = [](double value) { return saturate32(std::llround(value)); };
    tuning.ff1Q = whole(plant.motor.ld_h * perHenry);
    tuning.ff1D = whole(plant.motor.lq_h * perHenry);
    tuning.ff2 = whole(plant.motor.flux_wb * each);
}

void FeedForward::clear()
{
    m_voltage = {};
    m_q = m_d = 0;
}

void FeedForward::watch(Qd voltage)
{
    m_q += ((voltage.q - m_voltage.q) * (1 << kMoreBits) - m_q) >> kAverageShift;
    m_d += ((voltage.d - m_voltage.d) * (1 << kMoreBits) - m_d) >> kAverageShift;
}

Qd FeedForward::step(
    Qd reference, std::int16_t speed_dpp, std::uint16_t bus, const Tuning &tuning, Signals &out)
{
    const std::int64_t speed = speed_dpp;
    const std::int64_t d = -speed * reference.q * tuning.ff1D;
    const std::int64_t q = speed * reference.d * tuning.ff1Q;
    m_voltage = {share((q >> kInductanceShift) + speed * tuning.ff2, bus),
        share(d >> kInductanceShift, bus)};
    out.ffVq = m_voltage.q;
    out.ffVd = m_voltage.d;
    out.ffVqPi = saturate16(m_q >> kMoreBits);
    out.ffVdPi = saturate16(m_d >> kMoreBits);
    return m_voltage;
}

} // namespace simulation

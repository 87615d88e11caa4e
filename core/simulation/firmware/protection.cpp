// Thresholds come from registers and are read every time.
#include "simulation/firmware/protection.h"

#include <cstdlib>

namespace simulation {

Protection::Protection(const Limits &limits)
    : m_limits(limits)
{
}

void Protection::set(std::uint16_t bit, bool on)
{
    m_present = static_cast<std::uint16_t>(on ? m_present | bit : m_present & ~bit);
}

void Protection::watch(double bus_v, double heatsink_c, const Tuning &thresholds)
{
    const auto above = [this](std::uint16_t bit, double value, double limit, double hysteresis) {
        const bool was = (m_present & bit) != 0;
        set(bit, value > (was ? limit - hysteresis : limit));
    };
    above(fault::kOverVoltage, bus_v, thresholds.overVoltage_v, m_limits.overHysteresis_v);
    set(fault::kUnderVoltage, bus_v < thresholds.underVoltage_v);
    above(fault::kOverTemperature, heatsink_c, m_limits.overTemperature_c,
        m_limits.temperatureHysteresis_c);
}

bool Protection::trips(std::int32_t iA, std::int32_t iB)
{
    const std::int32_t trip = m_limits.trip_digits;
    if (std::abs(iA) <= trip && std::abs(iB) <= trip && std::abs(iA + iB) <= trip)
        return false;
    m_present |= fault::kOverCurrent;
    return true;
}

} // namespace simulation

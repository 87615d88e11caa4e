// What the firmware watches: bus voltage and temperature with the hysteresis that it has, the current with its
// comparator. It says which faults are present; what follows from them is the state machine's business.
// Source: mcp-aspep section 7 for the bits; firmware 6.x, safety task: above the upper threshold the fault is there,
// and it stays until the value is below the lower one.
#pragma once

#include "simulation/signals.h"

#include <cstdint>

namespace simulation {

namespace fault {
constexpr std::uint16_t kDuration = 0x0001, kOverVoltage = 0x0002, kUnderVoltage = 0x0004,
                        kOverTemperature = 0x0008, kStartUp = 0x0010, kSpeedFeedback = 0x0020,
                        kOverCurrent = 0x0040, kSoftware = 0x0080;
}

class Protection {
public:
    struct Limits {
        double overHysteresis_v = 0.5; ///< below the threshold, to be well again
        double overTemperature_c = 110.0, temperatureHysteresis_c = 10.0;
        std::int32_t trip_digits = 30000; ///< of a phase current, at the comparator
    };
    explicit Protection(const Limits &limits);

    void clear() { m_present = 0; }
    /// Once a millisecond: the averaged bus voltage and temperature.
    void watch(double bus_v, double heatsink_c, const Tuning &thresholds);
    /// Every control period; true if the comparator switches the bridge off.
    bool trips(std::int32_t iA, std::int32_t iB);
    std::uint16_t present() const { return m_present; }
    /// The comparator's latch is released once the current is gone; with the bridge off it is.
    void releaseComparator() { m_present &= static_cast<std::uint16_t>(~fault::kOverCurrent); }

private:
    void set(std::uint16_t bit, bool on);

    Limits m_limits;
    std::uint16_t m_present = 0;
};

} // namespace simulation

// Something that warms up by losses and cools towards the ambient: one heat capacity, one path.
//   C T' = P - C (T - ambient)/tau
#pragma once

namespace simulation {

class HeatStore {
public:
    /// @param capacity_jpk  0: stays at the ambient temperature
    /// @param cooling_s     time constant; 0: never cools
    HeatStore(double ambient_c, double capacity_jpk, double cooling_s);

    void warm(double energy_j, double over_s);
    double temperature_c() const { return m_ambient_c + m_rise_k; }

private:
    double m_ambient_c, m_capacity_jpk, m_cooling_s;
    double m_rise_k = 0.0;
};

inline constexpr double kCopper_jpkgk = 385.0; ///< specific heat

} // namespace simulation

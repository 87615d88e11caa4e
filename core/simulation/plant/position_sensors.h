// Encoder and Hall sensors with the timers that read them. They look at the rotor's angle and never move it.
#pragma once

#include "simulation/plant/parameters.h"

#include <cstdint>

namespace simulation {

/// A timer in encoder mode that counts every edge and starts again after a turn.
class Encoder {
public:
    explicit Encoder(int pulses);

    void powerUp(double rotor_rad) { m_zero_rad = rotor_rad; }
    std::uint16_t count(double rotor_rad) const;

private:
    int m_counts; ///< a turn
    double m_zero_rad = 0.0;
};

/// Three sensors 120 degrees apart. Turning forward the code goes 5 1 3 2 6 4, as ST numbers them; at the angle
/// `placement` it becomes 5.
struct HallReading {
    unsigned code = 0; ///< 1 to 6; 0: no sensors
    std::uint32_t edges = 0; ///< since the start, in either direction; wraps
    double sinceEdge_s = 0.0; ///< since the last edge, or since the start
    double lastPeriod_s = 0.0; ///< between the last two edges; 0: fewer than two
};

class Hall {
public:
    explicit Hall(const SensorParameters &sensors);

    void place(double electrical_rad); ///< no edge
    /// The rotor turned on by `by_rad`, evenly, in `step_s`.
    void turn(double by_rad, double step_s);
    HallReading reading() const;

private:
    bool m_present;
    double m_placement_rad;
    double m_sixths = 0.0; ///< angle since placement, in sectors, 0 to 6
    HallReading m_reading;
};

} // namespace simulation

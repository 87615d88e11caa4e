// Angle and speed from three Hall switches: their code and the captures of their timer in, an angle that runs on
// between the edges at the measured speed out. Call step() every control period, mediumTask() at 1 kHz.
//
// Codes in positive direction: 5 1 3 2 6 4, each for 60 electrical degrees, the first from `phaseShift` on: switch 1
// (bit 0) is high for the half turn from there, switch 2 and 3 a third and two thirds of a turn later.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/maths/speed_range.h"

#include <array>
#include <optional>

namespace simulation {

/// What the timer of the switches knows at one moment.
struct HallCapture {
    unsigned code = 0; ///< 1..6; 0 and 7 are impossible: a broken wire
    std::uint32_t edges = 0; ///< since ever, wrapping
    double sinceEdge_s = 0.0; ///< the last one
    double lastPeriod_s = 0.0; ///< between the last two
};

class HallSensor {
public:
    struct Parameters {
        int polePairs = 1;
        std::int16_t phaseShift = 0; ///< electrical angle where code 5 begins in positive direction
        std::uint16_t hfHz = 16000;
        double timer_hz = 1e6; ///< periods are whole ticks of it
        double timeout_s = 0.15; ///< without an edge for so long the rotor stands
        int depth = 6; ///< edges that the speed is averaged over, 1..18
        SpeedRange range = {};
    };

    explicit HallSensor(const Parameters &parameters);

    /// The angle now. At an edge it is the sector's border, then it runs on by the averaged speed, at most to the other
    /// border; standing, or after the direction changed, it is the middle of the sector.
    std::int16_t step(const HallCapture &capture);
    void mediumTask();
    void clear();

    std::int16_t angle() const { return m_angle; }
    std::int16_t speed_dHz() const { return m_speed_dHz; }
    std::int16_t speed_dpp() const { return m_speed_dpp; } ///< averaged, electrical
    /// False after impossible codes or sectors that were skipped, three in a row, and out of the speed range.
    bool reliable() const { return m_check.reliable(); }

private:
    static constexpr std::size_t kMaxDepth = 18;

    void edge(int sector, const HallCapture &capture);
    void stand(int sector);
    void startAveraging(int direction);
    std::int16_t borderOf(int sector) const;

    Parameters m_parameters;
    SpeedRangeCheck m_check;
    std::array<std::int64_t, kMaxDepth> m_periods{}; ///< ticks
    int m_filled = 0, m_next = 0;
    std::int64_t m_sum = 0;
    std::optional<int> m_sector;
    int m_direction = 0, m_badEdges = 0;
    std::uint32_t m_edges = 0;
    std::int32_t m_run = 0; ///< angle run since the edge
    std::int16_t m_angle = 0, m_speed_dpp = 0, m_speed_dHz = 0;
};

} // namespace simulation

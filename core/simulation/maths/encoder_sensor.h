// Angle and speed from a quadrature encoder: the counter of its timer in, electrical angle and averaged speed out.
// It knows no index pulse: where zero is, an alignment says. Call step() every control period, mediumTask() at 1 kHz.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/maths/speed_range.h"

#include <array>

namespace simulation {

class EncoderSensor {
public:
    struct Parameters {
        int countsPerTurn = 4096; ///< edges of both channels: four times the pulses; at least 4
        /// After so many counts the counter is back at 0: 65536, or countsPerTurn as ST's timer is set up.
        int counterRange = 65536;
        int polePairs = 1;
        std::uint16_t hfHz = 16000, mfHz = 1000;
        int depth = 16; ///< medium tasks that the speed is averaged over, 1..64
        SpeedRange range = {};
    };

    explicit EncoderSensor(const Parameters &parameters);

    /// Counts may go either way by less than half the counter's range a period. Returns the electrical angle.
    std::int16_t step(std::uint16_t count);
    /// Mean of the last `depth` differences: counts * 10 mfHz / (countsPerTurn depth), cut towards zero.
    void mediumTask();
    /// The rotor stands at this electrical angle now: the end of an alignment.
    void align(std::int16_t angle);
    /// Speed and reliability anew; the alignment stays.
    void clear();

    std::int16_t angle() const { return m_angle; }
    /// 65536 a turn of the shaft, 0 where the angle was aligned to 0
    std::int16_t mechanicalAngle() const;
    std::int16_t speed_dHz() const { return m_speed_dHz; }
    std::int16_t speed_dpp() const { return m_speed_dpp; } ///< electrical, of the last medium task
    bool reliable() const { return m_check.reliable(); }

private:
    static constexpr std::size_t kMaxDepth = 64;

    Parameters m_parameters;
    SpeedRangeCheck m_check;
    std::array<std::int32_t, kMaxDepth> m_moved{};
    std::size_t m_index = 0;
    std::uint16_t m_lastCount = 0;
    bool m_started = false;
    std::int32_t m_position = 0; ///< counts within a turn
    std::int32_t m_sinceMedium = 0;
    std::uint32_t m_zero = 0; ///< mechanical, 2^32 a turn
    std::int16_t m_angle = 0, m_speed_dHz = 0, m_speed_dpp = 0;
};

} // namespace simulation

// What the firmware makes of an angle that an observer only estimates: averaged speeds, whether to believe them, and
// whether a start-up may hand over to them. Call store() every control period, average() at the medium frequency,
// converged() after it while the rotor is still forced. Source: features 6.5, 6.6; the checks as in ST's library.
#pragma once

#include "simulation/maths/fixed_point.h"
#include "simulation/maths/speed_range.h"

#include <array>

namespace simulation {

/// A speed in 0.1 Hz mechanical from one in 1/65536 electrical turn a period: each division cuts towards zero.
std::int16_t mechanicalSpeed_dHz(std::int32_t speed_dpp, std::uint16_t hfHz, int polePairs);

struct SpeedEstimateParameters {
    std::uint16_t hfHz = 16000;
    int polePairs = 1; ///< at least 1
    int depth = 64; ///< control periods that the speed is averaged over, 1..64
    /// The same for the speed that the observer itself uses; power of two, at most `depth`.
    int depthDpp = 64;
    /// Of the speed squared, 128: all of it. 25 % for a PLL, 400 % for CORDIC.
    std::uint16_t varianceThreshold = 32;
    std::uint16_t maxReliable_dHz = 767; ///< 1.15 times the maximum application speed, mechanical
    std::uint16_t minReliable_dHz = 0;
    /// Of 64: how much of the expected squared back-EMF may be missing.
    std::uint16_t bemfTolerance = 64;
    std::uint16_t bemfGain = 64; ///< 64: the back-EMF scale is exact
    int errorsBeforeFault = 3; ///< so many bad averages in a row make the sensor unreliable
    std::uint16_t startUpMinimum_dHz = 0; ///< below it nothing converges
    int startUpTests = 2; ///< so many good ones in a row, at the medium frequency
    int bandLow = 15, bandHigh = 17; ///< in 1/16 of the forced speed
};

class SpeedEstimate {
public:
    explicit SpeedEstimate(SpeedEstimateParameters parameters);

    /// One control period's electrical speed.
    void store(std::int16_t speed_dpp);
    /// Averages, looks at the variance and at the size of the back-EMF, decides reliable(). Cost: O(depth).
    void average(AlphaBeta bemf);
    /// One test of the start-up; true from the one on that completes the series. Not yet converged, an estimate is
    /// unreliable only by its speed range.
    bool converged(std::int16_t forced_dHz);
    void forceConvergence();
    void clear() { *this = SpeedEstimate(m_parameters); }

    std::int16_t speed_dHz() const { return m_speed_dHz; } ///< averaged, mechanical
    std::int16_t speed_dpp() const { return m_speed_dpp; } ///< averaged, electrical
    bool reliable() const { return m_range.reliable(); }
    std::int32_t observedBemf() const { return m_observedBemf; } ///< squared digits
    std::int32_t expectedBemf() const { return m_expectedBemf; }

    const SpeedEstimateParameters &parameters() const { return m_parameters; }

private:
    static constexpr std::size_t kMaxDepth = 64;

    bool bemfIsConsistent(AlphaBeta bemf);

    SpeedEstimateParameters m_parameters;
    SpeedRangeCheck m_range;
    std::array<std::int16_t, kMaxDepth> m_buffer{};
    std::size_t m_index = 0;
    std::int32_t m_sumDpp = 0;
    std::int16_t m_speed_dpp = 0, m_speed_dHz = 0;
    bool m_varianceIsLow = false, m_converged = false;
    std::int32_t m_observedBemf = 0, m_expectedBemf = 0;
    int m_unreliable = 0, m_startUpTests = 0;
};

} // namespace simulation

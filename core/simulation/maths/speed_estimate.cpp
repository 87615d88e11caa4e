// Averages and decisions, at the medium frequency; nothing here needs more than the last 64 speeds.
#include "simulation/maths/speed_estimate.h"

#include <bit>
#include <cstdlib>

namespace simulation {

std::int16_t mechanicalSpeed_dHz(std::int32_t speed_dpp, std::uint16_t hfHz, int polePairs)
{
    const std::int64_t electrical = std::int64_t{speed_dpp} * hfHz * 10 / 65536;
    return saturate16(electrical / std::max(polePairs, 1));
}

SpeedEstimate::SpeedEstimate(SpeedEstimateParameters parameters)
    : m_parameters(parameters)
    , m_range(
          {parameters.maxReliable_dHz, parameters.minReliable_dHz, parameters.errorsBeforeFault})
{
    SpeedEstimateParameters &p = m_parameters;
    p.depth = std::clamp(p.depth, 1, static_cast<int>(kMaxDepth));
    p.depthDpp =
        static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(p.depthDpp, 1, p.depth))));
}

void SpeedEstimate::store(std::int16_t speed_dpp)
{
    const auto depth = static_cast<std::size_t>(m_parameters.depth);
    const auto depthDpp = static_cast<std::size_t>(m_parameters.depthDpp);
    m_index = m_index + 1 == depth ? 0 : m_index + 1;
    const std::size_t leaving =
        m_index >= depthDpp ? m_index - depthDpp : m_index + depth - depthDpp;
    m_sumDpp += speed_dpp - m_buffer[leaving];
    m_buffer[m_index] = speed_dpp;
    m_speed_dpp = static_cast<std::int16_t>(m_sumDpp >> std::countr_zero(depthDpp));
}

void SpeedEstimate::average(AlphaBeta bemf)
{
    const auto depth = static_cast<std::size_t>(m_parameters.depth);
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < depth; ++i)
        sum += m_buffer[i];
    const std::int32_t mean = sum / m_parameters.depth;
    std::int64_t squares = 0;
    for (std::size_t i = 0; i < depth; ++i)
        squares += std::int64_t{m_buffer[i] - mean} * (m_buffer[i] - mean);
    const std::int64_t variance = squares / m_parameters.depth;
    m_varianceIsLow = variance < std::int64_t{mean} * mean * m_parameters.varianceThreshold / 128;
    m_speed_dHz = mechanicalSpeed_dHz(mean, m_parameters.hfHz, m_parameters.polePairs);

    const bool consistent = bemfIsConsistent(bemf);
    m_range.look(m_speed_dHz);
    if (!m_converged)
        return;
    m_unreliable = m_varianceIsLow && consistent ? 0 : m_unreliable + 1;
    if (m_unreliable >= m_parameters.errorsBeforeFault) {
        m_unreliable = 0;
        m_range.fail();
    }
}

bool SpeedEstimate::bemfIsConsistent(AlphaBeta bemf)
{
    const std::int64_t size = std::abs(int{m_speed_dHz});
    if (m_parameters.maxReliable_dHz == 0 || size >= m_parameters.maxReliable_dHz)
        return false;
    const std::int64_t expected = size * kDigitsMax / m_parameters.maxReliable_dHz;
    m_observedBemf =
        saturate32(std::int64_t{bemf.alpha} * bemf.alpha + std::int64_t{bemf.beta} * bemf.beta);
    m_expectedBemf = saturate32(expected * m_parameters.bemfGain / 64 * expected);
    const std::int64_t least =
        m_expectedBemf - std::int64_t{m_expectedBemf / 64} * m_parameters.bemfTolerance;
    return m_observedBemf > least;
}

bool SpeedEstimate::converged(std::int16_t forced_dHz)
{
    const int size = std::abs(int{m_speed_dHz}), forced = std::abs(int{forced_dHz});
    if ((m_speed_dHz > 0) != (forced_dHz > 0) || m_speed_dHz == 0 || forced_dHz == 0)
        return false; // the series is neither continued nor broken
    const bool good = m_varianceIsLow && size > m_parameters.startUpMinimum_dHz
        && size >= forced * m_parameters.bandLow / 16
        && size <= forced * m_parameters.bandHigh / 16;
    m_startUpTests = good ? m_startUpTests + 1 : 0;
    if (!good || m_startUpTests < m_parameters.startUpTests)
        return false;
    forceConvergence();
    return true;
}

void SpeedEstimate::forceConvergence()
{
    m_converged = true;
    m_range.clear();
}

} // namespace simulation

// The shaft's angle is kept with 2^32 a turn, so that times the pole pairs it wraps by itself.
#include "simulation/maths/encoder_sensor.h"

namespace simulation {

namespace {

std::uint32_t shaftAngle(std::int32_t position, int countsPerTurn)
{
    const std::uint64_t turn = std::uint64_t{1} << 32;
    return static_cast<std::uint32_t>(
        static_cast<std::uint64_t>(position) * turn / static_cast<std::uint64_t>(countsPerTurn));
}

} // namespace

EncoderSensor::EncoderSensor(const Parameters &parameters)
    : m_parameters(parameters)
    , m_check(parameters.range)
{
    Parameters &p = m_parameters;
    p.countsPerTurn = std::max(p.countsPerTurn, 4);
    p.counterRange = std::clamp(p.counterRange, 4, 65536);
    p.polePairs = std::max(p.polePairs, 1);
    p.hfHz = std::max<std::uint16_t>(p.hfHz, 1);
    p.mfHz = std::max<std::uint16_t>(p.mfHz, 1);
    p.depth = std::clamp(p.depth, 1, static_cast<int>(kMaxDepth));
}

std::int16_t EncoderSensor::step(std::uint16_t count)
{
    const int range = m_parameters.counterRange;
    int moved = m_started ? (int{count} - int{m_lastCount}) % range : 0;
    if (moved >= range / 2)
        moved -= range;
    else if (moved < -(range / 2))
        moved += range;
    m_started = true;
    m_lastCount = count;
    m_sinceMedium += moved;
    m_position = (m_position + moved) % m_parameters.countsPerTurn;
    if (m_position < 0)
        m_position += m_parameters.countsPerTurn;
    const std::uint32_t shaft = shaftAngle(m_position, m_parameters.countsPerTurn) - m_zero;
    const std::uint32_t electrical = shaft * static_cast<std::uint32_t>(m_parameters.polePairs);
    m_angle = static_cast<std::int16_t>(static_cast<std::uint16_t>(electrical >> 16U));
    return m_angle;
}

void EncoderSensor::mediumTask()
{
    const auto depth = static_cast<std::size_t>(m_parameters.depth);
    m_moved[m_index] = m_sinceMedium;
    m_index = m_index + 1 == depth ? 0 : m_index + 1;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < depth; ++i)
        sum += m_moved[i];
    m_speed_dHz = saturate16(sum * 10 * m_parameters.mfHz
        / (std::int64_t{m_parameters.countsPerTurn} * m_parameters.depth));
    const std::int64_t turned = std::int64_t{m_sinceMedium} * 65536 * m_parameters.polePairs;
    m_speed_dpp = saturate16(turned * m_parameters.mfHz
        / (std::int64_t{m_parameters.countsPerTurn} * m_parameters.hfHz));
    m_sinceMedium = 0;
    m_check.look(m_speed_dHz);
}

void EncoderSensor::align(std::int16_t angle)
{
    const std::uint32_t wanted = static_cast<std::uint32_t>(static_cast<std::uint16_t>(angle))
        << 16U;
    m_zero = shaftAngle(m_position, m_parameters.countsPerTurn)
        - wanted / static_cast<std::uint32_t>(m_parameters.polePairs);
    m_angle = angle;
}

void EncoderSensor::clear()
{
    m_moved.fill(0);
    m_sinceMedium = 0;
    m_speed_dHz = 0;
    m_speed_dpp = 0;
    m_check.clear();
}

std::int16_t EncoderSensor::mechanicalAngle() const
{
    const std::uint32_t shaft = shaftAngle(m_position, m_parameters.countsPerTurn) - m_zero;
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(shaft >> 16U));
}

} // namespace simulation

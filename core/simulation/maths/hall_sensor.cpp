// Only whole ticks of the timer reach the arithmetic; seconds end at the capture.
#include "simulation/maths/hall_sensor.h"

#include "simulation/maths/speed_estimate.h"

#include <cmath>

namespace simulation {

namespace {

constexpr std::int32_t kSector = 65536 / 6;
constexpr int kSectors = 6;
constexpr int kMaxBadEdges = 3;
constexpr double kMaxTicks = 4294967295.0;

/// -1: a code that three switches 120 degrees apart cannot give.
int sectorOf(unsigned code)
{
    constexpr std::array<int, 8> kSectorOfCode{-1, 1, 3, 2, 5, 0, 4, -1};
    return kSectorOfCode[code & 7U];
}

} // namespace

HallSensor::HallSensor(const Parameters &parameters)
    : m_parameters(parameters)
    , m_check(parameters.range)
{
    Parameters &p = m_parameters;
    p.polePairs = std::max(p.polePairs, 1);
    p.hfHz = std::max<std::uint16_t>(p.hfHz, 1);
    p.depth = std::clamp(p.depth, 1, static_cast<int>(kMaxDepth));
}

std::int16_t HallSensor::borderOf(int sector) const
{
    return wrapAngle(m_parameters.phaseShift + sector * 65536 / kSectors);
}

std::int16_t HallSensor::step(const HallCapture &capture)
{
    const bool moved = m_sector && capture.edges != m_edges;
    m_edges = capture.edges;
    const int sector = sectorOf(capture.code);
    if (sector < 0) {
        if (++m_badEdges >= kMaxBadEdges)
            m_check.fail();
        return m_angle;
    }
    if (moved && sector != *m_sector)
        edge(sector, capture);
    else if (!m_sector || capture.sinceEdge_s > m_parameters.timeout_s)
        stand(sector);
    else if (m_direction != 0 && m_speed_dpp != 0) {
        const std::int32_t step = std::abs(int{m_speed_dpp});
        const std::int32_t run = std::min(m_run + step, kSector);
        m_angle = wrapAngle(m_angle + m_direction * (run - m_run));
        m_run = run;
    }
    return m_angle;
}

void HallSensor::edge(int sector, const HallCapture &capture)
{
    const int moved = (sector - *m_sector + kSectors) % kSectors;
    m_sector = sector;
    if (moved != 1 && moved != kSectors - 1) {
        if (++m_badEdges >= kMaxBadEdges)
            m_check.fail();
        startAveraging(0);
        m_angle = wrapAngle(borderOf(sector) + kSector / 2);
        return;
    }
    m_badEdges = 0;
    const int direction = moved == 1 ? 1 : -1;
    if (direction != m_direction) {
        startAveraging(direction); // the period before the turn says nothing
        m_angle = wrapAngle(borderOf(sector) + kSector / 2);
        return;
    }
    const double ticks = std::clamp(capture.lastPeriod_s * m_parameters.timer_hz, 1.0, kMaxTicks);
    const auto slot = static_cast<std::size_t>(m_next);
    m_sum += std::llround(ticks) - m_periods[slot];
    m_periods[slot] = std::llround(ticks);
    m_next = (m_next + 1) % m_parameters.depth;
    m_filled = std::min(m_filled + 1, m_parameters.depth);
    const double perPeriod = m_parameters.timer_hz / m_parameters.hfHz; // ticks
    const double mean = static_cast<double>(m_sum) / m_filled;
    m_speed_dpp = saturate16(direction * std::llround(65536.0 / kSectors * perPeriod / mean));
    m_angle = direction > 0 ? borderOf(sector) : borderOf(sector + 1);
    m_run = 0;
}

void HallSensor::stand(int sector)
{
    m_sector = sector;
    startAveraging(0);
    m_angle = wrapAngle(borderOf(sector) + kSector / 2);
}

void HallSensor::startAveraging(int direction)
{
    m_direction = direction;
    m_periods.fill(0);
    m_sum = 0;
    m_filled = 0;
    m_next = 0;
    m_run = 0;
    m_speed_dpp = 0;
}

void HallSensor::mediumTask()
{
    m_speed_dHz = mechanicalSpeed_dHz(m_speed_dpp, m_parameters.hfHz, m_parameters.polePairs);
    m_check.look(m_speed_dHz);
}

void HallSensor::clear()
{
    m_sector.reset();
    startAveraging(0);
    m_badEdges = 0;
    m_speed_dHz = 0;
    m_check.clear();
}

} // namespace simulation

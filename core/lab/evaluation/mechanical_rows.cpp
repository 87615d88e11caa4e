#include "lab/evaluation/mechanical_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

constexpr double kRow_s = 10e-3;
constexpr double kLeastStretch_s = 0.1; ///< between two gaps

} // namespace

/// Integrals over a segment from its beginning, and the means of these over a window around a sample. Its speed is the
/// mean over that window, too: what the window hides of one side of the equation it hides of the other.
class MechanicalRows::Integrals {
public:
    Integrals(const Segment &segment, double polePairs, std::size_t edge)
        : m_edge(edge)
        , m_step_s(segment.step_s)
        , m_turned(segment.turned_deg)
    {
        for (double &turned : m_turned)
            turned *= std::numbers::pi / 180.0 / polePairs; // mechanical
        const std::vector<double> &current = segment.values[0];
        double impulse = 0.0, cubes = 0.0;
        for (std::size_t at = 0; at < current.size(); ++at) {
            m_impulses.push_back(impulse);
            m_cubes.push_back(cubes);
            const double amps = (current[at] + current[std::min(at + 1, current.size() - 1)]) / 2.0;
            impulse += amps * m_step_s;
            cubes += amps * amps * amps * m_step_s;
        }
        m_turnedSum = summed(m_turned);
        m_impulseSum = summed(m_impulses);
        m_cubeSum = summed(m_cubes);
    }
    double speed(std::size_t at) const
    {
        return (m_turned[at + m_edge] - m_turned[at - m_edge])
            / (2.0 * static_cast<double>(m_edge) * m_step_s);
    }
    double current(std::size_t at) const
    {
        return (m_impulses[at + m_edge] - m_impulses[at - m_edge])
            / (2.0 * static_cast<double>(m_edge) * m_step_s);
    }
    double turned(std::size_t at) const { return mean(m_turnedSum, at); }
    double impulse(std::size_t at) const { return mean(m_impulseSum, at); } ///< of the current
    double cubes(std::size_t at) const { return mean(m_cubeSum, at); } ///< of its cube

private:
    /// By trapezoids, per step.
    static std::vector<double> summed(const std::vector<double> &values)
    {
        std::vector<double> sums{0.0};
        for (std::size_t at = 1; at < values.size(); ++at)
            sums.push_back(sums.back() + (values[at - 1] + values[at]) / 2.0);
        return sums;
    }
    double mean(const std::vector<double> &sums, std::size_t at) const
    {
        return (sums[at + m_edge] - sums[at - m_edge]) / (2.0 * static_cast<double>(m_edge));
    }

    std::size_t m_edge;
    double m_step_s;
    std::vector<double> m_turned, m_impulses, m_cubes, m_turnedSum, m_impulseSum, m_cubeSum;
};

void MechanicalRows::accept(const Segment &segment)
{
    const auto edge =
        static_cast<std::size_t>(std::max(1L, std::lround(m_facts.edge_s / segment.step_s)));
    const std::size_t size = segment.turned_deg.size();
    if (size <= 2 * edge)
        return;
    const double time = static_cast<double>(size - 2 * edge) * segment.step_s;
    const auto parts = static_cast<std::size_t>(std::ceil(time / m_facts.stretch_s));
    const std::size_t length = (size - 2 * edge) / parts;
    if (length == 0)
        return; // samples so far apart are no board's, but a file may hold them
    const Integrals integrals(segment, m_facts.polePairs, edge);
    for (std::size_t at = edge; at + length + edge <= size; at += length)
        if (static_cast<double>(length) * segment.step_s >= kLeastStretch_s)
            add(integrals, segment.step_s, at, at + length);
}

/// From its beginning, less their means: what they were before it is not known, and need not be.
void MechanicalRows::add(
    const Integrals &integrals, double step_s, std::size_t from, std::size_t to)
{
    const auto every = static_cast<std::size_t>(std::max(1L, std::lround(kRow_s / step_s)));
    const double sign = integrals.turned(to - 1) < integrals.turned(from) ? -1.0 : 1.0;
    const std::size_t first = rows.known.size();
    double squares = 0.0, before = integrals.speed(from);
    Row sum{};
    double sumWanted = 0.0;
    for (std::size_t at = from; at < to; at += every) {
        const double now = integrals.speed(at);
        if (at > from) // Simpson's rule would gain nothing on so short a time
            squares += (now * std::abs(now) + before * std::abs(before)) / 2.0
                * static_cast<double>(every) * step_s;
        before = now;
        fastest = std::max(fastest, std::abs(now));
        const double time = static_cast<double>(at - from) * step_s;
        rows.known.push_back({now, integrals.turned(at) - integrals.turned(from), sign * time,
            squares, integrals.cubes(at) - integrals.cubes(from), time});
        rows.wanted.push_back(
            m_facts.torquePerAmp * (integrals.impulse(at) - integrals.impulse(from)));
        rows.cluster.push_back(m_count);
        instants.push_back({now, m_facts.torquePerAmp * integrals.current(at)});
        for (std::size_t i = 0; i < kMostUnknowns; ++i)
            sum[i] += rows.known.back()[i];
        sumWanted += rows.wanted.back();
    }
    const auto many = static_cast<double>(rows.known.size() - first);
    for (std::size_t row = first; row < rows.known.size(); ++row) {
        for (std::size_t i = 0; i < kMostUnknowns; ++i)
            rows.known[row][i] -= sum[i] / many;
        rows.wanted[row] -= sumWanted / many;
        // A speed has the errors of its sensor; the impulse that made it has none of them.
        rows.instruments.push_back(rows.known[row]);
        rows.instruments.back()[kInertia] = rows.wanted[row];
    }
    time_s += static_cast<double>(to - from) * step_s;
    ++m_count;
}

} // namespace lab

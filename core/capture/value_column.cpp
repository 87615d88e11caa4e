#include "capture/value_column.h"

#include <algorithm>
#include <cassert>

namespace capture {

namespace {
/// A single value as a range; drawing needs no more than float.
MinMax rangeOf(double value)
{
    const auto rounded = static_cast<float>(value);
    return {rounded, rounded};
}
} // namespace

void ValueColumn::append(Nanos time, double value, Nanos holdUntil)
{
    if (inChunk(m_end) == 0)
        m_chunks.push_back(std::make_shared_for_overwrite<Chunk>());
    Chunk &chunk = *m_chunks.back();
    const std::size_t at = inChunk(m_end);
    chunk.times[at] = time;
    chunk.values[at] = value;
    if (m_broken || m_runs.empty())
        m_runs.push_back({m_end, 0, holdUntil});
    m_broken = false;
    m_runs.back().count += 1;
    m_runs.back().holdUntil = holdUntil;
    ++m_end;
    if (inChunk(m_end) % kBlock == 0) {
        const std::size_t block = at / kBlock;
        MinMax range;
        for (std::size_t i = block * kBlock; i <= at; ++i)
            range.include(rangeOf(chunk.values[i]));
        chunk.ranges[block] = range;
    }
}

void ValueColumn::extendHold(Nanos time)
{
    if (!m_broken && !m_runs.empty())
        m_runs.back().holdUntil = std::max(m_runs.back().holdUntil, time);
}

std::size_t ValueColumn::runOf(Index index) const
{
    if (index < m_begin || index >= m_end)
        return m_runs.size();
    const auto after = std::upper_bound(m_runs.begin(), m_runs.end(), index,
        [](Index wanted, const Run &run) { return wanted < run.first; });
    return static_cast<std::size_t>(after - m_runs.begin()) - 1;
}

Index ValueColumn::atOrAfter(Nanos time) const
{
    Index low = m_begin;
    Index high = m_end;
    while (low < high) {
        const Index middle = low + (high - low) / 2;
        if (timeOf(middle) < time)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

MinMax ValueColumn::extremes(Index from, Index to) const
{
    from = std::max(from, m_begin);
    to = std::min(to, m_end);
    MinMax range;
    while (from < to) {
        if (from % kBlock == 0 && from + kBlock <= to) {
            range.include(chunkOf(from).ranges[inChunk(from) / kBlock]);
            from += kBlock;
        } else {
            range.include(rangeOf(at(from)));
            ++from;
        }
    }
    return range;
}

void ValueColumn::releaseOldest()
{
    if (!canRelease())
        return;
    m_chunks.pop_front();
    ++m_released;
    m_begin = m_released * kChunkSamples;
    const std::size_t keep = runOf(m_begin);
    m_runs.erase(m_runs.begin(), m_runs.begin() + static_cast<std::ptrdiff_t>(keep));
    Run &front = m_runs.front();
    front.count -= m_begin - front.first;
    front.first = m_begin;
}

std::size_t ValueColumn::bytes() const
{
    return m_chunks.size() * sizeof(Chunk) + m_runs.capacity() * sizeof(Run);
}

} // namespace capture

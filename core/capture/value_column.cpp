#include "capture/value_column.h"

#include <algorithm>
#include <cassert>

namespace capture {

void ValueColumn::append(
    std::span<const Nanos> times, std::span<const double> values, Nanos holdUntil)
{
    assert(times.size() == values.size());
    if (times.empty())
        return;
    const auto full = [this] { return m_end == (m_released + m_chunks.size()) * kChunkSamples; };
    if (full()) // first, so that no run stays empty where there is no memory for it
        addChunk(times.front());
    if (m_broken || m_runs.empty())
        m_runs.push_back({m_end, 0, holdUntil});
    m_broken = true; // memory may run out in the middle
    m_runs.back().holdUntil = holdUntil;
    for (std::size_t done = 0; done < times.size();) {
        const std::size_t at = inChunk(m_end);
        if (full())
            addChunk(times[done]);
        const std::size_t count = std::min(times.size() - done, kChunkSamples - at);
        std::copy_n(times.data() + done, count, m_filled->times.data() + at);
        std::copy_n(values.data() + done, count, m_filled->values.data() + at);
        m_end += count;
        done += count;
        m_runs.back().count += count;
        m_lastTime = times[done - 1];
        for (std::size_t b = at / kBlockSamples; b < (at + count) / kBlockSamples; ++b)
            measure(b);
    }
    m_broken = false;
}

void ValueColumn::measure(std::size_t block)
{
    ValueRange range;
    for (std::size_t i = block * kBlockSamples; i < (block + 1) * kBlockSamples; ++i)
        range.include({m_filled->values[i], m_filled->values[i]});
    m_chunks.back()->ranges[block] = range;
}

void ValueColumn::addChunk(Nanos start)
{
    auto samples = std::make_shared_for_overwrite<Samples>();
    auto *filled = samples.get();
    auto chunk = std::make_shared<Chunk>();
    chunk->start = start;
    chunk->samples = std::move(samples);
    m_chunks.push_back(std::move(chunk));
    m_filled = filled;
}

void ValueColumn::handOver(std::vector<Stretch> &to)
{
    assert(archivableChunks() > 0);
    const auto &samples = chunkOf(toArchive()).samples;
    to.push_back({{samples, reinterpret_cast<const std::byte *>(samples.get())}, kArchivedBytes});
    m_archived.handOver();
}

void ValueColumn::place(Index first, std::span<const Stretch> where)
{
    assert(where.size() == 1 && where[0].size == kArchivedBytes);
    if (first < m_begin)
        return;
    std::shared_ptr<Chunk> &old =
        m_chunks[static_cast<std::size_t>(first / kChunkSamples - m_released)];
    auto chunk = std::make_shared<Chunk>(*old); // copies of the column may be reading the old one
    chunk->samples = {where[0].data, reinterpret_cast<const Samples *>(where[0].data.get())};
    old = std::move(chunk);
    m_archived.place(first / kChunkSamples);
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
    const auto after = std::lower_bound(m_chunks.begin(), m_chunks.end(), time,
        [](const std::shared_ptr<Chunk> &chunk, Nanos wanted) { return chunk->start < wanted; });
    if (after == m_chunks.begin())
        return m_begin;
    // In the chunk before it, or right behind that.
    Index low = m_begin + static_cast<Index>(after - m_chunks.begin() - 1) * kChunkSamples;
    Index high = std::min(low + kChunkSamples, m_end);
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
    // Rounding keeps the order: the extremes of rounded values are the rounded extremes.
    const ValueRange range = valueExtremes(from, to);
    return {static_cast<float>(range.min), static_cast<float>(range.max)};
}

ValueRange ValueColumn::valueExtremes(Index from, Index to) const
{
    from = std::max(from, m_begin);
    to = std::min(to, m_end);
    ValueRange range;
    while (from < to) {
        if (from % kBlockSamples == 0 && from + kBlockSamples <= to) {
            range.include(blockExtremes(from));
            from += kBlockSamples;
        } else {
            range.include({at(from), at(from)});
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
    m_archived.release(m_released);
    m_begin = m_released * kChunkSamples;
    const std::size_t keep = runOf(m_begin);
    m_runs.erase(m_runs.begin(), m_runs.begin() + static_cast<std::ptrdiff_t>(keep));
    Run &front = m_runs.front();
    front.count -= m_begin - front.first;
    front.first = m_begin;
}

std::size_t ValueColumn::bytes() const
{
    return m_chunks.size() * sizeof(Chunk)
        + (m_chunks.size() - static_cast<std::size_t>(archivedChunks())) * kArchivedBytes
        + m_runs.capacity() * sizeof(Run);
}

} // namespace capture

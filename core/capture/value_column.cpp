#include "capture/value_column.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

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
    if (block + 1 == m_chunks.back()->ranges.size())
        for (const ValueRange &part : m_chunks.back()->ranges)
            m_chunks.back()->all.include(part);
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

namespace {
/// Index of the first of these rising times that is not before `time`. They begin before it and end at it or later.
/// @param guess  about where it is: found in a few steps from there
std::size_t firstFrom(std::span<const Nanos> times, Nanos time, std::size_t guess)
{
    std::size_t low = 0; // is before it
    std::size_t high = times.size() - 1; // is not
    const bool rises = times[guess] < time;
    (rises ? low : high) = guess;
    for (std::size_t reach = 1; reach < high - low; reach *= 4) {
        const std::size_t probe = rises ? low + reach : high - reach;
        const bool before = times[probe] < time;
        (before ? low : high) = probe;
        if (before != rises)
            break;
    }
    const auto first = times.begin() + static_cast<std::ptrdiff_t>(low + 1);
    const auto last = times.begin() + static_cast<std::ptrdiff_t>(high);
    return static_cast<std::size_t>(std::lower_bound(first, last, time) - times.begin());
}
} // namespace

Index ValueColumn::atOrAfter(Nanos time) const { return edge(time, m_begin, 0); }

Index ValueColumn::edge(Nanos time, Index low, Nanos tolerance) const
{
    if (low >= m_end)
        return m_end;
    // The last chunk that begins before it: most often the one that `low` is in, or its neighbour.
    const auto begins = [](const std::shared_ptr<Chunk> &chunk, Nanos wanted) {
        return chunk->start < wanted;
    };
    const auto here =
        m_chunks.begin() + static_cast<std::ptrdiff_t>(low / kChunkSamples - m_released);
    if (!begins(*here, time))
        return low;
    auto after = std::next(here);
    if (after != m_chunks.end() && begins(*after, time))
        after = std::lower_bound(std::next(after), m_chunks.end(), time, begins);
    const Index first =
        (m_released + static_cast<Index>(after - m_chunks.begin()) - 1) * kChunkSamples;
    const std::span<const Nanos> times = this->times(first);
    if (times.back() < time)
        return first + times.size();
    // Most values come at about equal steps.
    const double share = static_cast<double>(time - times.front())
        / static_cast<double>(times.back() - times.front());
    const auto guess = static_cast<std::size_t>(share * static_cast<double>(times.size() - 1));
    const std::size_t block = (guess + kBlockSamples / 2) / kBlockSamples * kBlockSamples;
    if (block < times.size() && std::abs(times[block] - time) <= tolerance)
        return std::max(low, first + block);
    return std::max(low, first + firstFrom(times, time, guess));
}

std::span<const Nanos> ValueColumn::times(Index index) const
{
    const std::size_t at = inChunk(index);
    const auto left = static_cast<std::size_t>(m_end - index);
    return std::span(chunkOf(index).samples->times).subspan(at, std::min(left, kChunkSamples - at));
}

std::span<const double> ValueColumn::values(Index index) const
{
    const std::size_t at = inChunk(index);
    const auto left = static_cast<std::size_t>(m_end - index);
    return std::span(chunkOf(index).samples->values)
        .subspan(at, std::min(left, kChunkSamples - at));
}

ValueRange ValueColumn::valueExtremes(Index from, Index to) const
{
    from = std::max(from, m_begin);
    to = std::min(to, m_end);
    ValueRange range;
    while (from < to) {
        const Chunk &chunk = chunkOf(from);
        std::size_t at = inChunk(from);
        const std::size_t end =
            at + static_cast<std::size_t>(std::min<Index>(to - from, kChunkSamples - at));
        from += end - at;
        if (at == 0 && end == kChunkSamples) {
            range.include(chunk.all);
            continue;
        }
        while (at < end) {
            if (at % kBlockSamples == 0 && at + kBlockSamples <= end) {
                range.include(chunk.ranges[at / kBlockSamples]);
                at += kBlockSamples;
            } else {
                const double value = chunk.samples->values[at++];
                range.include({value, value});
            }
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

#include "capture/value_column.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>

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
    if (m_broken || m_runs.empty()) {
        if (!m_runs.empty()) // what was given up holds no longer than until another one comes
            m_runs.back().holdUntil = std::min(m_runs.back().holdUntil, times.front());
        m_runs.push_back({m_end, 0, holdUntil});
    }
    m_broken = true; // memory may run out in the middle
    m_runs.back().holdUntil = holdUntil;
    for (std::size_t done = 0; done < times.size();) {
        const std::size_t at = inChunk(m_end);
        if (full())
            addChunk(times[done]);
        const std::size_t count = std::min(times.size() - done, kChunkSamples - at);
        std::copy_n(times.data() + done, count, m_filledTimes + at);
        std::copy_n(values.data() + done, count, m_filledValues + at);
        m_end += count;
        done += count;
        m_runs.back().count += count;
        m_lastTime = times[done - 1];
        for (std::size_t b = at / kBlockSamples; b < (at + count) / kBlockSamples; ++b)
            measure(b);
        if (full())
            settle();
    }
    m_broken = false;
}

void ValueColumn::measure(std::size_t block)
{
    ValueRange range;
    for (std::size_t i = block * kBlockSamples; i < (block + 1) * kBlockSamples; ++i)
        range.include({m_filledValues[i], m_filledValues[i]});
    m_filledRanges[block] = range;
}

void ValueColumn::addChunk(Nanos start)
{
    const std::shared_ptr<std::byte[]> samples(new std::byte[kChunkSamples * kMostSampleBytes]);
    const auto ranges = std::make_shared_for_overwrite<ValueRange[]>(kBlocks);
    Chunk &chunk = m_chunks.emplace_back();
    chunk.start = start;
    chunk.samples = {samples, samples.get()};
    chunk.ranges = ranges;
    m_sampleBytes += m_chunks.back().bytes();
    m_filledTimes = reinterpret_cast<Nanos *>(samples.get());
    m_filledValues = reinterpret_cast<double *>(m_filledTimes + kChunkSamples);
    m_filledRanges = ranges.get();
}

void ValueColumn::settle()
{
    Chunk &chunk = m_chunks.back();
    for (std::size_t b = 0; b < kBlocks; ++b) {
        chunk.coarse[b / kFanOut].include(m_filledRanges[b]);
        chunk.all.include(m_filledRanges[b]);
    }
    chunk.settled = true;
    Chunk settled = chunk;
    const Nanos step = m_filledTimes[1] - m_filledTimes[0];
    const auto differs = [step](Nanos a, Nanos b) { return b - a != step; };
    const std::span<const Nanos> times(m_filledTimes, kChunkSamples);
    const bool equal = std::ranges::adjacent_find(times, differs) == times.end();
    settled.step = equal ? step : 0;

    std::array<ValueTable::Code, kChunkSamples> codes{};
    const std::span<const double> values(m_filledValues, kChunkSamples);
    if (!m_table)
        m_table = std::make_shared<ValueTable>();
    settled.coded = m_table->encode(values, codes.data());
    if (settled.step != 0 || settled.coded) {
        const std::shared_ptr<std::byte[]> bytes(new std::byte[settled.bytes()]);
        std::byte *to = bytes.get();
        const auto put = [&to](const void *from, std::size_t size) {
            std::memcpy(to, from, size);
            to += size;
        };
        if (settled.step == 0)
            put(times.data(), times.size_bytes());
        if (settled.coded)
            put(codes.data(), sizeof(codes));
        else
            put(values.data(), values.size_bytes());
        settled.samples = {bytes, bytes.get()}; // copies of the column go on reading the others
    }
    m_sampleBytes -= chunk.bytes() - settled.bytes();
    chunk = std::move(settled);
}

std::uint64_t ValueColumn::archivableBytes() const
{
    std::uint64_t sum = 0;
    for (Index chunk = m_archived.handed(); chunk < m_end / kChunkSamples; ++chunk)
        sum += chunkOf(chunk * kChunkSamples).bytes();
    return sum;
}

void ValueColumn::handOver(std::vector<Stretch> &to)
{
    assert(toArchive() + kChunkSamples <= m_end);
    const Chunk &chunk = chunkOf(toArchive());
    to.push_back({chunk.samples, chunk.bytes()});
    m_archived.handOver();
}

void ValueColumn::place(Index first, std::span<const Stretch> where)
{
    if (first < begin())
        return;
    Chunk &chunk = m_chunks[static_cast<std::size_t>(first / kChunkSamples - m_released)];
    assert(where.size() == 1 && where[0].size == chunk.bytes());
    chunk.samples = where[0].data; // copies of the column have one of their own
    m_archivedBytes += chunk.bytes();
    m_archived.place(first / kChunkSamples);
}

void ValueColumn::extendHold(Nanos time)
{
    if (!m_broken && !m_runs.empty())
        m_runs.back().holdUntil = std::max(m_runs.back().holdUntil, time);
}

void ValueColumn::endHere()
{
    breakHere();
    if (m_runs.empty())
        return;
    Run &run = m_runs.back();
    const Nanos usual = run.count > 1 ? m_lastTime - timeOf(run.end() - 2) : 1;
    run.holdUntil = std::min(run.holdUntil, m_lastTime + usual);
}

std::size_t ValueColumn::pieceOf(Index index) const
{
    if (index < begin() || index >= m_end)
        return m_runs.size();
    const auto after = std::ranges::upper_bound(m_runs, index, {}, &Run::first);
    return static_cast<std::size_t>(after - m_runs.begin()) - 1;
}

Index ValueColumn::atOrAfter(Nanos time) const { return edge(time, begin(), 0); }

Index ValueColumn::edge(Nanos time, Index low, Nanos tolerance) const
{
    if (low >= m_end)
        return m_end;
    // The last chunk that begins before it: most often the one that `low` is in, or its neighbour.
    const auto begins = [](const Chunk &chunk, Nanos wanted) { return chunk.start < wanted; };
    const auto here =
        m_chunks.begin() + static_cast<std::ptrdiff_t>(low / kChunkSamples - m_released);
    if (!begins(*here, time))
        return low;
    auto after = std::next(here);
    if (after != m_chunks.end() && begins(*after, time))
        after = std::lower_bound(std::next(after), m_chunks.end(), time, begins);
    const Index first =
        (m_released + static_cast<Index>(after - m_chunks.begin()) - 1) * kChunkSamples;
    const auto count = static_cast<std::size_t>(std::min<Index>(m_end - first, kChunkSamples));
    return std::max(low, first + std::prev(after)->atOrAfter(time, count, tolerance));
}

/// As edge(), of a chunk that begins before `time` and holds `count`.
std::size_t ValueColumn::Chunk::atOrAfter(Nanos time, std::size_t count, Nanos tolerance) const
{
    const Nanos last = timeOf(count - 1);
    if (last < time)
        return count;
    std::size_t index = 0;
    if (step == 0) { // most values come at about equal steps
        const double share = static_cast<double>(time - start) / static_cast<double>(last - start);
        const auto guess = static_cast<std::size_t>(share * static_cast<double>(count - 1));
        index = 1 + lastThatBegins(0, std::max<std::size_t>(1, guess), count, [&](std::size_t i) {
            return times()[i] < time;
        });
    } else {
        index = static_cast<std::size_t>((time - start + step - 1) / step);
    }
    // Rounded from where it is, not from the guess, which is another one when there are more values.
    const std::size_t block = (index + kBlockSamples / 2) / kBlockSamples * kBlockSamples;
    return block < count && std::abs(timeOf(block) - time) <= tolerance ? block : index;
}

ValueRange ValueColumn::extremes(Index from, Index to) const
{
    from = std::max(from, begin());
    to = std::min(to, m_end);
    ValueRange range;
    while (from < to) {
        const std::size_t at = inChunk(from);
        const auto count = static_cast<std::size_t>(std::min<Index>(to - from, kChunkSamples - at));
        range.include(rangeIn(chunkOf(from), at, at + count));
        from += count;
    }
    return range;
}

ValueRange ValueColumn::rangeIn(const Chunk &chunk, std::size_t from, std::size_t to) const
{
    if (to - from == kChunkSamples && chunk.settled)
        return chunk.all;
    ValueRange range;
    const auto read = [&](std::size_t until) {
        for (; from < until; ++from) {
            const double value = valueIn(chunk, from);
            range.include({value, value});
        }
    };
    const std::size_t low = (from + kBlockSamples - 1) / kBlockSamples;
    const std::size_t high = to / kBlockSamples;
    if (low < high) {
        read(low * kBlockSamples);
        for (std::size_t block = low; block < high;) {
            const bool coarse = chunk.settled && block % kFanOut == 0 && block + kFanOut <= high;
            range.include(coarse ? chunk.coarse[block / kFanOut]
                                 : chunk.ranges[static_cast<std::ptrdiff_t>(block)]);
            block += coarse ? kFanOut : 1;
        }
        from = high * kBlockSamples;
    }
    read(to);
    return range;
}

void ValueColumn::releaseOldest()
{
    if (!canRelease())
        return;
    const std::size_t bytes = m_chunks.front().bytes();
    m_sampleBytes -= bytes;
    if (m_archived.placedFrom(m_released) > 0)
        m_archivedBytes -= bytes;
    m_chunks.pop_front();
    ++m_released;
    m_archived.release(m_released);
    const std::size_t keep = pieceOf(begin());
    m_runs.erase(m_runs.begin(), m_runs.begin() + static_cast<std::ptrdiff_t>(keep));
    Run &front = m_runs.front();
    front.count -= begin() - front.first;
    front.first = begin();
}

std::size_t ValueColumn::bytes() const
{
    return m_chunks.size() * (sizeof(Chunk) + kBlocks * sizeof(ValueRange))
        + (m_table ? m_table->bytes() : 0) + m_sampleBytes - m_archivedBytes
        + m_runs.capacity() * sizeof(Run);
}

} // namespace capture

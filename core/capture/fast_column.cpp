#include "capture/fast_column.h"

#include <cassert>
#include <cstring>

namespace capture {

namespace {

/// Extremes of some entries: minima and maxima lie side by side, so both are taken of all, and half of each counts.
CodeRange extremesOfAll(const CodeRange *entries, std::size_t count)
{
#ifdef __SSE2__
    static_assert(sizeof(CodeRange) == 2 * sizeof(std::int16_t));
    constexpr std::size_t kInOne = 4; // entries in a register
    if (count >= kInOne) {
        const auto load = [entries](std::size_t at) {
            return _mm_loadu_si128(reinterpret_cast<const __m128i *>(entries + at));
        };
        // May overlap what comes: harmless, and no odd end is left.
        __m128i low = load(count - kInOne);
        __m128i high = low;
        for (std::size_t i = 0; i + kInOne < count; i += kInOne) {
            const __m128i next = load(i);
            low = _mm_min_epi16(low, next);
            high = _mm_max_epi16(high, next);
        }
        low = _mm_min_epi16(low, _mm_shuffle_epi32(low, _MM_SHUFFLE(1, 0, 3, 2)));
        low = _mm_min_epi16(low, _mm_shuffle_epi32(low, _MM_SHUFFLE(2, 3, 0, 1)));
        high = _mm_max_epi16(high, _mm_shuffle_epi32(high, _MM_SHUFFLE(1, 0, 3, 2)));
        high = _mm_max_epi16(high, _mm_shuffle_epi32(high, _MM_SHUFFLE(2, 3, 0, 1)));
        return {static_cast<std::int16_t>(_mm_extract_epi16(low, 0)),
            static_cast<std::int16_t>(_mm_extract_epi16(high, 1))};
    }
#endif
    CodeRange range = CodeRange::nothing();
    for (std::size_t i = 0; i < count; ++i)
        range.include(entries[i]);
    return range;
}

#ifdef __SSE2__
constexpr std::size_t kTogether = 4;

/// Of four registers with eight codes each, what `pick` leaves of each, side by side in the lower half of one: the four
/// are interleaved, so that one `pick` halves them all.
template <class Pick>
__m128i reduceFour(const __m128i *of, Pick pick)
{
    const auto words = [pick](__m128i a, __m128i b) {
        return pick(_mm_unpacklo_epi16(a, b), _mm_unpackhi_epi16(a, b));
    };
    const __m128i first = words(of[0], of[1]);
    const __m128i second = words(of[2], of[3]);
    const __m128i all = pick(_mm_unpacklo_epi32(first, second), _mm_unpackhi_epi32(first, second));
    return pick(all, _mm_unpackhi_epi64(all, all));
}

/// Copies four times sixteen codes and takes their extremes: the inner loop of every append. Both in one go takes half
/// the time of memcpy() and another look at what it copied.
void copy4Times16(const std::int16_t *codes, std::int16_t *to, CodeRange *extremes)
{
    __m128i low[kTogether];
    __m128i high[kTogether];
    for (std::size_t i = 0; i < kTogether; ++i) {
        const __m128i a = sse::load(codes + 16 * i);
        const __m128i b = sse::load(codes + 16 * i + 8);
        _mm_storeu_si128(reinterpret_cast<__m128i *>(to + 16 * i), a);
        _mm_storeu_si128(reinterpret_cast<__m128i *>(to + 16 * i + 8), b);
        low[i] = _mm_min_epi16(a, b);
        high[i] = _mm_max_epi16(a, b);
    }
    const __m128i mins = reduceFour(low, [](__m128i a, __m128i b) { return _mm_min_epi16(a, b); });
    const __m128i maxs = reduceFour(high, [](__m128i a, __m128i b) { return _mm_max_epi16(a, b); });
    _mm_storeu_si128(reinterpret_cast<__m128i *>(extremes), _mm_unpacklo_epi16(mins, maxs));
}
#endif

} // namespace

Index Segment::atOrAfter(Nanos time) const
{
    if (count == 0 || time <= start())
        return first;
    const double guess = static_cast<double>(time - start()) / stepNanos();
    if (guess >= static_cast<double>(count) + 1.0)
        return end();
    // The estimate can be one off by rounding: the integer times decide.
    Index index = std::min(end(), first + static_cast<Index>(guess));
    while (index > first && timeOf(index - 1) >= time)
        --index;
    while (index < end() && timeOf(index) < time)
        ++index;
    return index;
}

void FastColumn::fill(const std::int16_t *codes, std::size_t from, std::size_t to)
{
    std::size_t low = from / kFanOut;
    std::size_t high = to / kFanOut;
    // Copies: what the wide stores write might be the members, for all the compiler knows.
    std::int16_t *samples = m_filledSamples;
    CodeRange *ranges = m_filledRanges;
    std::size_t i = (from + kFanOut - 1) / kFanOut;
#ifdef __SSE2__
    if (high >= i + kTogether) {
        // Of a fixed size, which makes no call: two of memcpy() for what is less than a group at both ends take longer
        // than all between them where it is one of AVX-512.
        const auto copyGroup = [&](std::size_t at) {
            std::memcpy(samples + at, codes + (at - from), kFanOut * sizeof(std::int16_t));
        };
        const bool opened = i != low;
        copyGroup(from);
        for (; i + kTogether <= high; i += kTogether)
            copy4Times16(codes + (i * kFanOut - from), samples + i * kFanOut, ranges + i);
        if (i != high) {
            i = high - kTogether; // some of the last four a second time: cheaper than one at a time
            copy4Times16(codes + (i * kFanOut - from), samples + i * kFanOut, ranges + i);
        }
        copyGroup(to - kFanOut);
        if (opened) // not before: a wide load of what narrow stores have just written waits for them
            ranges[low] = extremesOf(samples + low * kFanOut, kFanOut);
    } else
#endif
    {
        std::memcpy(samples + from, codes, (to - from) * sizeof(std::int16_t));
        for (i = low; i < high; ++i)
            ranges[i] = extremesOf(samples + i * kFanOut, kFanOut);
    }
    const CodeRange *finer = ranges;
    for (std::size_t level = 1; level < kLevels && high > low; ++level) {
        low /= kFanOut;
        high /= kFanOut;
        CodeRange *entries = &m_chunks.back()->coarser[kLevelStart[level - 1]];
        for (i = low; i < high; ++i)
            entries[i] = extremesOfAll(finer + i * kFanOut, kFanOut);
        finer = entries;
    }
}

CodeRange FastColumn::Chunk::extremes(std::size_t from, std::size_t to) const
{
    // Climb: at each level only the ragged ends are read, the aligned middle is left to the next level. A few entries
    // are read as they are: ends of varying length, each guessed wrong by the processor, cost more.
    constexpr std::size_t kFew = 128;
    static_assert(kSliceSamples >> 4 * kLevels <= kFew, "the top level ends the climb");
    std::size_t low = (from + kFanOut - 1) / kFanOut;
    std::size_t high = to / kFanOut;
    if (low >= high)
        return extremesOf(&samples[from], to - from);
    CodeRange range = extremesOf(&samples[from], low * kFanOut - from);
    range.include(extremesOf(&samples[high * kFanOut], to - high * kFanOut));
    for (std::size_t level = 0;; ++level) {
        const CodeRange *entries = this->level(level);
        const std::size_t lowUp = (low + kFanOut - 1) / kFanOut;
        const std::size_t highUp = high / kFanOut;
        const bool last = high - low <= kFew;
        range.include(extremesOfAll(entries + low, (last ? high : lowUp * kFanOut) - low));
        if (last)
            return range;
        range.include(extremesOfAll(entries + highUp * kFanOut, high - highUp * kFanOut));
        low = lowUp;
        high = highUp;
    }
}

void FastColumn::append(
    const TickBase &base, Tick tick, std::uint32_t step, std::span<const std::int16_t> codes)
{
    if (codes.empty())
        return;
    const bool follows = !m_broken && !m_segments.empty() && m_segments.back().base == base
        && m_segments.back().step == step && m_segments.back().tickOf(m_end) == tick;
    if (m_end - m_begin == m_chunks.size() * kChunkSamples)
        addChunk(); // first, so that no segment stays empty where there is no memory for it
    if (!follows)
        m_segments.push_back({m_end, 0, tick, step, base});
    m_broken = true; // memory may run out in the middle
    appendCodes(codes);
    m_broken = false;
}

void FastColumn::appendCodes(std::span<const std::int16_t> codes)
{
    while (!codes.empty()) {
        const std::size_t used = inChunk(m_end);
        if (m_end - m_begin == m_chunks.size() * kChunkSamples)
            addChunk();
        const std::size_t count = std::min(codes.size(), kChunkSamples - used);
        fill(codes.data(), used, used + count);
        m_end += count;
        m_segments.back().count += count;
        codes = codes.subspan(count);
    }
}

void FastColumn::addChunk()
{
    if (!m_memory)
        m_memory = std::make_shared<SampleMemory>();
    const Slice samples = m_memory->take();
    const RangeSlice ranges = m_memory->takeRanges();
    auto chunk = std::make_shared_for_overwrite<Chunk>();
    chunk->samples = samples;
    chunk->finest = ranges;
    m_chunks.push_back(std::move(chunk));
    m_filledSamples = samples.get();
    m_filledRanges = ranges.get();
}

void FastColumn::handOver(std::vector<Stretch> &to)
{
    assert(archivableBytes() > 0);
    const Chunk &chunk = chunkOf(toArchive());
    const auto bytesOf = [](const auto &part) {
        return std::shared_ptr<const std::byte>(
            part, reinterpret_cast<const std::byte *>(part.get()));
    };
    to.push_back({bytesOf(chunk.samples), kSliceBytes});
    to.push_back({bytesOf(chunk.finest), kSliceRanges * sizeof(CodeRange)});
    m_archived.handOver();
}

void FastColumn::place(Index first, std::span<const Stretch> where)
{
    assert(where.size() == 2 && where[0].size == kSliceBytes);
    if (first < m_begin)
        return;
    const auto partOf = [&where]<class Entry>(std::size_t i, const Entry *) {
        const Stretch &part = where[i];
        return std::shared_ptr<const Entry[]>(
            part.data, reinterpret_cast<const Entry *>(part.data.get()));
    };
    std::shared_ptr<Chunk> &old = m_chunks[chunkAt(first)];
    // Another one with the same extremes: copies of the column may be reading the old one.
    auto chunk = std::make_shared<Chunk>(*old);
    chunk->samples = partOf(0, static_cast<const std::int16_t *>(nullptr));
    chunk->finest = partOf(1, static_cast<const CodeRange *>(nullptr));
    old = std::move(chunk);
    m_archived.place(first / kChunkSamples);
}

std::int16_t FastColumn::at(Index index) const
{
    assert(index >= m_begin && index < m_end);
    return chunkOf(index).samples[inChunk(index)];
}

std::span<const std::int16_t> FastColumn::codes(Index index, std::size_t limit) const
{
    if (index < m_begin || index >= m_end)
        return {};
    const std::size_t at = inChunk(index);
    const auto left = static_cast<std::size_t>(m_end - index);
    return {&chunkOf(index).samples[at], std::min({limit, kChunkSamples - at, left})};
}

CodeRange FastColumn::blockExtremes(Index index) const
{
    static_assert(kBlockSamples == kFanOut * kFanOut, "an entry of the second level");
    assert(index % kBlockSamples == 0 && index >= m_begin && index + kBlockSamples <= m_end);
    return chunkOf(index).level(1)[inChunk(index) / kBlockSamples];
}

CodeRange FastColumn::extremes(Index from, Index to) const
{
    from = std::max(from, m_begin);
    to = std::min(to, m_end);
    CodeRange range = CodeRange::nothing();
    while (from < to) {
        const std::size_t at = inChunk(from);
        const auto count = static_cast<std::size_t>(std::min<Index>(to - from, kChunkSamples - at));
        range.include(chunkOf(from).extremes(at, at + count));
        from += count;
    }
    return range;
}

std::size_t FastColumn::pieceOf(Index index) const
{
    if (index < m_begin || index >= m_end)
        return m_segments.size();
    const auto after = std::ranges::upper_bound(m_segments, index, {}, &Segment::first);
    return static_cast<std::size_t>(after - m_segments.begin()) - 1;
}

Index FastColumn::atOrAfter(Nanos time) const
{
    const auto after = std::ranges::upper_bound(m_segments, time, {}, &Segment::start);
    if (after == m_segments.begin())
        return m_begin;
    return std::max(m_begin, std::prev(after)->atOrAfter(time));
}

/// To the segment that `wanted` is in, from where the walk is: edges are asked for in rising order.
void FastColumn::seek(Nanos wanted, Walk &walk) const
{
    const std::size_t low = lastThatBegins(walk.segment, walk.stride, m_segments.size(),
        [&](std::size_t segment) { return m_segments[segment].start() <= wanted; });
    walk.stride = std::max<std::size_t>(1, low - walk.segment);
    const Segment &here = m_segments[low];
    const bool last = low + 1 == m_segments.size();
    walk.segment = low;
    walk.known = true;
    walk.start = here.start();
    walk.next = last ? std::numeric_limits<Nanos>::max() : m_segments[low + 1].start();
    walk.perNano = 1.0 / here.stepNanos();
    // A segment at another rate has other blocks: as many samples may be many slices there.
    const double density = walk.width * walk.perNano;
    walk.block = 1;
    while (walk.block < kChunkSamples && static_cast<double>(walk.block) * 8 * kFanOut <= density)
        walk.block *= kFanOut;
}

/// Index of the first sample from `wanted` on, rounded to a multiple of the walk's block inside its
/// segment.
Index FastColumn::edge(Nanos wanted, Walk &walk) const
{
    if (!walk.known || wanted >= walk.next)
        seek(wanted, walk);
    const Segment &here = m_segments[walk.segment];
    const std::uint64_t block = walk.block;
    if (block == 1)
        return std::max(here.atOrAfter(wanted), m_begin);
    // An estimate may be one sample off, which the rounding below makes nothing of.
    const double after = static_cast<double>(wanted - walk.start) * walk.perNano;
    if (!(after > 0.0))
        return std::max(here.first, m_begin);
    if (after > static_cast<double>(here.count) - 0.5) // behind the last sample
        return here.end();
    const Index index = here.first + static_cast<Index>(after);
    const Index rounded = (index + block / 2) & ~(block - 1); // a power of two
    return std::clamp(rounded, std::max(here.first, m_begin), here.end());
}

void FastColumn::releaseOldest()
{
    if (!canRelease())
        return;
    m_chunks.pop_front();
    m_begin += kChunkSamples;
    m_archived.release(m_begin / kChunkSamples);
    const std::size_t keep = pieceOf(m_begin);
    m_segments.erase(m_segments.begin(), m_segments.begin() + static_cast<std::ptrdiff_t>(keep));
    Segment &front = m_segments.front();
    front.firstTick = front.tickOf(m_begin);
    front.count -= m_begin - front.first;
    front.first = m_begin;
}

std::size_t FastColumn::bytes() const
{
    return m_chunks.size() * sizeof(Chunk) + m_chunks.size() * kArchivedBytes
        - static_cast<std::size_t>(archivedBytes()) + m_segments.capacity() * sizeof(Segment);
}

} // namespace capture

#include "mcp/deinterleave.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mcp {

namespace {

std::int16_t sampleAt(const std::uint8_t *from)
{
    return static_cast<std::int16_t>(from[0] | from[1] << 8);
}

/// Signal after signal from interleaved blocks. The number of signals is a constant in the usual cases, so that the
/// compiler can use wide loads.
template <std::size_t Signals>
void gather(const std::uint8_t *from, std::size_t blocks, std::int16_t *to, std::size_t pitch)
{
    for (std::size_t s = 0; s < Signals; ++s) {
        std::int16_t *out = to + s * pitch;
        const std::uint8_t *in = from + 2 * s;
        for (std::size_t i = 0; i < blocks; ++i)
            out[i] = sampleAt(in + 2 * Signals * i);
    }
}

void gatherAny(const std::uint8_t *from, std::size_t signals, std::size_t blocks, std::int16_t *to,
    std::size_t pitch)
{
    for (std::size_t s = 0; s < signals; ++s)
        for (std::size_t i = 0; i < blocks; ++i)
            to[s * pitch + i] = sampleAt(from + 2 * (signals * i + s));
}

#ifdef __SSE2__

__m128i load(const std::uint8_t *from)
{
    return _mm_loadu_si128(reinterpret_cast<const __m128i *>(from));
}

void storeLow(std::int16_t *to, __m128i value)
{
    _mm_storel_epi64(reinterpret_cast<__m128i *>(to), value);
}

void storeHigh(std::int16_t *to, __m128i value) { storeLow(to, _mm_unpackhi_epi64(value, value)); }

/// Four blocks of eight signals: a transposition in three steps, two columns of four in each register at its end.
void transpose8x4(const std::uint8_t *from, std::int16_t *to, std::size_t pitch)
{
    const __m128i row0 = load(from);
    const __m128i row1 = load(from + 16);
    const __m128i row2 = load(from + 32);
    const __m128i row3 = load(from + 48);
    const __m128i low01 = _mm_unpacklo_epi16(row0, row1);
    const __m128i high01 = _mm_unpackhi_epi16(row0, row1);
    const __m128i low23 = _mm_unpacklo_epi16(row2, row3);
    const __m128i high23 = _mm_unpackhi_epi16(row2, row3);
    const __m128i columns[] = {_mm_unpacklo_epi32(low01, low23), _mm_unpackhi_epi32(low01, low23),
        _mm_unpacklo_epi32(high01, high23), _mm_unpackhi_epi32(high01, high23)};
    for (std::size_t pair = 0; pair < 4; ++pair) {
        storeLow(to + 2 * pair * pitch, columns[pair]);
        storeHigh(to + (2 * pair + 1) * pitch, columns[pair]);
    }
}

/// Four blocks of four signals.
void transpose4x4(const std::uint8_t *from, std::int16_t *to, std::size_t pitch)
{
    const __m128i rows01 = load(from);
    const __m128i rows23 = load(from + 16);
    const __m128i even = _mm_unpacklo_epi16(rows01, _mm_unpackhi_epi64(rows01, rows01));
    const __m128i odd = _mm_unpacklo_epi16(rows23, _mm_unpackhi_epi64(rows23, rows23));
    const __m128i first = _mm_unpacklo_epi32(even, odd);
    const __m128i second = _mm_unpackhi_epi32(even, odd);
    storeLow(to, first);
    storeHigh(to + pitch, first);
    storeLow(to + 2 * pitch, second);
    storeHigh(to + 3 * pitch, second);
}

void gather8(const std::uint8_t *from, std::size_t blocks, std::int16_t *to, std::size_t pitch)
{
    std::size_t i = 0;
    for (; i + 4 <= blocks; i += 4)
        transpose8x4(from + 16 * i, to + i, pitch);
    gather<8>(from + 16 * i, blocks - i, to + i, pitch);
}

void gather4(const std::uint8_t *from, std::size_t blocks, std::int16_t *to, std::size_t pitch)
{
    std::size_t i = 0;
    for (; i + 4 <= blocks; i += 4)
        transpose4x4(from + 8 * i, to + i, pitch);
    gather<4>(from + 8 * i, blocks - i, to + i, pitch);
}

#endif // __SSE2__

} // namespace

void deinterleavePortable(const std::uint8_t *from, std::size_t signals, std::size_t blocks,
    std::int16_t *to, std::size_t pitch)
{
    switch (signals) {
    case 1:
        return gather<1>(from, blocks, to, pitch);
    case 2:
        return gather<2>(from, blocks, to, pitch);
    case 3:
        return gather<3>(from, blocks, to, pitch);
    case 4:
        return gather<4>(from, blocks, to, pitch);
    case 5:
        return gather<5>(from, blocks, to, pitch);
    case 6:
        return gather<6>(from, blocks, to, pitch);
    case 8:
        return gather<8>(from, blocks, to, pitch);
    default:
        return gatherAny(from, signals, blocks, to, pitch);
    }
}

void deinterleave(const std::uint8_t *from, std::size_t signals, std::size_t blocks,
    std::int16_t *to, std::size_t pitch)
{
#ifdef __SSE2__
    if (signals == 4)
        return gather4(from, blocks, to, pitch);
    if (signals == 8)
        return gather8(from, blocks, to, pitch);
#endif
    deinterleavePortable(from, signals, blocks, to, pitch);
}

} // namespace mcp

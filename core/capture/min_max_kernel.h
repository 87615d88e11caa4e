// Extremes of a run of 16-bit codes. SSE2 is part of every x86-64; elsewhere the plain loop does
// the same.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace capture {

/// Smallest and largest code. Without an initial value on purpose: arrays of it are filled as they
/// are reached.
struct CodeRange {
    std::int16_t min;
    std::int16_t max;

    static constexpr CodeRange nothing()
    {
        return {std::numeric_limits<std::int16_t>::max(), std::numeric_limits<std::int16_t>::min()};
    }
    bool empty() const { return min > max; }
    void include(CodeRange other)
    {
        min = std::min(min, other.min);
        max = std::max(max, other.max);
    }
};

inline CodeRange extremesOfPlain(const std::int16_t *codes, std::size_t count)
{
    CodeRange range = CodeRange::nothing();
    for (std::size_t i = 0; i < count; ++i)
        range.include({codes[i], codes[i]});
    return range;
}

#ifdef __SSE2__
namespace sse {
inline __m128i load(const std::int16_t *codes)
{
    return _mm_loadu_si128(reinterpret_cast<const __m128i *>(codes));
}
inline CodeRange reduce(__m128i low, __m128i high)
{
    // Three halvings, minimum and maximum side by side.
    low = _mm_min_epi16(low, _mm_shuffle_epi32(low, _MM_SHUFFLE(1, 0, 3, 2)));
    high = _mm_max_epi16(high, _mm_shuffle_epi32(high, _MM_SHUFFLE(1, 0, 3, 2)));
    low = _mm_min_epi16(low, _mm_shufflelo_epi16(low, _MM_SHUFFLE(1, 0, 3, 2)));
    high = _mm_max_epi16(high, _mm_shufflelo_epi16(high, _MM_SHUFFLE(1, 0, 3, 2)));
    low = _mm_min_epi16(low, _mm_shufflelo_epi16(low, _MM_SHUFFLE(2, 3, 0, 1)));
    high = _mm_max_epi16(high, _mm_shufflelo_epi16(high, _MM_SHUFFLE(2, 3, 0, 1)));
    return {static_cast<std::int16_t>(_mm_extract_epi16(low, 0)),
        static_cast<std::int16_t>(_mm_extract_epi16(high, 0))};
}
} // namespace sse

inline CodeRange extremesOf(const std::int16_t *codes, std::size_t count)
{
    if (count < 8)
        return extremesOfPlain(codes, count);
    __m128i low = sse::load(codes);
    __m128i high = low;
    for (std::size_t i = 8; i + 8 <= count; i += 8) {
        const __m128i next = sse::load(codes + i);
        low = _mm_min_epi16(low, next);
        high = _mm_max_epi16(high, next);
    }
    const __m128i tail = sse::load(codes + count - 8); // may overlap what was seen: harmless
    return sse::reduce(_mm_min_epi16(low, tail), _mm_max_epi16(high, tail));
}
#else
inline CodeRange extremesOf(const std::int16_t *codes, std::size_t count)
{
    return extremesOfPlain(codes, count);
}
#endif

} // namespace capture

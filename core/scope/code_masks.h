// Which of sixteen neighbouring codes lie in a half-line, as bits: a search then goes from one change to the next with
// a count of zeros, where asking code by code guesses wrong at each change. SSE2 is part of every x86-64; elsewhere
// the plain loop does the same.
#pragma once

#include "scope/level_crossing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace scope {

constexpr std::size_t kMaskedCodes = 16;

/// Asks for one half-line again and again.
class CodeMask {
public:
    explicit CodeMask(const Half<std::int32_t> &half)
        : m_up(half.up)
        , m_none(half.up ? half.bound > kMost : half.bound < kLeast)
        , m_bound(static_cast<std::int16_t>(std::clamp(half.bound, kLeast, kMost)))
    {
    }

    /// Bit i is set if codes[i] is in it. @param codes  kMaskedCodes of them
    std::uint32_t of(const std::int16_t *codes) const
    {
        if (m_none)
            return 0;
#ifdef __SSE2__
        const __m128i bound = _mm_set1_epi16(m_bound);
        const auto inside = [this, bound](const std::int16_t *eight) {
            const __m128i values = _mm_loadu_si128(reinterpret_cast<const __m128i *>(eight));
            return _mm_cmpeq_epi16(
                values, m_up ? _mm_max_epi16(values, bound) : _mm_min_epi16(values, bound));
        };
        return static_cast<std::uint32_t>(
            _mm_movemask_epi8(_mm_packs_epi16(inside(codes), inside(codes + 8))));
#else
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < kMaskedCodes; ++i)
            bits |= std::uint32_t{m_up ? codes[i] >= m_bound : codes[i] <= m_bound} << i;
        return bits;
#endif
    }

private:
    static constexpr std::int32_t kLeast = -32768;
    static constexpr std::int32_t kMost = 32767;

    bool m_up;
    bool m_none; ///< it lies where there are no codes
    std::int16_t m_bound;
};

} // namespace scope

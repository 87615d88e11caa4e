// Which of sixteen neighbouring codes lie in a half-line, as bits: a search then goes from one change to the next with
// a count of zeros, where asking code by code guesses wrong at each change. SSE2 is part of every x86-64; elsewhere
// the plain loop does the same.
#pragma once

#include "scope/level_crossing.h"

#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace scope {

constexpr std::size_t kMaskedCodes = 16;
constexpr std::uint32_t kEachMasked = (std::uint32_t{1} << kMaskedCodes) - 1;

/// Bit i is set if codes[i] is in the half-line. @param codes  kMaskedCodes of them
inline std::uint32_t maskOf(const Half<std::int32_t> &half, const std::int16_t *codes)
{
    const auto below = static_cast<std::int16_t>(half.bound - (half.up ? 1 : 0));
    std::uint32_t bits = 0; // of the codes above that one
#ifdef __SSE2__
    const auto above = [bound = _mm_set1_epi16(below)](const std::int16_t *eight) {
        return _mm_cmpgt_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i *>(eight)), bound);
    };
    bits = static_cast<std::uint32_t>(
        _mm_movemask_epi8(_mm_packs_epi16(above(codes), above(codes + 8))));
#else
    for (std::size_t i = 0; i < kMaskedCodes; ++i)
        bits |= std::uint32_t{codes[i] > below} << i;
#endif
    return half.up ? bits : bits ^ kEachMasked;
}

} // namespace scope

#include "base/crc_folding.h"

#include <algorithm>
#include <cassert>

#if (defined(__x86_64__) || defined(__i386__)) && (defined(__GNUC__) || defined(__clang__))
#define ROTORSCOPE_CAN_FOLD 1
#include <immintrin.h>
#endif

#ifdef ROTORSCOPE_CAN_FOLD

namespace {

/// x^n modulo the generator x^16 + x^12 + x^5 + 1.
constexpr long long powerOfX(unsigned n)
{
    std::uint32_t rest = 1;
    for (; n > 0; --n)
        rest = (rest & 0x8000U) != 0 ? (rest << 1 ^ 0x1021U) & 0xFFFFU : rest << 1;
    return rest;
}

/// Sixteen bytes as a polynomial: the first byte has the highest powers.
__attribute__((target("pclmul,ssse3"))) inline __m128i load(const std::uint8_t *bytes)
{
    const __m128i order = _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return _mm_shuffle_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i *>(bytes)), order);
}

/// `value` times a power of x, as far as the generator is concerned.
/// @param factors  the power in the low half, the power times x^64 in the high half
__attribute__((target("pclmul,ssse3"))) inline __m128i shifted(__m128i value, __m128i factors)
{
    return _mm_xor_si128(
        _mm_clmulepi64_si128(value, factors, 0x11), _mm_clmulepi64_si128(value, factors, 0x00));
}

} // namespace

bool canFoldCrc16()
{
    static const bool can =
        __builtin_cpu_supports("pclmul") != 0 && __builtin_cpu_supports("ssse3") != 0;
    return can;
}

/// Four sums side by side, so that no multiplication waits for the one before it.
__attribute__((target("pclmul,ssse3"))) Folded foldForCrc16(ByteView bytes)
{
    constexpr std::size_t kStep = 64;
    assert(bytes.size() >= kStep);
    // Zeros in front change nothing, as the CRC begins at 0; bytes left over behind would have to go one at a time.
    const std::size_t odd = bytes.size() % kStep;
    std::array<std::uint8_t, kStep> filled{};
    std::copy_n(bytes.begin(), odd, filled.end() - static_cast<std::ptrdiff_t>(odd));
    const std::uint8_t *at = odd != 0 ? filled.data() : bytes.data();
    const std::uint8_t *const end = bytes.data() + bytes.size();
    __m128i a = load(at);
    __m128i b = load(at + 16);
    __m128i c = load(at + 32);
    __m128i d = load(at + 48);
    const __m128i by512 = _mm_set_epi64x(powerOfX(512 + 64), powerOfX(512));
    for (at = bytes.data() + (odd != 0 ? odd : kStep); at != end; at += kStep) {
        a = _mm_xor_si128(shifted(a, by512), load(at));
        b = _mm_xor_si128(shifted(b, by512), load(at + 16));
        c = _mm_xor_si128(shifted(c, by512), load(at + 32));
        d = _mm_xor_si128(shifted(d, by512), load(at + 48));
    }
    const __m128i by128 = _mm_set_epi64x(powerOfX(128 + 64), powerOfX(128));
    b = _mm_xor_si128(shifted(a, by128), b);
    c = _mm_xor_si128(shifted(b, by128), c);
    d = _mm_xor_si128(shifted(c, by128), d);
    const __m128i order = _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    Folded folded{};
    _mm_storeu_si128(reinterpret_cast<__m128i *>(folded.data()), _mm_shuffle_epi8(d, order));
    return folded;
}

#else

bool canFoldCrc16() { return false; }

Folded foldForCrc16(ByteView)
{
    assert(false);
    return {};
}

#endif

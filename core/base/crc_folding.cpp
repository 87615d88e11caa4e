#include "base/crc_folding.h"

#include <algorithm>
#include <cassert>
#include <utility>

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

/// What multiplies by x^n: the power in the low half, the power times x^64 in the high half.
template <unsigned n>
__attribute__((target("pclmul,ssse3"))) inline __m128i factors()
{
    constexpr long long low = powerOfX(n);
    constexpr long long high = powerOfX(n + 64);
    return _mm_set_epi64x(high, low);
}

__attribute__((target("pclmul,ssse3"))) inline __m128i reversed(__m128i bytes)
{
    return _mm_shuffle_epi8(
        bytes, _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
}

/// Sixteen bytes as a polynomial: the first byte has the highest powers.
__attribute__((target("pclmul,ssse3"))) inline __m128i load(const std::uint8_t *bytes)
{
    return reversed(_mm_loadu_si128(reinterpret_cast<const __m128i *>(bytes)));
}

/// `value` times a power of x, as far as the generator is concerned.
/// @param by  factors()
__attribute__((target("pclmul,ssse3"))) inline __m128i shifted(__m128i value, __m128i by)
{
    return _mm_xor_si128(
        _mm_clmulepi64_si128(value, by, 0x11), _mm_clmulepi64_si128(value, by, 0x00));
}

/// Two times sixteen bytes, each as above.
__attribute__((target("vpclmulqdq,avx2"))) inline __m256i loadTwo(const std::uint8_t *bytes)
{
    const __m128i order = _mm_set_epi8(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return _mm256_shuffle_epi8(_mm256_loadu_si256(reinterpret_cast<const __m256i *>(bytes)),
        _mm256_broadcastsi128_si256(order));
}

__attribute__((target("vpclmulqdq,avx2"))) inline __m256i shiftedTwo(__m256i values, __m256i by)
{
    return _mm256_xor_si256(
        _mm256_clmulepi64_epi128(values, by, 0x11), _mm256_clmulepi64_epi128(values, by, 0x00));
}

/// Zeros in front change nothing, as the CRC begins at 0; bytes left over behind would have to go one at a time.
/// @param filled  takes what is odd in front of the whole steps
/// @return where the first step begins, and the second
template <std::size_t kStep>
std::pair<const std::uint8_t *, const std::uint8_t *> firstSteps(
    ByteView bytes, std::array<std::uint8_t, kStep> &filled)
{
    assert(bytes.size() >= kStep);
    const std::size_t odd = bytes.size() % kStep;
    if (odd == 0)
        return {bytes.data(), bytes.data() + kStep};
    std::copy_n(bytes.begin(), odd, filled.end() - static_cast<std::ptrdiff_t>(odd));
    return {filled.data(), bytes.data() + odd};
}

__attribute__((target("pclmul,ssse3"))) Folded stored(__m128i value)
{
    Folded folded{};
    _mm_storeu_si128(reinterpret_cast<__m128i *>(folded.data()), reversed(value));
    return folded;
}

/// Four sums side by side, so that no multiplication waits for the one before it.
__attribute__((target("pclmul,ssse3"))) Folded foldBy16(ByteView bytes)
{
    constexpr std::size_t kStep = 64;
    std::array<std::uint8_t, kStep> filled{};
    auto [first, at] = firstSteps(bytes, filled);
    __m128i a = load(first);
    __m128i b = load(first + 16);
    __m128i c = load(first + 32);
    __m128i d = load(first + 48);
    const __m128i by512 = factors<512>();
    for (const std::uint8_t *const end = bytes.data() + bytes.size(); at != end; at += kStep) {
        a = _mm_xor_si128(shifted(a, by512), load(at));
        b = _mm_xor_si128(shifted(b, by512), load(at + 16));
        c = _mm_xor_si128(shifted(c, by512), load(at + 32));
        d = _mm_xor_si128(shifted(d, by512), load(at + 48));
    }
    const __m128i by128 = factors<128>();
    b = _mm_xor_si128(shifted(a, by128), b);
    c = _mm_xor_si128(shifted(b, by128), c);
    d = _mm_xor_si128(shifted(c, by128), d);
    return stored(d);
}

/// The same with registers of twice the width: sums of every second sixteen bytes lie beside each other.
__attribute__((target("vpclmulqdq,avx2"))) Folded foldBy32(ByteView bytes)
{
    constexpr std::size_t kStep = 128;
    std::array<std::uint8_t, kStep> filled{};
    auto [first, at] = firstSteps(bytes, filled);
    __m256i a = loadTwo(first);
    __m256i b = loadTwo(first + 32);
    __m256i c = loadTwo(first + 64);
    __m256i d = loadTwo(first + 96);
    const __m256i by1024 = _mm256_broadcastsi128_si256(factors<1024>());
    for (const std::uint8_t *const end = bytes.data() + bytes.size(); at != end; at += kStep) {
        a = _mm256_xor_si256(shiftedTwo(a, by1024), loadTwo(at));
        b = _mm256_xor_si256(shiftedTwo(b, by1024), loadTwo(at + 32));
        c = _mm256_xor_si256(shiftedTwo(c, by1024), loadTwo(at + 64));
        d = _mm256_xor_si256(shiftedTwo(d, by1024), loadTwo(at + 96));
    }
    const __m256i by256 = _mm256_broadcastsi128_si256(factors<256>());
    b = _mm256_xor_si256(shiftedTwo(a, by256), b);
    c = _mm256_xor_si256(shiftedTwo(b, by256), c);
    d = _mm256_xor_si256(shiftedTwo(c, by256), d);
    const __m128i front = _mm256_castsi256_si128(d);
    return stored(_mm_xor_si128(shifted(front, factors<128>()), _mm256_extracti128_si256(d, 1)));
}

} // namespace

Folding widestFolding()
{
    static const Folding widest = [] {
        if (__builtin_cpu_supports("vpclmulqdq") != 0 && __builtin_cpu_supports("avx2") != 0)
            return Folding::By32;
        const bool narrow =
            __builtin_cpu_supports("pclmul") != 0 && __builtin_cpu_supports("ssse3") != 0;
        return narrow ? Folding::By16 : Folding::None;
    }();
    return widest;
}

Folded foldForCrc16(ByteView bytes, Folding how)
{
    assert(how != Folding::None && how <= widestFolding());
    return how == Folding::By32 ? foldBy32(bytes) : foldBy16(bytes);
}

#else

Folding widestFolding() { return Folding::None; }

Folded foldForCrc16(ByteView, Folding)
{
    assert(false);
    return {};
}

#endif

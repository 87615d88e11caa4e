// The numbers of the firmware: 16-bit vectors in the digits of the registers, and how they saturate. Values only.
//
// Rotor coordinates as in ST's library: alpha lies on phase A, and with positive speed I_B follows I_A by 120 degrees,
//   alpha = q cos + d sin     beta = d cos - q sin     so that the back-EMF is (E cos, -E sin)
// Rounding everywhere: products are kept in 32 bits and shifted arithmetically, which rounds towards minus infinity.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace simulation {

/// Two phases; the third is minus their sum.
struct Ab {
    std::int16_t a = 0, b = 0;
    bool operator==(const Ab &) const = default;
};

/// Coordinates that stand still.
struct AlphaBeta {
    std::int16_t alpha = 0, beta = 0;
    bool operator==(const AlphaBeta &) const = default;
};

/// Coordinates that turn with the rotor.
struct Qd {
    std::int16_t q = 0, d = 0;
    bool operator==(const Qd &) const = default;
};

/// Cosine and sine in Q15: 1.0 is 32767, -1.0 is -32767.
struct Trig {
    std::int16_t cosine = 32767, sine = 0;
    bool operator==(const Trig &) const = default;
};

constexpr std::int32_t kDigitsMax = 32767;

/// Cut to -32768..32767.
constexpr std::int16_t saturate16(std::int64_t value)
{
    return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, -32768, 32767));
}

/// Cut to -32767..32767: what the transforms give, so that a result can be negated.
constexpr std::int16_t saturateSymmetric(std::int64_t value)
{
    return static_cast<std::int16_t>(std::clamp<std::int64_t>(value, -32767, 32767));
}

/// Cut to 32 bits.
constexpr std::int32_t saturate32(std::int64_t value)
{
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(
        value, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()));
}

/// The low 16 bits: angles (1/65536 turn) are meant to wrap, nothing else is.
constexpr std::int16_t wrapAngle(std::int32_t angle)
{
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::uint32_t>(angle)));
}

/// Largest integer whose square is not above `value`; 0 for negative ones.
std::int32_t squareRoot(std::int64_t value);

} // namespace simulation

// Random numbers that are the same everywhere: a seed says all that is drawn.
#pragma once

#include <cstdint>

/// splitmix64, by S. Vigna: the next number, from a state that it moves on.
inline std::uint64_t splitmix64(std::uint64_t &state)
{
    std::uint64_t z = state += 0x9E3779B97F4A7C15ULL;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
    return z ^ z >> 31;
}

/// Draws numbers; the same seed draws the same ones.
class Draw {
public:
    explicit Draw(std::uint64_t seed)
        : m_state(seed)
    {
    }
    double between(double least, double most)
    {
        return least + (most - least) * static_cast<double>(splitmix64(m_state) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t m_state;
};

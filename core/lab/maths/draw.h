// Random numbers that are the same everywhere: a plan with its seed says all that its course does.
#pragma once

#include <cstdint>

namespace lab {

/// splitmix64, by S. Vigna.
class Draw {
public:
    explicit Draw(std::uint64_t seed)
        : m_state(seed)
    {
    }
    double between(double least, double most)
    {
        std::uint64_t z = m_state += 0x9E3779B97F4A7C15ULL;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
        return least + (most - least) * static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t m_state;
};

} // namespace lab

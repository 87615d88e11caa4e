// Random numbers that are the same everywhere: a plan with its seed says all that its course does.
#pragma once

#include "base/splitmix.h"

namespace lab {

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

} // namespace lab

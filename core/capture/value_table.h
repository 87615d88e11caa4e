// Up to 65,536 different values, each with a code of 16 bits: what came from 16 bits, whatever it was scaled with and
// however it was written down since, has no more. Values keep their bits. One may add while others read what they know
// the codes of.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace capture {

class ValueTable {
public:
    using Code = std::uint16_t;
    static constexpr std::size_t kMost = 65536;

    /// Adds those that are new.
    /// @param codes  as many; without a meaning where false is returned: there are too many different ones
    bool encode(std::span<const double> values, Code *codes);
    double at(Code code) const { return m_values[code]; }
    std::size_t bytes() const
    {
        return m_size * sizeof(double) + m_places.size() * sizeof(std::uint32_t);
    }

private:
    void spread(std::size_t places);
    std::size_t placeOf(std::uint64_t bits) const;

    // As large as it may become: it never moves under a reader, and unwritten pages take no memory.
    std::unique_ptr<double[]> m_values = std::make_unique_for_overwrite<double[]>(kMost);
    std::size_t m_size = 0;
    /// By a hash of the bits: a code and one; 0: free. A power of two, half empty.
    std::vector<std::uint32_t> m_places;
};

} // namespace capture

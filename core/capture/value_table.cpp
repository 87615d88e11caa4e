#include "capture/value_table.h"

#include <bit>

namespace capture {

namespace {
constexpr std::size_t kFirstPlaces = 1024;
}

/// Where it is, or the free place where it belongs.
std::size_t ValueTable::placeOf(std::uint64_t bits) const
{
    const std::size_t mask = m_places.size() - 1;
    std::size_t place = (bits * 0x9E3779B97F4A7C15ULL >> 32) & mask;
    while (
        m_places[place] != 0 && std::bit_cast<std::uint64_t>(m_values[m_places[place] - 1]) != bits)
        place = (place + 1) & mask;
    return place;
}

void ValueTable::spread(std::size_t places)
{
    m_places.assign(places, 0);
    for (std::size_t code = 0; code < m_size; ++code)
        m_places[placeOf(std::bit_cast<std::uint64_t>(m_values[code]))] =
            static_cast<std::uint32_t>(code + 1);
}

bool ValueTable::encode(std::span<const double> values, Code *codes)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (2 * m_size >= m_places.size() && m_size < kMost)
            spread(std::max(kFirstPlaces, 2 * m_places.size()));
        const std::size_t place = placeOf(std::bit_cast<std::uint64_t>(values[i]));
        if (m_places[place] == 0) {
            if (m_size == kMost)
                return false;
            m_values[m_size++] = values[i];
            m_places[place] = static_cast<std::uint32_t>(m_size);
        }
        codes[i] = static_cast<Code>(m_places[place] - 1);
    }
    return true;
}

} // namespace capture

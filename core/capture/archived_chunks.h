// Which chunks of a column lie in an archive, or are on their way: always the oldest. Chunks are counted from the first
// one that the column ever had.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace capture {

class ArchivedChunks {
public:
    std::uint64_t handed() const { return m_handed; } ///< the oldest that is not even on its way
    /// How many of those from `first` on lie in the archive. @param first  the oldest that is kept
    std::uint64_t placedFrom(std::uint64_t first) const { return m_placed - first; }

    void handOver() { ++m_handed; }
    void place(std::uint64_t chunk)
    {
        assert(chunk == m_placed && chunk < m_handed);
        m_placed = chunk + 1;
    }
    void takeBack() { m_handed = m_placed; }
    /// @param first  the oldest that is still kept
    void release(std::uint64_t first)
    {
        m_placed = std::max(m_placed, first);
        m_handed = std::max(m_handed, first);
    }

private:
    std::uint64_t m_placed = 0;
    std::uint64_t m_handed = 0;
};

} // namespace capture

// A capture as one array of structures in NumPy's file format; docs/npy.md describes its fields and rows. Source of the
// layout: numpy/lib/format.py, versions 1.0 and 3.0.
#pragma once

#include "capture/rows.h"

#include <string>
#include <string_view>

namespace capture {

class NpyWriter {
public:
    /// All numbers are in memory at once.
    static constexpr std::size_t kMostBytes = std::size_t{1} << 31;

    /// @param mostBytes  for tests
    explicit NpyWriter(const Snapshot &channels, const std::optional<TimeSpan> &range = {},
        std::size_t mostBytes = kMostBytes);

    /// More numbers than `mostBytes` holds; there is nothing to write.
    bool tooLong() const { return m_tooLong; }
    /// Shows the next piece, about 1 MiB, good until the following call. False when all is written, or if it is too
    /// long.
    bool next(std::string_view &bytes);
    double progress() const; ///< 0..1
    std::uint64_t rows() const { return m_rows.time.size() + m_gaps.size(); }

private:
    std::string head() const;
    void findGaps();
    void putRow();

    Snapshot m_channels;
    Rows m_rows;
    std::vector<double> m_gaps; ///< seconds, rising, none of them a row
    bool m_tooLong = false;
    bool m_begun = false;
    std::size_t m_row = 0, m_gap = 0; ///< to be written next
    std::string m_piece; ///< shown last
};

} // namespace capture

// Comma-separated text into a capture, piece by piece. It reads what CsvWriter writes, in both dialects, to the last
// digit; and the files of PlotJuggler (`__time` first) and of VESC Tool (`;`, `ms_today` in ms). Nothing is guessed
// from the system's language: what separates fields is counted in the heading, and a comma within a number is its
// decimal mark only where fields are separated by something else.
//
// Each column but the time becomes a channel of values. Empty fields are gaps, and so are distances that stand out
// among those of the rows around: docs/csv.md says when. So a row reaches the capture when some more have been read.
// Source of the foreign formats: headings as these programs write them.
#pragma once

#include "capture/capture.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace capture {

struct CsvError {
    enum class What : std::uint8_t {
        NoHeading, ///< empty, or its first line is no list of names
        NoSignals, ///< one column only
        TooManyColumns,
        LineTooLong,
        OtherNumberOfFields, ///< than the heading has
        NoNumber,
        NoTime, ///< empty or no number where the time stands
        TimeRunsBack,
        NoRows,
    } what = What::NoHeading;
    std::uint64_t line = 0; ///< from 1
    std::size_t column = 0; ///< from 1; 0: the whole line
    std::string field; ///< what stands there, its beginning
};

class CsvImport {
public:
    static constexpr std::size_t kMostColumns = 1024;
    static constexpr std::size_t kLongestLine = std::size_t{1} << 20;

    /// @param capture  gets channels of its own; what is there already stays
    explicit CsvImport(Capture &capture)
        : m_capture(capture)
    {
    }

    /// The next piece of the text, cut anywhere. False after the first error; the capture then holds the rows before
    /// it.
    bool feed(std::string_view text);
    /// The text is over. False if there is an error.
    bool finish();

    const std::optional<CsvError> &error() const { return m_error; }
    std::uint64_t rows() const { return m_rows; }
    /// Rows that are not in the capture, because they have the time of the row before; those of VESC Tool do not count.
    std::uint64_t leftOut() const { return m_leftOut; }
    const std::vector<ChannelId> &channels() const { return m_channels; } ///< in the file's order

private:
    bool parseLine(std::string_view line);
    bool parseHeading(std::string_view line);
    bool parseRow(std::string_view line);
    bool split(std::string_view line);
    bool splitQuoted(std::string_view line);
    bool parseTime(std::string_view field, std::size_t column, Nanos &time);
    std::string_view withPoint(std::string_view field);
    double number(std::string_view field);
    void settle();
    void settleAll();
    void store(std::size_t channel);
    Nanos usualAround(std::uint64_t row) const;
    bool isGap(std::uint64_t row, Nanos usual) const;
    bool fail(CsvError::What what, std::size_t column = 0, std::string_view field = {});

    static constexpr std::size_t kAround = 16; ///< rows, either way, that tell what is usual
    struct Row {
        Nanos time = 0;
        std::vector<double> values; ///< NaN: unknown
    };
    /// Of one channel, on their way into the capture: one by one would take as long as reading them.
    struct Pending {
        std::vector<Nanos> times;
        std::vector<double> values;
        Nanos holdUntil = 0;
    };

    Capture &m_capture;
    std::string m_rest; ///< a line that has not ended yet
    std::vector<std::string_view> m_fields; ///< of the line, or of m_unquoted
    std::string m_unquoted;
    std::vector<ChannelId> m_channels;
    std::vector<Pending> m_pending; ///< one a channel
    char m_separator = ',';
    std::size_t m_timeColumn = 0;
    std::size_t m_columns = 0;
    Nanos m_timeUnit = 1'000'000'000; ///< nanoseconds
    bool m_wrapsAtMidnight = false;
    Nanos m_midnights = 0; ///< added to times of a clock that begins anew each day
    Nanos m_last = 0;
    std::array<Row, kAround + 1> m_ahead; ///< row n at n modulo the size, until it is settled
    std::array<Nanos, 2 * kAround + 1> m_distances{}; ///< of row n from the one before, likewise
    std::uint64_t m_sameSince = 1; ///< the newest distances are equal from this row on
    std::uint64_t m_settled = 0; ///< rows in the capture, or pending
    std::uint64_t m_line = 0;
    std::uint64_t m_rows = 0;
    std::uint64_t m_leftOut = 0;
    std::optional<CsvError> m_error;
    std::string m_scratch;
};

} // namespace capture

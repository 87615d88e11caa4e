// A capture as comma-separated text, made piece by piece from a snapshot: the owner of the file writes the pieces.
// The format is described in docs/csv.md: two dialects, UTF-8, shortest numbers that read back exactly, time first.
//
// Rows are the samples of the fastest kind of channel that has any in the range; slower ones are held. What is not
// known is blank, what was lost has no row, and nothing is ever filled in.
#pragma once

#include "capture/capture.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace capture {

/// How fields and decimals are marked; chosen by name, never by the system's language.
enum class CsvDialect : std::uint8_t {
    Plain, ///< `,` and `.`, LF, no byte-order mark: for programs
    Continental, ///< `;` and a decimal comma, CRLF and a byte-order mark: for spreadsheets that expect them
};

struct CsvOptions {
    std::optional<TimeSpan> range; ///< rows in [from, to); all if not set
    CsvDialect dialect = CsvDialect::Plain;
};

/// Snapshots that share a rate: all fast channels, all slow ones, each polled one alone. Empty channels are left out.
/// For one file per rate; every sample of every channel is then in some file.
std::vector<Snapshot> splitByRate(const Snapshot &channels);

/// Whether CsvWriter would write every sample of these channels, all of their time, into one file: not if a slower one
/// has values that no row shows. Cost: a search for each of those.
bool everySampleHasARow(const Snapshot &channels);

/// A column's heading, e.g. `I_Q_MEAS [A]`: quoted where it must be, and with a leading apostrophe where a
/// spreadsheet would take it for a formula.
std::string csvHeading(const ChannelInfo &channel);

/// Nanoseconds as seconds with as few digits as say it exactly, e.g. 62500 -> "0.0000625".
std::string csvTime(Nanos time);

class CsvWriter {
public:
    /// @param channels  columns in this order
    explicit CsvWriter(Snapshot channels, CsvOptions options = {});
    ~CsvWriter();
    CsvWriter(const CsvWriter &) = delete;
    CsvWriter &operator=(const CsvWriter &) = delete;

    /// Shows the next mebibyte of the text, the last time what is left of it: good until the following call. False when
    /// all was shown.
    bool next(std::string_view &piece);

    double progress() const; ///< 0..1
    std::uint64_t rows() const { return m_rows; } ///< written so far, without the heading

private:
    class CodeTexts; ///< the text of every 16-bit code, made when it is first needed
    struct Column;
    struct Field { ///< a column during one run
        Column *column;
        CodeTexts *texts;
        const std::int16_t *codes; ///< nullptr: not a fast column with samples
        bool there;
    };
    struct Run; ///< rows that follow each other with samples in the same columns

    std::shared_ptr<CodeTexts> textsFor(const Channel &channel) const;
    std::string heading() const;
    bool plan(Run &run) const;
    char *writeRun(const Run &run, char *at);
    static char *writeHeld(Column &column, Nanos time, char decimal, char *at);

    Snapshot m_channels;
    CsvOptions m_options;
    std::vector<std::unique_ptr<Column>> m_columns;
    std::vector<Field> m_fields; ///< of the run being written
    std::vector<std::int16_t> m_codes; ///< of it, column by column
    std::vector<char> m_text; ///< with room for one run more than a piece
    std::size_t m_size = 0; ///< of what is written in it
    std::size_t m_shown = 0; ///< of that, as the last piece
    std::uint64_t m_rows = 0;
    std::uint64_t m_total = 0; ///< samples to write in the columns that make rows
    std::uint64_t m_done = 0;
};

} // namespace capture

// The formats that signals are written in: a row each, which is all that the programs know of a format.
#pragma once

#include "capture/wav_export.h"
#include "session/files/whole_file.h"

#include <span>

namespace session {

struct ExportWanted {
    capture::Snapshot channels; ///< in the order of the file
    std::optional<capture::TimeSpan> range; ///< all if not set
};

using capture::ExportProblem;

struct ExportOutcome {
    FileResult file;
    ExportProblem problem = ExportProblem::None;
    quint64 rows = 0; ///< of samples, in a file that is whole
};

struct ExportFormat {
    enum class Holds : std::uint8_t {
        RowsOfTheFastest, ///< and what a slower signal has at their times
        EverySample,
        FastSignals,
    };
    const char *name = ""; ///< one word
    /// Of the file, without a point. The first row of a suffix is the usual one, a further one has a decimal comma.
    const char *suffix = "";
    const char *title = ""; ///< for a choice; can be translated, in the context "ExportFormat"
    const char *mostText = ""; ///< how much fits: a piece of exportProblemText() (problems.h)
    Holds holds = Holds::EverySample;
    /// Writes the whole file, or none. @param proceed  told 0..1; false cancels
    ExportOutcome (*write)(const QString &path, const ExportWanted &wanted,
        const std::function<bool(double)> &proceed) = nullptr;
};

std::span<const ExportFormat> exportFormats(); ///< the first one is plain CSV
/// The one for this name of a file, whatever the case; nullptr if none has its ending.
/// @param decimalComma  where the format has a dialect with one
const ExportFormat *exportFormatOf(const QString &path, bool decimalComma = false);
const ExportFormat *exportFormatNamed(std::string_view name);

} // namespace session

// What a person wants in a file, as values, and the writing of it in any thread: CSV in two dialects, WAV, MATLAB.
// Pictures are of the screen and are made in its thread (scope_picture.h).
#pragma once

#include "capture/capture.h"
#include "capture/wav_export.h"
#include "session/csv_file.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace widgets {

enum class ExportFormat : std::uint8_t { Csv, CsvContinental, Wav, Mat, Png, Svg, Pdf };

bool isPicture(ExportFormat format);
QString suffixOf(ExportFormat format); ///< "csv"
QString filterOf(ExportFormat format); ///< for a file dialog

struct ExportOrder {
    struct Part {
        QString path;
        capture::Snapshot channels;
    };
    ExportFormat format = ExportFormat::Csv;
    QString path; ///< as the person named it
    QList<Part> parts; ///< a file each; none for a picture
    std::optional<capture::TimeSpan> range; ///< all if not set
    QString motionLog; ///< where the log goes beside it; empty: it has none
};

struct ExportResult {
    session::CsvResult file; ///< of the first part that failed, else of the last one
    capture::WavProblem wav = capture::WavProblem::None;
    bool matTooLong = false;
    QStringList written; ///< names of the parts that are whole
    bool allInIt = false; ///< every sample of the parts is in a file
    bool ok() const
    {
        return file.error == session::FileError::None && wav == capture::WavProblem::None
            && !matTooLong;
    }
    bool cancelled() const { return file.error == session::FileError::Cancelled; }
};

/// Writes the files one after the other; each appears whole or not at all.
/// @param proceed  told 0..1; false cancels
ExportResult carryOut(const ExportOrder &order, const std::function<bool(double)> &proceed);

/// Why there is no file, and what to do; empty if there is one.
QString exportErrorText(const ExportResult &result);

} // namespace widgets

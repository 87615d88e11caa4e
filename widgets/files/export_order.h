// What is wanted in a file, as values, and the writing of it in any thread, in one of session::exportFormats().
// Pictures are of the screen and are made in its thread (scope_picture.h).
#pragma once

#include "session/files/export_formats.h"

#include <QList>
#include <QString>
#include <QStringList>

namespace widgets {

struct PictureFormat;

struct ExportOrder {
    struct Part {
        QString path;
        capture::Snapshot channels;
    };
    const session::ExportFormat *format = nullptr; ///< null for a picture
    const PictureFormat *picture = nullptr;
    QString path; ///< as it was named
    QList<Part> parts; ///< a file each; none for a picture
    std::optional<capture::TimeSpan> range; ///< all if not set
    QString motionLog; ///< where the log goes beside it; empty: it has none
};

struct ExportResult {
    session::ExportOutcome last; ///< of the first part that failed, else of the last one
    QString path; ///< its
    QStringList written; ///< names of the parts that are whole
    bool allInIt = false; ///< every sample of the parts is in a file
    quint64 rows = 0; ///< of samples, in all parts that are whole
    QString logWrong; ///< why the motion log is in no file; empty: it is, or there is none
    bool ok() const
    {
        return last.file.error == session::FileError::None
            && last.problem == session::ExportProblem::None;
    }
    bool cancelled() const { return last.file.error == session::FileError::Cancelled; }
};

/// Writes the files one after the other; each appears whole or not at all.
/// @param proceed  told 0..1; false cancels
ExportResult carryOut(const ExportOrder &order, const std::function<bool(double)> &proceed);

/// Why there is no file, and what to do; empty if there is one.
QString exportErrorText(const ExportOrder &order, const ExportResult &result);

} // namespace widgets

// Writes a capture as a CSV file: the file appears whole or not at all, and what was there before stays until then.
// The text itself is core/capture/csv_export.h; only whether the disk took it is decided here.
#pragma once

#include "capture/csv_export.h"
#include "session/piece_file.h"

#include <QString>

#include <functional>

namespace session {

using CsvError = FileError;

struct CsvResult {
    CsvError error = CsvError::None;
    QString path;
    QString systemText; ///< the system's words for it, e.g. "No space left on device"
    quint64 rows = 0;
    qint64 bytes = 0;
};

/// Writes the whole file and returns when it is there, or the reason why it is not.
/// @param proceed  called with the progress 0..1 about every mebibyte; false cancels
CsvResult writeCsvFile(const QString &path, capture::CsvWriter &writer,
    const std::function<bool(double)> &proceed = {});

} // namespace session

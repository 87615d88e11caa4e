// Reading signals from a CSV file, in a thread of the pool, into a capture of its own.
#pragma once

#include "capture/csv_import.h"

#include <QString>

#include <functional>

class QWidget;

namespace widgets {

class FileJob;

/// @param config  of the capture; where it has no room the oldest samples are let go
/// Calls `take` in the GUI thread, with how many rows were left out, too (CsvImport::leftOut()), or `fail` with a
/// sentence that names line and column; nothing if it was cancelled.
FileJob *importCsv(const QString &path, QWidget *window,
    std::function<void(capture::Capture &, std::uint64_t leftOut)> take,
    std::function<void(const QString &)> fail, capture::Capture::Config config);

} // namespace widgets

// The CSV file of a capture: whole or not at all.
#pragma once

#include "capture/capture.h"
#include "failure.h"

namespace cli {

/// Looks whether the file could be written, before a motor is started for it.
Outcome<int> checkCsvTarget(const QString &path);
/// Writes what the stream recorded, fast signals first. @return  number of rows
Outcome<std::uint64_t> writeCsv(const capture::Capture &capture, const QString &path);

} // namespace cli

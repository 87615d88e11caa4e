// The CSV file of a capture: whole or not at all.
#pragma once

#include "capture/capture.h"
#include "failure.h"

#include <span>

namespace cli {

/// Looks whether the file could be written, before a motor is started for it.
Outcome<int> checkCsvTarget(const QString &path);
/// Writes these channels, in this order. @return  number of rows
Outcome<std::uint64_t> writeCsv(const capture::Capture &capture,
    std::span<const capture::ChannelId> channels, const QString &path);

} // namespace cli

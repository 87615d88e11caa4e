// Comma-separated text to rows of fields (RFC 4180: quotes, doubled quotes, line ends inside
// quotes). It only cuts; what the fields mean is the reader's business.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace catalog {

struct TableError {
    std::size_t line = 0; ///< 1-based
    std::string what; ///< one sentence, in English, for logs and tests
};

struct CsvRow {
    std::size_t line = 0; ///< 1-based, where the row begins
    std::vector<std::string> fields;
};

/// All rows of `text`, header included; empty lines are passed over. Fails at a quote that is never
/// closed or that is followed by something else than a separator.
Result<std::vector<CsvRow>, TableError> readCsv(std::string_view text);

} // namespace catalog

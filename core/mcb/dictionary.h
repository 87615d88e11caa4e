// What registers a drive is likely to have, by the one public dictionary (Summit 1.12.0) and the names of newer ones.
// Dictionaries drift between firmwares: it is good for names, and GET INFO for everything else.
// Source: resources/registers/mcb.csv.
#pragma once

#include "catalog/csv.h"
#include "mcb/value.h"

#include <string>

namespace mcb {

struct Entry {
    std::uint16_t address = 0;
    std::string name; ///< of newer firmware where it has one
    std::string olderName; ///< where it differs; else empty
    Info info; ///< size 0: a text of unknown length
    catalog::Effect effect = catalog::Effect::Unknown; ///< of a write
    std::string unit; ///< empty: a plain number
    std::string description;
};

/// Entries by rising address. Columns are found by their names in the first row; fails with one sentence at an address
/// that comes twice or is too large, and at a word that is not known.
Result<std::vector<Entry>, catalog::TableError> readDictionary(std::string_view csv);

/// The dictionary that is built in.
const std::vector<Entry> &dictionary();

/// nullptr if the dictionary has no such register.
const Entry *findEntry(std::uint16_t address);

} // namespace mcb

// The fields of an event in a recording, read as what they should be: files are foreign.
#pragma once

#include "record/entry.h"

#include <optional>
#include <string>
#include <string_view>

namespace lab {

std::string fieldOf(const record::Happening &happening, std::string_view key); ///< empty: none
/// A finite number of a magnitude below 1e9; empty if it is anything else.
std::optional<double> numberOf(const record::Happening &happening, std::string_view key);
/// The shortest text that is the same number again.
std::string textOf(double value);
/// With so many digits that count.
std::string textOf(double value, int digits);

} // namespace lab

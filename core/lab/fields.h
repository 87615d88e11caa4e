// The fields of an event in a recording, read as what they should be: files are foreign.
#pragma once

#include "base/number_text.h"
#include "record/entry.h"

#include <optional>
#include <string>
#include <string_view>

namespace lab {

std::string fieldOf(const record::Happening &happening, std::string_view key); ///< empty: none
/// A finite number of a magnitude below 1e9; empty if it is anything else.
std::optional<double> numberOf(const record::Happening &happening, std::string_view key);

} // namespace lab

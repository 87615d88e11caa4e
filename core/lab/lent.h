// Registers that an experiment writes and gives back, and what is to be said of them where it did not.
#pragma once

#include "catalog/register_info.h"

#include <optional>
#include <string>
#include <vector>

namespace lab {

struct Lent {
    std::string name;
    std::string held; ///< before, as `rotorscope-cli set` takes it
    bool operator==(const Lent &) const = default;
};

/// As `rotorscope-cli set` takes it: a structure in hexadecimal digits, with blanks where its line may be broken; a
/// number as it is, because gains have no scale, and exact, because it is written back.
std::string typedText(const catalog::Value &value);

/// The value of such a text, as a register of that type holds it; empty if it has none.
std::optional<catalog::Value> typedValue(const std::string &text, catalog::ValueType type);

/// What is to be said of those that were not given back, and how all of it comes back; without full stops.
std::vector<std::string> leftTexts(const std::vector<Lent> &lent);

/// Where another program left them. @param texts  those, in a row
std::string cutOffText(const std::string &texts);

} // namespace lab

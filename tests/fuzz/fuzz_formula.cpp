// Any text as a formula: one error with a place inside the text, or a machine that computes without harm.
#include "fuzz/script.h"
#include "scope/formula.h"

#include <algorithm>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const std::vector<scope::FormulaName> names{
        {"I_A", "A"}, {"V", "V"}, {"ANGLE", "°"}, {"x (2)", ""}};
    auto formula = scope::Formula::compile(text, names);
    if (!formula) {
        fuzz::require(formula.error().position <= size);
        return 0;
    }
    fuzz::require(size <= scope::Formula::kMostBytes);
    fuzz::require(std::is_sorted(formula->used().begin(), formula->used().end()));
    std::vector<double> values(formula->used().size());
    for (int i = 0; i < 20; ++i) {
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = static_cast<double>(i) * 37.5 - 200.0 + static_cast<double>(k);
        formula->step(values, 1e-3, i % 7 != 0);
    }
    return 0;
}

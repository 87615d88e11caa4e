#include "lab/lent.h"

#include "base/text.h"
#include "drive/values.h"

namespace lab {

std::string typedText(const catalog::Value &value)
{
    const auto *bytes = std::get_if<Bytes>(&value);
    return bytes != nullptr ? "\"" + hexOf(*bytes, " ") + "\""
                            : shortNumber(drive::asNumber(value).value_or(0.0));
}

std::vector<std::string> leftTexts(const std::vector<Lent> &lent)
{
    std::vector<std::string> texts;
    std::string all;
    for (const Lent &one : lent) {
        texts.push_back(one.name + " may hold what the experiment wrote");
        all += " " + one.name + "=" + one.held;
    }
    if (!lent.empty())
        texts.push_back("what it held before comes back with: rotorscope-cli set" + all);
    return texts;
}

} // namespace lab

#include "recorded/gain_stretches.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace recorded {
namespace {

/// The number behind a word of what was told of a write, e.g. of "ok, was 700, is 350".
std::optional<double> numberBehind(std::string_view told, std::string_view word)
{
    const std::size_t place = told.find(word);
    if (place == std::string_view::npos)
        return std::nullopt;
    const char *begin = told.data() + place + word.size();
    double number = 0.0;
    const auto [end, error] = readDecimal(begin, told.data() + told.size(), number);
    return error == std::errc() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

} // namespace

bool isGain(std::string_view name)
{
    name = name.substr(0, name.find('@'));
    return name.ends_with("_KP") || name.ends_with("_KI") || name.ends_with("_KD");
}

void GainStretches::accept(Nanos at, const Entry &entry)
{
    if (m_all.empty())
        m_all.push_back({at, at, {}});
    at = std::max(m_all.back().to, at); // a file may hold any number
    m_all.back().to = at;
    const auto *happening = std::get_if<Happening>(&entry);
    if (happening == nullptr || happening->name != "ended")
        return;
    for (const auto &[name, told] : happening->fields) {
        const auto before = numberBehind(told, ", was "), after = numberBehind(told, ", is ");
        if (isGain(name) && after)
            change(at, name, before.value_or(*after), *after);
    }
}

void GainStretches::part(Nanos at)
{
    if (m_all.empty() || at <= m_all.back().from)
        return;
    m_all.back().to = at - 1; // what is told at that time belongs to the next one
    m_all.push_back({at, at, m_all.back().gains});
}

void GainStretches::change(Nanos at, const std::string &name, double before, double after)
{
    for (GainStretch &stretch : m_all)
        stretch.gains.emplace(name, before);
    GainStretch &last = m_all.back();
    if (last.gains[name] == after)
        return;
    if (last.from == at) { // several registers of one list
        last.gains[name] = after;
        return;
    }
    GainStretch next{at, at, last.gains};
    next.gains[name] = after;
    m_all.push_back(std::move(next));
}

} // namespace recorded

#include "widgets/scope/signals/polled_rates.h"

#include <algorithm>

namespace widgets {

void PolledRates::accept(const drive::Reading &reading)
{
    if (reading.status != drive::ReadStatus::Ok)
        return;
    Stretch &stretch = m_now[reading.id];
    if (stretch.count++ == 0)
        stretch.first = reading.at;
    stretch.last = std::max(stretch.last, reading.at);
    stretch.spread = std::max(stretch.spread, reading.spread);
}

void PolledRates::turn()
{
    m_reached.clear();
    for (auto at = m_now.begin(); at != m_now.end();) {
        Stretch &stretch = at->second;
        if (stretch.count < 2 || stretch.last <= stretch.first) {
            at = m_now.erase(at); // nothing more came
            continue;
        }
        m_reached[at->first] = {
            static_cast<double>(stretch.count - 1) / toSeconds(stretch.last - stretch.first),
            toSeconds(stretch.spread)};
        stretch = {stretch.last, stretch.last, 1, {}};
        ++at;
    }
}

void PolledRates::forget()
{
    m_now.clear();
    m_reached.clear();
}

std::optional<PolledRates::Reached> PolledRates::reached(catalog::RegisterId id) const
{
    const auto found = m_reached.find(id);
    return found == m_reached.end() ? std::nullopt : std::optional(found->second);
}

} // namespace widgets

// PolledRates: how often signals that are read one by one really come, and how well their times are known, from the
// readings alone. The window shows it beside what was planned.
#pragma once

#include "drive/event.h"

#include <map>
#include <optional>

namespace widgets {

class PolledRates {
public:
    struct Reached {
        double hz = 0.0;
        /// Longest; a value was true within so long before its time; 0: not told.
        double spread_s = 0.0;
        bool operator==(const Reached &) const = default;
    };

    void accept(const drive::Reading &reading);
    /// Ends a stretch of time: what was read during it is what `reached` tells until the next one.
    void turn();
    void forget();
    /// Empty: it was read less than twice.
    std::optional<Reached> reached(catalog::RegisterId id) const;

private:
    struct Stretch {
        TimePoint first, last;
        unsigned count = 0;
        Duration spread{};
    };
    std::map<catalog::RegisterId, Stretch> m_now;
    std::map<catalog::RegisterId, Reached> m_reached;
};

} // namespace widgets

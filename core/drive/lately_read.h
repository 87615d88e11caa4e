// What the rounds of watched registers have read a moment ago. A parameter among them is not asked for once more before it is
// written: nobody but this drive writes it, and firmware leaves parameters alone. Knows no clock.
#pragma once

#include "drive/event.h"

#include <map>
#include <vector>

namespace drive {

class LatelyRead {
public:
    static constexpr Duration kHolds = std::chrono::milliseconds(250); ///< from the question on

    /// @param asked  when the question left: no value is older
    void take(const std::vector<Reading> &readings, TimePoint asked)
    {
        for (const Reading &reading : readings)
            if (reading.status == ReadStatus::Ok && asked >= m_since)
                m_values[reading.id] = {reading.value, asked};
    }
    /// Something leaves that may change registers, or nobody knows what happened meanwhile.
    void forget(TimePoint now)
    {
        m_values.clear();
        m_since = now;
    }
    /// Nothing if it was not read, or is too old.
    const Value *valueOf(RegisterId id, TimePoint now) const
    {
        const auto at = m_values.find(id);
        return at != m_values.end() && now - at->second.asked <= kHolds ? &at->second.value
                                                                        : nullptr;
    }

private:
    struct Held {
        Value value;
        TimePoint asked;
    };
    std::map<RegisterId, Held> m_values;
    TimePoint m_since;
};

} // namespace drive

// What a board gave for its registers, of the last kKept only.
#pragma once

#include "base/time.h"

#include <cstdint>
#include <deque>
#include <map>

namespace judge {

class GivenValues {
public:
    static constexpr Duration kKept = std::chrono::seconds(20);

    struct Value {
        TimePoint at;
        double number = 0.0; ///< signed as its register has it; of a real number its value
    };

    void add(std::uint16_t id, double number, TimePoint at)
    {
        m_values[id].push_back({at, number});
    }
    void forgetOld(TimePoint now)
    {
        for (auto &[id, values] : m_values)
            while (values.size() > 1 && values[1].at + kKept < now) // what stood then counts, too
                values.pop_front();
    }
    /// The oldest first. @param id  with its motor
    const std::deque<Value> &of(std::uint16_t id) const
    {
        static const std::deque<Value> kNone;
        const auto found = m_values.find(id);
        return found == m_values.end() ? kNone : found->second;
    }

private:
    std::map<std::uint16_t, std::deque<Value>> m_values;
};

} // namespace judge

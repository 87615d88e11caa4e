// A slave of MCB behind a byte stream: whenever a whole frame has come in, as many bytes go out. The end of the answer
// means that the ready line is high again; a frame that stays unfinished for kUnfinished is dropped, as when chip select
// goes high.
#pragma once

#include "base/bytes.h"
#include "base/time.h"

#include <functional>
#include <utility>

namespace simulation {

class McbFraming {
public:
    static constexpr Duration kUnfinished = std::chrono::milliseconds(50);

    /// @param length    of a frame now
    /// @param exchange  what goes out while a frame comes in; shorter or empty: it is torn
    void receive(ByteView bytes, TimePoint now, const std::function<std::size_t()> &length,
        const std::function<Bytes(ByteView)> &exchange)
    {
        advance(now);
        if (!bytes.empty())
            m_lastInput = now;
        m_input.insert(m_input.end(), bytes.begin(), bytes.end());
        std::size_t taken = 0;
        for (std::size_t size = length(); m_input.size() - taken >= size; size = length()) {
            const Bytes output = exchange(ByteView(m_input).subspan(taken, size));
            m_output.insert(m_output.end(), output.begin(), output.end());
            taken += size;
        }
        m_input.erase(m_input.begin(), m_input.begin() + static_cast<std::ptrdiff_t>(taken));
    }
    void advance(TimePoint now)
    {
        if (!m_input.empty() && now - m_lastInput >= kUnfinished)
            m_input.clear();
    }
    Bytes takeOutput() { return std::exchange(m_output, {}); }
    bool outputWaits() const { return !m_output.empty(); }
    TimePoint nextWake() const
    {
        return m_input.empty() ? TimePoint::max() : m_lastInput + kUnfinished;
    }
    void clear()
    {
        m_input.clear();
        m_output.clear();
    }

private:
    Bytes m_input, m_output;
    TimePoint m_lastInput{};
};

} // namespace simulation

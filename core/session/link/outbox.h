// Outbox: what a drive wants to send, held back until the line has rested as long as each part asks
// for. It writes to a transport and knows the baud rate; it has no timer: the session calls pump()
// at nextDue().
#pragma once

#include "base/output.h"
#include "session/transports/transport.h"

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace session {

using Clock = std::function<TimePoint()>;

class Outbox {
public:
    explicit Outbox(std::uint32_t baud)
        : m_baud(baud)
    {
    }

    /// What waits is dropped if one of them says so; at the next pump() also by the port.
    void add(std::vector<Output> outputs);

    /// Writes what may leave now. The clock is read again after each write: a process that was
    /// preempted between reading the time and writing would otherwise make the next gap too short,
    /// and the board would lose what follows.
    /// @param told  of each write, before it
    void pump(Transport &transport, const Clock &clock,
        const std::function<void(ByteView, TimePoint)> &told);

    /// True once each time that everything added so far has left the line, as far as can be known.
    bool allSent(const Transport &transport, TimePoint now);

    /// When pump() or allSent() has something to do; empty while nothing is on its way.
    /// @param patience  how much later it may be told that all has left
    std::optional<TimePoint> nextDue(Duration patience = {}) const;

    bool idle() const { return m_waiting.empty() && !m_unreported; }

private:
    std::uint32_t m_baud;
    std::deque<Output> m_waiting;
    TimePoint m_lineFree{}; ///< when the last bit written has left
    std::optional<TimePoint> m_askAgain; ///< the port still holds bytes although their time is over
    bool m_dropInPort = false; ///< nothing that was written before matters any more
    bool m_unreported = false; ///< something was written since allSent() was last true
};

} // namespace session

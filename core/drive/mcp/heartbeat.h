// The heartbeat of a drive that has a watchdog: user command 1, every third of the time-out, while the user has the
// drive armed: a session that only reads keeps no motor alive. It starts nothing. It is never sent to firmware whose
// name does not ask for it, because user commands mean something else elsewhere (HSO builds write and read flash with
// them).
// Contract: docs/drive-watchdog.md.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/task.h"

#include <string_view>

namespace drive {

/// The time-out that a firmware's name ends in (" RSWD500"), 100 ms to 60 s; nothing for any other name.
std::optional<std::chrono::milliseconds> watchdogIn(std::string_view firmwareName);

class McpHeartbeat : public Task<McpProtocol> {
public:
    static constexpr int kRefusals = 3; ///< in a row, then it is sent no more

    explicit McpHeartbeat(const McpFacts &board)
        : m_board(board)
    {
    }

    /// A new connection.
    void restart(TimePoint now)
    {
        m_wanted = false;
        m_refused = 0;
        m_due = now;
    }
    void setWanted(bool wanted) { m_wanted = wanted; }
    /// When the next one is due; nothing if none is to be sent.
    std::optional<TimePoint> due() const;
    /// The board has refused too many: it has no watchdog that we could feed.
    bool givenUp() const { return m_refused >= kRefusals; }

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const McpAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool>, TimePoint) override { } ///< the next one is due soon

private:
    const McpFacts &m_board;
    bool m_wanted = false;
    int m_refused = 0;
    TimePoint m_due;
};

} // namespace drive

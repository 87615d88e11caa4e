// What a START would go to. The user's own limits bound what the board was set to before as well: its last ramps, its
// references and the stages of its start-up are read first, and a START that would go beyond is refused. In speed control
// the last ramp counts, as in drive/start_target.h, and the reference only where the board does not tell that ramp.
// Without such limits nothing is read; the board's own limits are the business of its firmware then.
#pragma once

#include "drive/mcp/mcp_protocol.h"

#include <optional>
#include <string>

namespace drive {

class StartCheck {
public:
    StartCheck(const McpFacts &board, int motor)
        : m_board(board)
        , m_motor(motor)
    {
    }

    /// The next question; nothing once all is known (then refusal() says what was found).
    std::optional<McpRequest> nextRequest();
    void onResponse(const ByteView &response, TimePoint now);
    void onNoResponse() { m_reader.onNoResponse(); }

    bool gaveUp() const { return m_reader.gaveUp(); }
    /// Why the motor must not be started; empty if it may.
    std::string refusal() const;

private:
    std::vector<RegisterId> wanted() const;
    std::optional<Value> held(RegisterId id) const;
    std::string refuseTorque(const Value &held) const;

    const McpFacts &m_board;
    int m_motor;
    Reader<McpProtocol> m_reader{m_board};
    std::vector<Reading> m_readings;
    bool m_started = false;
};

} // namespace drive

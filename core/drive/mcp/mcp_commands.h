// Motor commands and set-points as wishes. A command that moves something is sent once: if its answer is lost it ends
// Unknown (or NotSent, if the board's count of requests proves it), and the state is read instead.
#pragma once

#include "drive/mcp/mcp_limits.h"
#include "drive/mcp/mcp_protocol.h"
#include "drive/set_point_check.h"
#include "drive/task.h"

namespace drive {

/// What a START would go to. The user's own limits bound what the board was set to before as well: its last ramps, its
/// references and the stages of its start-up are read first, and a START that would go beyond is refused. In speed control
/// the last ramp counts, as in drive/start_target.h, and the reference only where the board does not tell that ramp.
/// Without such limits nothing is read; the board's own limits are the business of its firmware then.
class StartCheck {
public:
    StartCheck(const McpFacts &board, int motor)
        : m_board(board)
        , m_motor(motor)
    {
    }

    /// The next question; nothing once all is known (then refusal() says what was found).
    std::optional<McpRequest> nextRequest();
    void onResponse(const ByteView &response, TimePoint now)
    {
        for (Reading &reading : m_reader.onResponse(response, now))
            m_readings.push_back(std::move(reading));
    }
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

class CommandTask : public WishTask<McpProtocol> {
public:
    CommandTask(WishId id, const Command &command, const McpFacts &board);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const ByteView &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    const McpFacts &m_board;
    Command m_command;
    StartCheck m_check;
    std::string m_refusal; ///< the board's word, while the state that explains it is read
    Reader<McpProtocol> m_reader{m_board};
    std::string m_state, m_faults;
};

/// Speed ramp, torque ramp or current reference: the control mode first, if it is another one, then the raw register.
class SetPointTask : public WishTask<McpProtocol> {
public:
    SetPointTask(WishId id, const SetPoint &wanted, const McpFacts &board);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const ByteView &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    enum class Step : std::uint8_t { Begin, ReadMode, SetMode, SetPoint };

    McpRequest order() const;

    const McpFacts &m_board;
    SetPoint m_wanted;
    std::int64_t m_mode; ///< that it takes effect in
    Step m_step = Step::Begin;
    bool m_modeRepeated = false;
    Reader<McpProtocol> m_reader{m_board};
};

/// A move of the shaft to an angle. Where the shaft is now is read first, because the speed on the way follows from it; then
/// the raw register is set, which also makes the firmware control the position. Sent once.
class PositionTask : public WishTask<McpProtocol> {
public:
    PositionTask(WishId id, const PositionRamp &ramp, const McpFacts &board);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const ByteView &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    RawPosition wanted() const;
    void judge();

    const McpFacts &m_board;
    PositionRamp m_ramp;
    Reader<McpProtocol> m_reader{m_board};
    std::optional<double> m_position_rad;
    bool m_asked = false;
};

} // namespace drive

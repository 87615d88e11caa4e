// Motor commands and set-points as wishes. A command that moves something is sent once: if its answer is lost it ends
// Unknown (or NotSent, if the board's count of requests proves it), and the state is read instead.
#pragma once

#include "drive/act_task.h"
#include "drive/mcp/limits.h"
#include "drive/mcp/requests.h"
#include "drive/set_point_check.h"
#include "mcp/protocol.h"

namespace drive {

/// A command. The user's own limits bound what the board was set to before a START as well: its last ramps, its
/// references and the stages of its start-up are read first, and a START that would go beyond is refused. In speed
/// control the last ramp counts, as in drive/start_target.h, and the reference only where the board does not tell that
/// ramp. Without such limits nothing is read; the board's own limits are the business of its firmware then.
class McpCommandTask final : public ActTask<McpProtocol> {
public:
    McpCommandTask(WishId id, const Command &command, const McpFacts &board)
        : ActTask(id, command, board)
        , m_command(command)
    {
    }

private:
    std::string refuse() const override { return refuseCommand(m_board, m_command); }
    std::vector<RegisterId> needs() const override;
    std::string unread() const override { return "no answer about what it would start to"; }
    std::string plan() override;
    void conclude(const McpRequest &asked, AnswerEnd said) override;
    void onRead() override;

    Command m_command;
    std::string m_refusal; ///< the board's word, while the state that explains it is read
};

/// Speed ramp, torque ramp or current reference: the control mode first, if it is another one, then the raw register.
class McpSetPointTask final : public ActTask<McpProtocol> {
public:
    McpSetPointTask(WishId id, const SetPoint &wanted, const McpFacts &board)
        : ActTask(id, wanted, board)
        , m_wanted(wanted)
    {
    }

private:
    std::string refuse() const override { return refuseSetPoint(m_board, m_wanted); }
    std::vector<RegisterId> needs() const override
    {
        return {idOf(mcp::reg::kControlMode, m_motor)};
    }
    std::string plan() override;
    bool repeats() const override { return more(); } ///< the mode, a scalar

    SetPoint m_wanted;
};

/// A move of the shaft to an angle. Where the shaft is now is read first, because the speed on the way follows from it;
/// then the raw register is set, which also makes the firmware control the position. Sent once.
class McpPositionTask final : public ActTask<McpProtocol> {
public:
    McpPositionTask(WishId id, const PositionRamp &ramp, const McpFacts &board)
        : ActTask(id, ramp, board)
        , m_wanted{ramp.radians, toSeconds(ramp.duration)}
    {
    }

private:
    std::string refuse() const override;
    std::vector<RegisterId> needs() const override;
    std::string unread() const override { return "the board does not tell where the shaft is"; }
    std::string plan() override;

    Move m_wanted;
};

} // namespace drive

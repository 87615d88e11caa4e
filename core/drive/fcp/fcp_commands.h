// Motor commands and set-points of the older serial protocol as wishes, each one frame that is sent once: if its answer is
// lost it ends Unknown (NotSent, if the board said that it did not understand), and the state is read instead.
//
// An acknowledgement here proves nothing: START is acknowledged in any state. What the motor does is read by others.
// Writes are wishes with rules of their own.
#pragma once

#include "drive/fcp/fcp_protocol.h"
#include "drive/set_point_check.h"
#include "drive/stepwise_write.h"
#include "drive/task.h"

namespace drive {

class FcpActTask : public WishTask<FcpProtocol> {
public:
    FcpActTask(WishId id, const Command &command, const FcpFacts &board)
        : WishTask(id, permissionOf(command))
        , m_board(board)
        , m_act(command)
        , m_motor(command.motor)
    {
    }
    FcpActTask(WishId id, const SetPoint &wanted, const FcpFacts &board)
        : WishTask(id, Permission::Armed)
        , m_board(board)
        , m_act(wanted)
        , m_motor(wanted.motor)
    {
    }

    std::optional<fcp::Request> nextRequest(TimePoint now) override;
    void onResponse(const fcp::Reply &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    bool looking(); ///< at what a start would go to, because of the user's own limits
    std::string refuseStart() const;
    fcp::Command encode(const Command &command) const;
    fcp::Command encode(const SetPoint &wanted) const;

    const FcpFacts &m_board;
    std::variant<Command, SetPoint> m_act;
    int m_motor;
    Reader<FcpProtocol> m_reader{m_board};
    std::vector<Reading> m_found;
    bool m_looked = false;
};

/// Write wishes of the older serial protocol: each register is set in its full width, the rev-up stage by stage. What the
/// board did not understand goes out once more.
class FcpWriteTask final : public StepwiseWrite<FcpProtocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &write) override;
    bool repeats() const override { return true; }
    /// START is acknowledged in any state.
    bool acknowledgementCounts() const override { return false; }
};

} // namespace drive

// Motor commands and set-points of the older serial protocol as wishes, each one frame that is sent once: if its answer
// is lost it ends Unknown (NotSent, if the board said that it did not understand), and the state is read instead.
//
// An acknowledgement here proves nothing: START is acknowledged in any state. What the motor does is read by others.
// Writes are wishes with rules of their own.
#pragma once

#include "drive/act_task.h"
#include "drive/fcp/requests.h"
#include "drive/set_point_check.h"
#include "drive/stepwise_write.h"

namespace drive {

class FcpActTask final : public ActTask<FcpProtocol> {
public:
    FcpActTask(WishId id, const auto &act, const FcpFacts &board)
        : ActTask(id, act, board)
        , m_act(act)
    {
    }

private:
    std::string refuse() const override;
    std::vector<RegisterId> needs() const override; ///< what a start would go to
    std::string unread() const override { return "no answer about what it would start to"; }
    std::string plan() override;
    fcp::Command encode() const;

    std::variant<Command, SetPoint> m_act;
};

/// Write wishes of the older serial protocol: each register is set in its full width, the rev-up stage by stage. What
/// the board did not understand goes out once more.
class FcpWriteTask final : public StepwiseWrite<FcpProtocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &write) override;
    bool same(const RegisterWrite &write, const Value &read) const override;
    bool showsInForce(const catalog::RegisterInfo &info) const override
    {
        return info.setPoint == catalog::SetPoint::Current;
    }
    bool repeats() const override { return true; }
    /// START is acknowledged in any state.
    bool acknowledgementCounts() const override { return false; }
};

} // namespace drive

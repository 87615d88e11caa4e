// Write wishes of the older serial protocol: each register is set in its full width, the rev-up stage by stage. What the
// board did not understand goes out once more.
#pragma once

#include "drive/fcp/fcp_protocol.h"
#include "drive/stepwise_write.h"
#include "motor/rev_up.h"

namespace drive {

/// Beyond what a stage may ask for: its speed, and where the scale is known its current; empty if it is not.
std::string refuseStages(const FcpFacts &board, int motor, const motor::RevUp &stages);

class FcpWriteTask final : public StepwiseWrite<FcpProtocol> {
public:
    using StepwiseWrite::StepwiseWrite;

private:
    std::string plan(const RegisterWrite &write) override;
    bool repeats() const override { return true; }
    bool acknowledgementCounts() const override
    {
        return false;
    } // START is acknowledged in any state
};

} // namespace drive

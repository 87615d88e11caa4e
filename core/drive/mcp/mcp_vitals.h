// State, faults and speed of every motor; which register holds the speed depends on the firmware's family.
#pragma once

#include "drive/mcp/mcp_protocol.h"
#include "drive/vitals.h"

namespace drive {

class McpVitals final : public Vitals<McpProtocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override;
    std::optional<MotorStatus> statusOf(int motor) const override;
};

/// The neutral state behind a STATUS number.
MotorState motorStateOf(std::int64_t status);
/// The states of a run in their order; those before the start, and those that are rare, share a step.
std::vector<StateStep> stateSteps();

} // namespace drive

// State, faults and speed of every motor of a board of the older serial protocol.
#pragma once

#include "drive/legacy/legacy_reads.h"
#include "drive/vitals.h"

namespace drive {

class LegacyVitals final : public Vitals<LegacyProtocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override;
    std::optional<MotorStatus> statusOf(int motor) const override;
};

/// The states of a run in their order, by the names that the statuses carry.
std::vector<StateStep> legacyStateSteps();

} // namespace drive

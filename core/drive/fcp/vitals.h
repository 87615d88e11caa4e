// State, faults and speed of every motor of a board of the older serial protocol.
#pragma once

#include "drive/fcp/requests.h"
#include "drive/vitals.h"

namespace drive {

class FcpVitals final : public Vitals<FcpProtocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override;
    std::optional<MotorStatus> statusOf(int motor) const override;
};

} // namespace drive

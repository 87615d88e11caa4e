// The status word, the measured velocity, and the latest error where there is a fault.
#pragma once

#include "drive/mcb/requests.h"
#include "drive/vitals.h"

namespace drive {

class McbVitals final : public Vitals<McbProtocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override;
    std::vector<RegisterId> idsBehind() override;
    std::optional<MotorStatus> statusOf(int motor) const override;

    bool m_errorAsked = false; ///< in this round
};

} // namespace drive

// The motors behind a board of the older serial protocol, as its server sees them: values to be looked up before each
// answer, and what a request makes them do. Motors are counted from 0 here.
#pragma once

#include "legacy/protocol.h"
#include "legacy/request.h"
#include "simulation/legacy/rig.h"

#include <cstdint>

namespace simulation {

class LegacyMachine {
public:
    LegacyMachine() = default;
    LegacyMachine(const LegacyMachine &) = delete;
    LegacyMachine &operator=(const LegacyMachine &) = delete;
    virtual ~LegacyMachine() = default;

    /// Fills in what the motor's registers hold now.
    virtual void refresh(std::size_t motor, LegacyMotor &registers) = 0;

    virtual void written(std::size_t motor, std::uint8_t id, std::int64_t value) = 0;
    virtual void execute(std::size_t motor, legacy::CommandId command) = 0;
    virtual void setControlMode(std::size_t motor, bool torque) = 0;
    virtual void rampSpeed(std::size_t motor, std::int32_t rpm, std::uint16_t duration_ms) = 0;
    virtual void rampTorque(std::size_t motor, std::int16_t digits, std::uint16_t duration_ms) = 0;
    virtual void setCurrents(std::size_t motor, std::int16_t iq, std::int16_t id) = 0;
    virtual void setRevUp(
        std::size_t motor, std::size_t stage, const legacy::RevUpStage &values) = 0;
};

} // namespace simulation

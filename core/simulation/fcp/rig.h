// What a static board of the older serial protocol is and holds: no motor turns behind it, its values change only by
// what the protocol says, so that every answer can be foretold.
#pragma once

#include "base/time.h"
#include "fcp/request.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

struct FcpMotor {
    enum class Sensing : std::uint8_t { Pll, Cordic, Encoder, Hall };

    std::uint8_t state = 0; ///< STATUS
    std::uint8_t controlMode = 1; ///< 0 torque, 1 speed
    std::uint32_t faults = 0; ///< FLAGS: present now << 16 | not acknowledged
    Sensing sensing = Sensing::Pll;
    std::map<std::uint8_t, std::int64_t> registers; ///< raw digits; those not named are 0
    std::vector<fcp::RevUpStage> revUp; ///< empty: a build without
};

struct FcpRig {
    fcp::Dialect dialect = fcp::Dialect::Stm32;
    std::string name; ///< for messages
    std::vector<FcpMotor> motors{FcpMotor{}}; ///< 1 to 7
    bool fluxWeakening = false, feedForward = false, pfc = false, profiler = false, dac = false;
    std::string firmware = "ST MC SDK\tVer.5.4.3"; ///< answer of GET_FW_VERSION
    bool integersInBoardInfo = false; ///< its version as the text has it, not as digits
    std::int32_t speedStep_rpm = 6; ///< speeds are kept in whole steps, 1 or more rpm each
    std::optional<Duration>
        frameTimer; ///< from the header; none: a broken frame stays half received, as in 5.4.3
};

} // namespace simulation

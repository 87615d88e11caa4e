// What sets the simulated firmwares apart: how the SDK of a version behaves, read by every part of the board. What a
// project switched on is in build.h; which registers a version knows is in the register tables. Source: mcp-aspep facts
// 3 to 8 and the sessions recorded with 6.2.0 and 6.4.0; `spec` is the printed text where it can work beside them.
#pragma once

#include <cstdint>
#include <string_view>

namespace simulation {

struct Traits {
    std::string_view profile;
    std::string_view firmwareName; ///< FW_NAME
    std::uint32_t sdkVersion = 0; ///< as GLOBAL_CONFIG holds it
    std::uint32_t registerVersion = 0; ///< 0xMMmmpp: which registers it knows

    bool decodesInInterrupt = false; ///< headers are decoded when complete, not every 0.5 ms
    bool truncatesPingNumber = false; ///< connected, it echoes the second header byte as the number
    bool ignoresMotorBits = false; ///< of identifiers, with a single motor
    bool invertsStartStop = false; ///< START_STOP from IDLE answers NOK although the motor starts
    bool hasCpuLoadClear = false; ///< command 8
    bool hasProfilerCommand = false; ///< command 13
    bool hasSoftReset = false; ///< command 15 restarts the board
    bool hasSensorSwitch = false; ///< command 16
    bool hasScaleConfig = false;
    bool nominalCurrentInDigits = false; ///< APPLICATION_CONFIG of 14 bytes
    bool swapsPositionRamp = false; ///< in GET: duration first
    /// A fault sends the unfinished datalog packet; profiler builds always.
    bool flushesOnFault = false;
    bool scalesReadSpeeds = false; ///< GET of sensors' speeds: a fraction of the full scale
    /// The printed text wherever a Controller for shipped firmware survives it.
    bool asPrinted = false;
};

/// The row of a profile; nullptr if there is none of that name.
const Traits *findTraits(std::string_view profile);

} // namespace simulation

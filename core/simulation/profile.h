// What sets the simulated firmwares apart: one row a profile, read by every part of the board.
// Source: firmware 6.2.0 and 6.4.0 as recorded; `spec` is the printed text where it can work beside them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace simulation {

struct Traits {
    std::string_view profile;
    std::string_view firmwareName; ///< FW_NAME
    std::uint32_t sdkVersion; ///< as GLOBAL_CONFIG holds it
    bool decodesInInterrupt; ///< headers are looked at when they are complete, not every 0.5 ms
    bool truncatesPingNumber; ///< connected, it echoes the second header byte as the number
    bool invertsStartStop; ///< START_STOP from IDLE answers NOK although the motor starts
    bool hasSoftReset; ///< command 15 restarts the board
    bool hasHall; ///< Hall sensors beside the observer
    bool hasOpenLoopAngle; ///< OPENLOOP_EL_ANGLE can be logged
    bool flushesOnFault; ///< a fault sends the unfinished datalog packet
    bool scalesReadSpeeds; ///< speeds of sensors are read as a fraction of SCALE_CONFIG.frequency
    bool asPrinted; ///< the printed text wherever a Controller for shipped firmware survives it
};

/// The row of a profile; nullptr if there is none of that name.
const Traits *findTraits(std::string_view profile);

} // namespace simulation

// The 16-bit registers: a table from element number to the variable behind it.
#pragma once

#include "simulation/profile.h"
#include "simulation/signals.h"

#include <cstdint>

namespace simulation {

struct WordRegister {
    enum class Build : std::uint8_t { Every, Hall, OpenLoop };
    enum class Use : std::uint8_t {
        Measured, ///< read only
        Logged, ///< read only, and a source of the datalog
        Reference, ///< as Logged; a write is a command to the firmware
        LoggedSpeed, ///< as Logged; up to 6.2 read as a fraction of the full scale
        OnlyLogged, ///< neither read nor written
        Gain, ///< read and written
    };
    std::uint16_t element = 0;
    Use use = Use::Measured;
    std::int16_t Signals::*signal = nullptr;
    std::int16_t Tuning::*gain = nullptr;
    Build build = Build::Every;

    bool logged() const { return use != Use::Measured && use != Use::Gain; }
};

/// nullptr if this build does not have it.
const WordRegister *findWordRegister(unsigned element, const Traits &traits);

} // namespace simulation

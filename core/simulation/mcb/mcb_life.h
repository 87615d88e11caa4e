// What stands behind the registers of a slave that is more than its registers: a motor and its control.
#pragma once

#include "simulation/mcb/mcb_registers.h"

#include <optional>

namespace simulation {

class McbLife {
public:
    McbLife() = default;
    McbLife(const McbLife &) = delete;
    McbLife &operator=(const McbLife &) = delete;
    virtual ~McbLife() = default;

    /// Puts the present values into the registers; before every frame.
    virtual void show(McbRegisters &registers) = 0;
    /// Why a value that the register could hold is not taken; before it is stored.
    virtual std::optional<mcb::ErrorCode> refusal(
        std::uint16_t address, mcb::WordView words) const = 0;
    /// Something was stored, by a write or by a cyclic frame.
    virtual void look(const McbRegisters &registers) = 0;
};

} // namespace simulation

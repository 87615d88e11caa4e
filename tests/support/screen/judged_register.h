// How the judge knows a register by the name that is shown: its number in what the board gives, and what a digit of it
// is in the unit that is shown.
#pragma once

#include "support/judged_line.h"
#include "support/wire/fcp_board.h"
#include "support/wire/mcb_board.h"
#include "support/wire/mcp_registers.h"

#include <optional>
#include <string_view>

namespace support {

struct JudgedRegister {
    std::uint16_t id = 0; ///< with its motor
    double factor = 1.0; ///< of a digit to what is shown
};

inline std::optional<double> shownFactor(JudgedWorld &world, const judge::McpRegister &known)
{
    using Digit = judge::McpRegister::Digit;
    switch (known.digit) {
    case Digit::One:
        return 1.0;
    case Digit::Amps:
        if (const double amps = world.ampsPerDigit(); amps > 0.0)
            return amps;
        return {};
    case Digit::Degrees:
        return 360.0 / 65536.0;
    case Digit::Volts:
    case Digit::TenthHz:
        break;
    }
    return {};
}

/// @param raw  its digits are shown. Empty: not to the judge.
inline std::optional<JudgedRegister> judgedRegister(
    JudgedWorld &world, std::string_view name, int motor, bool raw)
{
    if (world.older()) {
        const auto *known = judge::findFcpRegister(name);
        if (known == nullptr || !(raw || known->plain))
            return {};
        return JudgedRegister{static_cast<std::uint16_t>(known->number << 3 | motor), 1.0};
    }
    if (!world.mcp()) {
        const auto *known = raw ? nullptr : judge::findMcbRegister(name);
        if (known == nullptr)
            return {};
        return JudgedRegister{
            static_cast<std::uint16_t>(known->address << 3 | motor), known->factor};
    }
    const auto *known = judge::findMcpRegister(name);
    const auto factor = known == nullptr ? std::nullopt
        : raw                            ? std::optional(1.0)
                                         : shownFactor(world, *known);
    if (!factor)
        return {};
    return JudgedRegister{static_cast<std::uint16_t>(known->bare | motor), *factor};
}

} // namespace support

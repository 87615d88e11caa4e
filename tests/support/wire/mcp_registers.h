// Registers of the MCSDK that a window shows, by the protocol's table: their numbers and what a digit of them is. Those
// that are texts, structures, flags or states are left out, and what other builds have.
#pragma once

#include <cstdint>
#include <string_view>

namespace judge {

struct McpRegister {
    enum class Digit : std::uint8_t {
        One, ///< of what the register is in, or a gain's numerator
        Amps, ///< by the board's scale
        Volts, ///< by the board's scale, which the judge does not know
        Degrees, ///< 65536 are a turn
        TenthHz, ///< in samples 6 rpm; as a value by firmware
    };
    std::string_view name;
    std::uint16_t bare = 0; ///< number without its motor
    Digit digit = Digit::One;
    bool isSigned = true;
};

inline constexpr McpRegister kMcpRegisters[] = {{"SPEED_MEAS", 0x0058}, {"SPEED_REF", 0x0098},
    {"SPEED_KP", 0x0090}, {"SPEED_KI", 0x00D0}, {"SPEED_KD", 0x0110}, {"I_Q_KP", 0x0190},
    {"I_Q_KI", 0x01D0}, {"I_Q_KD", 0x0210}, {"I_D_KP", 0x0290}, {"I_D_KI", 0x02D0},
    {"I_D_KD", 0x0310}, {"STOPLL_C1", 0x0350}, {"STOPLL_C2", 0x0390}, {"STOPLL_KI", 0x0450},
    {"STOPLL_KP", 0x0490}, {"FLUXWK_KP", 0x04D0}, {"FLUXWK_KI", 0x0510},
    {"BUS_VOLTAGE", 0x0590, McpRegister::Digit::One, false}, {"HEATS_TEMP", 0x05D0},
    {"I_A", 0x07D0, McpRegister::Digit::Amps}, {"I_B", 0x0810, McpRegister::Digit::Amps},
    {"I_ALPHA_MEAS", 0x0850, McpRegister::Digit::Amps},
    {"I_BETA_MEAS", 0x0890, McpRegister::Digit::Amps},
    {"I_Q_MEAS", 0x08D0, McpRegister::Digit::Amps}, {"I_D_MEAS", 0x0910, McpRegister::Digit::Amps},
    {"I_Q_REF", 0x0950, McpRegister::Digit::Amps}, {"I_D_REF", 0x0990, McpRegister::Digit::Amps},
    {"V_Q", 0x09D0, McpRegister::Digit::Volts}, {"V_D", 0x0A10, McpRegister::Digit::Volts},
    {"V_ALPHA", 0x0A50, McpRegister::Digit::Volts}, {"V_BETA", 0x0A90, McpRegister::Digit::Volts},
    {"ENCODER_EL_ANGLE", 0x0AD0, McpRegister::Digit::Degrees},
    {"ENCODER_SPEED", 0x0B10, McpRegister::Digit::TenthHz},
    {"STOPLL_EL_ANGLE", 0x0B50, McpRegister::Digit::Degrees},
    {"STOPLL_ROT_SPEED", 0x0B90, McpRegister::Digit::TenthHz},
    {"STOPLL_BEMF_ALPHA", 0x0C50, McpRegister::Digit::Volts},
    {"STOPLL_BEMF_BETA", 0x0C90, McpRegister::Digit::Volts}, {"SPEED_KP_DIV", 0x1450},
    {"SPEED_KI_DIV", 0x1490}, {"SPEED_KD_DIV", 0x14D0}, {"I_D_KP_DIV", 0x1510},
    {"I_D_KI_DIV", 0x1550}, {"I_D_KD_DIV", 0x1590}, {"I_Q_KP_DIV", 0x15D0}, {"I_Q_KI_DIV", 0x1610},
    {"I_Q_KD_DIV", 0x1650}, {"STOPLL_KI_DIV", 0x18D0}, {"STOPLL_KP_DIV", 0x1910}};

/// nullptr: not known to the judge.
inline const McpRegister *findMcpRegister(std::string_view name)
{
    for (const McpRegister &known : kMcpRegisters)
        if (known.name == name)
            return &known;
    return nullptr;
}

} // namespace judge

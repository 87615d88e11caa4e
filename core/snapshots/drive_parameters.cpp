#include "snapshots/drive_parameters.h"

#include "base/text.h"
#include "drive/values.h"
#include "motor/rev_up.h"

#include <array>
#include <cmath>

namespace snapshots {

namespace {

struct Macro {
    const char *macro = "";
    const char *registerName = "";
    const char *suffix = "";
};
constexpr const char *kPerUnit = "/(SPEED_UNIT/10)"; // as generated: registers count in 0.1 Hz

constexpr std::array kNumerators{Macro{"PID_TORQUE_KP_DEFAULT", "I_Q_KP"},
    Macro{"PID_TORQUE_KI_DEFAULT", "I_Q_KI"}, Macro{"PID_TORQUE_KD_DEFAULT", "I_Q_KD"},
    Macro{"PID_SPEED_KP_DEFAULT", "SPEED_KP", kPerUnit},
    Macro{"PID_SPEED_KI_DEFAULT", "SPEED_KI", kPerUnit},
    Macro{"PID_SPEED_KD_DEFAULT", "SPEED_KD", kPerUnit}, Macro{"GAIN1", "STOPLL_C1"},
    Macro{"GAIN2", "STOPLL_C2"}, Macro{"PLL_KP_GAIN", "STOPLL_KP"},
    Macro{"PLL_KI_GAIN", "STOPLL_KI"}, Macro{"CORD_GAIN1", "STOCORDIC_C1"},
    Macro{"CORD_GAIN2", "STOCORDIC_C2"}, Macro{"FW_KP_GAIN", "FLUXWK_KP"},
    Macro{"FW_KI_GAIN", "FLUXWK_KI"}, Macro{"FW_VOLTAGE_REF", "FLUXWK_BUS"},
    Macro{"PID_POSITION_KP_GAIN", "POSITION_KP"}, Macro{"PID_POSITION_KI_GAIN", "POSITION_KI"},
    Macro{"PID_POSITION_KD_GAIN", "POSITION_KD"}, Macro{"M1_CONSTANT1_Q", "FF_1Q"},
    Macro{"M1_CONSTANT1_D", "FF_1D"}, Macro{"M1_CONSTANT2_QD", "FF_2"}};
constexpr std::array kDivisors{Macro{"TF_KPDIV", "I_Q_KP_DIV"}, Macro{"TF_KIDIV", "I_Q_KI_DIV"},
    Macro{"TF_KDDIV", "I_Q_KD_DIV"}, Macro{"SP_KPDIV", "SPEED_KP_DIV"},
    Macro{"SP_KIDIV", "SPEED_KI_DIV"}, Macro{"SP_KDDIV", "SPEED_KD_DIV"},
    Macro{"PLL_KPDIV", "STOPLL_KP_DIV"}, Macro{"PLL_KIDIV", "STOPLL_KI_DIV"},
    Macro{"FW_KPDIV", "FLUXWK_KP_DIV"}, Macro{"FW_KIDIV", "FLUXWK_KI_DIV"},
    Macro{"PID_POSITION_KPDIV", "POSITION_KP_DIV"}, Macro{"PID_POSITION_KIDIV", "POSITION_KI_DIV"},
    Macro{"PID_POSITION_KDDIV", "POSITION_KD_DIV"}};

class Text {
public:
    Text(const Snapshot &snapshot, int motor)
        : m_snapshot(snapshot)
        , m_motor(motor)
    {
    }

    std::optional<std::int64_t> number(const std::string &name) const
    {
        const Entry *entry = m_snapshot.find(name, m_motor);
        const auto *whole = entry != nullptr ? std::get_if<std::int64_t>(&entry->value) : nullptr;
        return whole != nullptr ? std::optional(*whole) : std::nullopt;
    }
    void define(const std::string &macro, const std::string &value)
    {
        std::string line = "#define " + macro;
        line.resize(std::max<std::size_t>(line.size() + 1, 40), ' ');
        m_text += line + value + "\n";
    }
    void line(const std::string &text) { m_text += text + "\n"; }

    void numerators()
    {
        for (const Macro &row : kNumerators)
            if (const auto value = number(row.registerName))
                define(row.macro, std::to_string(*value) + row.suffix);
        for (const char *letter : {"P", "I", "D"})
            flux(std::string("K") + letter);
    }

    void divisors()
    {
        for (const Macro &row : kDivisors) {
            const auto exponent = number(row.registerName);
            if (!exponent || *exponent < 0 || *exponent > 15)
                continue;
            const std::string divisor = std::to_string(1 << *exponent);
            define(row.macro, divisor);
            define(std::string(row.macro) + "_LOG", "LOG2((" + divisor + "))");
        }
    }

    void revUp(double ampsPerDigit)
    {
        const Entry *entry = m_snapshot.find("REVUP_DATA", m_motor);
        const auto *bytes = entry != nullptr ? std::get_if<Bytes>(&entry->value) : nullptr;
        const auto stages = motor::revUpOfBytes(bytes != nullptr ? *bytes : Bytes{});
        if (!stages)
            return;
        for (std::size_t i = 0; i < stages->size(); ++i) {
            const motor::RevUpStage &stage = (*stages)[i];
            const std::string phase = "PHASE" + std::to_string(i + 1);
            define(phase + "_DURATION", std::to_string(stage.duration_ms));
            define(phase + "_FINAL_SPEED_UNIT",
                "(" + std::to_string(stage.speed_rpm) + "*SPEED_UNIT/U_RPM)");
            if (ampsPerDigit > 0.0)
                define(
                    phase + "_FINAL_CURRENT_A", shortNumber(stage.current_digits * ampsPerDigit));
            else
                define(phase + "_FINAL_CURRENT", std::to_string(stage.current_digits));
        }
    }

    std::string take() { return std::move(m_text); }

private:
    /// The flux regulator over the divisor that it shares with torque.
    void flux(const std::string &gain)
    {
        const auto value = number("I_D_" + gain);
        if (!value)
            return;
        const auto own = number("I_D_" + gain + "_DIV"), shared = number("I_Q_" + gain + "_DIV");
        const bool differ = own && shared && *own != *shared;
        const double same = differ
            ? std::ldexp(static_cast<double>(*value), static_cast<int>(*shared - *own))
            : 0.0;
        define(
            "PID_FLUX_" + gain + "_DEFAULT", std::to_string(differ ? std::llround(same) : *value));
    }

    const Snapshot &m_snapshot;
    int m_motor;
    std::string m_text;
};

/// The device's text must not end the comment it stands in.
std::string harmless(std::string text)
{
    for (char &c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == '*' || c == '\\' || c == '?' || c == 0x7F)
            c = ' ';
    return text;
}

} // namespace

std::string driveParametersHeader(const Snapshot &snapshot, int motor, double ampsPerDigit)
{
    Text text(snapshot, motor);
    text.line("/* Tuned values of motor " + std::to_string(motor) + ", read by Rotorscope.");
    text.line(" * Board: " + harmless(snapshot.board.controlBoard)
        + "; firmware: " + harmless(snapshot.board.firmware) + " */");
    text.line("#ifndef DRIVE_PARAMETERS_H\n#define DRIVE_PARAMETERS_H\n");
    text.line("/* Gains */");
    text.numerators();
    text.line("\n/* Divisors */");
    text.divisors();
    text.line("\n/* Rev-up */");
    text.revUp(ampsPerDigit);
    text.line("\n#endif /* DRIVE_PARAMETERS_H */");
    return text.take();
}

} // namespace snapshots

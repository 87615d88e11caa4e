#include "drive/start_target.h"

#include "drive/mcb/mcb_commands.h"

#include <array>
#include <cmath>
#include <string_view>

namespace drive {

namespace {

using catalog::Catalog;
using catalog::RegisterInfo;

// Of each kind the first that a board has. What is followed in the end, not the ramp on the way to it.
constexpr std::array<std::string_view, 2> kModes{"DRV_OP_CMD", "CONTROL_MODE"};
constexpr std::array<std::string_view, 4> kSpeeds{
    "CL_VEL_SET_POINT_VALUE", "RAMP_FINAL_SPEED", "FOC_SPEEDREF_FREQ_PU", "SPEED_REF"};
constexpr std::array<std::string_view, 3> kCurrents{"CL_CUR_Q_SET_POINT", "FOC_IQREF", "I_Q_REF"};

template <std::size_t N>
const RegisterInfo *first(const Catalog &catalog, const std::array<std::string_view, N> &names)
{
    for (const std::string_view name : names)
        if (const RegisterInfo *info = catalog.find(name); info != nullptr && info->readable())
            return info;
    return nullptr;
}

} // namespace

std::vector<catalog::RegisterId> startRegisters(const Catalog &catalog, int motor)
{
    std::vector<catalog::RegisterId> ids;
    for (const RegisterInfo *info :
        {first(catalog, kModes), first(catalog, kSpeeds), first(catalog, kCurrents)})
        if (info != nullptr)
            ids.push_back(catalog.withMotor(*info, motor));
    return ids;
}

StartTarget startTarget(const Catalog &catalog, const MotorLimits &limits, int motor,
    const std::function<std::optional<double>(catalog::RegisterId)> &shown)
{
    StartTarget target;
    const RegisterInfo *mode = first(catalog, kModes);
    const auto number = mode == nullptr ? std::nullopt : shown(catalog.withMotor(*mode, motor));
    if (!number)
        return target;
    target.control = mode->name == kModes.front()
        ? mcbControlOf(static_cast<std::uint16_t>(std::lround(*number)))
        : controlModeOf(std::lround(*number));
    const auto value = [&](const RegisterInfo *info) -> std::optional<double> {
        if (info == nullptr)
            return std::nullopt;
        const auto id = catalog.withMotor(*info, motor);
        const double each = setPointPerDigit(*info, {1.0, catalog.readScale(id).unit}, limits);
        const auto held = shown(id);
        return held && each > 0.0 ? std::optional(*held * each) : std::nullopt;
    };
    if (target.control == ControlMode::Speed)
        target.rpm = value(first(catalog, kSpeeds));
    else if (target.control == ControlMode::Torque)
        target.amps = value(first(catalog, kCurrents));
    return target;
}

} // namespace drive

#include "drive/start_target.h"

#include "base/bytes.h"
#include "drive/mcb/mcb_commands.h"
#include "drive/values.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace drive {

namespace {

using catalog::Catalog;
using catalog::RegisterInfo;

// Of each kind the first that a board has. What is followed in the end, not the ramp on the way to it.
constexpr std::array<std::string_view, 2> kModes{"DRV_OP_CMD", "CONTROL_MODE"};
constexpr std::array<std::string_view, 1> kRamps{"SPEED_RAMP"}; // s32 rpm, u16 ms
constexpr std::array<std::string_view, 4> kSpeeds{
    "CL_VEL_SET_POINT_VALUE", "RAMP_FINAL_SPEED", "FOC_SPEEDREF_FREQ_PU", "SPEED_REF"};
constexpr std::array<std::string_view, 3> kCurrents{"CL_CUR_Q_SET_POINT", "FOC_IQREF", "I_Q_REF"};

const RegisterInfo *first(const Catalog &catalog, std::span<const std::string_view> names)
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
    for (const RegisterInfo *info : {first(catalog, kModes), first(catalog, kRamps),
             first(catalog, kSpeeds), first(catalog, kCurrents)})
        if (info != nullptr)
            ids.push_back(catalog.withMotor(*info, motor));
    return ids;
}

StartTarget startTarget(
    const Catalog &catalog, const MotorLimits &limits, int motor, const ValueSource &held)
{
    StartTarget target;
    const auto valueOf = [&](const RegisterInfo *info) {
        return info == nullptr ? std::nullopt : held(catalog.withMotor(*info, motor));
    };
    const auto numberOf = [&](const RegisterInfo *info) -> std::optional<double> {
        const auto value = valueOf(info);
        return value ? asNumber(*value) : std::nullopt;
    };
    const RegisterInfo *mode = first(catalog, kModes);
    const auto number = numberOf(mode);
    if (!number)
        return target;
    target.control = mode->name == kModes.front() ? mcbControlOf(std::lround(*number))
                                                  : controlModeOf(std::lround(*number));
    const auto reference = [&](const RegisterInfo *info) -> std::optional<double> {
        const auto digits = numberOf(info);
        if (!digits)
            return std::nullopt;
        const catalog::Scale scale = catalog.readScale(catalog.withMotor(*info, motor));
        const double each = setPointPerDigit(*info, scale, limits);
        return each > 0.0 ? std::optional(*digits * each) : std::nullopt;
    };
    if (target.control == ControlMode::Speed) {
        const auto ramp = valueOf(first(catalog, kRamps));
        const auto *bytes = ramp ? std::get_if<Bytes>(&*ramp) : nullptr;
        constexpr std::size_t kRampBytes = 6;
        if (bytes != nullptr && bytes->size() == kRampBytes) {
            ByteReader reader(*bytes);
            target.rpm = reader.s32();
            target.ramp = std::chrono::milliseconds(reader.u16());
        } else {
            target.rpm = reference(first(catalog, kSpeeds));
        }
    } else if (target.control == ControlMode::Torque) {
        target.amps = reference(first(catalog, kCurrents));
    }
    return target;
}

} // namespace drive

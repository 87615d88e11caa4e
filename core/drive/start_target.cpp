#include "drive/start_target.h"

#include "base/bytes.h"
#include "drive/values.h"

#include <cmath>
#include <span>
#include <string_view>

namespace drive {

namespace {

using catalog::Catalog;
using catalog::ControlMode;
using catalog::RegisterInfo;

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
    const catalog::StartRegisters &start = catalog.start();
    for (const RegisterInfo *info : {first(catalog, start.mode), first(catalog, start.ramp),
             first(catalog, start.speed), first(catalog, start.current)})
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
    const catalog::StartRegisters &start = catalog.start();
    const auto number = numberOf(first(catalog, start.mode));
    if (!number)
        return target;
    target.control = start.controlOf(std::lround(*number));
    const auto reference = [&](const RegisterInfo *info) -> std::optional<double> {
        const auto digits = numberOf(info);
        if (!digits)
            return std::nullopt;
        const catalog::Scale scale = catalog.readScale(catalog.withMotor(*info, motor));
        const double each = setPointPerDigit(*info, scale, limits);
        return each > 0.0 ? std::optional(*digits * each) : std::nullopt;
    };
    if (target.control == ControlMode::Speed) {
        const auto ramp = valueOf(first(catalog, start.ramp));
        const auto *bytes = ramp ? std::get_if<Bytes>(&*ramp) : nullptr;
        constexpr std::size_t kRampBytes = 6;
        if (bytes != nullptr && bytes->size() == kRampBytes) {
            ByteReader reader(*bytes);
            target.rpm = reader.s32();
            target.ramp = std::chrono::milliseconds(reader.u16());
        } else {
            target.rpm = reference(first(catalog, start.speed));
        }
    } else if (target.control == ControlMode::Torque) {
        target.amps = reference(first(catalog, start.current));
    }
    return target;
}

} // namespace drive

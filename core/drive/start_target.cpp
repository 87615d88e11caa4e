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
    for (const RegisterInfo *info :
        {first(catalog, start.mode), first(catalog, start.ramp), first(catalog, start.speed),
            first(catalog, {&start.torqueRamp, 1}), first(catalog, start.current)})
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
    const auto reference = [&](const RegisterInfo *info,
                               std::optional<double> digits) -> std::optional<double> {
        if (info == nullptr || !digits)
            return std::nullopt;
        const catalog::Scale scale = catalog.readScale(catalog.withMotor(*info, motor));
        const double each = setPointPerDigit(*info, scale, limits);
        return each > 0.0 ? std::optional(*digits * each) : std::nullopt;
    };
    const auto bytesOf = [&](const RegisterInfo *info, std::size_t size) -> std::optional<Bytes> {
        const auto value = valueOf(info);
        const auto *bytes = value ? std::get_if<Bytes>(&*value) : nullptr;
        return bytes != nullptr && bytes->size() == size ? std::optional(*bytes) : std::nullopt;
    };
    if (target.control == ControlMode::Speed) {
        if (const auto bytes = bytesOf(first(catalog, start.ramp), 6)) {
            ByteReader reader(*bytes);
            target.rpm = reader.s32();
            target.ramp = std::chrono::milliseconds(reader.u16());
        } else {
            const RegisterInfo *speed = first(catalog, start.speed);
            target.rpm = reference(speed, numberOf(speed));
        }
    } else if (target.control == ControlMode::Torque) {
        const RegisterInfo *current = first(catalog, start.current);
        target.amps = reference(current, numberOf(current));
        // At rest the reference in force is 0, whatever a start goes to. One that was set without a ramp is in no ramp.
        const auto ramp = bytesOf(first(catalog, {&start.torqueRamp, 1}), 4);
        if (const int digits = ramp ? ByteReader(*ramp).s16() : 0; digits != 0)
            target.amps = reference(current, digits);
    }
    return target;
}

} // namespace drive

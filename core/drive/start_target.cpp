#include "drive/start_target.h"

#include "base/bytes.h"
#include "catalog/control_mode.h"
#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

#include <algorithm>
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

/// Of the last torque ramp: firmware keeps 16 bits, which come first in either length that it is read with.
std::string refuseTorque(const BoardFacts &board, int motor, const catalog::Value &held)
{
    const auto *bytes = std::get_if<Bytes>(&held);
    if (bytes == nullptr || bytes->size() < sizeof(std::int16_t))
        return {};
    const double digits = ByteReader(*bytes).s16();
    return refuseCurrent(board, motor, leastAmps(digits, board.ampsPerDigit(motor)));
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

std::string refuseStartTarget(const BoardFacts &board, int motor, const std::vector<Reading> &found)
{
    const Catalog &catalog = *board.catalog;
    const catalog::StartRegisters &start = catalog.start();
    const auto held = [&](catalog::RegisterId id) -> std::optional<catalog::Value> {
        const auto at = std::ranges::find(found, id, &Reading::id);
        return at != found.end() && at->status == ReadStatus::Ok ? std::optional(at->value)
                                                                 : std::nullopt;
    };
    const StartTarget target = startTarget(catalog, board.limitsOf(motor), motor, held);
    const bool torque = target.control == ControlMode::Torque;
    if (torque)
        if (auto why = refuseTorqueControl(board); !why.empty())
            return why;
    // At rest the references of torque and flux read as 0, whatever a start goes to.
    if (torque && start.torqueRamp.empty() && board.user.maxCurrentAmps > 0.0)
        return "in torque control this board does not tell to which current a start goes; "
               "take your own limit of current away first";
    const RegisterInfo *modes = first(catalog, start.mode);
    const auto mode = modes == nullptr ? std::nullopt : held(catalog.withMotor(*modes, motor));
    if (mode && *mode != catalog::Value(catalog::kPositionModeNumber)
        && target.control == ControlMode::Other)
        return "in this control mode no limit of your own holds: take yours away first";
    const bool byRamp = target.ramp.has_value(); // the reference is left from before, then
    for (const Reading &reading : found) {
        const RegisterInfo *info = catalog.find(reading.id);
        if (reading.status != ReadStatus::Ok || info == nullptr)
            continue;
        std::string name = catalog.nameOf(reading.id);
        if (start.isSource(info->name) && asNumber(reading.value).value_or(0.0) != 0.0)
            return name + " is on, and then no limit of your own holds: turn it off first";
        std::string why;
        if (info->name == start.ramp[0])
            why = byRamp ? refuseSpeed(board, motor, target.rpm.value_or(0.0)) : "";
        else if (info->name == start.torqueRamp)
            why = torque ? refuseTorque(board, motor, reading.value) : "";
        else if (const auto *raw = std::get_if<Bytes>(&reading.value))
            why = refuseStages(board, motor, *raw);
        else if (torque || (info->setPoint == catalog::SetPoint::Speed && !byRamp))
            why = refuseNumber(board, {reading.id, reading.value});
        if (!why.empty())
            return name.append(" is ").append(why);
    }
    return {};
}

} // namespace drive

#include "drive/set_points/shaft_position.h"

#include "drive/values.h"

#include <cmath>
#include <numbers>

namespace drive {

namespace {

using catalog::RegisterInfo;

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

struct Counter {
    const RegisterInfo *position = nullptr;
    const RegisterInfo *countsPerTurn = nullptr; ///< where it counts; else it is in radians
};

Counter counterOf(const catalog::Catalog &catalog)
{
    const auto readable = [&](const char *name) {
        const RegisterInfo *info = catalog.find(name);
        return info != nullptr && info->readable() ? info : nullptr;
    };
    if (const RegisterInfo *radians = readable("CURRENT_POSITION"))
        return {radians, nullptr};
    const RegisterInfo *counts = readable("CL_POS_FBK_VALUE");
    const RegisterInfo *each = readable("FBK_DIGENC1_RESOLUTION");
    return counts != nullptr && each != nullptr ? Counter{counts, each} : Counter{};
}

} // namespace

std::vector<RegisterId> shaftRegisters(const catalog::Catalog &catalog, int motor)
{
    std::vector<RegisterId> ids;
    const Counter counter = counterOf(catalog);
    for (const RegisterInfo *info : {counter.position, counter.countsPerTurn})
        if (info != nullptr)
            ids.push_back(catalog.withMotor(*info, motor));
    return ids;
}

std::optional<double> shaftAngle_rad(
    const catalog::Catalog &catalog, int motor, const ValueSource &held)
{
    const Counter counter = counterOf(catalog);
    const auto numberOf = [&](const RegisterInfo *info) -> std::optional<double> {
        const auto value = info ? held(catalog.withMotor(*info, motor)) : std::nullopt;
        const auto number = value ? asNumber(*value) : std::nullopt;
        return number && std::isfinite(*number) ? number : std::nullopt;
    };
    const auto position = numberOf(counter.position);
    if (!position || counter.countsPerTurn == nullptr)
        return position;
    const auto counts = numberOf(counter.countsPerTurn);
    return counts && *counts >= 1.0 ? std::optional(*position / *counts * kTurn_rad) : std::nullopt;
}

} // namespace drive

// A motor as described by a board, a file, a data sheet. Each figure is there or is not; two descriptions can be
// laid side by side. Phase values and peak amperes, as in constants.h. Pure functions.
#pragma once

#include "motor/constants.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace motor {

struct MotorSheet {
    std::string name; ///< empty: none
    std::optional<double> polePairs;
    std::optional<double> rs_ohm, ld_h, lq_h;
    std::optional<double> flux_wb;
    std::optional<double> nominalCurrent_a; ///< peak
    std::optional<double> maxSpeed_rpm;
    std::optional<double> bus_v; ///< nominal
    std::optional<double> inertia_kgm2;
    std::optional<double> viscous_nms; ///< friction torque per rad/s
    std::optional<double> coulomb_nm; ///< friction torque at any speed

    /// What motorConstants() and checkMotor() take; 0 for what is not there.
    MotorParameters parameters() const;
};

enum class MotorQuantity : std::uint8_t {
    PolePairs,
    Resistance,
    InductanceD,
    InductanceQ,
    Flux,
    NominalCurrent,
    MaxSpeed,
    BusVoltage,
    Inertia,
    ViscousFriction,
    DryFriction,
};

struct MotorQuantityInfo {
    MotorQuantity quantity;
    std::optional<double> MotorSheet::*member;
    std::string_view unit;
};

/// All of them, in the order of the enumeration.
std::span<const MotorQuantityInfo> motorQuantities();

/// One figure in two descriptions.
struct MotorComparison {
    MotorQuantity quantity = MotorQuantity::PolePairs;
    std::optional<double> here, there;
    /// Both are there, and farther apart than the tolerance.
    bool differs = false;
    bool operator==(const MotorComparison &) const = default;
};

/// Every figure that at least one of them has.
/// @param tolerance  of the larger one; single precision and rounding to three digits are no difference
std::vector<MotorComparison> compareMotors(
    const MotorSheet &here, const MotorSheet &there, double tolerance = 2e-3);

} // namespace motor

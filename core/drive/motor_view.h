// What a board says of one motor and of how it drives it: the structures it describes itself with, as named members
// with units, and the few facts that tuning starts from. Neutral: which bytes hold what is known behind this header
// only. Pure functions; they ask for nothing.
#pragma once

#include "drive/event.h"
#include "motor/gain_plan.h"
#include "motor/sheet.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace drive {

/// What tuning starts from. 0: the board does not say, or was not asked yet.
struct MotorFacts {
    motor::MotorParameters motor; ///< its nominal current is the motor's own
    std::string name;
    double bus_v = 0.0; ///< nominal
    MotorLimits limits; ///< of the drive, and what its set-points stay within
    double ampsPerDigit = 0.0;
    double controlPeriod_s = 0.0, speedPeriod_s = 0.0;
    double inertia_kgm2 = 0.0; ///< as a profiler found it
    /// How late the measured speed is with the average that ST's generator takes for the board's sensor: half its
    /// length. No board tells the one that it was built with.
    double speedDelay_s = 0.0;
    /// Of the current loop: ST's advice for how the board measures currents.
    double bandwidthGuide_radps = 0.0;
    bool sixStep = false;
    /// The sensor that knows the angle at rest, by which the drive starts; empty: by a rev-up, or not known.
    std::string angleSensor;
    /// The strength of the magnets was given per hertz instead of per 1000 rpm.
    bool fluxPerHertz = false;
};

/// One member of a structure.
struct StructureField {
    std::string key; ///< core's own word, unique among all of them, e.g. "pole pairs"
    std::string unit; ///< empty: a count, a name, flags
    Value value; ///< a whole number, a floating-point one or a text, in that unit
    bool flags = false;
    /// Of the bits that are set, or the one of an enumeration's value.
    std::vector<std::string> names;
};

/// One structure; without members where it was not read or has an unknown length.
struct StructureView {
    enum class Of : std::uint8_t { Motor, Limits, Firmware, Scales, Board } of{};
    RegisterId id = 0; ///< of this motor
    std::string name; ///< of the register
    bool writable = false;
    std::optional<std::size_t> bytes; ///< how many were read
    std::vector<StructureField> fields;
};

/// The newest value of a register, if there is one.
using ValueSource = std::function<std::optional<Value>(RegisterId)>;

/// What has to be read for the two functions below; only what this board has.
std::vector<RegisterId> motorRegisters(const catalog::Catalog &catalog, int motor);

MotorFacts motorFacts(const catalog::Catalog &catalog, int motor, const ValueSource &known);

/// The same as a description that files can be compared with; what the board does not say is not in it.
motor::MotorSheet sheetOf(const MotorFacts &facts);

/// The same as what a gain plan starts from.
motor::GainPlant gainPlant(const MotorFacts &facts);

/// In the order of StructureView::Of.
std::vector<StructureView> motorStructures(
    const catalog::Catalog &catalog, int motor, const ValueSource &known);

} // namespace drive

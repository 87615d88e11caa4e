// What a bandwidth of the current loops and a damping of the speed loop ask of a board's gains: the numbers for its
// registers, what the loops will do with them, and what is wrong about it. The one place that the window and the
// command line take such numbers from. Pure functions; nothing is sent.
#pragma once

#include "motor/constants.h"
#include "motor/fixed_point.h"
#include "motor/speed_loop.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace motor {

/// Torque is the loop of Iq, flux the one of Id.
enum class GainId : std::uint8_t { TorqueKp, TorqueKi, FluxKp, FluxKi, SpeedKp, SpeedKi };
constexpr std::size_t kGainIds = 6;
/// One of something a gain; indexed with indexOf().
template <class T>
using PerGain = std::array<T, kGainIds>;
constexpr std::size_t indexOf(GainId id) { return static_cast<std::size_t>(id); }

/// The motor and the board. 0: not known.
struct GainPlant {
    MotorParameters motor;
    double inertia_kgm2 = 0.0; ///< rotor and load
    PowerStage stage;
    double speedPeriod_s = 0.0; ///< of the speed loop
    double speedDelay_s = 0.0; ///< of the measured speed; 0: none
    /// Beyond it the way of measuring currents is known to struggle.
    double bandwidthGuide_radps = 0.0;

    CurrentPlant torque() const { return {motor.rs_ohm, motor.lq_h}; }
    CurrentPlant flux() const { return {motor.rs_ohm, motor.ld_h}; }
    SpeedPlant speed() const
    {
        return {ktOfFlux_nmpa(motor.flux_wb, motor.polePairs), inertia_kgm2};
    }
};

struct GainWish {
    double bandwidth_radps = 0.0; ///< of the current loops, by ST's rule
    double damping = 0.0; ///< of the speed loop, > 1; 0: it stays as it is
};

enum class GainWarning : std::uint8_t {
    // These are in the way: blocks().
    MotorMissing, ///< Rs, Ld or Lq
    ScaleMissing, ///< the bus voltage, or what a digit of current is worth
    PeriodMissing, ///< the control rate
    BandwidthBeyondLimit, ///< [rad/s]
    DoesNotFit, ///< with no divisor
    RoundsToZero,
    ProductTooLarge,
    // The speed loop was left alone.
    SpeedNeedsFlux, ///< flux or pole pairs
    SpeedNeedsInertia,
    SpeedNeedsPeriod, ///< the rate of the speed loop
    // Worth knowing.
    BandwidthBeyondGuide, ///< [rad/s]
    CurrentMarginSmall, ///< [degrees]
    SpeedMarginSmall, ///< [degrees]
    CoarseRounding, ///< [fraction]
    LdAboveLq,
};
/// Such gains must not be written.
constexpr bool blocks(GainWarning warning) { return warning < GainWarning::SpeedNeedsFlux; }

struct GainFinding {
    GainWarning warning = GainWarning::MotorMissing;
    std::optional<GainId> gain; ///< where it is about one
    double is = 0.0, limit = 0.0; ///< in the unit that the warning names
    bool operator==(const GainFinding &) const = default;
};

constexpr double kSmallMargin_deg = 45.0;
constexpr double kCoarseRounding = 0.02;
/// A divisor that is there is kept up to this rounding, so that few registers change and ST's own numbers come out.
constexpr double kFineRounding = 0.005;

struct PlannedGain {
    GainId id = GainId::TorqueKp;
    double asked = 0.0; ///< physical, by ST's rule: V/A, V/(A s); A/(rad/s), A/rad
    double real = 0.0; ///< what the kept digits make at the motor
    Quantised quantised;
};

/// What a current loop does with its gains.
struct CurrentForecast {
    double ruleBandwidth_radps = 0.0; ///< what ST's rule takes it for
    double realBandwidth_radps = 0.0; ///< at the motor
    double phaseMargin_deg = 0.0; ///< with the delay of a late timer
    StepPrediction step; ///< with a prompt timer: the slower rise
    double lateOvershoot = 0.0; ///< with a late one: the larger overshoot
};
/// @param digits  as the firmware has them, both > 0
/// @param duration_s  of the step; 0: ten time constants
CurrentForecast forecastCurrent(const PiGains &digits, const CurrentPlant &plant,
    const PowerStage &stage, double duration_s = 0.0);

/// What the speed loop does with its gains.
struct SpeedForecast {
    double lag_s = 0.0;
    LoopMargin margin;
    StepPrediction step;
    double largestStep_rpm = 0.0; ///< the current stays below the motor's nominal one; 0: not known
};
/// @param digits  as the firmware has them, Kp > 0
/// @param realBandwidth_radps  of the current loop
SpeedForecast forecastSpeed(const PiGains &digits, const GainPlant &plant,
    double realBandwidth_radps, double duration_s = 0.0);

struct GainPlan {
    std::vector<PlannedGain> gains; ///< torque, flux, then speed; four without the speed loop
    std::optional<CurrentForecast> current; ///< of torque
    std::optional<SpeedForecast> speed;
    double rampedOvershoot = 0.0; ///< of the speed behind a prefilter, which a ramp resembles
    std::vector<GainFinding> findings; ///< in the order of the enumeration

    bool blocked() const; ///< these gains must not be written
    const PlannedGain *find(GainId id) const; ///< nullptr if it stays as it is
};

/// @param wish  bandwidth > 0
/// @param divisors  exponents that the board has now; empty: not known, the finest is taken
GainPlan planGains(
    const GainPlant &plant, const GainWish &wish, const PerGain<std::optional<int>> &divisors);

/// The physical gain that digits make at the motor: V/A and V/(A s), A/(rad/s) and A/rad. Empty: a scale is not known.
std::optional<double> physicalGain(GainId id, double digits, const GainPlant &plant);

} // namespace motor

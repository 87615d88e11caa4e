// The rules behind the defaults: bandwidths by features 6.2 and 6.3, the observer by 6.6, the start by 6.5 but quicker,
// as light rotors allow.
#include "simulation/firmware/design.h"

#include "simulation/firmware/feed_forward.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr double kRoot3 = 1.7320508075688772;
constexpr double kTimer_hz = 170e6;
/// D of the symmetrical optimum: 17 % overshoot of a hard step.
constexpr double kSpeedDamping = 4.0;
constexpr double kStartShare = 0.5; ///< of the nominal current, for alignment and rev-up
constexpr double kRevUpSpeedShare = 0.3, kStartMinimumShare = 0.15; ///< of the maximum speed
constexpr double kAccelerationShare = 0.3; ///< of the torque that is left over friction

double radps(double rpm) { return rpm * 2.0 * std::numbers::pi / 60.0; }

std::int16_t digits(double amps, const CurrentSensing &sensing)
{
    return saturate16(std::llround(amps * sensing.digitsPerAmp()));
}

double torqueConstant(const MotorParameters &m) { return 1.5 * m.polePairs * m.flux_wb; }

/// The closed current loop as fast as features 6.2 advises, slower where the control rate is low. Buried magnets want
/// more: at little current dead time acts as a resistance that the observer does not know, and a slow loop lets angle
/// and currents hunt each other.
double currentBandwidth(const MotorParameters &motor, double hfHz)
{
    const bool salient = motor.lq_h > 1.2 * motor.ld_h;
    return salient ? std::min(4000.0, 0.3 * hfHz) : std::min(1500.0, 0.1 * hfHz);
}

RevUp::Stages revUpFor(const MotorParameters &m, const CurrentSensing &sensing)
{
    const double amps = kStartShare * m.nominal_a, kt = torqueConstant(m);
    // A rotor that is let go swings around the field; this is one swing to and fro.
    const double swing_s =
        2.0 * std::numbers::pi / std::sqrt(m.polePairs * kt * amps / m.inertia_kgm2);
    const double rpm = std::round(kRevUpSpeedShare * m.maxSpeed_rpm / 60.0) * 60.0;
    const double left_nm = kt * amps - m.coulomb_nm - m.cogging_nm - m.viscous_nms * radps(rpm);
    const double alpha = kAccelerationShare * std::max(left_nm, 0.1 * kt * amps) / m.inertia_kgm2;
    const auto ms = [](double seconds) {
        return static_cast<std::uint16_t>(
            std::clamp(std::ceil(seconds * 100.0) * 10.0, 30.0, 5000.0));
    };
    // First the current comes, then the field creeps by a third of a turn, so that a rotor that happens to stand
    // against it moves too; only then it runs.
    const double creep_s = std::max(1.5 * swing_s, 0.12);
    const auto creep = 6 * static_cast<std::int32_t>(40.0 / (m.polePairs * creep_s) / 6.0);
    const auto speed = static_cast<std::int32_t>(rpm);
    const std::int16_t torque = digits(amps, sensing);
    return {{{0, torque, ms(0.75 * swing_s)}, {creep, torque, ms(creep_s)},
        {speed, torque, ms(std::max(radps(rpm) / alpha, 5.0 * swing_s))}, {speed, torque, 100},
        {speed, torque, 0}}};
}

/// How late the averaged speed of the sensor that closes the loop is.
double speedDelay_s(
    const PlantParameters &plant, const DriveDesign &design, double hfHz, SpeedSensor main)
{
    if (main == SpeedSensor::Encoder)
        return 0.5 * design.encoder.depth / 1000.0;
    if (main == SpeedSensor::Hall) // six edges a period; at the speed of a start
        return 0.5 * design.hall.depth
            / (6.0 * plant.motor.polePairs * kRevUpSpeedShare * plant.motor.maxSpeed_rpm / 60.0);
    return 0.5 * design.pll.speed.depth / hfHz;
}

void designSensors(const PlantParameters &plant, double hfHz, DriveDesign &design)
{
    const MotorParameters &m = plant.motor;
    const auto hf = static_cast<std::uint16_t>(std::lround(hfHz));
    const SpeedRange range{.max_dHz = design.pll.speed.maxReliable_dHz};
    if (plant.sensors.encoderPulses > 0)
        design.encoder = {.countsPerTurn = 4 * plant.sensors.encoderPulses,
            .counterRange = 4 * plant.sensors.encoderPulses,
            .polePairs = m.polePairs,
            .hfHz = hf,
            .depth = 8,
            .range = range};
    const double placement = plant.sensors.hallPlacement_deg / 360.0 * 65536.0;
    design.hall = {.polePairs = m.polePairs,
        .phaseShift = wrapAngle(static_cast<std::int32_t>(std::lround(placement))),
        .hfHz = hf,
        .range = range};
}

/// A position loop of 80 rad/s, critically damped by the inertia that is known.
void designPosition(const PlantParameters &plant, Tuning &t)
{
    constexpr double kOwn_radps = 80.0, kMf_hz = 1000.0;
    const MotorParameters &m = plant.motor;
    const double each = sensingOf(plant).digitsPerAmp() * 2.0 * std::numbers::pi / 65536.0;
    const double kp = m.inertia_kgm2 * kOwn_radps * kOwn_radps / torqueConstant(m) * each;
    const auto put = [](double gain, std::int16_t &numerator, std::int16_t &divisor) {
        const Fraction f = fractionOf(gain, divisor);
        numerator = f.numerator;
        divisor = static_cast<std::int16_t>(f.shift);
    };
    put(kp, t.positionKp, t.positionKpDiv);
    put(kp * 0.2 * kOwn_radps / kMf_hz, t.positionKi, t.positionKiDiv);
    put(kp * 2.0 / kOwn_radps * kMf_hz, t.positionKd, t.positionKdDiv);
}

void designLoops(const PlantParameters &plant, double hfHz, SpeedSensor main, DriveDesign &design)
{
    const MotorParameters &m = plant.motor;
    const CurrentSensing sensing = sensingOf(plant);
    const double bandwidth = currentBandwidth(m, hfHz);
    const Pi::Gains q = currentGains(m.lq_h, m.rs_ohm, bandwidth, sensing, hfHz);
    const Pi::Gains d = currentGains(m.ld_h, m.rs_ohm, bandwidth, sensing, hfHz);
    const Pi::Gains speed = speedGains({.inertia_kgm2 = m.inertia_kgm2,
                                           .torqueConstant_nmPerA = torqueConstant(m),
                                           .currentBandwidth_radps = bandwidth,
                                           .filter_s = speedDelay_s(plant, design, hfHz, main),
                                           .hfHz = hfHz,
                                           .damping = kSpeedDamping},
        sensing);
    const auto put = [](const Pi::Gains &gains, std::int16_t &kp, std::int16_t &ki,
                         std::int16_t &kpDiv, std::int16_t &kiDiv) {
        kp = gains.kp;
        ki = gains.ki;
        kpDiv = static_cast<std::int16_t>(gains.kpShift);
        kiDiv = static_cast<std::int16_t>(gains.kiShift);
    };
    Tuning &t = design.tuning;
    put(q, t.qKp, t.qKi, t.qKpDiv, t.qKiDiv);
    put(d, t.dKp, t.dKi, t.dKpDiv, t.dKiDiv);
    put(speed, t.speedKp, t.speedKi, t.speedKpDiv, t.speedKiDiv);
}

void designObservers(const PlantParameters &plant, double hfHz, DriveDesign &design)
{
    const MotorParameters &m = plant.motor;
    const double fastest_radps = m.polePairs * radps(1.2 * m.maxSpeed_rpm);
    const ObserverConstants observer = observerGains({.rs_ohm = m.rs_ohm,
        .ls_h = m.lq_h,
        .hfHz = hfHz,
        .maxCurrent_a = plant.inverter.maxReadable_a(),
        .maxBemf_v = fastest_radps * m.flux_wb,
        .maxVoltage_v = plant.inverter.busRange_v / kRoot3});
    const double max_dHz = m.maxSpeed_rpm / 6.0;
    SpeedEstimateParameters speed;
    speed.hfHz = static_cast<std::uint16_t>(std::lround(hfHz));
    speed.polePairs = m.polePairs;
    // Four milliseconds, as with 64 periods of 16 kHz.
    speed.depth = std::clamp(static_cast<int>(std::lround(0.004 * hfHz)), 8, 64);
    speed.depthDpp = speed.depth;
    speed.maxReliable_dHz = static_cast<std::uint16_t>(1.15 * max_dHz);
    speed.startUpMinimum_dHz = static_cast<std::uint16_t>(kStartMinimumShare * max_dHz);
    // Half the back-EMF must be seen, or the rotor is not where it seems: ST's default of 64 looks at nothing.
    speed.bemfTolerance = 48;
    // At half the maximum speed the PLL is critically damped.
    const double half_digits = 32767.0 * 0.5 / 1.2;
    const double follow_radps = std::min(400.0, 0.1 * hfHz);
    const Pi::Gains pll = pllGains(follow_radps, 1.0, half_digits, hfHz);
    design.pll = {.observer = observer, .speed = speed, .pll = pll};
    Tuning &t = design.tuning;
    t.pllC1 = t.cordicC1 = observer.gain1;
    t.pllC2 = t.cordicC2 = observer.gain2;
    t.pllKp = pll.kp;
    t.pllKi = pll.ki;
    t.pllKpDiv = static_cast<std::int16_t>(pll.kpShift);
    t.pllKiDiv = static_cast<std::int16_t>(pll.kiShift);
    speed.varianceThreshold = 512; // 400 %
    design.cordic = {.observer = observer, .speed = speed};
}

} // namespace

CurrentSensing sensingOf(const PlantParameters &plant)
{
    return {.bus_v = plant.inverter.supply_v,
        .shunt_ohm = plant.inverter.shunt_ohm,
        .amplifierGain = plant.inverter.amplifierGain,
        .reference_v = plant.inverter.converterReference_v};
}

DriveDesign designFor(const PlantParameters &plant, double hfHz, SpeedSensor main)
{
    const MotorParameters &m = plant.motor;
    const CurrentSensing sensing = sensingOf(plant);
    DriveDesign design;
    design.stage = {.maxReadable_a = plant.inverter.maxReadable_a(),
        .nominal_v = plant.inverter.supply_v,
        .nominal_a = m.nominal_a,
        .maxSpeed_rpm = static_cast<int>(m.maxSpeed_rpm),
        .busFullScale_v = plant.inverter.busRange_v};
    design.polePairs = m.polePairs;
    design.defaultSpeed_rpm =
        static_cast<std::int16_t>(std::round(0.375 * m.maxSpeed_rpm / 60.0) * 60.0);
    design.alignmentTorque = digits(kStartShare * m.nominal_a, sensing);
    design.pwmPeriod =
        static_cast<std::uint16_t>(std::clamp(kTimer_hz / (2.0 * hfHz), 100.0, 65535.0));
    design.currentLimit = digits(m.nominal_a, sensing);
    design.demagnetising = design.currentLimit * 7 / 10;
    design.protection.trip_digits =
        std::min<std::int32_t>(digits(3.0 * m.nominal_a, sensing), 30000);
    design.tuning.overVoltage_v =
        static_cast<std::int16_t>(std::lround(1.25 * plant.inverter.supply_v));
    design.tuning.underVoltage_v =
        static_cast<std::int16_t>(std::lround(0.5 * plant.inverter.supply_v));
    design.revUp = revUpFor(m, sensing);
    designObservers(plant, hfHz, design);
    designSensors(plant, hfHz, design);
    designLoops(plant, hfHz, main, design);
    designPosition(plant, design.tuning);
    FeedForward::design(plant, hfHz, design.tuning);
    return design;
}

} // namespace simulation

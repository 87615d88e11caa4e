// The numbers that this board's project was generated with: what a generated drive_parameters.h holds for a motor and a
// power stage. Pure functions of the plant's parameters. Source: features 6.2, 6.3, 6.5, 6.6.
#pragma once

#include "simulation/firmware/build.h"
#include "simulation/firmware/protection.h"
#include "simulation/firmware/rev_up.h"
#include "simulation/maths/encoder_sensor.h"
#include "simulation/maths/gains.h"
#include "simulation/maths/hall_sensor.h"
#include "simulation/maths/sensorless.h"
#include "simulation/plant/parameters.h"
#include "simulation/signals.h"

namespace simulation {

/// What the board's design fixes and its structures tell: how digits relate to amps and volts, what it allows.
/// Source: mcp-aspep sections 7, 8 and 9.
struct Stage {
    double maxReadable_a = 60.175056458; ///< 32768 digits
    double nominal_v = 24.0; ///< of the bus
    double nominal_a = 5.0; ///< peak
    int maxSpeed_rpm = 4000;
    double busFullScale_v = 60.0; ///< of the bus converter, 65536 digits

    double ampsPerDigit() const { return maxReadable_a / 32768.0; }
    double voltsPerDigit() const { return nominal_v / (1.7320508075688772 * 32767.0); }
};

struct DriveDesign {
    Stage stage;
    Tuning tuning;
    int polePairs = 1;

    // Start without a sensor.
    RevUp::Stages revUp{};
    std::size_t firstAcceleration = 2; ///< the stage from which the observer is believed
    int transition_ms = 25;
    std::int16_t defaultSpeed_rpm = 1500;

    // Start with an encoder.
    int alignment_ms = 500;
    std::int16_t alignmentTorque = 0; ///< digits, reached after half of it

    std::uint16_t pwmPeriod = 5312; ///< counts of half a PWM period
    std::int32_t currentLimit = 0; ///< digits: |iq|
    std::int32_t demagnetising = 0; ///< digits: how far below zero flux weakening may take id

    ObserverPll::Parameters pll{};
    ObserverCordic::Parameters cordic{};
    EncoderSensor::Parameters encoder{};
    HallSensor::Parameters hall{};
    Protection::Limits protection;
};

/// A sound project for this motor on this power stage at this control rate, with `main` in the speed loop.
DriveDesign designFor(const PlantParameters &plant, double hfHz, SpeedSensor main);

/// The sensing chain of the power stage, in the units of the gain formulas.
CurrentSensing sensingOf(const PlantParameters &plant);

} // namespace simulation

// One motor with its firmware on virtual time, both tasks at their rates; what the world outside sees is not here.
#pragma once

#include "simulation/axis.h"
#include "simulation/plant/presets.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace support {

using simulation::Axis;
using simulation::Build;
using simulation::Firmware;
using simulation::MotorState;
using simulation::PlantParameters;

constexpr double kRpmPerRadps = 30.0 / std::numbers::pi;

/// With the sensor that the motor has in the speed loop.
inline simulation::DriveDesign usualDesign(const simulation::PlantParameters &plant, double hfHz)
{
    using simulation::SpeedSensor;
    const SpeedSensor main = plant.sensors.encoderPulses > 0 ? SpeedSensor::Encoder
        : plant.sensors.hall                                 ? SpeedSensor::Hall
                                                             : SpeedSensor::ObserverPll;
    return simulation::designFor(plant, hfHz, main);
}

struct AxisBench {
    static constexpr double kHf_hz = 16000.0;
    static constexpr int kHfPerMs = 16;

    explicit AxisBench(const PlantParameters &plant = simulation::presets().front().parameters,
        const Build &build = {}, std::uint64_t seed = 1)
        : axis(plant, build, kHf_hz, seed)
    {
    }
    AxisBench(const PlantParameters &plant, const Build &build,
        const simulation::DriveDesign &design, std::uint64_t seed = 1)
        : axis(plant, build, design, kHf_hz, seed)
    {
    }

    void ms(int count)
    {
        for (int i = 0; i < count; ++i) {
            firmware.mfTask();
            for (int k = 0; k < kHfPerMs; ++k)
                axis.hfTask();
        }
    }
    bool reaches(MotorState state, int mostMs)
    {
        for (int i = 0; i < mostMs && firmware.state() != state; ++i)
            ms(1);
        return firmware.state() == state;
    }
    bool runs(int mostMs = 1500)
    {
        ms(20); // the processor has just been switched on
        return firmware.start() && reaches(MotorState::Run, mostMs);
    }
    double speed_rpm() const { return axis.plant.speed_radps() * kRpmPerRadps; } ///< the truth

    Axis axis;
    Firmware &firmware = axis.firmware;
};

} // namespace support

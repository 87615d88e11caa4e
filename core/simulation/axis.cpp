#include "simulation/axis.h"

#include <numbers>

namespace simulation {

MotorTruth truthOf(const Axis &axis)
{
    const MotorState state = axis.firmware.state();
    const Stage &stage = axis.firmware.stage();
    const bool idle = state == MotorState::Idle || state == MotorState::FaultNow
        || state == MotorState::FaultOver;
    return {.driven = !idle && state != MotorState::Stop,
        .idle = idle,
        .state = state,
        .faults = axis.firmware.faultFlags(),
        .rpm = axis.plant.speed_radps() * 30.0 / std::numbers::pi,
        .measuredRpm = double(axis.firmware.speed_rpm()),
        .referenceRpm = double(axis.firmware.speedReference_rpm()),
        .iqAmps = axis.plant.iq_a(),
        .maxRpm = double(stage.maxSpeed_rpm),
        .ampsPerDigit = stage.ampsPerDigit(),
        .maxAmps = stage.maxReadable_a};
}

MotorTruth truthOf(const Axes &axes, int motor)
{
    const bool there = motor >= 1 && static_cast<std::size_t>(motor) <= axes.size();
    return there ? truthOf(*axes[static_cast<std::size_t>(motor) - 1U]) : MotorTruth{};
}

} // namespace simulation

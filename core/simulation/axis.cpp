#include "simulation/axis.h"

#include <numbers>

namespace simulation {

MotorTruth truthOf(const Axis &axis)
{
    const MotorState state = axis.firmware.state();
    const Stage &stage = axis.firmware.stage();
    MotorTruth truth;
    truth.idle = state == MotorState::Idle || state == MotorState::FaultNow
        || state == MotorState::FaultOver;
    truth.driven = !truth.idle && state != MotorState::Stop;
    truth.state = state;
    truth.faults = axis.firmware.faultFlags();
    truth.measuredRpm = axis.firmware.speed_rpm();
    truth.referenceRpm = axis.firmware.speedReference_rpm();
    truth.rpm = axis.plant.speed_radps() * 30.0 / std::numbers::pi;
    truth.iqAmps = axis.plant.iq_a();
    truth.maxRpm = stage.maxSpeed_rpm;
    truth.ampsPerDigit = stage.ampsPerDigit();
    truth.maxAmps = stage.maxReadable_a;
    return truth;
}

MotorTruth truthOf(const Axes &axes, int motor)
{
    const bool there = motor >= 1 && static_cast<std::size_t>(motor) <= axes.size();
    return there ? truthOf(*axes[static_cast<std::size_t>(motor) - 1U]) : MotorTruth{};
}

} // namespace simulation

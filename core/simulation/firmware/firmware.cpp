// What the firmware is told (commands, references, modes) and its fast task: what a control period measures, the
// current loops, the observers. The slow task is states.cpp.
#include "simulation/firmware/firmware.h"

#include <algorithm>
#include <cmath>

namespace simulation {

namespace {

constexpr double kBootCalibration_s = 0.004; ///< so that what is shown at rest is noise around zero

} // namespace

Firmware::Firmware(Plant &plant, const Build &build, const DriveDesign &design, double hfHz)
    : m_plant(plant)
    , m_build(build)
    , m_design(design)
    , m_hfHz(hfHz)
    , m_currents(design.pwmPeriod)
    , m_sensors(build, design)
    , m_virtual(design.polePairs, hfHz)
    , m_protection(design.protection)
{
    restart();
}

void Firmware::restart()
{
    m_occurredFaults = 0;
    m_protection.clear();
    enter(MotorState::Idle);
    m_offTicks = kStopTicks; // no speed to be forgotten
    m_hungry_ms = 0;
    m_modeAsked = 3;
    m_lastSpeedRamp = {m_design.defaultSpeed_rpm, 0};
    m_lastTorqueRamp = {0, 0};
    m_lastPositionRamp = {};
    m_stages = m_design.revUp;
    m_tuning = m_design.tuning;
    m_signals = {};
    m_positionControl.clear();
    m_speedControl.clear();
    m_speedControl.setMode(SpeedControl::Mode::Speed);
    m_speedControl.rampSpeed(toSpeed_dHz(m_design.defaultSpeed_rpm), 0);
    m_offsets = {};
    m_bootPeriods = std::max(1, static_cast<int>(kBootCalibration_s * m_hfHz));
    m_bus_v = m_plant.bus_v();
    m_heatsink_c = m_plant.heatsink_c();
    m_power_w = 0.0;
    m_sensors.restart();
    measureSlowly();
}

bool Firmware::start()
{
    if (m_state != MotorState::Idle || faultFlags() != 0)
        return false;
    enter(MotorState::ChargeBootCap);
    return true;
}

bool Firmware::driven() const
{
    return powered() || m_state == MotorState::ChargeBootCap || m_state == MotorState::OffsetCalib;
}

void Firmware::stop()
{
    if (driven())
        enter(MotorState::Stop);
}

void Firmware::stopRamp()
{
    if (m_state == MotorState::Run)
        m_speedControl.hold();
}

void Firmware::acknowledgeFaults()
{
    if (m_state != MotorState::FaultOver || presentFaults() != 0)
        return;
    m_occurredFaults = 0;
    enter(MotorState::Idle);
}

void Firmware::clearCurrentReferences()
{
    m_speedControl.rampTorque(0, 0);
    m_idWanted = 0;
}

/// Speeds are counted in 0.1 Hz: 6 rpm are one.
std::int32_t Firmware::toSpeed_dHz(std::int16_t rpm) const
{
    const int limit = m_design.stage.maxSpeed_rpm;
    return std::clamp<int>(rpm, -limit, limit) / 6;
}

int Firmware::direction() const
{
    const bool byTorque = m_modeAsked == 4 || m_modeAsked == 2;
    return (byTorque ? m_lastTorqueRamp.digits : m_lastSpeedRamp.rpm) < 0 ? -1 : 1;
}

void Firmware::rampSpeed(SpeedRamp ramp)
{
    const auto limit = static_cast<std::int16_t>(m_design.stage.maxSpeed_rpm);
    ramp.rpm = std::clamp(ramp.rpm, static_cast<std::int16_t>(-limit), limit);
    m_lastSpeedRamp = ramp;
    if (m_state == MotorState::Run && openLoop()) {
        m_virtual.accelerate(toSpeed_dHz(ramp.rpm), ramp.ms);
        return;
    }
    const bool fromPosition = positions();
    m_modeAsked = 3;
    if (m_state != MotorState::Run)
        return; // kept until Run is reached
    if (m_speedControl.mode() == SpeedControl::Mode::Torque || fromPosition)
        m_speedControl.takeOver(m_speed_dHz, m_wanted.q, m_tuning);
    m_speedControl.rampSpeed(toSpeed_dHz(ramp.rpm), ramp.ms);
}

void Firmware::rampTorque(TorqueRamp ramp)
{
    m_lastTorqueRamp = ramp;
    if (m_state == MotorState::Run && openLoop()) {
        m_speedControl.rampTorque(ramp.digits, ramp.ms);
        return;
    }
    const bool fromPosition = positions();
    m_modeAsked = 4;
    if (m_state != MotorState::Run)
        return;
    if (m_speedControl.mode() == SpeedControl::Mode::Speed || fromPosition)
        m_speedControl.rampTorque(m_wanted.q, 0);
    m_speedControl.setMode(SpeedControl::Mode::Torque);
    m_speedControl.rampTorque(ramp.digits, ramp.ms);
}

void Firmware::rampPosition(PositionRamp ramp)
{
    m_lastPositionRamp = ramp;
    if (!m_build.positionControl || m_build.mainSensor != SpeedSensor::Encoder)
        return;
    if (!positions())
        m_positionControl.clear();
    m_modeAsked = 7;
    if (m_state == MotorState::Run)
        beginMove();
}

void Firmware::beginMove()
{
    const double duration_s =
        std::isfinite(m_lastPositionRamp.duration_s) ? m_lastPositionRamp.duration_s : 0.0;
    m_positionControl.move(m_sensors.position(),
        PositionControl::digitsOf(m_lastPositionRamp.target_rad),
        static_cast<int>(std::clamp(duration_s, 0.0, 1e5) * kMfHz));
}

void Firmware::setCurrentReferences(std::int16_t iq, std::int16_t id)
{
    rampTorque({iq, 0});
    m_idWanted = id;
}

void Firmware::setControlMode(std::uint8_t mode)
{
    if ((mode == 1 || mode == 2) && m_build.openLoopDebug) {
        if (m_state != MotorState::Run || openLoop())
            m_modeAsked = mode;
    } else if (mode == 3) {
        rampSpeed({static_cast<std::int16_t>(speedReference_rpm()), 0});
    } else if (mode == 4) {
        rampTorque({m_state == MotorState::Run ? torqueReference() : std::int16_t{0}, 0});
    }
}

void Firmware::Offsets::begin()
{
    sumA = sumB = 0;
    count = 0;
}

void Firmware::Offsets::add(std::uint16_t readA, std::uint16_t readB)
{
    sumA += readA;
    sumB += readB;
    ++count;
}

void Firmware::Offsets::end()
{
    if (count == 0)
        return;
    a = static_cast<std::int32_t>((sumA + count / 2) / count);
    b = static_cast<std::int32_t>((sumB + count / 2) / count);
}

bool Firmware::powered() const
{
    return m_state == MotorState::Alignment || m_state == MotorState::Start
        || m_state == MotorState::SwitchOver || m_state == MotorState::Run;
}

bool Firmware::virtualAngle() const
{
    return powered() && (m_state != MotorState::Run || openLoop());
}

Ab Firmware::readCurrents()
{
    const std::uint16_t readA = m_plant.currentA(), readB = m_plant.currentB();
    if (m_state == MotorState::OffsetCalib || m_bootPeriods > 0)
        m_offsets.add(readA, readB);
    if (m_bootPeriods > 0 && --m_bootPeriods == 0)
        m_offsets.end();
    return {saturateSymmetric(m_offsets.a - readA), saturateSymmetric(m_offsets.b - readB)};
}

CurrentControl::Frame Firmware::frame() const
{
    if (virtualAngle())
        return {m_virtual.angle(), m_virtual.perPeriod()};
    return {m_sensors.angle(), m_sensors.perPeriod()};
}

void Firmware::hfTask()
{
    const Ab currents = readCurrents();
    m_sensors.senseRotor(m_plant, m_signals);
    if (m_bridgeOn && m_protection.trips(currents.a, currents.b))
        switchOff(); // by hardware; the slow task finds out
    if (m_bridgeOn && powered()) {
        control(currents);
        observe({m_signals.vAlpha, m_signals.vBeta});
        m_virtual.step(m_sensors.angle());
        return;
    }
    CurrentControl::measure(currents, frame().angle, m_signals);
    if (m_offTicks < kStopTicks && !m_bridgeOn)
        observe({}); // it is not told that the bridge is open: it goes on with the last speed
}

void Firmware::control(Ab currents)
{
    if (m_state == MotorState::SwitchOver) {
        m_switchOverTorque.step();
        m_reference.q = saturate16(m_switchOverTorque.value());
    }
    Duties duties;
    if (m_state == MotorState::Run && m_modeAsked == 1) {
        const std::int16_t voltage =
            saturateSymmetric(direction() * m_tuning.openLoopVq * kDigitsMax / 100);
        duties = m_currents.drive(currents, frame(), {voltage, 0}, m_signals);
    } else {
        duties = m_currents.step(
            currents, frame(), m_reference, m_feedForward.voltage(), m_tuning, m_signals);
    }
    m_fluxWeakening.watch({m_signals.vQ, m_signals.vD});
    m_feedForward.watch({m_signals.vQ, m_signals.vD});
    m_signals.openLoopAngle = m_virtual.angle();
    m_plant.setBridge({true, duties.a, duties.b, duties.c});
}

void Firmware::observe(AlphaBeta voltage)
{
    m_sensors.observe({voltage, {m_signals.iAlpha, m_signals.iBeta}, m_bus}, m_tuning, m_signals);
}

} // namespace simulation

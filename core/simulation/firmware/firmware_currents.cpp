// The fast half of the firmware: what a control period measures, the current loops, the observers.
#include "simulation/firmware/firmware.h"

namespace simulation {

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
    if (m_state == MotorState::Run)
        return openLoop();
    return m_state == MotorState::Alignment || m_state == MotorState::Start
        || m_state == MotorState::SwitchOver;
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

// The slow half of the firmware: states and their times, the start, the speed loop, faults, the watchdog.
#include "simulation/firmware/firmware.h"

#include "simulation/maths/transforms.h"

#include <algorithm>

namespace simulation {

namespace {

constexpr int kBootCapTicks = 10, kOffsetTicks = 40;
constexpr int kOpenLoopRampTicks = 1000;
constexpr double kAverage = 0.125; ///< of a new bus voltage, temperature or power

} // namespace

void Firmware::mfTask()
{
    measureSlowly();
    updateFaults();
    lookAtWatchdog();
    runStates();
}

void Firmware::enter(MotorState state)
{
    m_state = state;
    m_ticksInState = 0;
    if (state == MotorState::ChargeBootCap) {
        m_bridgeOn = true;
        m_plant.setBridge({true, 0.0, 0.0, 0.0}); // the lower switches charge the capacitors
    } else if (!powered()) {
        switchOff();
    }
}

void Firmware::switchOff()
{
    if (m_bridgeOn)
        m_offTicks = 0;
    m_bridgeOn = false;
    m_plant.setBridge({});
    m_currents.clear();
    m_speedControl.clear();
    m_positionControl.clear();
    m_feedForward.clear();
    m_wanted = m_reference = {};
    m_idWanted = 0;
    m_signals.iQRef = m_signals.iDRef = 0;
    m_signals.vQ = m_signals.vD = m_signals.vAlpha = m_signals.vBeta = 0;
    m_signals.ffVq = m_signals.ffVd = m_signals.ffVqPi = m_signals.ffVdPi = 0;
    m_signals.fluxWeakeningBus = 0;
}

/// A rotor that turns on is not seen without voltages.
void Firmware::forgetRotor()
{
    m_sensors.clearObservers();
    Signals &s = m_signals;
    s.pllBemfAlpha = s.pllBemfBeta = s.pllIAlpha = s.pllIBeta = 0;
    s.cordicBemfAlpha = s.cordicBemfBeta = s.cordicIAlpha = s.cordicIBeta = 0;
}

void Firmware::measureSlowly()
{
    m_bus_v += (m_plant.bus_v() - m_bus_v) * kAverage;
    m_heatsink_c += (m_plant.heatsink_c() - m_heatsink_c) * kAverage;
    m_bus = static_cast<std::uint16_t>(
        std::clamp(m_bus_v / m_design.stage.busFullScale_v * 65536.0, 0.0, 65535.0));
    m_signals.busVoltage_v = static_cast<std::int16_t>(m_bus_v);
    m_signals.temperature_c = static_cast<std::int16_t>(m_heatsink_c);
    m_sensors.average(m_signals);
    m_signals.positionState = static_cast<std::uint8_t>(m_positionControl.state());
    m_signals.alignState = m_state == MotorState::Alignment ? 1 : m_sensors.aligned() ? 2 : 0;

    const double volts = m_bus_v / (1.7320508075688772 * 32767.0);
    const double amps = m_design.stage.ampsPerDigit();
    const double now_w = 1.5 * volts * amps
        * (static_cast<double>(m_signals.vQ) * m_signals.iQ
            + static_cast<double>(m_signals.vD) * m_signals.iD);
    m_power_w += (now_w - m_power_w) * kAverage;
    m_signals.power_w = static_cast<float>(m_power_w);

    if (m_bridgeOn && virtualAngle())
        m_speed_dHz = m_virtual.speed_dHz();
    else
        m_speed_dHz = m_sensors.speed_dHz();
    if (!m_bridgeOn && m_offTicks < kStopTicks && ++m_offTicks == kStopTicks)
        forgetRotor();
}

void Firmware::updateFaults()
{
    m_protection.watch(m_bus_v, m_heatsink_c, m_tuning);
    const std::uint16_t present = presentFaults();
    m_occurredFaults |= present;
    const bool trips = m_occurredFaults != 0 && m_state != MotorState::FaultOver;
    const bool returns = present != 0 && m_state == MotorState::FaultOver;
    if (m_state != MotorState::FaultNow && (trips || returns))
        enter(MotorState::FaultNow);
    if (!m_bridgeOn)
        m_protection.releaseComparator();
}

void Firmware::fail(std::uint16_t bit)
{
    m_occurredFaults |= bit;
    enter(MotorState::FaultNow);
}

/// Time counts while the motor is driven, so a start has one whole time-out before it needs a heartbeat.
void Firmware::lookAtWatchdog()
{
    if (m_watchdog_ms == 0 || !driven())
        m_hungry_ms = 0;
    else if (++m_hungry_ms >= m_watchdog_ms)
        stop();
}

void Firmware::runStates()
{
    ++m_ticksInState;
    switch (m_state) {
    case MotorState::ChargeBootCap:
        if (m_ticksInState > kBootCapTicks) {
            enter(MotorState::OffsetCalib);
            m_offsets.begin();
        }
        break;
    case MotorState::OffsetCalib:
        if (m_ticksInState > kOffsetTicks) {
            m_offsets.end();
            leaveCalibration();
        }
        break;
    case MotorState::Alignment:
        align();
        break;
    case MotorState::Start:
        startUp();
        break;
    case MotorState::SwitchOver:
        m_virtual.tick();
        if (m_virtual.transitionEnded())
            beginRun();
        break;
    case MotorState::Run:
        run();
        break;
    case MotorState::Stop:
        if (m_ticksInState > kStopTicks)
            enter(MotorState::Idle);
        break;
    case MotorState::FaultNow:
        if (presentFaults() == 0 && m_ticksInState > 1)
            enter(MotorState::FaultOver);
        break;
    default:
        break;
    }
}

void Firmware::leaveCalibration()
{
    m_bridgeOn = true;
    m_virtual.clear(0);
    m_sensors.clearObservers();
    m_sensors.setDirection(direction());
    m_fluxWeakening.clear();
    if (m_sensors.needsAlignment() && !openLoop()) {
        m_alignmentTorque.set(0);
        m_alignmentTorque.start(m_design.alignmentTorque, m_design.alignment_ms / 2);
        enter(MotorState::Alignment);
        align();
        return;
    }
    m_revUp.begin(direction());
    enter(MotorState::Start);
}

/// The field comes from a third of a turn away, so that a rotor that happens to stand against it moves too, and ends
/// where a rotor that follows it stands at angle 0.
void Firmware::align()
{
    constexpr std::int32_t kQuarter = 16384, kThird = 21845;
    m_alignmentTorque.step();
    m_reference = {saturate16(m_alignmentTorque.value()), 0};
    const int sweep = std::max(m_design.alignment_ms / 2, 1);
    const int left = std::max(sweep - m_ticksInState, 0);
    m_virtual.clear(wrapAngle(-kQuarter - kThird * left / sweep));
    if (m_ticksInState <= m_design.alignment_ms)
        return;
    m_sensors.align();
    enter(MotorState::Start);
}

void Firmware::startOpenLoop()
{
    m_virtual.accelerate(toSpeed_dHz(m_lastSpeedRamp.rpm), kOpenLoopRampTicks);
    m_speedControl.setMode(SpeedControl::Mode::Torque);
    const int torque = m_lastTorqueRamp.digits != 0 ? m_lastTorqueRamp.digits
                                                    : direction() * m_design.alignmentTorque;
    m_speedControl.rampTorque(torque, 0);
    enter(MotorState::Run);
}

void Firmware::startUp()
{
    if (openLoop()) {
        startOpenLoop();
        return;
    }
    if (m_sensors.seesRotorAtRest()) {
        m_reference = {};
        beginRun();
        return;
    }
    m_virtual.tick();
    const RevUp::Step step = m_revUp.step(m_stages);
    if (step.over) {
        fail(fault::kStartUp);
        return;
    }
    if (step.begins)
        m_virtual.accelerate(step.speed_dHz, step.ticks);
    m_reference = {step.torque, 0};
    if (!m_revUp.reached(m_design.firstAcceleration))
        m_sensors.clearObservers();
    else if (m_sensors.converged(m_virtual.speed_dHz()))
        believeObserver();
}

/// The forced current becomes the part of it that turned the rotor, while the angle becomes the observed one.
void Firmware::believeObserver()
{
    const int periods = static_cast<int>(m_design.transition_ms * m_hfHz / kMfHz);
    m_virtual.startTransition(periods);
    const Qd seen = park({m_signals.iAlpha, m_signals.iBeta}, trig(m_sensors.angle()));
    m_switchOverTorque.set(m_reference.q);
    m_switchOverTorque.start(seen.q, periods);
    enter(MotorState::SwitchOver);
}

void Firmware::beginRun()
{
    enter(MotorState::Run);
    m_speed_dHz = m_sensors.speed_dHz();
    m_wanted = {m_reference.q, m_idWanted};
    m_speedControl.takeOver(m_speed_dHz, m_reference.q, m_tuning);
    if (positions())
        beginMove();
    else if (m_modeAsked == 4)
        rampTorque(m_lastTorqueRamp);
    else
        rampSpeed(m_lastSpeedRamp);
}

void Firmware::run()
{
    m_virtual.tick();
    if (!openLoop() && !m_sensors.reliable()) {
        fail(fault::kSpeedFeedback);
        return;
    }
    const std::int32_t limit = m_design.currentLimit;
    m_wanted.d = m_idWanted;
    m_wanted.q = positions() ? m_positionControl.step(m_sensors.position(), limit, m_tuning)
                             : m_speedControl.step(m_speed_dHz, limit, m_tuning);
    m_reference = m_wanted;
    if (m_build.fluxWeakening)
        m_reference =
            m_fluxWeakening.step(m_wanted, limit, m_design.demagnetising, m_tuning, m_signals);
    if (m_build.feedForward && !openLoop())
        m_feedForward.step(m_reference, m_sensors.perPeriod(), m_bus, m_tuning, m_signals);
}

} // namespace simulation

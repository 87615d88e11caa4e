// The slow half of the firmware: states, ramps, faults, the speed loop. The fast half is firmware_currents.cpp.
#include "simulation/firmware/firmware.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr int kBootCapTicks = 10, kOffsetTicks = 40, kSwitchOverTicks = 25, kStopTicks = 400;
constexpr double kSpeedToSwitchOver_rpm = 600.0;
constexpr std::uint16_t kStartUpFailed = 0x0010;
constexpr std::int16_t kDefaultSpeed_rpm = 1500;

std::array<RevUpStage, Firmware::kRevUpStages> defaultRevUp()
{
    return {{{0, 1360, 50}, {900, 1360, 300}, {900, 1360, 0}, {900, 1360, 0}, {900, 1360, 0}}};
}

} // namespace

void Firmware::Ramp::start(double to, int ticks)
{
    target = to;
    ticksLeft = ticks;
    if (ticks == 0)
        value = to;
}

void Firmware::Ramp::step()
{
    if (ticksLeft > 0) {
        value += (target - value) / ticksLeft;
        --ticksLeft;
    }
}

Firmware::Firmware(double hfHz, std::uint64_t seed)
    : m_hfHz(hfHz)
    , m_motor(PmsmParameters{})
    , m_random(seed * 0x9E3779B97F4A7C15ULL + 1)
{
    restart();
}

void Firmware::restart()
{
    m_state = MotorState::Idle;
    m_ticksInState = 0;
    m_occurredFaults = 0;
    m_hungry_ms = 0;
    m_mode = Mode::Speed;
    m_modeAsked = 3;
    m_lastSpeedRamp = {kDefaultSpeed_rpm, 0};
    m_lastTorqueRamp = {0, 0};
    m_speedRamp = {};
    m_speedRamp.start(kDefaultSpeed_rpm, 0);
    m_torqueRamp = {};
    m_idReference = 0.0;
    m_revUp = defaultRevUp();
    // Pole and zero cancel at 1500 rad/s, or a tenth of the control rate where that is slower.
    const auto &motor = m_motor.parameters();
    const double bandwidth_radps = std::min(1500.0, 0.1 * m_hfHz);
    const double ampsToVolts = m_stage.ampsPerDigit() / m_stage.voltsPerDigit();
    m_tuning = {};
    m_tuning.qKp = static_cast<std::int16_t>(motor.lq_h * bandwidth_radps * ampsToVolts * 1024.0);
    m_tuning.qKi =
        static_cast<std::int16_t>(motor.rs_ohm * bandwidth_radps * ampsToVolts * 16384.0 / m_hfHz);
    m_tuning.dKp = static_cast<std::int16_t>(motor.ld_h * bandwidth_radps * ampsToVolts * 1024.0);
    m_tuning.dKi = m_tuning.qKi;
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

/// Time counts while the motor is driven, so a start has one whole time-out before it needs a heartbeat.
void Firmware::lookAtWatchdog()
{
    if (m_watchdog_ms == 0 || !driven())
        m_hungry_ms = 0;
    else if (++m_hungry_ms >= m_watchdog_ms)
        stop();
}

void Firmware::stopRamp()
{
    if (m_state != MotorState::Run)
        return;
    m_speedRamp.start(m_speedRamp.value, 0);
    m_torqueRamp.start(m_torqueRamp.value, 0);
}

void Firmware::acknowledgeFaults()
{
    if (m_state != MotorState::FaultOver || m_presentFaults != 0)
        return;
    m_occurredFaults = 0;
    enter(MotorState::Idle);
}

void Firmware::clearCurrentReferences()
{
    m_torqueRamp.start(0.0, 0);
    m_idReference = 0.0;
}

void Firmware::rampSpeed(SpeedRamp ramp)
{
    const auto limit = static_cast<std::int16_t>(m_stage.maxSpeed_rpm);
    ramp.rpm = std::clamp(ramp.rpm, static_cast<std::int16_t>(-limit), limit);
    m_lastSpeedRamp = ramp;
    m_modeAsked = 3;
    if (m_state != MotorState::Run)
        return; // kept until Run is reached
    if (m_mode == Mode::Torque) {
        m_mode = Mode::Speed;
        m_speedIntegral = m_iqReference;
        m_speedRamp.start(m_filteredSpeed_dHz * 6.0, 0);
    }
    const int target_rpm = ramp.rpm / 6 * 6; // counted in 0.1 Hz
    m_speedRamp.start(target_rpm, ramp.ms);
}

void Firmware::rampTorque(TorqueRamp ramp)
{
    m_lastTorqueRamp = ramp;
    m_modeAsked = 4;
    if (m_state != MotorState::Run)
        return;
    if (m_mode == Mode::Speed)
        m_torqueRamp.start(m_iqReference, 0);
    m_mode = Mode::Torque;
    m_torqueRamp.start(ramp.digits, ramp.ms);
}

void Firmware::setCurrentReferences(std::int16_t iq, std::int16_t id)
{
    m_modeAsked = 4;
    m_lastTorqueRamp = {iq, 0};
    if (m_state != MotorState::Run)
        return;
    m_mode = Mode::Torque;
    m_torqueRamp.start(iq, 0);
    m_idReference = id;
}

void Firmware::setControlMode(std::uint8_t mode)
{
    if (mode == 3)
        rampSpeed({static_cast<std::int16_t>(speedReference_rpm()), 0});
    else if (mode == 4)
        rampTorque({m_state == MotorState::Run ? torqueReference() : std::int16_t{0}, 0});
}

std::int32_t Firmware::speedReference_rpm() const
{
    return 6 * static_cast<std::int32_t>(std::lround(m_speedRamp.value / 6.0));
}

std::int16_t Firmware::torqueReference() const
{
    return static_cast<std::int16_t>(std::clamp(m_iqReference, -32767.0, 32767.0));
}

double Firmware::power_w() const
{
    if (!powered())
        return 0.0;
    return 1.5 * m_stage.voltsPerDigit() * (m_vd * m_motor.id_a() + m_vq * m_motor.iq_a());
}

bool Firmware::powered() const
{
    return m_state == MotorState::Start || m_state == MotorState::SwitchOver
        || m_state == MotorState::Run;
}

void Firmware::enter(MotorState state)
{
    m_state = state;
    m_ticksInState = 0;
    if (powered())
        return;
    m_vd = m_vq = m_dIntegral = m_qIntegral = 0.0;
    m_iqReference = m_speedIntegral = m_idReference = 0.0;
}

void Firmware::mfTask()
{
    const double measured_dHz = m_motor.speed_radps() / (2.0 * std::numbers::pi) * 10.0;
    m_filteredSpeed_dHz += (measured_dHz - m_filteredSpeed_dHz) * 0.25;
    if (m_motor.atRest() && std::abs(m_filteredSpeed_dHz) < 0.5)
        m_filteredSpeed_dHz = 0.0;
    m_speed_rpm = 6 * static_cast<std::int32_t>(std::lround(m_filteredSpeed_dHz));
    m_signals.busVoltage_v = static_cast<std::int16_t>(m_stage.nominal_v);
    m_signals.temperature_c = 25;
    updateFaults();
    lookAtWatchdog();
    runStates();
    m_rest = !powered() && m_motor.atRest();
}

void Firmware::updateFaults()
{
    m_occurredFaults |= m_presentFaults;
    const bool trips = m_occurredFaults != 0 && m_state != MotorState::FaultOver;
    const bool returns = m_presentFaults != 0 && m_state == MotorState::FaultOver;
    if (m_state != MotorState::FaultNow && (trips || returns))
        enter(MotorState::FaultNow);
}

void Firmware::runStates()
{
    ++m_ticksInState;
    switch (m_state) {
    case MotorState::ChargeBootCap:
        if (m_ticksInState > kBootCapTicks)
            enter(MotorState::OffsetCalib);
        break;
    case MotorState::OffsetCalib:
        if (m_ticksInState > kOffsetTicks) {
            enter(MotorState::Start);
            m_stageIndex = 0;
            m_stageTicks = 0;
            m_stageFrom_rpm = m_forced_rpm = 0.0;
        }
        break;
    case MotorState::Start:
        startUp();
        break;
    case MotorState::SwitchOver:
        speedLoop();
        if (m_ticksInState > kSwitchOverTicks)
            beginRun();
        break;
    case MotorState::Run:
        m_speedRamp.step();
        m_torqueRamp.step();
        m_currentLimit = m_stage.nominal_a / m_stage.ampsPerDigit();
        m_forced_rpm = m_speedRamp.value;
        if (m_mode == Mode::Speed)
            speedLoop();
        else
            m_iqReference = m_torqueRamp.value;
        break;
    case MotorState::Stop:
        if (m_ticksInState > kStopTicks)
            enter(MotorState::Idle);
        break;
    case MotorState::FaultNow:
        if (m_presentFaults == 0 && m_ticksInState > 1)
            enter(MotorState::FaultOver);
        break;
    default:
        break;
    }
}

void Firmware::startUp()
{
    // The forced speed follows the stages; the observer is trusted once the rotor is fast enough.
    while (m_stageIndex < kRevUpStages && m_stageTicks >= m_revUp[m_stageIndex].ms) {
        m_stageFrom_rpm = m_revUp[m_stageIndex].rpm;
        m_stageTicks = 0;
        ++m_stageIndex;
    }
    if (m_stageIndex == kRevUpStages) {
        m_occurredFaults |= kStartUpFailed;
        enter(MotorState::FaultNow);
        return;
    }
    const RevUpStage &stage = m_revUp[m_stageIndex];
    ++m_stageTicks;
    const double direction = m_modeAsked == 3 && m_lastSpeedRamp.rpm < 0 ? -1.0 : 1.0;
    m_forced_rpm =
        direction * (m_stageFrom_rpm + (stage.rpm - m_stageFrom_rpm) * m_stageTicks / stage.ms);
    m_currentLimit = std::abs(static_cast<double>(stage.torque));
    speedLoop();
    if (std::abs(m_filteredSpeed_dHz * 6.0) >= kSpeedToSwitchOver_rpm)
        enter(MotorState::SwitchOver);
}

void Firmware::beginRun()
{
    enter(MotorState::Run);
    m_mode = Mode::Speed;
    m_speedRamp.start(m_filteredSpeed_dHz * 6.0, 0);
    m_torqueRamp.start(m_iqReference, 0);
    if (m_modeAsked == 4)
        rampTorque(m_lastTorqueRamp);
    else
        rampSpeed(m_lastSpeedRamp);
}

void Firmware::speedLoop()
{
    const double error_dHz = m_forced_rpm / 6.0 - m_filteredSpeed_dHz;
    m_speedIntegral += scaledGain(m_tuning.speedKi, m_tuning.speedKiDiv) * error_dHz;
    m_speedIntegral = std::clamp(m_speedIntegral, -m_currentLimit, m_currentLimit);
    const double proportional = scaledGain(m_tuning.speedKp, m_tuning.speedKpDiv) * error_dHz;
    m_iqReference = std::clamp(proportional + m_speedIntegral, -m_currentLimit, m_currentLimit);
}

} // namespace simulation

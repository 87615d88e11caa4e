#include "simulation/mcb/servo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {
namespace {

constexpr std::uint16_t kFaultReset = 0x0080;
constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr int kCountsPerPulse = 4;

Build servoBuild(const BoardOptions &options)
{
    Build build = buildOf(options);
    build.encoder = build.positionControl = true;
    build.mainSensor = SpeedSensor::Encoder;
    build.motors = 1;
    return build;
}

PlantParameters servoPlant(PlantParameters plant)
{
    constexpr int kPulses = 1000;
    if (plant.sensors.encoderPulses == 0)
        plant.sensors.encoderPulses = kPulses;
    return plant;
}

std::int16_t clampedDigits(double value)
{
    return static_cast<std::int16_t>(std::clamp(std::nearbyint(value), -32767.0, 32767.0));
}

} // namespace

Servo::Servo(const BoardOptions &options, const PlantParameters &plant, const ServoOptions &servo)
    : m_servo(servo)
    , m_axis(servoPlant(plant), servoBuild(options), options.hfHz, options.seed)
    , m_hfHz(options.hfHz)
{
    restart();
}

void Servo::restart()
{
    m_axis.firmware.restart();
    m_axis.firmware.rampSpeed({0, 0});
    m_state = State::SwitchOnDisabled;
    m_wanted = {};
    m_wanted.gains = gains();
    m_followed = m_wanted;
    m_lastControl = 0;
    m_lastError = 0;
    m_following = m_resetWanted = false;
}

double Servo::radPerCount() const
{
    return kTurn_rad / (kCountsPerPulse * m_axis.plant.parameters().sensors.encoderPulses);
}

void Servo::advance(TimePoint now)
{
    if (!m_started) {
        m_started = true;
        m_begun = now;
    }
    const auto due = static_cast<std::uint64_t>(std::max(0.0, toSeconds(now - m_begun)) * m_hfHz);
    const auto perTask = static_cast<std::uint64_t>(m_hfHz / Firmware::kMfHz);
    while (m_hfTicks < due) {
        m_axis.hfTask();
        if (++m_hfTicks % std::max<std::uint64_t>(perTask, 1) == 0)
            task();
    }
}

void Servo::task()
{
    Firmware &firmware = m_axis.firmware;
    firmware.mfTask();
    const MotorState motor = firmware.state();
    const bool fault = motor == MotorState::FaultNow || motor == MotorState::FaultOver;
    if (fault && m_state != State::Fault) {
        m_state = State::Fault;
        m_lastError = errorCode();
    }
    if (m_state == State::SwitchedOn && m_following && motor == MotorState::Idle)
        firmware.start(); // also when the stop before has to run out first
    if (m_state == State::SwitchedOn && m_following && motor == MotorState::Run) {
        m_state = State::Enabled;
        follow();
    } else if (m_state == State::QuickStop && motor == MotorState::Idle) {
        m_state = State::SwitchOnDisabled;
    }
    if (m_wanted.gains != m_followed.gains)
        adoptGains();
    if (m_state == State::Enabled && m_wanted != m_followed)
        follow();
}

void Servo::obey(std::uint16_t control)
{
    Firmware &firmware = m_axis.firmware;
    const bool resets = (control & kFaultReset) != 0 && (m_lastControl & kFaultReset) == 0;
    m_lastControl = control;
    if (m_state == State::Fault) {
        if (resets)
            firmware.acknowledgeFaults();
        if (resets && firmware.state() == MotorState::Idle)
            m_state = State::SwitchOnDisabled;
        return;
    }
    const auto leave = [&](State next) {
        m_following = false;
        firmware.stop();
        m_state = next;
    };
    if ((control & 0x02) == 0)
        return leave(State::SwitchOnDisabled);
    if ((control & 0x04) == 0)
        return leave(m_state == State::Enabled ? State::QuickStop : State::SwitchOnDisabled);
    const bool on = (control & 0x01) != 0, enable = (control & 0x08) != 0;
    if (!on) {
        if (m_state != State::QuickStop)
            leave(State::Ready);
    } else if (m_state == State::Ready) {
        m_state = State::SwitchedOn;
        m_following = enable;
    } else if (m_state == State::SwitchedOn) {
        m_following = enable;
        if (!enable)
            firmware.stop();
    } else if (m_state == State::Enabled && !enable) {
        leave(State::SwitchedOn);
    }
    if (m_following && m_state == State::SwitchedOn)
        follow();
}

/// Hands the set-points to the firmware, which keeps them until it runs.
void Servo::follow()
{
    const Wanted &w = m_wanted;
    Firmware &firmware = m_axis.firmware;
    const double amps = m_axis.firmware.stage().ampsPerDigit();
    const double before_rps =
        (m_state == State::Enabled ? firmware.speedReference_rpm() : firmware.speed_rpm()) / 60.0;
    const auto within = [](float value, float limit) {
        return limit > 0.0F ? std::clamp(value, -limit, limit) : value;
    };
    const auto rpm = static_cast<std::int16_t>(std::clamp(
        std::nearbyint(60.0 * within(w.velocity_rps, w.velocityLimit_rps)), -32767.0, 32767.0));
    switch (w.mode) {
    case 2:
    case 34:
        firmware.setCurrentReferences(clampedDigits(within(w.iq_a, w.currentLimit_a) / amps),
            clampedDigits(within(w.id_a, w.currentLimit_a) / amps));
        break;
    case 19: {
        const double step = std::abs(rpm / 60.0 - before_rps);
        const double ms = w.maxAcceleration > 0.0F ? 1000.0 * step / w.maxAcceleration : 0.0;
        firmware.rampSpeed({rpm, static_cast<std::uint16_t>(std::clamp(ms, 0.0, 65535.0))});
        break;
    }
    case 4:
    case 20:
    case 36: {
        const double target = w.position_cnt * radPerCount();
        const double way =
            std::abs(target - static_cast<double>(firmware.variables().position_rad));
        constexpr double kPeak = 1.875; // highest over mean speed of the firmware's path
        const double duration =
            w.mode == 20 && w.maxVelocity > 0.0F ? kPeak * way / (kTurn_rad * w.maxVelocity) : 0.0;
        firmware.rampPosition({static_cast<float>(target), static_cast<float>(duration)});
        break;
    }
    default:
        firmware.rampSpeed({rpm, 0});
        break;
    }
    m_followed = m_wanted;
}

std::uint16_t Servo::statusWord() const
{
    constexpr unsigned kVoltage = 0x0010, kRemote = 0x0200, kReached = 0x0400, kOperating = 0x1000;
    const auto word = [](unsigned bits) { return static_cast<std::uint16_t>(bits); };
    switch (m_state) {
    case State::SwitchOnDisabled:
        return word(0x40 | kRemote);
    case State::Ready:
        return word(0x21 | kRemote);
    case State::SwitchedOn:
        return word(0x23 | kVoltage | kRemote);
    case State::QuickStop:
        return word(0x07 | kVoltage | kRemote);
    case State::Fault:
        return word(0x08 | kRemote);
    case State::Enabled:
        break;
    }
    const bool speeds = m_wanted.mode == 3 || m_wanted.mode == 19 || m_wanted.mode == 35;
    constexpr int kNear_rpm = 30;
    const bool reached = !speeds
        || std::abs(m_axis.firmware.speed_rpm() - 60.0 * static_cast<double>(m_wanted.velocity_rps))
            < kNear_rpm;
    return word(0x27 | kVoltage | kRemote | kOperating | (reached ? kReached : 0U));
}

std::int32_t Servo::errorCode() const
{
    struct Row {
        unsigned bit;
        std::int32_t code;
    };
    // Bits of MCP's fault flags, codes of CiA 402.
    static constexpr Row kRows[] = {{0x01, 0x6010}, {0x02, 0x3210}, {0x04, 0x3220}, {0x08, 0x4310},
        {0x10, 0x7500}, {0x20, 0x7300}, {0x40, 0x2310}};
    const std::uint32_t flags = m_axis.firmware.faultFlags();
    for (const Row &row : kRows)
        if (((flags | flags >> 16) & row.bit) != 0)
            return row.code;
    return 0x1000; // generic
}

std::optional<mcb::ErrorCode> Servo::refusal(std::uint16_t address, mcb::WordView words) const
{
    if (address != 0x014 || words.empty())
        return std::nullopt;
    static constexpr std::uint16_t kModes[] = {2, 3, 4, 19, 20, 34, 35, 36};
    return std::ranges::find(kModes, words[0]) == std::end(kModes)
        ? std::optional(mcb::ErrorCode::General)
        : std::nullopt;
}

} // namespace simulation

#include "simulation/fcp/motor_board.h"

#include "simulation/axis.h"
#include "simulation/fcp/board.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

constexpr Duration kMfPeriod = std::chrono::milliseconds(1);
constexpr Duration kNotice = std::chrono::microseconds(100); ///< from a request to its answer
using namespace fcp::number;
constexpr std::uint8_t kSpeedMode = 3, kTorqueMode = 4; ///< as the firmware numbers them
constexpr Duration kPrintedFrameTime = std::chrono::milliseconds(25);

/// A register that shows or sets a variable of the firmware.
template <class Holder>
struct Variable {
    std::uint8_t id;
    std::int16_t Holder::*member;
};
constexpr Variable<Tuning> kTuning[] = {{0x05, &Tuning::speedKp}, {0x06, &Tuning::speedKi},
    {0x07, &Tuning::speedKd}, {0x09, &Tuning::qKp}, {0x0A, &Tuning::qKi}, {0x0B, &Tuning::qKd},
    {0x0D, &Tuning::dKp}, {0x0E, &Tuning::dKi}, {0x0F, &Tuning::dKd}, {0x10, &Tuning::pllC1},
    {0x11, &Tuning::pllC2}, {0x12, &Tuning::cordicC1}, {0x13, &Tuning::cordicC2},
    {0x14, &Tuning::pllKi}, {0x15, &Tuning::pllKp}, {0x16, &Tuning::fluxKp},
    {0x17, &Tuning::fluxKi}, {0x18, &Tuning::fluxBus}};
constexpr Variable<Signals> kSignals[] = {{0x08, &Signals::iQRef}, {0x0C, &Signals::iDRef},
    {0x19, &Signals::busVoltage_v}, {0x1A, &Signals::temperature_c}, {0x1F, &Signals::iQ},
    {0x20, &Signals::iD}, {0x21, &Signals::fluxWeakeningBus}, {0x49, &Signals::ffVq},
    {0x4A, &Signals::ffVd}, {0x4B, &Signals::ffVqPi}, {0x4C, &Signals::ffVdPi}};

/// Where firmware before 6.0 goes through a state of its own for a turn of its medium-frequency task; 0: nowhere.
std::uint8_t stateBetween(MotorState from, MotorState to)
{
    constexpr std::uint8_t kIdleStart = 3, kStartRun = 5, kAnyStop = 7, kStopIdle = 9;
    if (from == to || to == MotorState::FaultNow || to == MotorState::FaultOver)
        return 0;
    if (to == MotorState::Stop)
        return kAnyStop;
    if (to == MotorState::Run)
        return kStartRun;
    if (to == MotorState::Idle)
        return from == MotorState::Stop ? kStopIdle : 0;
    return from == MotorState::Idle ? kIdleStart : 0;
}

std::int16_t to16(std::int64_t value) { return static_cast<std::int16_t>(value); }

class Motors final : public FcpMachine {
public:
    Motors(const PlantParameters &plant, const Build &build, const BoardOptions &options)
        : m_hfHz(options.hfHz)
    {
        for (int i = 0; i < build.motors; ++i)
            m_axes.push_back(std::make_unique<Axis>(
                plant, build, options.hfHz, options.seed + static_cast<std::uint64_t>(i)));
        m_passed.resize(m_axes.size());
        m_entered.resize(m_axes.size());
    }

    void advance(TimePoint now);
    void restart()
    {
        for (const auto &axis : m_axes)
            axis->firmware.restart();
    }
    const Axes &axes() const { return m_axes; }
    Firmware &firmware(std::size_t motor) { return m_axes[motor]->firmware; }

    void refresh(std::size_t motor, FcpMotor &registers) override;
    void written(std::size_t motor, std::uint8_t id, std::int64_t value) override;
    void execute(std::size_t motor, fcp::CommandId command) override;
    void setControlMode(std::size_t motor, bool torque) override
    {
        firmware(motor).setControlMode(torque ? kTorqueMode : kSpeedMode);
    }
    void rampSpeed(std::size_t motor, std::int32_t rpm, std::uint16_t duration_ms) override
    {
        firmware(motor).setControlMode(kSpeedMode);
        // Behind it motors turn at 16 bits of rpm at most.
        firmware(motor).rampSpeed({to16(std::clamp(rpm, -INT16_MAX, INT16_MAX)), duration_ms});
    }
    void rampTorque(std::size_t motor, std::int16_t digits, std::uint16_t duration_ms) override
    {
        firmware(motor).setControlMode(kTorqueMode);
        firmware(motor).rampTorque({digits, duration_ms});
    }
    void setCurrents(std::size_t motor, std::int16_t iq, std::int16_t id) override
    {
        firmware(motor).setControlMode(kTorqueMode);
        firmware(motor).setCurrentReferences(iq, id);
    }
    void setRevUp(std::size_t motor, std::size_t stage, const fcp::StageFields &values) override
    {
        firmware(motor).setRevUpStage(stage, {values.speed_rpm, values.torque, values.duration_ms});
    }

private:
    TimePoint hfTime() const
    {
        return m_start
            + fromSeconds(
                static_cast<double>(m_hfTicks) / (m_hfHz * static_cast<double>(m_axes.size())));
    }

    std::uint8_t shownState(std::size_t motor)
    {
        const MotorState now = firmware(motor).state();
        const std::uint8_t between = stateBetween(m_passed[motor], now);
        return between != 0 ? between : static_cast<std::uint8_t>(now);
    }

    Axes m_axes;
    // By motor: the states of the turn before the last one, and of the last one.
    std::vector<MotorState> m_passed, m_entered;
    double m_hfHz;
    bool m_started = false;
    TimePoint m_start{}, m_nextMf{};
    std::uint64_t m_hfTicks = 1;
};

void Motors::advance(TimePoint now)
{
    if (!std::exchange(m_started, true)) {
        m_start = now;
        m_nextMf = now + kMfPeriod;
    }
    while (true) {
        const TimePoint hf = hfTime();
        if (std::min(hf, m_nextMf) > now)
            return;
        if (hf <= m_nextMf) {
            m_axes[m_hfTicks++ % m_axes.size()]->hfTask();
            continue;
        }
        m_nextMf += kMfPeriod;
        for (std::size_t motor = 0; motor < m_axes.size(); ++motor) {
            m_passed[motor] = std::exchange(m_entered[motor], firmware(motor).state());
            firmware(motor).mfTask();
        }
    }
}

void Motors::refresh(std::size_t motor, FcpMotor &registers)
{
    Firmware &from = firmware(motor);
    registers.state = shownState(motor);
    registers.faults = from.faultFlags();
    registers.controlMode = from.controlMode() == kTorqueMode ? 0 : 1;
    auto &values = registers.registers;
    for (const auto &link : kTuning)
        values[link.id] = from.tuning().*link.member;
    for (const auto &link : kSignals)
        values[link.id] = from.variables().*link.member;
    values[kSpeedRef] = from.speedReference_rpm();
    values[kSpeedMeas] = from.speed_rpm();
    values[kMotorPower] = std::lround(from.power_w());
    values[kMaxSpeed] = from.stage().maxSpeed_rpm;
    values[kFf1Q] = from.tuning().ff1Q;
    values[kFf1D] = from.tuning().ff1D;
    values[kFf2] = from.tuning().ff2;
    values[kFinalSpeed] = from.lastSpeedRamp().rpm;
    values[kSpeedKpDiv] = std::int64_t{1} << from.tuning().speedKpDiv;
    values[kSpeedKiDiv] = std::int64_t{1} << from.tuning().speedKiDiv;
    for (std::size_t i = 0; i < registers.revUp.size(); ++i) {
        const StageDigits &stage = from.revUp()[i];
        registers.revUp[i] = {stage.rpm, stage.torque, static_cast<std::uint16_t>(stage.ms)};
    }
}

void Motors::written(std::size_t motor, std::uint8_t id, std::int64_t value)
{
    Tuning &tuning = firmware(motor).tuning();
    for (const auto &link : kTuning)
        if (link.id == id)
            tuning.*link.member = to16(value);
    const auto number = static_cast<std::int32_t>(value);
    if (id == kFf1Q)
        tuning.ff1Q = number;
    else if (id == kFf1D)
        tuning.ff1D = number;
    else if (id == kFf2)
        tuning.ff2 = number;
}

void Motors::execute(std::size_t motor, fcp::CommandId command)
{
    using enum fcp::CommandId;
    Firmware &to = firmware(motor);
    switch (command) {
    case StartMotor:
        to.start();
        break;
    case StopMotor:
    case ProfilerStop:
        to.stop();
        break;
    case StartStop:
        if (!to.start())
            to.stop();
        break;
    case StopRamp:
        to.stopRamp();
        break;
    case FaultAck:
        to.acknowledgeFaults();
        break;
    case IqdRefClear:
        to.clearCurrentReferences();
        break;
    default:
        break;
    }
}

FcpRig rigOf(const BoardOptions &options, const Build &build)
{
    FcpRig rig;
    rig.name = options.profile;
    rig.fluxWeakening = build.fluxWeakening;
    rig.feedForward = build.feedForward;
    rig.dac = build.dac;
    if (options.profile == "powerpc") {
        rig.dialect = fcp::Dialect::PowerPc;
        rig.firmware = "PowerPC MC\tVer.1.0.0";
    }
    if (options.profile != "legacy")
        rig.frameTimer = kPrintedFrameTime;
    rig.integersInBoardInfo = options.profile == "legacy-text";
    rig.motors.resize(static_cast<std::size_t>(build.motors));
    for (FcpMotor &motor : rig.motors) {
        using Sensor = FcpMotor::Sensing;
        motor.sensing = build.mainSensor == SpeedSensor::Encoder ? Sensor::Encoder
            : build.mainSensor == SpeedSensor::Hall              ? Sensor::Hall
                                                                 : Sensor::Pll;
        if (build.sensorless())
            motor.revUp.resize(fcp::kRevUpStages);
    }
    return rig;
}

/// So that the motors are made before the board that answers for them.
struct Behind {
    Behind(const PlantParameters &plant, const Build &build, const BoardOptions &options)
        : motors(plant, build, options)
    {
    }
    Motors motors;
};

class FcpMotorBoard final : private Behind, public FcpBoard {
public:
    FcpMotorBoard(const BoardOptions &options, const Build &build, const PlantParameters &plant)
        : Behind(plant, build, options)
        , FcpBoard(rigOf(options, build), options.baud, kNotice, &motors)
        , m_profile(options.profile)
    {
    }

    void reset() override
    {
        motors.restart();
        FcpBoard::reset();
    }
    void setFaults(std::uint16_t present) override
    {
        for (const auto &axis : motors.axes())
            axis->firmware.setPresentFaults(present);
    }
    void setLoadTorque(int motor, double nm) override
    {
        if (motor >= 1 && static_cast<std::size_t>(motor) <= motors.axes().size())
            motors.axes()[static_cast<std::size_t>(motor) - 1U]->plant.setLoadTorque(nm);
    }
    MotorTruth truth(int motor) const override { return truthOf(motors.axes(), motor); }
    std::string describe() const override
    {
        const PlantParameters &plant = motors.axes().front()->plant.parameters();
        return "Simulated board, " + m_profile + ", "
            + std::to_string(std::lround(plant.inverter.supply_v)) + " V PMSM with "
            + std::to_string(plant.motor.polePairs) + " pole pairs";
    }

protected:
    void advanceMachine(TimePoint now) override { motors.advance(now); }

private:
    std::string m_profile;
};

} // namespace

std::vector<std::string_view> fcpProfiles() { return {"legacy", "legacy-text", "powerpc"}; }

bool isFcpProfile(std::string_view name)
{
    const auto all = fcpProfiles();
    return std::ranges::find(all, name) != all.end();
}

std::unique_ptr<SimulatedBoard> makeFcpBoard(const BoardOptions &options)
{
    if (!isFcpProfile(options.profile))
        return nullptr;
    const auto plant = plantOf(options);
    if (!plant)
        return nullptr;
    return std::make_unique<FcpMotorBoard>(options, buildOf(options), *plant);
}

} // namespace simulation

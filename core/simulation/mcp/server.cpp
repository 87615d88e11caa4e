// Dispatch and the two register lists.
#include "simulation/mcp/server.h"

#include "aspep/packet.h"
#include "simulation/simulated_board.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace simulation {

namespace {

using mcp::CommandId;
using mcp::RegisterId;
using mcp::Status;

constexpr int kHeartbeat = 1; ///< user command that feeds the watchdog
constexpr std::size_t kUserAnswerMax = 64;
/// Behind it there is room for any one value.
constexpr std::size_t kAnswerMax = aspep::kMaxPayload - 128;

constexpr std::array kOfMotors{CommandId::StartMotor, CommandId::StopMotor, CommandId::StopRamp,
    CommandId::StartStop, CommandId::FaultAck, CommandId::CpuLoadClear, CommandId::IqdRefClear,
    CommandId::ProfilerCmd, CommandId::SensorSwitch};

std::int16_t angleOf(SpeedSensor sensor, const Signals &signals)
{
    switch (sensor) {
    case SpeedSensor::ObserverCordic:
        return signals.cordicAngle;
    case SpeedSensor::Encoder:
        return signals.encoderAngle;
    case SpeedSensor::Hall:
        return signals.hallAngle;
    default:
        return signals.pllAngle;
    }
}

} // namespace

Server::Server(const Traits &traits, const BoardOptions &options, const Build &build,
    const Axes &axes, RegisterFile &registers, DatalogRecorder &datalog)
    : m_traits(traits)
    , m_options(options)
    , m_build(build)
    , m_axes(axes)
    , m_registers(registers)
    , m_datalog(datalog)
{
}

Bytes Server::execute(ByteView buffer, std::uint16_t length, std::size_t responseMax)
{
    const StaleBytes stale(buffer);
    const std::uint16_t word = stale.u16(0);
    const Request request{static_cast<std::uint16_t>(word >> 3), word & 7U, stale.from(2),
        static_cast<std::uint16_t>(length - 2), static_cast<int>(responseMax) - 1};
    m_answer.clear();
    const Status status = dispatch(request);
    if (m_resetWanted)
        return {};
    m_answer.push_back(static_cast<std::uint8_t>(status));
    if (m_buffer.size() < m_answer.size())
        m_buffer.resize(m_answer.size());
    std::copy(m_answer.begin(), m_answer.end(), m_buffer.begin());
    return m_answer;
}

Status Server::dispatch(const Request &request)
{
    switch (static_cast<CommandId>(request.command)) {
    case CommandId::GetMcpVersion:
        m_buffer.resize(std::max<std::size_t>(m_buffer.size(), 4));
        m_answer.assign(m_buffer.begin(), m_buffer.begin() + 4); // only the first byte is written
        if (m_traits.asPrinted)
            m_answer.assign(4, 0);
        m_answer[0] = 1;
        return Status::Ok;
    case CommandId::SetRegister:
        return set(request);
    case CommandId::GetRegister:
        return get(request);
    default:
        break;
    }
    if (request.command >= static_cast<std::uint16_t>(CommandId::UserFirst))
        return userCommand(request);
    return command(request);
}

Status Server::get(const Request &request)
{
    Status status = Status::Nok;
    std::size_t at = 0;
    for (std::uint16_t left = request.length; left > 0;
         left = static_cast<std::uint16_t>(left - 2), at += 2) {
        const RegisterId id{request.data.u16(at)};
        if (!m_registers.hasMotor(id))
            return Status::Nok;
        if (m_answer.size() > kAnswerMax)
            return Status::NoTxSyncSpace; // real firmware has overwritten its memory by now
        status = m_registers.read(id, request.room - static_cast<int>(m_answer.size()), m_answer);
        if (status != Status::Ok)
            break;
    }
    return status;
}

Status Server::set(const Request &request)
{
    Status total = Status::Ok;
    std::size_t at = 0;
    // The firmware counts in 16 bits with a sign: the length of an empty request is negative and nothing is done.
    for (int left = static_cast<std::int16_t>(request.length); left > 0;) {
        const RegisterId id{request.data.u16(at)};
        at += 2;
        left -= 2;
        if (!m_registers.hasMotor(id)) {
            total = Status::Nok;
            break;
        }
        const auto written = m_registers.write(id, request.data.from(at), left, m_datalog);
        at += static_cast<std::size_t>(written.consumed);
        left -= written.consumed;
        if (left == 0 && m_answer.empty())
            return written.status; // a single one, exactly consumed: its status is the answer
        m_answer.push_back(static_cast<std::uint8_t>(written.status));
        if (written.status != Status::Ok)
            total = Status::Nok;
        if (written.status == Status::BadDataType || written.status == Status::BadRawFormat)
            break;
    }
    if (total == Status::Ok)
        m_answer.clear();
    else if (m_traits.asPrinted)
        std::ranges::replace(m_answer, std::uint8_t{0}, std::uint8_t{1});
    return total;
}

Status Server::command(const Request &request)
{
    const auto id = static_cast<CommandId>(request.command);
    if (id == CommandId::SwReset)
        m_resetWanted = m_traits.hasSoftReset;
    if (std::ranges::find(kOfMotors, id) == kOfMotors.end())
        return Status::CommandUnknown;
    if (request.motor == 0 || request.motor > m_axes.size())
        return Status::Nok; // real firmware reads outside its tables here
    return motorCommand(request, m_axes[request.motor - 1]->firmware);
}

bool Server::start(unsigned motor)
{
    const bool accepted = m_axes[motor - 1]->firmware.start();
    if (accepted)
        m_registers.started(motor);
    return accepted;
}

Status Server::motorCommand(const Request &request, Firmware &firmware)
{
    switch (static_cast<CommandId>(request.command)) {
    case CommandId::StartMotor:
        return start(request.motor) ? Status::Ok : Status::Nok;
    case CommandId::StopMotor:
        firmware.stop();
        return Status::Ok;
    case CommandId::StopRamp:
        firmware.stopRamp();
        return Status::Ok;
    case CommandId::StartStop:
        if (firmware.state() != MotorState::Idle) {
            firmware.stop();
            return Status::Ok;
        }
        return start(request.motor) != m_traits.invertsStartStop ? Status::Ok : Status::Nok;
    case CommandId::FaultAck:
        firmware.acknowledgeFaults();
        return Status::Ok;
    case CommandId::CpuLoadClear:
        return clearCpuLoad();
    case CommandId::IqdRefClear:
        if (m_build.family != Family::Foc)
            return Status::CommandUnknown;
        firmware.clearCurrentReferences();
        return Status::Ok;
    case CommandId::ProfilerCmd:
        return profilerCommand(request);
    case CommandId::SensorSwitch:
        return switchSensor(request, firmware);
    default:
        return Status::CommandUnknown;
    }
}

Status Server::clearCpuLoad()
{
    if (!m_traits.hasCpuLoadClear || !m_build.cpuLoad)
        return Status::CommandUnknown;
    Signals &measured = m_axes.front()->firmware.variables();
    measured.cpuLoadMin = measured.cpuLoadMax = measured.cpuLoad;
    return Status::Ok;
}

/// The self-commissioning is not simulated: its commands are taken and nothing runs.
Status Server::profilerCommand(const Request &request) const
{
    constexpr std::uint8_t kLastCommand = 6;
    if (!m_traits.hasProfilerCommand || m_build.family != Family::Foc || !m_build.profiler)
        return Status::CommandUnknown;
    return request.data.u8(0) <= kLastCommand ? Status::Ok : Status::Nok;
}

/// The margin is looked at, the loops stay with the main sensor.
Status Server::switchSensor(const Request &request, const Firmware &firmware) const
{
    if (!m_traits.hasSensorSwitch || m_build.family != Family::Foc
        || m_build.auxiliarySensor == SpeedSensor::None)
        return Status::CommandUnknown;
    const auto apart = static_cast<std::int16_t>(angleOf(m_build.mainSensor, firmware.variables())
        - angleOf(m_build.auxiliarySensor, firmware.variables()));
    const bool close = std::abs(apart) <= request.data.u16(0);
    return firmware.state() == MotorState::Run && close ? Status::Ok : Status::Nok;
}

Status Server::heartbeat(const Request &request)
{
    if (request.length != 2 || request.data.u16(0) != m_options.watchdogMs)
        return Status::Nok; // meant for something else
    for (const auto &axis : m_axes)
        axis->firmware.feedWatchdog();
    return Status::Ok;
}

Status Server::userCommand(const Request &request)
{
    if (request.command > static_cast<std::uint16_t>(CommandId::UserLast))
        return Status::CommandUnknown;
    const int index = request.command - static_cast<int>(CommandId::UserFirst);
    if (index == kHeartbeat && m_options.watchdogMs > 0)
        return heartbeat(request);
    if (m_build.hso() && index <= 1 && m_options.userCallbacks == 0)
        return Status::Ok; // writes and reads the parameter page of the flash
    if (index >= m_options.userCallbacks)
        return Status::CallbackNotRegistered;
    if (index > 0)
        return static_cast<Status>(0x42);
    const std::size_t size =
        std::min({std::size_t{request.length}, static_cast<std::size_t>(request.room),
            request.length == 65534 ? kUserAnswerMax : std::size_t{65535}});
    for (std::size_t i = size; i > 0; --i)
        m_answer.push_back(request.data.u8(i - 1));
    return Status::Ok;
}

} // namespace simulation

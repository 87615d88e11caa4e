// Events happen in the order of time: bytes, SysTick every 0.5 ms with the 1 kHz task in every second one, HF tasks at
// the control rate.
#include "simulation/mcp/board.h"

#include "aspep/packet.h"
#include "simulation/axis.h"
#include "simulation/mcp/datalog_recorder.h"
#include "simulation/mcp/performer.h"
#include "simulation/mcp/profile.h"
#include "simulation/mcp/register_file.h"
#include "simulation/mcp/server.h"
#include "simulation/mcp/uart.h"
#include "simulation/signals.h"

#include <algorithm>
#include <cmath>

namespace simulation {

namespace {

constexpr Duration kSysTick = std::chrono::microseconds(500);
/// Minutes of a full line; a line without a listener keeps nothing.
constexpr std::size_t kOutputMax = 16U << 20;

/// How busy the processor says it is. Nothing is measured: an idle board, a turning motor and a running datalog cost
/// about what they cost on a 170 MHz part, with a wobble that repeats.
class CpuLoad {
public:
    /// Once a millisecond; `signals` of the first motor carry the numbers. PERF_* show them.
    void measure(Signals &signals, int drivenMotors, bool logging)
    {
        constexpr float kIdle = 12.0F, kDriven = 21.0F, kLogging = 4.0F, kWobble = 0.25F;
        m_phase = static_cast<std::uint8_t>(m_phase * 5U + 1U); // full period
        const float wobble = kWobble * static_cast<float>(m_phase & 7U);
        signals.cpuLoad = kIdle + kDriven * static_cast<float>(drivenMotors)
            + (logging ? kLogging : 0.0F) + wobble;
        signals.cpuLoadMin =
            m_first ? signals.cpuLoad : std::min(signals.cpuLoadMin, signals.cpuLoad);
        signals.cpuLoadMax =
            m_first ? signals.cpuLoad : std::max(signals.cpuLoadMax, signals.cpuLoad);
        m_first = false;
    }

private:
    std::uint8_t m_phase = 0;
    bool m_first = true;
};

/// What a restart makes anew: everything but the motor and the line.
struct Processor final : AsyncLine {
    Processor(const Traits &traits, const BoardOptions &options, const Build &build,
        const Axes &axes, UartReceiver &uartReceiver, Transmitter &uartTransmitter)
        : receiver(uartReceiver)
        , transmitter(uartTransmitter)
        , performer(traits, options, uartReceiver, uartTransmitter)
        , registers(traits, options, build, axes)
        , datalog(
              options.streams,
              build.hso() ? UnknownSignal::KeepsPrevious : UnknownSignal::ReadsZero,
              [this](mcp::RegisterId id) { return registers.source(id); }, *this)
        , server(traits, options, build, axes, registers, datalog)
        , timestamp(options.firstTimestamp)
    {
    }

    bool acquire() override { return transmitter.acquireAsync(); }
    void send(ByteView payload) override
    {
        if (performer.connected())
            transmitter.sendAsync(performer.framed(false, payload), now);
        else
            transmitter.releaseAsync(); // a finished packet without a connection is thrown away
    }
    void release() override { transmitter.releaseAsync(); }
    std::size_t payloadMax() const override { return performer.asyncMax(); }

    UartReceiver &receiver;
    Transmitter &transmitter;
    Performer performer;
    RegisterFile registers;
    DatalogRecorder datalog;
    Server server;
    CpuLoad load;
    std::uint32_t timestamp;
    TimePoint now{};
};

/// About what a Controller waits for an answer: the longest packets in both directions, and a host's own delay.
Duration replyTime(const BoardOptions &options)
{
    return 3 * wireTime(options.txAsyncMax + options.txSyncMax + 8, options.baud) / 2
        + std::chrono::milliseconds(22);
}

/// Six-step firmware has no datalog, and its link is told so.
BoardOptions linkOf(BoardOptions options, const Build &build)
{
    if (build.sixStep())
        options.txAsyncMax = 0;
    return options;
}

class Board final : public SimulatedBoard {
public:
    Board(const BoardOptions &options, const Traits &traits, const Build &build,
        const PlantParameters &plant)
        : m_build(build)
        , m_options(linkOf(options, m_build))
        , m_traits(traits)
        , m_liar(options.lies, replyTime(options), options.seed)
        , m_receiver(options.baud)
        , m_transmitter(options.baud, m_liar)
    {
        for (int i = 0; i < m_build.motors; ++i)
            m_axes.push_back(std::make_unique<Axis>(plant, driveBehind(m_build), options.hfHz,
                options.seed + static_cast<std::uint64_t>(i)));
        for (const auto &axis : m_axes)
            axis->firmware.setWatchdog(options.watchdogMs);
        powerUp();
    }

    void receive(ByteView bytes, TimePoint now) override
    {
        advance(now);
        m_receiver.put(bytes, now);
    }
    void advance(TimePoint now) override;
    Bytes takeOutput() override { return std::exchange(m_output, {}); }
    TimePoint nextWake() const override { return m_nextSysTick; }
    std::size_t headerBytes() const override { return aspep::kHeaderSize; }

    void reset() override
    {
        m_receiver.reset();
        m_transmitter.reset();
        for (const auto &axis : m_axes)
            axis->firmware.restart();
        powerUp();
    }
    void setFaults(std::uint16_t present) override
    {
        for (const auto &axis : m_axes)
            axis->firmware.setPresentFaults(present);
    }
    void mute(Duration time) override { m_faults.muteUntil = m_now + time; }
    void corruptAfter(std::uint64_t bytes) override { m_faults.corruptAfter = bytes; }
    void setLoadTorque(int motor, double nm) override
    {
        if (motor >= 1 && motor <= m_build.motors)
            m_axes[static_cast<std::size_t>(motor) - 1U]->plant.setLoadTorque(nm);
    }
    MotorTruth truth(int motor) const override { return truthOf(m_axes, motor); }
    void inject(ByteView bytes) override
    {
        m_output.insert(m_output.end(), bytes.begin(), bytes.end());
    }
    std::string describe() const override
    {
        const PlantParameters &plant = m_axes.front()->plant.parameters();
        return "Simulated board, " + std::string(m_traits.profile) + ", "
            + std::to_string(std::lround(plant.inverter.supply_v)) + " V PMSM with "
            + std::to_string(plant.motor.polePairs) + " pole pairs";
    }

private:
    void powerUp()
    {
        m_processor = std::make_unique<Processor>(
            m_traits, m_options, m_build, m_axes, m_receiver, m_transmitter);
        m_processor->now = m_now;
    }
    TimePoint hfTime() const
    {
        return m_start
            + fromSeconds(static_cast<double>(m_hfTicks)
                / (m_options.hfHz * static_cast<double>(m_axes.size())));
    }
    void sysTick(TimePoint at);
    void hfTask();
    Bytes execute(ByteView buffer, std::uint16_t length, std::size_t responseMax);
    bool actAsLiar(TimePoint at); ///< true: the board restarted
    void receiverEvent();
    void measureLoad();

    Build m_build;
    BoardOptions m_options;
    const Traits &m_traits;
    Liar m_liar;
    UartReceiver m_receiver;
    Transmitter m_transmitter;
    Axes m_axes;
    std::unique_ptr<Processor> m_processor;

    bool m_started = false; ///< the first instant seen is the instant of power-on
    TimePoint m_now{}, m_start{}, m_nextSysTick{}, m_nextHf{};
    std::uint64_t m_hfTicks = 0;
    bool m_mfTurn = false;
    LineFaults m_faults;
    Bytes m_output;
};

void Board::advance(TimePoint now)
{
    if (!m_started) {
        m_started = true;
        m_now = m_start = now;
        m_nextSysTick = now + kSysTick;
        m_hfTicks = 1;
        m_nextHf = hfTime();
    }
    if (now < m_now)
        return;
    constexpr TimePoint kNever = TimePoint::max();
    while (true) {
        const TimePoint received = m_receiver.nextEvent().value_or(kNever);
        const TimePoint sent = m_transmitter.nextEvent().value_or(kNever);
        const TimePoint next = std::min({received, sent, m_nextSysTick, m_nextHf});
        if (next > now)
            break;
        m_now = m_processor->now = next;
        if (next == sent)
            m_transmitter.step();
        else if (next == received)
            receiverEvent();
        else if (next == m_nextHf)
            hfTask();
        else
            sysTick(next);
    }
    m_now = m_processor->now = now;
    m_transmitter.collect(now, m_faults, m_output);
    if (m_output.size() > kOutputMax)
        m_output.clear();
}

void Board::receiverEvent()
{
    switch (m_receiver.step()) {
    case UartReceiver::Happened::TransferComplete:
        if (m_traits.decodesInInterrupt)
            m_processor->performer.poll();
        break;
    case UartReceiver::Happened::LineIdle:
        m_processor->performer.handleLineIdle();
        break;
    case UartReceiver::Happened::Nothing:
        break;
    }
}

/// With two motors their tasks take turns; the counter and the datalog know no difference.
void Board::hfTask()
{
    Processor &cpu = *m_processor;
    ++cpu.timestamp;
    m_axes[m_hfTicks % m_axes.size()]->hfTask();
    if (cpu.datalog.running())
        cpu.datalog.tick(cpu.timestamp);
    ++m_hfTicks;
    m_nextHf = hfTime();
}

Bytes Board::execute(ByteView buffer, std::uint16_t length, std::size_t responseMax)
{
    const ByteView request = buffer.first(std::min<std::size_t>(length, buffer.size()));
    if (auto pretence = m_liar.insteadOf(request))
        return *pretence;
    return m_liar.answer(request, m_processor->server.execute(buffer, length, responseMax));
}

bool Board::actAsLiar(TimePoint at)
{
    if (m_liar.honest())
        return false;
    const auto urge = m_liar.act(at, static_cast<std::uint8_t>(m_axes.front()->firmware.state()),
        m_transmitter.responseFree());
    m_transmitter.sendAsIs(urge.bytes, at);
    m_receiver.put(urge.heard, at);
    if (urge.faults)
        setFaults(*urge.faults);
    if (urge.restart)
        reset();
    return urge.restart;
}

void Board::sysTick(TimePoint at)
{
    m_nextSysTick = at + kSysTick;
    m_mfTurn = !m_mfTurn;
    if (actAsLiar(at))
        return;
    if (m_mfTurn) {
        m_processor->performer.task(
            at, [this](ByteView buffer, std::uint16_t length, std::size_t responseMax) {
                return execute(buffer, length, responseMax);
            });
        if (m_processor->performer.takeServicesReset())
            m_processor->datalog.reset();
        if (m_processor->server.takeResetWanted()) {
            reset();
            return;
        }
        bool tripped = false;
        for (const auto &axis : m_axes) {
            const MotorState before = axis->firmware.state();
            axis->firmware.mfTask();
            tripped |=
                axis->firmware.state() == MotorState::FaultNow && before != MotorState::FaultNow;
        }
        if (tripped && (m_traits.flushesOnFault || m_build.profiler))
            m_processor->datalog.flush();
        if (m_build.cpuLoad)
            measureLoad();
    }
    // Looked at behind the task: what is complete now is acted upon in the next one.
    if (!m_traits.decodesInInterrupt)
        m_processor->performer.poll();
}

void Board::measureLoad()
{
    const auto driven = std::ranges::count_if(
        m_axes, [](const auto &axis) { return axis->firmware.state() == MotorState::Run; });
    m_processor->load.measure(m_axes.front()->firmware.variables(), static_cast<int>(driven),
        m_processor->datalog.running());
}

} // namespace

std::unique_ptr<SimulatedBoard> makeMcpBoard(const BoardOptions &options)
{
    const Traits *traits = findTraits(options.profile);
    if (traits == nullptr)
        return nullptr;
    const auto plant = plantOf(options);
    if (!plant)
        return nullptr;
    return std::make_unique<Board>(options, *traits, buildOf(options), *plant);
}

} // namespace simulation

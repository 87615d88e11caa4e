// Drive for boards that speak MCP over ASPEP. It joins the link (aspep::Controller) with the pieces of work that want
// something of the board (Task) and gives the link to the most urgent one whenever it is free:
//
//   the stop of every motor > identification > heartbeat > state poll > wishes that act > wishes that read > watched
//   registers
//
// After every connection: version, state of every motor, datalog stopped, the rest of the identification; only then
// anything else. No motion, no write and no acknowledgement is ever sent that a wish of this session did not ask for;
// the heartbeat of a drive with a watchdog moves nothing.
#include "aspep/controller.h"
#include "drive/mcp/commands.h"
#include "drive/mcp/heartbeat.h"
#include "drive/mcp/identification.h"
#include "drive/mcp/stream.h"
#include "drive/mcp/vitals.h"
#include "drive/mcp/writes.h"
#include "drive/protocol_table.h"
#include "drive/task_drive.h"

namespace drive {

namespace {

/// Where another protocol is tried next a second of Beacons into silence is enough: a third of a second each at 115200
/// baud.
constexpr int kHastyOffers = 3;

LinkReason reasonOf(aspep::Controller::LostReason reason)
{
    switch (reason) {
    case aspep::Controller::LostReason::NoAnswer:
        return LinkReason::NoAnswer;
    case aspep::Controller::LostReason::OnlyGarbage:
        return LinkReason::OnlyGarbage;
    case aspep::Controller::LostReason::OldProtocol:
        return LinkReason::OldProtocol;
    case aspep::Controller::LostReason::NoAgreement:
        return LinkReason::NoAgreement;
    case aspep::Controller::LostReason::Silence:
        return LinkReason::Silence;
    case aspep::Controller::LostReason::RecoveryFailed:
        break;
    }
    return LinkReason::RecoveryFailed;
}

/// Empty only if there is no such motor.
Bytes stopOf(int motor)
{
    return encode(McpAct{mcp::CommandId::StopMotor, motor}, sizeof(std::uint16_t))
        .value_or(Bytes());
}

class McpDrive final : public TaskDrive<McpProtocol> {
public:
    McpDrive(const LineOptions &line, Search search)
        : TaskDrive({.baud = line.baud,
            .patience = line.patience,
            .firstSilentOffers = search == Search::Hasty ? kHastyOffers : Link::kSilentOffers})
    {
        m_board.baud = line.baud;
    }

    std::vector<Output> stopScript() const override;
    void remember(const LineMemory &memory) override
    {
        TaskDrive::remember(memory);
        if (memory.agreed)
            if (const auto header = aspep::decodeHeader(*memory.agreed))
                m_link.remember(std::get<aspep::Beacon>(*header));
    }
    Duration gathersFor() const override;

private:
    Made taskFor(const Wish &wish) override;

    // what the link tells
    void onLinkEvents(TimePoint now) override
    {
        for (const Link::Event &event : m_link.takeEvents())
            std::visit([&](const auto &what) { on(what, now); }, event);
    }
    void on(const Link::Connected &event, TimePoint now);
    void on(const Link::Lost &event, TimePoint now)
    {
        linkLost(reasonOf(event.reason), now);
        m_stop.stopFailed(m_stopMotor, now); // what was about to leave has gone with the link
    }
    void on(const Link::Response &event, TimePoint now);
    void on(const Link::NoResponse &event, TimePoint now)
    {
        if (m_task != nullptr)
            passLoss(event.executed, now);
        else
            m_stopUnderWay = false;
    }
    void on(const Link::Recovered &, TimePoint)
    {
        m_suspect = false;
        m_stream.connected();
    }
    void on(const Link::Suspect &, TimePoint) { m_suspect = true; }
    void on(const Link::Async &event, TimePoint) { m_stream.receive(event.payload, event.at); }
    void onIdentified(TimePoint now) override;
    bool connected() const override { return m_link.state() == Link::State::Connected; }
    bool recovering() const override { return m_link.state() == Link::State::Recovering; }
    LinkCounters counters() const override;

    // what goes out
    void prepare(TimePoint now) override;
    bool sendFirst(TimePoint now) override;
    bool send(const McpRequest &request, WishTask<McpProtocol> *wish, TimePoint now) override;
    void sendStop(int motor, TimePoint now) override;
    TimePoint stopMayLeave() const override
    {
        if (m_link.urgentWaits())
            return TimePoint::max(); // the last one is still to leave, when the link says
        return m_stopUnderWay ? m_stopSince + m_stop.turn() : TimePoint{};
    }
    Duration closingTime() const override { return std::chrono::milliseconds(500); }
    void leave() override
    {
        if (m_stream.wanted() && connected() && m_board.identified)
            m_wishes.add(std::make_unique<McpStreamTask>(0, Stream{}, m_stream));
    }
    void closeLink() override
    {
        m_stream.close();
        m_link.reset();
        static_cast<void>(m_link.takeEvents());
    }
    void collect(TimePoint now) override;
    std::optional<TimePoint> nextOwn() const override { return m_stream.nextTimeout(); }
    std::optional<TimePoint> nextWork() const override { return m_heartbeat.due(); }

    McpHeartbeat m_heartbeat{m_board};
    McpStreamControl m_stream{m_board};
};

/// Less comes meanwhile than the 4 kB that a system keeps of what was not read. An answer comes between samples.
Duration McpDrive::gathersFor() const
{
    constexpr Duration kSamples = std::chrono::milliseconds(16),
                       kAnswer = std::chrono::milliseconds(8);
    constexpr std::size_t kMostBytes = 3000;
    if (!m_stream.wanted() || !atRest())
        return {};
    return std::min(linkIsFree() ? kSamples : kAnswer, wireTime(kMostBytes, m_board.baud));
}

McpDrive::Made McpDrive::taskFor(const Wish &wish)
{
    if (const auto setPoint = setPointOf(wish.what))
        return std::make_unique<McpSetPointTask>(wish.id, *setPoint, m_board);
    if (const auto *command = std::get_if<Command>(&wish.what))
        return std::make_unique<McpCommandTask>(wish.id, *command, m_board);
    if (const auto *position = std::get_if<PositionRamp>(&wish.what))
        return std::make_unique<McpPositionTask>(wish.id, *position, m_board);
    if (const auto *stream = std::get_if<Stream>(&wish.what))
        return std::make_unique<McpStreamTask>(wish.id, *stream, m_stream);
    return nullptr;
}

void McpDrive::on(const Link::Connected &event, TimePoint now)
{
    linkFound();
    m_memory.agreed = aspep::encodeHeader(event.agreed);
    if (event.afterReset)
        disarm();
    m_board.linkId = m_link.linkId();
    m_heartbeat.restart(now);
    m_stream.connected();
    meet(event.afterReset ? LinkReason::BoardReset : LinkReason::None, now);
    m_board.requestBytes = event.agreed.rxMax();
    m_board.responseBytes = event.agreed.txSyncMax();
    m_board.streamBytes = event.agreed.txAsyncMax();
}

void McpDrive::on(const Link::Response &event, TimePoint now)
{
    if (m_task == &m_identification
        && m_identification.phase() == McpIdentification::Phase::StopDatalog)
        m_stream.stopSent();
    passAnswer(mcp::decodeResponse(event.payload), now);
}

void McpDrive::onIdentified(TimePoint)
{
    m_stream.restart();
    if (m_stream.wanted() && m_mode == Mode::Open)
        m_wishes.addFirst(std::make_unique<McpStreamTask>(0, m_stream.wish(), m_stream));
}

void McpDrive::prepare(TimePoint now)
{
    m_stream.handleTimeout(now);
    if (m_heartbeat.givenUp() && m_board.identity.watchdog) {
        m_board.identity.watchdog.reset();
        tellIdentified();
    }
    m_heartbeat.setWanted(!m_stop.active() && armed());
}

std::vector<Output> McpDrive::stopScript() const
{
    std::vector<Bytes> stops;
    for (int motor = 1; motor <= motorsToStop(); ++motor)
        stops.push_back(stopOf(motor));
    return m_link.blindScript(stops);
}

void McpDrive::sendStop(int motor, TimePoint now)
{
    const Bytes request = stopOf(motor);
    if (request.empty())
        return;
    noteStop(motor, request, now);
    m_link.sendUrgent(request, now);
    onLinkEvents(now); // the end of what was open before, perhaps of the last STOP
    m_stopUnderWay = true;
    m_stopMotor = motor;
    m_stopSince = now;
}

bool McpDrive::sendFirst(TimePoint now)
{
    using Phase = McpIdentification::Phase;
    if (m_identification.phase() == Phase::States) {
        if (m_vitals.complete())
            m_identification.statesRead();
        else if (give(m_vitals, now))
            return true;
    }
    return TaskDrive::sendFirst(now) || give(m_heartbeat, now);
}

bool McpDrive::send(const McpRequest &request, WishTask<McpProtocol> *wish, TimePoint now)
{
    const auto payload = encode(request, m_board.requestBytes);
    if (!payload)
        return false;
    if (wish != nullptr && wish->motion() && !std::holds_alternative<McpGet>(request))
        noteSent(*wish->motion(), *payload);
    m_link.sendRequest(*payload, now);
    return true;
}

void McpDrive::collect(TimePoint now)
{
    m_watch.setStreamLoad(m_stream.load());
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
    TaskDrive::collect(now);
}

LinkCounters McpDrive::counters() const
{
    const Link::Stats &link = m_link.stats();
    return {.bytesIn = link.bytesIn,
        .bytesOut = link.bytesOut,
        .packetsIn = link.packetsIn,
        .packetsOut = link.packetsOut,
        .badPackets = link.badHeaderCrc + link.unknownType + link.inconsistent + link.tooLong
            + link.badPayloadCrc + link.torn + link.unexpected,
        .nacks = link.nacks,
        .timeouts = link.timeouts,
        .recoveries = link.recoveries,
        .streamPackets = m_stream.packets(),
        .streamLostTicks = m_stream.lostTicks(),
        .streamSkipped = m_stream.skipped()};
}

} // namespace

std::unique_ptr<Drive> makeMcpDrive(const LineOptions &line, Search search)
{
    return std::make_unique<McpDrive>(line, search);
}

} // namespace drive

// What an MCP drive sends, most urgent first, and what it tells its owner.
#include "drive/mcp/mcp_machine.h"
#include "drive/motion_of.h"
#include "mcp/protocol.h"
#include "mcp/request.h"

namespace drive {

namespace {

/// The motion log has only what can change something.
bool onlyReads(ByteView request)
{
    const auto decoded = mcp::decodeRequest(request);
    return decoded && decoded->command == static_cast<std::uint16_t>(mcp::CommandId::GetRegister);
}

Bytes stopOf(int motor)
{
    const auto word =
        static_cast<unsigned>(mcp::CommandId::StopMotor) << 3 | static_cast<unsigned>(motor);
    return ByteWriter().u16(word).take();
}

} // namespace

void McpDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    takeStatuses(m_vitals.takeStatuses(), m_vitals.askedAt());
    if (m_identification.takeNews())
        onIdentified(now);
    if (m_heartbeat.takeGivenUp()) {
        m_board.watchdog.reset();
        tellIdentity();
    }
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open && !m_stop.blind(now)) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    if (followStop(now))
        sendStop(now);
    m_heartbeat.setWanted(!m_stop.active() && armed());
    if (linkIsFree())
        sendNext(m_vitals, m_watch, now);
    collect();
    if (m_mode == Mode::Closing)
        close(now);
    tellLinkState();
    tellLinkCounters(now);
}

std::vector<Output> McpDrive::stopScript() const
{
    std::vector<Bytes> stops;
    for (int motor = 1; motor <= m_board.motors; ++motor)
        stops.push_back(stopOf(motor));
    return m_link.blindScript(stops);
}

bool McpDrive::sendStop(TimePoint now)
{
    if (m_stopUnderWay && now < m_stopSince + m_stop.turn())
        return false;
    const auto motor = m_stop.stopDue(now, connected());
    if (!motor)
        return false;
    const Bytes request = stopOf(*motor);
    noteStop(*motor, request, now);
    m_link.sendUrgent(request, now);
    onLinkEvents(now); // the end of what was open before, perhaps of the last STOP
    m_stopUnderWay = true;
    m_stopMotor = *motor;
    m_stopSince = now;
    return true;
}

bool McpDrive::sendFirst(TimePoint now)
{
    using Phase = Identification::Phase;
    if (m_identification.phase() == Phase::States) {
        if (m_vitals.complete())
            m_identification.statesRead();
        else if (give(m_vitals, now))
            return true;
    }
    if (m_identification.phase() == Phase::Done)
        return give(m_heartbeat, now);
    give(m_identification, now);
    return true;
}

bool McpDrive::give(Task &task, TimePoint now)
{
    const auto request = task.nextRequest(now);
    if (!request)
        return false;
    m_task = &task;
    if (auto *wish = dynamic_cast<WishTask *>(&task);
        wish != nullptr && wish->motion() && !onlyReads(*request))
        noteSent(*wish->motion(), *request);
    m_link.sendRequest(*request, now);
    return true;
}

void McpDrive::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false, now) != nullptr;
    if (busy && connected() && now < m_closeBy)
        return;
    cutAllWishes("disconnected");
    m_stream.close();
    m_link.reset();
    static_cast<void>(m_link.takeEvents());
    m_task = nullptr;
    m_stopUnderWay = false;
    m_stop.end();
    m_lost.reset();
    m_reconnectAt.reset();
    m_mode = Mode::Closed;
    collect();
}

void McpDrive::collect()
{
    m_watch.setStreamLoad(m_stream.load());
    if (auto readings = m_watch.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
    collectWishes();
}

void McpDrive::tellLinkState()
{
    LinkState state = LinkState::Connecting;
    LinkReason reason = LinkReason::None;
    if (m_mode == Mode::Closed) {
        state = LinkState::Closed;
    } else if (m_lost) {
        state = LinkState::Lost;
        reason = *m_lost;
    } else if (connected()) {
        state = m_suspect ? LinkState::Suspect : LinkState::Connected;
        reason = m_toldState == state ? m_toldReason : LinkReason::None;
    } else if (m_link.state() == Link::State::Recovering) {
        state = m_suspect ? LinkState::Suspect : LinkState::Recovering;
    }
    tellLink(state, reason);
}

void McpDrive::tellLinkCounters(TimePoint now)
{
    const Link::Stats &link = m_link.stats();
    LinkCounters counters;
    counters.bytesIn = link.bytesIn;
    counters.bytesOut = link.bytesOut;
    counters.packetsIn = link.packetsIn;
    counters.packetsOut = link.packetsOut;
    counters.badPackets = link.badHeaderCrc + link.unknownType + link.inconsistent + link.tooLong
        + link.badPayloadCrc + link.torn + link.unexpected;
    counters.nacks = link.nacks;
    counters.timeouts = link.timeouts;
    counters.recoveries = link.recoveries;
    counters.streamPackets = m_stream.packets();
    counters.streamLostTicks = m_stream.lostTicks();
    counters.streamSkipped = m_stream.skipped();
    tellCounters(counters, now);
}

} // namespace drive

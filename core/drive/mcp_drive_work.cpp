// What an MCP drive sends, most urgent first, and what it tells its owner.
#include "drive/mcp_machine.h"
#include "drive/mcp_motion.h"
#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr Duration kCountersEvery = 250ms;

} // namespace

void McpDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    tellVitals();
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
    if (m_mode == Mode::Open && m_stop.active())
        sendStop(now);
    m_heartbeat.setWanted(!m_stop.active() && (m_armed || m_vitals.motorDriven()));
    if (linkIsFree())
        sendNext(now);
    collect();
    if (m_mode == Mode::Closing)
        close(now);
    tellLink();
    tellCounters(now);
}

bool McpDrive::sendStop(TimePoint now)
{
    if (m_stopUnderWay && now < m_stopSince + StopSequence::kRepeat)
        return false;
    const auto motor = m_stop.stopDue(now, connected());
    if (!motor)
        return false;
    m_stopUnderWay = true;
    m_stopMotor = *motor;
    m_stopSince = now;
    m_stop.stopSent(*motor, now);
    const auto word =
        static_cast<unsigned>(mcp::CommandId::StopMotor) << 3 | static_cast<unsigned>(*motor);
    const Bytes request = ByteWriter().u16(word).take();
    noteSent(m_stopsSent[*motor], request);
    m_link.sendUrgent(request, now);
    onLinkEvents(now);
    return true;
}

bool McpDrive::stopHoldsBack(TimePoint now) const
{
    return m_stop.exclusive() && (!m_stop.alarmed() || m_stop.blind(now));
}

void McpDrive::sendNext(TimePoint now)
{
    if (m_mode == Mode::Open
        && (sendIdentification(now) || give(m_heartbeat, now) || give(m_vitals, now)))
        return;
    while (WishTask *wish = m_wishes.next(m_armed)) {
        if (give(*wish, now))
            return;
        if (!wish->finished())
            break; // waits for something else; nothing overtakes it
        m_wishes.collect(m_events, m_workedAt);
    }
    if (m_mode == Mode::Open)
        give(m_watch, now);
}

/// Whether the link is not there for anything else now.
bool McpDrive::sendIdentification(TimePoint now)
{
    if (m_stop.active() && give(m_vitals, now))
        return true;
    if (stopHoldsBack(now))
        return true;
    using Phase = Identification::Phase;
    if (m_identification.phase() == Phase::States) {
        if (m_vitals.complete())
            m_identification.statesRead();
        else if (give(m_vitals, now))
            return true;
    }
    if (m_identification.phase() == Phase::Done)
        return false;
    give(m_identification, now);
    return true;
}

bool McpDrive::give(Task &task, TimePoint now)
{
    const auto request = task.nextRequest(now);
    if (!request)
        return false;
    m_task = &task;
    if (auto *wish = dynamic_cast<WishTask *>(&task); wish != nullptr && wish->motion())
        noteSent(*wish->motion(), *request);
    m_link.sendRequest(*request, now);
    return true;
}

void McpDrive::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false) != nullptr;
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
    m_wishes.collect(m_events, m_workedAt);
    m_watch.setStreamLoad(m_stream.load());
    if (auto readings = m_watch.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
    for (const StopProgress &progress : m_stop.takeProgress()) {
        m_events.emplace_back(logged(progress, std::exchange(m_stopsSent[progress.motor], {})));
        m_events.emplace_back(progress);
    }
}

/// The word of a stop as the motion log has it, with the STOPs that left since the word before.
MotionRecord McpDrive::logged(const StopProgress &progress, MotionRecord record) const
{
    record.act = MotionAct::Stop;
    record.motor = progress.motor;
    record.asked = m_stopAsked;
    record.ended = std::max(m_stopAsked, progress.at);
    record.stop = progress.word;
    const bool sure =
        progress.word != StopWord::Requested && progress.word != StopWord::NotConfirmed;
    record.outcome = sure ? Outcome::Ok : Outcome::Unknown;
    return record;
}

void McpDrive::tellVitals()
{
    for (MotorStatus &status : m_vitals.takeStatuses()) {
        m_stop.takeStatus(status, m_vitals.askedAt());
        m_events.emplace_back(std::move(status));
    }
}

void McpDrive::tell(LinkState state, LinkReason reason)
{
    m_toldState = state;
    m_toldReason = reason;
    m_events.emplace_back(LinkChanged{state, reason});
}

void McpDrive::tellLink()
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
    if (state != m_toldState || reason != m_toldReason)
        tell(state, reason);
}

void McpDrive::tellCounters(TimePoint now)
{
    if (now < m_countersAt)
        return;
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
    if (counters == m_counters)
        return;
    m_counters = counters;
    m_countersAt = now + kCountersEvery;
    m_events.emplace_back(counters);
}

} // namespace drive

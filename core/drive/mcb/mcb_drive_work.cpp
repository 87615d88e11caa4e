// What an MCB drive sends, most urgent first, and what it tells its owner.
#include "drive/mcb/mcb_machine.h"

#include "drive/mcb/mcb_messages.h"
#include "drive/motion_of.h"

namespace drive {

namespace {

/// Control word 06, shutdown: the power stage goes off in every state but a fault, where it is off.
constexpr std::uint16_t kShutdown = 0x06;

} // namespace

void McbDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    takeStatuses(m_vitals.takeStatuses(), m_vitals.askedAt());
    if (m_identification.takeNews())
        onIdentified(now);
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    if (m_mode == Mode::Open && m_stop.active())
        sendStop(now);
    if (linkIsFree())
        sendNext(m_vitals, m_watch, now);
    collect(now);
    if (m_mode == Mode::Closing)
        close(now);
    tellLinkState();
    tellLinkCounters(now);
}

bool McbDrive::sendStop(TimePoint now)
{
    if (!connected() || (m_stopUnderWay && now < m_stopSince + StopSequence::kRepeat))
        return false;
    if (!m_stop.stopDue(now, true))
        return false;
    if (!m_link.canSend()) {
        m_link.cancel(now);
        onLinkEvents(now);
    }
    if (!m_link.canSend())
        return false; // the length of frames is changing
    const mcb::Words word{kShutdown};
    noteStop(1, mcbWrite(mcbreg::kControl, word), now);
    m_stopUnderWay = true;
    m_stopSince = now;
    m_link.send({mcb::Command::Write, mcbreg::kControl, word}, now);
    return true;
}

bool McbDrive::sendFirst(TimePoint now)
{
    if (m_identification.done())
        return false;
    give(m_identification, now);
    return true;
}

bool McbDrive::give(Task &task, TimePoint now)
{
    const auto request = task.nextRequest(now);
    if (!request)
        return false;
    m_task = &task;
    if (auto *wish = dynamic_cast<WishTask *>(&task);
        wish != nullptr && wish->motion() && !mcbReads(*request))
        noteSent(*wish->motion(), *request);
    const McbRequest wanted = mcbRequestOf(*request);
    switch (wanted.kind) {
    case McbRequest::Kind::One:
        m_link.send(wanted.request, now);
        break;
    case McbRequest::Kind::Map:
        m_link.switchOn(wanted.mapping, m_stream.period(), now);
        break;
    case McbRequest::Kind::Unmap:
        m_link.switchOff(now);
        break;
    }
    return true;
}

void McbDrive::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false) != nullptr;
    if (busy && connected() && now < m_closeBy)
        return;
    cutAllWishes("disconnected");
    m_stream.close();
    m_link.close();
    m_task = nullptr;
    m_stopUnderWay = false;
    m_stop.end();
    m_lost.reset();
    m_reconnectAt.reset();
    m_board.expert.clear();
    m_mode = Mode::Closed;
    collect(now);
}

void McbDrive::collect(TimePoint now)
{
    collectWishes();
    if (auto readings = m_watch.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    m_stream.flush(now);
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
}

void McbDrive::tellLinkState()
{
    LinkState state = LinkState::Connecting;
    LinkReason reason = LinkReason::None;
    if (m_mode == Mode::Closed) {
        state = LinkState::Closed;
    } else if (m_lost) {
        state = LinkState::Lost;
        reason = *m_lost;
    } else if (connected()) {
        state = LinkState::Connected;
        reason = m_toldState == state ? m_toldReason : LinkReason::None;
    } else if (m_link.state() == Link::State::Seeking && m_toldState != LinkState::Connecting) {
        state = LinkState::Recovering;
    }
    tellLink(state, reason);
}

void McbDrive::tellLinkCounters(TimePoint now)
{
    const Link::Stats &link = m_link.stats();
    LinkCounters counters;
    counters.bytesIn = link.bytesIn;
    counters.bytesOut = link.bytesOut;
    counters.packetsIn = link.goodFrames;
    counters.packetsOut = link.exchanges;
    counters.badPackets = link.damaged + link.dead + link.torn + link.strays;
    counters.timeouts = link.timeouts;
    counters.recoveries = link.searches;
    counters.streamPackets = m_stream.packets();
    counters.streamLostTicks = m_stream.lost();
    tellCounters(counters, now);
}

} // namespace drive

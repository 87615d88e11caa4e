// What an MCB drive sends, most urgent first, and what it tells its owner.
#include "drive/mcb/mcb_machine.h"

#include "drive/mcb/mcb_messages.h"
#include "drive/motion_of.h"

#include <algorithm>

namespace drive {

namespace {

/// Control word 06, shutdown: the power stage goes off in every state but a fault, where it is off.
constexpr std::uint16_t kShutdown = 0x06;

} // namespace

void McbDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    takeVitals();
    if (m_identification.takeNews())
        onIdentified(now);
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    if (followStop(now)) {
        restSetPoints();
        sendStop(now);
    } else {
        m_stopWaits.reset();
    }
    if (linkIsFree())
        sendNext(m_vitals, m_watch, now);
    collect(now);
    if (m_mode == Mode::Closing)
        close(now);
    tellLinkState();
    tellLinkCounters(now);
}

/// In the length of frames that the drive has now, and in the other one: it may be changing.
std::vector<Output> McbDrive::stopScript() const
{
    constexpr Duration kBehindFrame = std::chrono::milliseconds(2); // to be ready again
    constexpr Duration kBehindWrongFrame =
        std::chrono::milliseconds(60); // byte streams forget an unfinished frame, see Master::quiet
    mcb::Frame stop{mcbreg::kControl, mcb::Command::Write, false, {kShutdown}, {}};
    std::vector<Output> script{{mcb::encodeFrame(stop), kBehindFrame}};
    if (const std::size_t words = m_link.mapping().words(); words > 0) {
        stop.cyclic.resize(words);
        script.push_back({mcb::encodeFrame(stop), kBehindFrame});
        if (m_link.state() == Link::State::Cyclic)
            std::swap(script.front(), script.back());
        script.back().gapBefore = kBehindWrongFrame;
    }
    return script;
}

bool McbDrive::sendStop(TimePoint now)
{
    if (m_stopUnderWay && now < m_stopSince + StopSequence::kRepeat)
        return false;
    if (!m_stop.stopDue(now, connected()))
        return false;
    if (connected() && !m_link.canSend()) {
        m_link.cancel(now);
        onLinkEvents(now);
    }
    if (m_link.canSend() && m_link.ready())
        m_stopWaits.reset();
    else
        m_stopWaits = m_stopWaits.value_or(now);
    const bool blind = !connected() || (m_stopWaits && now >= *m_stopWaits + StopSequence::kRepeat);
    if (!blind && !m_link.canSend())
        return false; // the length of frames is changing: in a moment it is known
    const mcb::Words word{kShutdown};
    noteStop(1, mcbWrite(mcbreg::kControl, word), now);
    m_stopSince = now;
    m_stopUnderWay = !blind;
    if (blind)
        m_link.sendBlind(stopScript(), now);
    else
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
    const McbRequest wanted = mcbRequestOf(*request);
    if (auto *wish = dynamic_cast<WishTask *>(&task);
        wish != nullptr && wish->motion() && !mcbReads(*request))
        noteSent(*wish->motion(), travels(wanted.request) ? frameWith(wanted.request) : *request);
    switch (wanted.kind) {
    case McbRequest::Kind::One:
        if (travels(wanted.request))
            sendInFrames(wanted.request, now);
        else
            m_link.send(wanted.request, now);
        break;
    case McbRequest::Kind::Map:
        // In the config state, so that no frame goes out with words of another mapping.
        m_link.setCyclicOutput(m_setPoints.output(wanted.mapping.rx));
        m_link.switchOn(wanted.mapping, m_stream.period(), now);
        break;
    case McbRequest::Kind::Unmap:
        m_link.switchOff(now);
        break;
    }
    return true;
}

/// Whether a set-point is one that goes out with every frame now.
bool McbDrive::travels(const Link::Request &request) const
{
    const auto &rx = m_link.mapping().rx;
    return request.command == mcb::Command::Write && m_link.state() == Link::State::Cyclic
        && std::any_of(rx.begin(), rx.end(),
            [&](const mcb::MappedRegister &one) { return one.address == request.address; });
}

/// The first one that has the new value.
Bytes McbDrive::frameWith(const Link::Request &request) const
{
    McbSetPoints after = m_setPoints;
    after.set(request.address, request.words);
    mcb::Frame frame{request.address, mcb::Command::Read, false, {}, {}};
    frame.cyclic = after.output(m_link.mapping().rx);
    frame.cyclic.resize(m_link.mapping().words());
    return mcb::encodeFrame(frame);
}

/// The frame that asks for the register has its new value already, and so has every one after it: what is read back is
/// the answer.
void McbDrive::sendInFrames(const Link::Request &request, TimePoint now)
{
    m_setPoints.set(request.address, request.words);
    m_link.setCyclicOutput(m_setPoints.output(m_link.mapping().rx));
    m_confirming = request.words;
    m_link.send({mcb::Command::Read, request.address}, now);
}

mcb::Master::Done McbDrive::confirmed(const Link::Done &read, const mcb::Words &wanted)
{
    Link::Done write = read;
    if (read.end == Link::End::NotSent)
        write.end = Link::End::Unknown; // the question was not, but the value may have been
    if (read.end != Link::End::Ok)
        return write;
    const bool same = read.words.size() >= wanted.size()
        && std::equal(wanted.begin(), wanted.end(), read.words.begin());
    if (!same) { // the drive has its own mind: it is left with it
        write.end = Link::End::Refused;
        write.code = kOtherValueRead;
        m_setPoints.set(read.request.address,
            mcb::WordView(read.words).first(std::min(wanted.size(), read.words.size())));
        m_link.setCyclicOutput(m_setPoints.output(m_link.mapping().rx));
    }
    return write;
}

void McbDrive::restSetPoints()
{
    m_setPoints.rest();
    m_link.setCyclicOutput({});
}

void McbDrive::endSetPoints()
{
    m_setPoints.end();
    m_link.setCyclicOutput({});
    m_confirming.reset();
}

/// A motor that a fault has stopped does not go back to its set-point when the fault is over.
void McbDrive::takeVitals()
{
    auto statuses = m_vitals.takeStatuses();
    for (const MotorStatus &status : statuses) {
        const bool fault =
            status.state == MotorState::FaultNow || status.state == MotorState::FaultOver;
        if (fault && !std::exchange(m_faulty, fault))
            restSetPoints();
        m_faulty = fault;
    }
    takeStatuses(std::move(statuses), m_vitals.askedAt());
}

void McbDrive::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false, now) != nullptr;
    if (busy && connected() && now < m_closeBy)
        return;
    cutAllWishes("disconnected");
    m_stream.close();
    endSetPoints();
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
    if (m_setPoints.wanted() != m_toldCyclic)
        m_events.emplace_back(CyclicSetPointsChanged{m_toldCyclic = m_setPoints.wanted()});
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

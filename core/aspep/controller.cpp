#include "aspep/controller.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace aspep {

using namespace std::chrono_literals;

namespace {

constexpr Duration kTornGrace = 30ms; ///< beyond the wire time of what is missing
/// The Performer listens again after the next idle line only.
constexpr Duration kRestAfterNack = 10ms;
/// A packet that lacks no more than this is left open: the replies of the dialogue fill it up, and what then follows is
/// seen to be out of step. One that lacks more would swallow the whole dialogue: only silence ends it. So every
/// parser that goes by lengths agrees on where packets start.
constexpr std::size_t kShortTail = 12;

} // namespace

Controller::Controller(Config config)
    : m_config(config)
    , m_sender(config.baud, config.payloadPause)
    , m_negotiation(config.offer)
{
}

Duration Controller::responseTimeout() const
{
    const Duration host = m_config.hostLatency + m_config.patience;
    if (m_state == State::Negotiating && !m_heardBytes && m_attempts > m_config.attempts)
        return wireTime(2 * kHeaderSize, m_config.baud) + 5ms + host; // no stream
    const Duration wire = wireTime(m_negotiation.longestReply() + 2 * kHeaderSize, m_config.baud);
    return wire + wire / 2 + 2ms + host;
}

void Controller::connect(TimePoint now)
{
    reset();
    m_heardBytes = m_heardAnswer = m_afterReset = false;
    m_firstHeard.clear();
    m_dialogueStart = m_lastByte = m_lastValid = now;
    m_sender.freeLine(now);
    m_rounds = 0;
    m_echoesLeft = 1;
    m_attempts = 0;
    if (now >= m_sender.replyDue().value_or(now))
        return negotiate(now);
    m_state = State::Negotiating; // the last packet of the link before may still be answered
    m_framer.setLimits({});
    rest(now, {});
}

void Controller::reset()
{
    endRequest(std::nullopt);
    if (m_urgent && !blind())
        m_events.push_back(NoResponse{}); // promised an end, though it was never sent
    m_urgent.reset();
    m_state = State::Idle;
    m_step = Step::None;
    m_suspect = m_inDoubt = false;
    m_sender.clear();
    m_async.reset();
    m_framer.resynchronise();
}

bool Controller::canSend() const
{
    return m_state == State::Connected && m_step == Step::None && !m_urgent;
}

void Controller::sendRequest(ByteView payload, TimePoint now)
{
    assert(canSend());
    assert(payload.size() >= 2 && payload.size() <= agreed().rxMax());
    m_step = Step::Waiting;
    m_requestOpen = true;
    sendData(payload, {}, now);
}

void Controller::receive(ByteView bytes, TimePoint now)
{
    m_stats.bytesIn += bytes.size();
    if (m_state == State::Idle && !m_urgent)
        return;
    if (bytes.empty())
        return;
    m_lastByte = now;
    m_tornTold = false;
    if (!std::exchange(m_heardBytes, true) && m_state == State::Negotiating)
        // What was swallowed does not count, but may echo late.
        m_attempts = std::min(m_attempts, 2);
    const std::size_t wanted = std::min(kHeaderSize - m_firstHeard.size(), bytes.size());
    m_firstHeard.insert(m_firstHeard.end(), bytes.begin(), bytes.begin() + wanted);
    Packet packet;
    bool proved = false; // that the stream is in step again
    bool answered = false; // by the last packet, and nothing has come of it yet
    for (;;) {
        const bool lost = !m_framer.inStep();
        if (!m_framer.midPacket())
            m_packetBegan = now;
        const Framer::Step step = m_framer.next(bytes, packet);
        proved = m_framer.inStep() && (proved || lost);
        if (step == Framer::Step::NeedBytes)
            break;
        if (step == Framer::Step::Packet) {
            tellAsync();
            onPacket(packet, now);
        } else {
            if (answered)
                withdrawResponse();
            m_async.reset(); // bytes of it were lost, and those of another one stand in their place
            onFault(step, now);
        }
        answered = step == Framer::Step::Packet && canSend() && !m_events.empty()
            && std::holds_alternative<Response>(m_events.back());
        if (m_state == State::Idle && !m_urgent)
            break;
        if (hurried() && !m_framer.inStep()) {
            // A stop does not wait for silence; only an exact echo counts anyway.
            m_framer.resynchronise();
        }
    }
    if (m_framer.inPayload())
        tellAsync();
    if (m_step == Step::Draining && m_framer.inStep() && (proved || !m_framer.midPacket()))
        rest(now, {}); // the packet that seemed torn is whole, or the stream goes on
    m_stats.discardedBytes = m_framer.discardedBytes();
}

void Controller::onPacket(Packet &packet, TimePoint now)
{
    ++m_stats.packetsIn;
    m_lastValid = now;
    if (std::exchange(m_suspect, false) && m_state == State::Connected)
        m_events.push_back(Recovered{});
    if (const auto *data = std::get_if<Data>(&packet.header))
        onData(*data, packet.payload, now);
    else if (const auto *beacon = std::get_if<Beacon>(&packet.header))
        onBeacon(*beacon, now);
    else if (const auto *reply = std::get_if<Ping>(&packet.header))
        onPing(*reply, now);
    else
        onNack(now);
}

void Controller::onData(const Data &data, Bytes &payload, TimePoint now)
{
    if (!data.response) {
        if (m_state == State::Connected || m_state == State::Recovering)
            m_async = Async{std::move(payload), now};
        return;
    }
    // What begins before the payload can have left answers something else: the request before, for the second time.
    if (m_step != Step::Waiting || tooSoon())
        return ignore();
    m_sender.settle();
    m_step = Step::None;
    m_requestOpen = false;
    m_parity = !m_parity;
    m_events.push_back(Response{std::move(payload)});
    if (blind()) {
        m_dialogueStart = now; // the board is there
        endBlind(now);
    } else if (m_urgent) {
        onUrgentDue(now);
    }
}

/// What comes right behind it is no packet: its own end is missing, and something else made up for that.
void Controller::withdrawResponse()
{
    m_events.pop_back();
    m_requestOpen = true;
    m_parity = !m_parity;
}

/// Another packet begins where it ended.
void Controller::tellAsync()
{
    if (m_async)
        m_events.push_back(std::move(*m_async));
    m_async.reset();
}

void Controller::onNack(TimePoint now)
{
    ++m_stats.nacks;
    if (blind())
        return damage();
    m_sender.settle(); // an answer of a kind: the Performer is done with what was sent
    damage();
    if (m_state == State::Connected)
        recover(now);
    if (m_step != Step::Draining)
        rest(now, kRestAfterNack);
}

void Controller::countFault(Framer::Step what)
{
    using Step = Framer::Step;
    static constexpr std::pair<Step, std::uint64_t Stats::*> kCounters[] = {
        {Step::BadHeaderCrc, &Stats::badHeaderCrc}, {Step::UnknownType, &Stats::unknownType},
        {Step::Inconsistent, &Stats::inconsistent}, {Step::TooLong, &Stats::tooLong},
        {Step::BadPayloadCrc, &Stats::badPayloadCrc}};
    for (const auto &[step, counter] : kCounters)
        m_stats.*counter += step == what ? 1 : 0;
}

void Controller::damage()
{
    m_damaged = true;
    m_echoesLeft = std::max(m_echoesLeft, 2);
}

void Controller::onFault(Framer::Step what, TimePoint now)
{
    countFault(what);
    damage();
    if (hurried())
        return;
    if (m_state == State::Connected)
        recover(now);
    drain(now, m_config.hostLatency + wireTime(2 * kHeaderSize, m_config.baud));
}

void Controller::onTorn(TimePoint now)
{
    ++m_stats.torn;
    m_tornTold = true;
    damage();
    if (hurried()) {
        m_framer.resynchronise();
        return;
    }
    if (m_state == State::Connected)
        recover(now);
    if (m_framer.missing() > kShortTail)
        drain(now, kLongSilence);
}

void Controller::handleTimeout(TimePoint now)
{
    if (m_async && !m_framer.midPacket() && now >= m_async->at + kWhole)
        tellAsync();
    if (m_urgent && now >= m_urgent->until)
        onUrgentDue(now);
    if (reached(tornAt(), now))
        onTorn(now);
    if (reached(stepEnd(), now))
        onStepOver(now);
    checkHealth(now);
    m_stats.discardedBytes = m_framer.discardedBytes();
}

void Controller::onStepOver(TimePoint now)
{
    if (m_step == Step::Draining)
        onDrainOver(now);
    else if (m_step == Step::Resting)
        goOn(now);
    else if (m_step == Step::Settling)
        afterEcho(now);
    else
        onReplyTimeout(now); // all other steps wait for one
}

void Controller::onReplyTimeout(TimePoint now)
{
    ++m_stats.timeouts;
    m_sender.settle();
    if (blind()) {
        endRequest(std::nullopt);
        return endBlind(now);
    }
    if (m_framer.midPacket() && !m_tornTold && now - m_lastByte >= m_config.hostLatency)
        onTorn(now); // with every word of a dialogue its tail would come nearer, but only a little
    if (m_step == Step::Probing && m_lastByte > m_sender.askedAt())
        damage(); // what came may have been the answer, as the end of a packet that lacked some bytes
    if (m_state == State::Connected)
        recover(now);
    else if (m_step != Step::Draining && m_step != Step::Resting)
        retry(now);
}

/// What a link is judged by: a stop may talk where there is none, and proves nothing by talking.
Controller::State Controller::judgedState() const { return m_urgent ? m_urgent->before : m_state; }

bool Controller::linked() const
{
    return judgedState() == State::Connected || judgedState() == State::Recovering;
}

Controller::Health Controller::health() const
{
    Health due;
    if (linked() && !m_suspect)
        due.suspect = m_lastValid + m_config.suspectAfter;
    if (canSend())
        due.keepAlive = m_lastValid + m_config.keepAliveAfter;
    if (m_state == State::Connected || judgedState() == State::Idle)
        return due;
    due.lost = m_dialogueStart + dialogueLimit();
    if (linked())
        earliest(due.lost, spentAt());
    return due;
}

void Controller::checkHealth(TimePoint now)
{
    const Health due = health();
    if (reached(due.suspect, now)) {
        m_suspect = true;
        m_events.push_back(Suspect{});
    }
    if (reached(due.keepAlive, now)) {
        m_step = Step::KeepingAlive;
        sendPing({}, now);
    }
    if (reached(due.lost, now))
        lose(linked() ? outageFailure() : connectFailure());
}

std::optional<TimePoint> Controller::tornAt() const
{
    if (!m_framer.midPacket() || m_tornTold || m_step == Step::Draining
        || (m_state == State::Idle && !m_urgent))
        return std::nullopt;
    return m_lastByte + wireTime(m_framer.missing(), m_config.baud) + m_config.hostLatency
        + kTornGrace;
}

std::optional<TimePoint> Controller::stepEnd() const
{
    if (m_step == Step::None)
        return std::nullopt;
    if (m_step == Step::Resting || m_step == Step::Settling)
        return m_restUntil;
    if (m_step != Step::Draining)
        return m_sender.replyDue();
    const TimePoint silent = std::max(m_lastByte, m_drainStart) + m_quiet;
    const Duration longest = wireTime(m_negotiation.longestAsync(), m_config.baud);
    const TimePoint end = std::min(silent, m_drainStart + m_quiet + longest + 50ms);
    return std::max(end, m_sender.replyDue().value_or(end));
}

std::optional<TimePoint> Controller::nextTimeout() const
{
    std::optional<TimePoint> due;
    const Health ahead = health();
    for (const auto &at : {stepEnd(), tornAt(), ahead.suspect, ahead.keepAlive, ahead.lost})
        earliest(due, at);
    if (m_async && !m_framer.midPacket())
        earliest(due, m_async->at + kWhole);
    if (m_urgent && m_urgent->stage != Urgent::Stage::Sent)
        earliest(due, m_urgent->until);
    return due;
}

void Controller::send(const Packet &packet, Duration gap, TimePoint now)
{
    ++m_stats.packetsOut;
    m_stats.bytesOut += m_sender.send(packet, agreed().dataCrc, gap, responseTimeout(), now);
}

void Controller::sendData(ByteView payload, Duration gap, TimePoint now)
{
    const Data header{false, static_cast<std::uint16_t>(payload.size())};
    send({header, Bytes(payload.begin(), payload.end())}, gap, now);
}

void Controller::sendPing(Duration gap, TimePoint now)
{
    send({Ping{false, false, 0, ++m_number}, {}}, gap, now);
}

void Controller::endRequest(std::optional<bool> executed)
{
    if (std::exchange(m_requestOpen, false))
        m_events.push_back(NoResponse{executed});
}

} // namespace aspep

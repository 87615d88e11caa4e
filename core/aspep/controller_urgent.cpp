// The hurried way for Stop. First by dialogue, because a Performer that is not connected swallows
// requests; then without waiting, because a stop that may be lost is better than one that is not
// sent.
#include "aspep/controller.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace aspep {

using namespace std::chrono_literals;

namespace {

constexpr Duration kPatience = 50ms; ///< for the reply that is due when the stop comes
constexpr Duration kDialogue = 20ms; ///< for the echoes; then without them
/// A packet of the dialogue that has just left has its time, but all of them have no more than this.
constexpr Duration kWholeDialogue = 2 * kDialogue;
constexpr Duration kBlindGap = 2ms; ///< the Performer listens again only after its next 1 ms task
/// Ends the usual payload that a board still waits for; the longest, 256 bytes, with the third repetition.
constexpr int kFillBeacons = 20;

} // namespace

void Controller::sendUrgent(ByteView payload, TimePoint now)
{
    assert(payload.size() >= 2);
    if (blind())
        endRequest(std::nullopt);
    else if (m_urgent)
        m_events.push_back(NoResponse{});
    const bool again = m_urgent.has_value();
    const State before = again ? m_urgent->before : m_state;
    m_urgent.reset();
    if (canSend())
        return sendRequest(payload, now);
    m_urgent = Urgent{
        Bytes(payload.begin(), payload.end()), Urgent::Stage::Patience, before, now + kPatience};
    if (m_state == State::Connected && m_replyDue)
        m_urgent->until = std::min(m_urgent->until, *m_replyDue);
    else
        startUrgentDialogue(now);
}

void Controller::onUrgentDue(TimePoint now)
{
    if (m_state == State::Connected && m_step == Step::None) {
        const Bytes payload = std::move(m_urgent->payload);
        m_urgent.reset();
        sendRequest(payload, now);
    } else if (m_urgent->stage == Urgent::Stage::Patience) {
        startUrgentDialogue(now);
    } else if (m_urgent->stage == Urgent::Stage::Dialogue) {
        const TimePoint answered =
            std::min(m_askedAt + kDialogue, m_urgent->begun + kWholeDialogue);
        if (m_replyDue && now < answered)
            m_urgent->until = answered;
        else
            sendBlind(now);
    }
}

void Controller::startUrgentDialogue(TimePoint now)
{
    endRequest(std::nullopt);
    m_urgent->stage = Urgent::Stage::Dialogue;
    m_urgent->begun = now;
    m_urgent->until = now + kDialogue;
    m_rounds = 0;
    m_echoesLeft = 1;
    if (m_step != Step::Pinging)
        m_attempts = 1;
    if (!m_framer.inStep() || m_state == State::Idle)
        m_framer.resynchronise();
    if (underWay(now)) {
        if (m_step != Step::Draining)
            return;
        m_step = Step::Offering;
        if (m_state != State::Recovering)
            m_offer = m_config.offer;
        return;
    }
    if (m_state == State::Idle || m_state == State::Connected) { // else the outage has begun before
        m_dialogueStart = now;
        m_outageStart = m_lastValid;
        m_probed = m_inDoubt = false;
    }
    m_attempts = 0;
    if (m_everAgreed)
        m_state = State::Recovering;
    else if (m_state == State::Idle)
        m_offer = m_config.offer;
    m_step = Step::Offering;
    m_lineFree = std::min(m_lineFree, now); // what has not left never does
    offer(now, kBlindGap);
    m_output.back().dropsEarlier = true;
}

/// Whether a word of the dialogue has just left whose answer can still come: another would make the board miss both.
bool Controller::underWay(TimePoint now) const
{
    const bool word = m_step == Step::Offering || m_step == Step::Probing || m_step == Step::Pinging
        || (m_step == Step::Draining && m_askedAt >= m_drainStart); // the Beacon that ends a stream
    return word && m_replyDue && m_output.empty() && now - m_askedAt < kDialogue;
}

void Controller::sendBlind(TimePoint now)
{
    const bool echoed = m_step == Step::Pinging && m_attempts == 1;
    m_urgent->stage = Urgent::Stage::Sent;
    m_inDoubt = m_inDoubt || (m_everAgreed && !m_probed);
    if (!echoed)
        sendPacket(blindOffer(), kBlindGap, now);
    sendPacket(Ping{false, false, 0, ++m_number}, kBlindGap, now);
    m_step = Step::Waiting;
    m_requestOpen = true;
    sendData(m_urgent->payload, kBlindGap, now);
    *m_replyDue += 2 * kBlindGap;
}

/// A board that goes on with an agreement leaves the connection for any offer beyond it, and then swallows requests.
const Beacon &Controller::blindOffer() const
{
    const bool unheard = m_remembered && m_offer == m_config.offer;
    return m_state == State::Recovering || unheard ? m_agreed : m_offer;
}

std::vector<Output> Controller::blindScript(const std::vector<Bytes> &payloads) const
{
    std::vector<Output> script;
    const auto add = [&script](const Header &header, Duration gap) {
        const HeaderBytes bytes = encodeHeader(header);
        script.push_back({Bytes(bytes.begin(), bytes.end()), gap});
    };
    // A board that is connected would leave that state for the offer of a stranger, and not come back without an echo.
    const bool known = m_everAgreed || m_remembered;
    if (known)
        add(m_agreed, kBlindGap);
    add(Ping{}, kBlindGap);
    for (const Bytes &payload : payloads) {
        add(Data{false, static_cast<std::uint16_t>(payload.size())}, kBlindGap);
        script.push_back({bodyOf(payload), m_config.payloadPause});
    }
    if (known) {
        const HeaderBytes beacon = encodeHeader(m_agreed);
        Output fill{{}, kBlindGap};
        for (int i = 0; i < kFillBeacons; ++i)
            fill.bytes.insert(fill.bytes.end(), beacon.begin(), beacon.end());
        script.push_back(std::move(fill));
    }
    return script;
}

void Controller::endBlind(TimePoint now)
{
    const State before = m_urgent->before;
    m_urgent.reset();
    if (before == State::Idle) {
        reset();
    } else if (before == State::Connected || before == State::Recovering) {
        recover(now);
    } else {
        m_echoesLeft = std::max(m_echoesLeft, 2);
        negotiate(now);
    }
}

bool Controller::blind() const { return m_urgent && m_urgent->stage == Urgent::Stage::Sent; }

bool Controller::urgentWaits() const { return m_urgent && (!blind() || m_sentPending); }

bool Controller::hurried() const { return m_urgent && m_urgent->stage != Urgent::Stage::Patience; }

} // namespace aspep

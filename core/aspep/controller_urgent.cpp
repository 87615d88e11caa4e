// The hurried way for Stop. First by dialogue, because a Performer that is not connected swallows requests; then
// without waiting, because a stop that may be lost is better than one that is not sent.
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
constexpr Duration kBlindGap = Sender::kBlindGap;

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
    if (m_state == State::Connected && m_sender.replyDue())
        m_urgent->until = std::min(m_urgent->until, *m_sender.replyDue());
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
            std::min(m_sender.askedAt() + kDialogue, m_urgent->begun + kWholeDialogue);
        if (m_sender.replyDue() && now < answered)
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
            m_negotiation.startOver();
        return;
    }
    if (m_state == State::Idle || m_state == State::Connected) { // else the outage has begun before
        m_dialogueStart = now;
        m_outageStart = m_lastValid;
        m_probed = m_inDoubt = false;
    }
    m_attempts = 0;
    if (m_negotiation.concluded())
        m_state = State::Recovering;
    else if (m_state == State::Idle)
        m_negotiation.startOver();
    m_sender.freeLine(now);
    offer(now, kBlindGap);
    m_sender.overtake();
}

/// Whether a word of the dialogue has just left whose answer can still come: another would make the board miss both.
bool Controller::underWay(TimePoint now) const
{
    const bool word = m_step == Step::Offering || m_step == Step::Probing
        || m_step == Step::Pinging
        // The Beacon that ends a stream.
        || (m_step == Step::Draining && m_sender.askedAt() >= m_drainStart);
    return word && m_sender.justAsked(kDialogue, now);
}

void Controller::sendBlind(TimePoint now)
{
    const bool echoed = m_step == Step::Pinging && m_attempts == 1;
    m_urgent->stage = Urgent::Stage::Sent;
    m_inDoubt = m_inDoubt || (m_negotiation.concluded() && !m_probed);
    if (!echoed)
        send({blindOffer(), {}}, kBlindGap, now);
    sendPing(kBlindGap, now);
    m_step = Step::Waiting;
    m_requestOpen = true;
    sendData(m_urgent->payload, kBlindGap, now);
    m_sender.putOff(2 * kBlindGap);
}

const Beacon &Controller::blindOffer() const
{
    return m_state == State::Recovering ? agreed() : m_negotiation.blindOffer();
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

bool Controller::urgentWaits() const { return m_urgent && (!blind() || m_sender.pending()); }

bool Controller::hurried() const { return m_urgent && m_urgent->stage != Urgent::Stage::Patience; }

} // namespace aspep

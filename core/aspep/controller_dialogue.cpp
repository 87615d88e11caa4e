// How the Controller's link comes about, and how it is mended: Beacons until the own one is echoed, then a Ping.
//
// A recovery begins with Pings until one is answered: a board that was reset says so only before it has heard a
// matching Beacon. (A stop cannot wait for that. A link that comes back by its Beacons is a new one.) Where nothing bad
// was heard, only nothing at all, the Ping's reply is enough: the board is there and connected, and its stream goes on.
// Else the agreed Beacon must come back exactly, twice: the first echo shows that the line is in step, the second that
// the first was no late answer and that nothing which came before is still under way.
#include "aspep/controller.h"

#include <algorithm>

namespace aspep {

using namespace std::chrono_literals;

namespace {

/// Counter-proposals and returns to the start before there is no agreement.
constexpr int kMaxRounds = 10;
constexpr Duration kDialogueLimit = 4s; ///< whatever happens, a dialogue has ended after this

/// A refusal as boards of the protocol before this one send it: FF, one byte, its error code, and the sum of all that
/// with the carry added. The code is 0x0C at most. Five Beacons are to such a board at least one frame with a bad sum.
bool isOldRefusal(const Bytes &heard)
{
    return heard.size() == 4 && heard[0] == 0xFF && heard[1] == 1 && heard[2] <= 0x0C
        && heard[3] == heard[2] + 1;
}

} // namespace

void Controller::negotiate(TimePoint now)
{
    m_state = State::Negotiating;
    m_framer.setLimits({});
    m_negotiation.startOver();
    m_attempts = 0;
    offer(now);
}

void Controller::offer(TimePoint now, Duration gap)
{
    const bool recovering = m_state == State::Recovering;
    const int most = m_heardBytes   ? m_config.attempts
        : m_negotiation.concluded() ? kSilentOffers
                                    : m_config.firstSilentOffers;
    if (!recovering && m_attempts >= most)
        return lose(connectFailure());
    if (!recovering)
        m_state = State::Negotiating;
    m_inDoubt = m_inDoubt || (recovering && !m_probed);
    m_step = Step::Offering;
    ++m_attempts;
    send({offered(), {}}, gap, now);
}

/// A link that is mended keeps what was agreed.
const Beacon &Controller::offered() const
{
    return m_state == State::Recovering ? agreed() : m_negotiation.offered();
}

void Controller::ping(Step step, TimePoint now)
{
    if (m_state != State::Recovering)
        m_state = State::Pinging;
    m_step = step;
    ++m_attempts;
    sendPing({}, now);
}

void Controller::onBeacon(const Beacon &answer, TimePoint now)
{
    if (m_step == Step::Offering && tooSoon()) // the late echo of one before: ours has not left
        return ignore();
    if (m_step == Step::Offering) {
        const bool recovering = m_state == State::Recovering;
        if (answer == offered() && (recovering || answer.version == 0))
            return acceptAnswer(now);
        const bool plausible = m_state == State::Negotiating && m_negotiation.allows(answer);
        m_heardAnswer = m_heardAnswer || plausible;
        if (plausible && answer.version == 0) {
            if (++m_rounds > kMaxRounds)
                return lose(LostReason::NoAgreement);
            m_negotiation.offer(answer);
            ++m_echoesLeft; // this one is no echo
            return acceptAnswer(now);
        }
    }
    // It answers nothing that was asked: noise, or a late echo behind which the Performer has left the connection.
    ignore();
    if (blind())
        return;
    damage();
    if (m_step == Step::Settling) {
        m_restUntil = now + m_config.hostLatency;
    } else if (m_state == State::Connected) {
        recover(now);
    } else if (m_step == Step::Pinging) {
        ++m_rounds;
        rest(now, m_config.hostLatency);
    }
}

void Controller::acceptAnswer(TimePoint now)
{
    m_sender.settle();
    const bool repeated = m_attempts > 1; // then echoes of the earlier ones may be on their way
    if (repeated)
        m_echoesLeft = std::max(m_echoesLeft, 2);
    --m_echoesLeft;
    m_attempts = 0;
    if (!repeated)
        return afterEcho(now);
    m_step = Step::Settling;
    m_restUntil = now + m_config.hostLatency;
}

void Controller::afterEcho(TimePoint now)
{
    if (m_echoesLeft > 0)
        return offer(now);
    if (m_state != State::Recovering)
        m_negotiation.conclude();
    m_framer.setLimits(m_negotiation.limits()); // also where a stop mends what was being opened
    ping(Step::Pinging, now);
}

void Controller::onPing(const Ping &reply, TimePoint now)
{
    const bool due =
        m_step == Step::Probing || m_step == Step::Pinging || m_step == Step::KeepingAlive;
    // Firmware up to 6.2.1 truncates the number once it is connected; unconfigured it never does.
    if (!due || (!reply.configured && reply.number != m_number))
        return ignore();
    if (m_step == Step::Pinging && tooSoon()) { // the end is of another
        ignore();
        return damage();
    }
    m_sender.settle();
    m_heardAnswer = true;
    if (!reply.configured)
        return onNotConfigured(now);
    m_linkId = reply.linkId;
    if (m_step == Step::Probing && m_damaged) {
        // Left-over bytes and the first one of the answer can look like it: the rest of it comes before the Beacon.
        m_probed = true;
        m_attempts = 0;
        return rest(now, wireTime(2 * kHeaderSize, m_config.baud));
    }
    if (m_step == Step::Probing || m_step == Step::Pinging)
        return enterConnected(reply, now);
    m_step = Step::None;
    m_parity = reply.parity;
    if (m_urgent)
        onUrgentDue(now);
}

void Controller::enterConnected(const Ping &reply, TimePoint now)
{
    endRequest(m_inDoubt ? std::nullopt : std::optional(reply.parity != m_parity));
    m_parity = reply.parity;
    const bool recovered = linked();
    m_state = State::Connected;
    m_step = Step::None;
    m_attempts = m_rounds = 0;
    m_echoesLeft = 1;
    m_damaged = false;
    m_suspect = false;
    if (recovered && !m_inDoubt && !m_afterReset)
        m_events.push_back(Recovered{});
    else
        m_events.push_back(Connected{agreed(), m_afterReset});
    m_afterReset = m_inDoubt = false;
    if (m_urgent)
        onUrgentDue(now);
}

void Controller::onNotConfigured(TimePoint now)
{
    if (m_state == State::Connected || m_state == State::Recovering) {
        endRequest(std::nullopt);
        m_afterReset = true;
        m_inDoubt = false;
        m_dialogueStart = now;
        m_rounds = 0;
    } else if (++m_rounds > kMaxRounds) {
        return lose(LostReason::NoAgreement);
    }
    negotiate(now);
}

void Controller::recover(TimePoint now)
{
    ++m_stats.recoveries;
    if (m_state != State::Recovering) { // else by a stop, within the same outage
        m_outageStart = m_lastValid;
        m_dialogueStart = now;
        m_inDoubt = false;
    }
    m_state = State::Recovering;
    m_attempts = m_rounds = 0;
    m_echoesLeft = std::max(m_echoesLeft, 2);
    m_probed = false;
    rest(now, {});
}

void Controller::drain(TimePoint now, Duration quiet)
{
    if (m_step != Step::Draining)
        m_drainStart = now;
    m_quiet = quiet;
    m_step = Step::Draining;
}

void Controller::onDrainOver(TimePoint now)
{
    m_sender.settle();
    const Duration silence = now - std::max(m_lastByte, m_drainStart);
    if (silence >= m_quiet && silence < kLongSilence && m_framer.missingToScanner() > 0) {
        m_drainStart = m_lastByte;
        m_quiet = kLongSilence;
        return;
    }
    if (silence >= m_quiet) {
        m_framer.resynchronise();
        return goOn(now);
    }
    // A stream that never pauses. A Beacon makes the Performer leave the connection, and so the stream end.
    if (m_state != State::Recovering && m_attempts >= m_config.attempts)
        return lose(connectFailure());
    ++m_attempts;
    m_drainStart = now;
    const bool recovering = m_state == State::Recovering;
    m_inDoubt = m_inDoubt || (recovering && !m_probed);
    send({recovering ? agreed() : m_config.offer, {}}, {}, now);
}

void Controller::rest(TimePoint now, Duration pause)
{
    m_step = Step::Resting;
    m_restUntil = std::max(now + pause, m_sender.replyDue().value_or(now));
}

void Controller::goOn(TimePoint now)
{
    m_sender.settle();
    if (m_state == State::Recovering && !m_probed && !hurried())
        return ping(Step::Probing, now);
    if (m_state != State::Recovering)
        m_negotiation.startOver(); // a misheard answer must not shrink what is offered
    offer(now);
}

void Controller::retry(TimePoint now)
{
    const bool recovering = m_state == State::Recovering;
    if (recovering && reached(spentAt(), now))
        return lose(outageFailure());
    if (m_step == Step::Probing || (m_step == Step::Pinging && m_attempts < m_config.attempts))
        return ping(m_step, now);
    if (m_step != Step::Pinging)
        return offer(now);
    if (!recovering)
        return lose(connectFailure());
    m_echoesLeft = 2;
    offer(now);
}

std::optional<TimePoint> Controller::spentAt() const
{
    if (m_urgent) // counts no attempts
        return m_lastValid + m_config.lostAfter;
    if (m_attempts < m_config.attempts)
        return std::nullopt;
    return m_outageStart + m_config.lostAfter;
}

Duration Controller::dialogueLimit() const
{
    return std::max(kDialogueLimit, (m_config.attempts + 1) * responseTimeout());
}

void Controller::lose(LostReason reason)
{
    reset();
    m_events.push_back(Lost{reason});
}

Controller::LostReason Controller::outageFailure() const
{
    return m_lastValid > m_outageStart ? LostReason::RecoveryFailed : LostReason::Silence;
}

Controller::LostReason Controller::connectFailure() const
{
    if (m_afterReset)
        return LostReason::RecoveryFailed;
    if (m_heardAnswer)
        return LostReason::NoAgreement;
    if (isOldRefusal(m_firstHeard))
        return LostReason::OldProtocol;
    return m_heardBytes ? LostReason::OnlyGarbage : LostReason::NoAnswer;
}

} // namespace aspep

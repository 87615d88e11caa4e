// The rules, each a function of its own.
#include "support/ms_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace judge {

namespace {

std::string number(double value) { return std::to_string(value); }

std::string milliseconds(Duration time)
{
    return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count())
        + " ms";
}

bool same(std::optional<double> a, std::optional<double> b, double tolerance)
{
    return !a || !b || std::abs(*a - *b) <= tolerance;
}

/// A component of a current is never more than the whole of it.
bool noMore(std::optional<double> sent, std::optional<double> asked)
{
    return !sent || !asked || std::abs(*sent) <= std::abs(*asked) + 0.01;
}

} // namespace

/// Toggles, empty packets, resets: there is no case for them.
void MsRules::neverLeaves(const Sent &sent)
{
    if (sent.kind == Kind::Never)
        violate("never", sent.why);
}

/// A motor that a board does not have is an index past the end of its table.
void MsRules::onlyMotorsThatAreThere(const Sent &sent)
{
    const bool commands = sent.kind == Kind::Start || sent.kind == Kind::Stop
        || sent.kind == Kind::StopRamp || sent.kind == Kind::Acknowledge
        || sent.kind == Kind::SetPoint;
    if (commands && (sent.motor < 1 || sent.motor > std::max(m_line.motors, m_line.motorsTold)))
        violate("motors that are there",
            std::string(nameOf(sent.kind)) + " for motor " + std::to_string(sent.motor) + " of "
                + std::to_string(m_line.motors));
}

/// Arming is an act of the user, in this connection, with no Stop since.
void MsRules::nothingActsUnarmed(const Sent &sent)
{
    // The window's word may still be on its way to the thread that serves the line: what was asked for before leaves.
    const auto asked = pendingFor(sent);
    const bool onItsWay = m_now < m_disarmedAt + m_line.grace && asked != m_acts.end()
        && asked->act.at < m_disarmedAt;
    if (acts(sent.kind) && !m_armed && !wasUnderWay() && !onItsWay)
        violate("armed",
            std::string(nameOf(sent.kind)) + " left, and nobody has armed since "
                + (m_stop ? "the Stop" : "the connection or the last Stop"));
}

/// What was asked for and has not been used up, and what leaves could be of.
std::vector<MsRules::Pending>::iterator MsRules::pendingFor(const Sent &sent)
{
    const auto fits = [&](const Pending &one) {
        const Act &act = one.act;
        // What has begun to leave is finished.
        const bool begun =
            act.id != 0 && std::any_of(m_acts.begin(), m_acts.end(), [&](const Pending &other) {
                return other.act.id == act.id && !other.used.empty();
            });
        const bool series = act.kind == Act::Kind::Series;
        // A list of writes that was begun in time goes on; what began it may have been a read.
        const Duration within =
            m_line.fresh + (act.kind == Act::Kind::Write ? m_line.stall : Duration());
        const bool fresh = series
            ? m_now - act.at <= kSeries
            : m_now - std::max(act.at, m_answeredAt) <= within && m_now - act.at <= kOldest;
        if ((!fresh && !begun)
            || (one.voided && m_packetBegan >= *one.voided && m_now >= one.voidedAt + m_line.grace))
            return false;
        // Some are done in torque control, and some borrow registers.
        if (series)
            return sent.kind == Kind::SetPoint || sent.kind == Kind::Mode
                || sent.kind == Kind::Write
                || (sent.kind == Kind::Start && !one.used.contains(Kind::Start));
        if (act.kind == Act::Kind::Restore)
            return sent.kind == Kind::Write;
        if (act.kind == Act::Kind::Input)
            return sent.kind == Kind::Write || sent.kind == Kind::Mode
                || !one.used.contains(sent.kind);
        if (act.kind == Act::Kind::Write) {
            const bool plain = sent.kind == Kind::Write || sent.kind == Kind::Mode;
            // Without a motor in its number a register is the same for all of them.
            const bool here = act.target == sent.target
                || (act.target % 8 == 0 && act.target / 8 == sent.target / 8);
            return here && sent.target != 0 && same(act.value, sent.value, 0.01)
                && one.uses
                < (!sent.value ? 12
                        : plain
                        // Stages go one by one, a scalar that was not taken may be written again.
                        ? 3
                        : 2);
        }
        if (act.motor != sent.motor)
            return false;
        switch (sent.kind) {
        case Kind::Start:
            return act.kind == Act::Kind::Start && one.uses < m_line.startParts;
        case Kind::SetPoint:
            return (act.kind == Act::Kind::SetPoint || act.kind == Act::Kind::StopRamp)
                && one.uses < (act.amps ? m_line.referenceParts : 1) && same(act.rpm, sent.rpm, 1.0)
                && noMore(sent.amps, act.amps);
        case Kind::Mode:
            return act.kind == Act::Kind::SetPoint;
        case Kind::Acknowledge:
            return act.kind == Act::Kind::Acknowledge && one.uses == 0;
        case Kind::StopRamp:
            return act.kind == Act::Kind::StopRamp && one.uses == 0;
        default:
            return false;
        }
    };
    return std::find_if(m_acts.begin(), m_acts.end(), fits);
}

Act *MsRules::actFor(const Sent &sent)
{
    const auto at = pendingFor(sent);
    if (at == m_acts.end())
        return nullptr;
    at->used.insert(sent.kind);
    if (sent.kind != Kind::Mode || at->act.kind == Act::Kind::Write)
        ++at->uses;
    return &at->act;
}

/// One act, one thing that acts; never again by itself.
void MsRules::nothingActsUnasked(const Sent &sent)
{
    if (acts(sent.kind) && actFor(sent) == nullptr)
        violate("asked for",
            std::string(nameOf(sent.kind)) + " for motor " + std::to_string(sent.motor)
                + " left, register " + std::to_string(sent.target)
                + (sent.value ? " value " + number(*sent.value) : std::string())
                + (sent.rpm ? " rpm " + number(*sent.rpm) : std::string())
                + ", and no fresh act asked for it");
}

/// Until every motor is at rest, or two seconds without success are over, only STOP, link control and states.
void MsRules::onlyStopAndStatesDuringAStop(const Sent &sent)
{
    // A gap counts: the product's clock went on, too.
    if (!m_stop || m_now - m_stop->pressed > kBlind)
        return;
    const bool open = std::any_of(m_stop->motors.begin(), m_stop->motors.end(),
        [](const auto &of) { return !of.second.rested; });
    const bool may = sent.kind == Kind::Stop
        || sent.kind == Kind::LinkControl
        // Who is there, to stop it.
        || sent.kind == Kind::StatusRead || (sent.kind == Kind::Read && !m_identified);
    if (open && !may && m_packetBegan >= m_stop->moment && m_now >= m_stop->first + m_line.grace)
        violate("stop first",
            std::string(nameOf(sent.kind)) + " left " + milliseconds(m_now - m_stop->first)
                + " after the Stop, before every motor was at rest");
}

/// What keeps a motor alive needs arming.
void MsRules::heartbeatsOnlyWhileArmed(const Sent &sent)
{
    if (sent.kind == Kind::Heartbeat && !m_armed && !wasUnderWay())
        violate("heartbeats", "a heartbeat left although nobody is armed");
}

/// A motor is not started by one slip of a finger, nor to where it was going before it was stopped.
void MsRules::firstStartsAreAsked(const Sent &sent)
{
    const Agreed &agreed = wasUnderWay() ? m_agreedBefore : m_agreed;
    if (!m_line.asksFirst || sent.kind != Kind::Start || agreed.startedOnce)
        return;
    const auto fresh = [this](const std::optional<TimePoint> &at) {
        return at && m_now - *at <= m_line.fresh + m_line.grace;
    };
    if (!fresh(agreed.confirmed) && !(agreed.hold && fresh(m_held)))
        violate("first starts are asked",
            "the first START since the connection or the last Stop left, and nobody said yes to "
            "it");
}

/// By the board's limits and by the user's own.
void MsRules::setPointsAreBounded(const Sent &sent)
{
    const auto most = [](double board, double user) {
        return board > 0.0 && user > 0.0 ? std::min(board, user) : std::max(board, user);
    };
    // What had begun to leave when the user changed them is finished.
    const Bounds &user = std::prev(m_user.upper_bound(m_packetBegan))->second;
    const double rpm = most(m_line.maxRpm, user.rpm), amps = most(m_line.maxAmps, user.amps);
    if (sent.rpm && !(std::isfinite(*sent.rpm) && (rpm <= 0.0 || std::abs(*sent.rpm) <= rpm + 1.0)))
        violate("bounded", number(*sent.rpm) + " rpm, allowed are " + number(rpm));
    if (sent.amps
        && !(std::isfinite(*sent.amps) && (amps <= 0.0 || std::abs(*sent.amps) <= 1.001 * amps)))
        violate("bounded", number(*sent.amps) + " A, allowed are " + number(amps));
}

/// Never a second request before the answer to the first; a Stop alone may.
void MsRules::oneInFlight(const Sent &sent)
{
    if (m_line.answerWithin <= Duration{} || !sent.firstOfPacket)
        return;
    if (sent.kind == Kind::LinkControl)
        return m_unanswered.reset(); // the dialogue that ends the wait
    if (m_unanswered && m_now - *m_unanswered < m_line.answerWithin && sent.kind != Kind::Stop)
        violate("one in flight",
            std::string(nameOf(sent.kind)) + " left " + milliseconds(m_now - *m_unanswered)
                + " after a request without its answer");
    m_unanswered = m_now;
}

/// A link that comes about or comes back begins with a look.
void MsRules::firstRequestOnlyReads(const Sent &sent)
{
    if (!m_requested && sent.firstOfPacket && acts(sent.kind) && !wasUnderWay())
        violate("looks first", std::string(nameOf(sent.kind)) + " is the first request of a link");
}

/// The board listens again only after its next look at the header.
void MsRules::payloadPause()
{
    if (m_line.gap <= Duration{})
        return;
    if (const auto gap = m_decoder->takeGap(); gap && *gap < m_line.gap)
        violate("payload pause",
            "the payload left " + std::to_string(gap->count() / 1000) + " us after its header");
}

void MsRules::stopsLeaveInTime(TimePoint now)
{
    if (!m_stop || !m_open)
        return;
    for (auto &[motor, of] : m_stop->motors)
        if (!of.rested) {
            stopsAreRepeated(motor, of, now);
            alarmComes(motor, of, now);
        }
}

/// The first STOP at once, the next ones while the motor is driven: with a link, or blind for two seconds.
void MsRules::stopsAreRepeated(int motor, OpenStop::Of &of, TimePoint now)
{
    const bool linked = m_link == LinkState::Connected || m_link == LinkState::Suspect;
    if (!linked && (!m_line.stopsBlind || now - m_stop->latest >= kBlind)) {
        of.allowed.reset();
        return;
    }
    if (!linked && motor > 1 && !m_identified)
        return; // it is not known to be there
    if (!of.allowed)
        of.allowed = of.sent ? now : std::max(m_stop->first, m_opened);
    if (linked && motor > 1 && !m_identified) {
        of.allowed = now;
        return;
    }
    const auto one = of.sent ? m_line.repeat : m_line.firstStop;
    const TimePoint since = std::max(*of.allowed, of.sent.value_or(TimePoint{}));
    // The order is the drive's: one STOP at once, and every motor has its turn.
    const bool none = std::none_of(m_stop->motors.begin(), m_stop->motors.end(),
        [](const auto &each) { return each.second.sent.has_value(); });
    const Duration within = (none && motor == 1 ? 1 : m_line.motors) * one;
    if (now - since > within && !std::exchange(of.late, true))
        violate("stop in time",
            "motor " + std::to_string(motor) + " is driven, and no STOP of it left for "
                + milliseconds(now - since));
}

/// No rest within half a second is told in red, counted from the first press.
void MsRules::alarmComes(int motor, OpenStop::Of &of, TimePoint now)
{
    const bool known = motor == 1 || m_identified;
    const bool anyone = std::any_of(m_stop->motors.begin(), m_stop->motors.end(),
        [](const auto &each) { return each.second.alarmed; });
    if (now - m_stop->first <= m_line.alarm || of.alarmed || (!known && anyone))
        return;
    if (!std::exchange(of.told, true))
        violate("alarm",
            "motor " + std::to_string(motor) + " is driven " + milliseconds(now - m_stop->first)
                + " after the Stop, and nobody was told");
}

void MsRules::said(Word word, int motor, TimePoint at)
{
    m_now = std::max(m_now, at);
    if (word == Word::NotConfirmed && m_stop)
        m_stop->motors[motor].alarmed = true;
    if (word == Word::NotConfirmed)
        m_alarming.insert(motor);
    else if (word != Word::Accepted)
        m_alarming.erase(motor);
    if (word == Word::DriveIdle && !restedLately(motor, 0.0, at))
        violate("true words",
            "\"drive idle\" for motor " + std::to_string(motor) + ", which is driven");
    if (word == Word::Standstill && m_line.speedIsMeasured && !restedLately(motor, 1.0, at))
        violate("true words",
            "\"standstill\" for motor " + std::to_string(motor) + ", which turns at "
                + number(m_truth[motor].rpm) + " rpm");
}

/// What is told of a motor is no older than half a second when it is told.
void MsRules::saidStatus(TimePoint evidence, TimePoint at)
{
    m_now = std::max(m_now, at);
    if (evidence > at)
        violate("fresh", "a state from the future");
    if (at - evidence > kEvidence + m_line.stall)
        violate("fresh", "a state is told " + milliseconds(at - evidence) + " after it was read");
}

void MsRules::closes(TimePoint now)
{
    m_now = std::max(m_now, now);
    if (!m_open || (m_leave && now - *m_leave < std::chrono::seconds(10)))
        return;
    for (const auto &[motor, truth] : m_truth) {
        const auto sent = m_stopSent.find(motor);
        if (truth.driven
            && (sent == m_stopSent.end() || now - sent->second > std::chrono::seconds(3)))
            violate("stops before it goes",
                "the line is closed, motor " + std::to_string(motor)
                    + " is driven, and nobody chose to leave it so");
    }
}

/// A line that has fallen silent is not called connected.
void MsRules::silenceIsTold(TimePoint now)
{
    if (!m_open || !m_heardAt)
        return;
    const Duration silence = now - *m_heardAt;
    if (m_line.suspect > Duration{} && silence > m_line.suspect && m_link == LinkState::Connected) {
        violate(
            "silence is told", milliseconds(silence) + " without a byte, and still \"connected\"");
        m_heardAt.reset();
    } else if (m_line.lost > Duration{} && silence > m_line.lost
        && (m_link == LinkState::Suspect || m_link == LinkState::Recovering)) {
        violate("silence is told", milliseconds(silence) + " without a byte, and not yet \"lost\"");
        m_heardAt.reset();
    }
}

} // namespace judge

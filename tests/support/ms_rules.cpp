// What happens on the line and beside it, as the rules need it.
#include "support/ms_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace judge {

namespace {

constexpr std::size_t kMostViolations = 20; ///< the first is what counts
/// For which what waits to leave remembers that it was asked for.
constexpr std::uint64_t kKeptMoments = 1000;

std::string hexOf(ByteView bytes)
{
    static const char digits[] = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes.first(std::min<std::size_t>(bytes.size(), 40))) {
        text += digits[byte >> 4];
        text += digits[byte & 15U];
    }
    return text;
}

} // namespace

const char *nameOf(Kind kind)
{
    switch (kind) {
    case Kind::LinkControl:
        return "link control";
    case Kind::StatusRead:
        return "a read of states";
    case Kind::Read:
        return "a read";
    case Kind::StreamSetup:
        return "a stream's set-up";
    case Kind::Heartbeat:
        return "a heartbeat";
    case Kind::Stop:
        return "STOP";
    case Kind::StopRamp:
        return "the end of a ramp";
    case Kind::Start:
        return "START";
    case Kind::SetPoint:
        return "a set-point";
    case Kind::Mode:
        return "a mode";
    case Kind::Write:
        return "a write";
    case Kind::Acknowledge:
        return "an acknowledgement of faults";
    case Kind::Never:
        break;
    }
    return "what nobody may send";
}

void MsRules::watch(std::unique_ptr<Decoder> decoder, const Line &line)
{
    m_decoder = std::move(decoder);
    m_line = line;
}

void MsRules::excuse(const std::string &rule, const std::string &) { m_excused.insert(rule); }

void MsRules::violate(const char *rule, const std::string &what)
{
    if (m_excused.contains(rule) || m_violations.size() >= kMostViolations)
        return;
    const auto us =
        std::chrono::duration_cast<std::chrono::microseconds>(m_now.time_since_epoch()).count();
    std::string text = std::string(rule) + ": " + what + " at " + std::to_string(us) + " us";
    if (!m_packet.empty())
        text += ", bytes " + m_packet;
    m_violations.push_back(std::move(text));
}

void MsRules::sent(ByteView bytes, TimePoint at, std::uint64_t handed)
{
    if (!watching())
        return;
    if (!m_decoder->midPacket())
        m_packetBegan = handed;
    m_now = std::max(m_now, at);
    m_packet = hexOf(bytes);
    ++m_counts.packets;
    const auto all = m_decoder->sent(bytes, at);
    payloadPause();
    for (const Sent &one : all)
        judge(one, m_packet);
    m_packet.clear();
}

void MsRules::heard(ByteView bytes, TimePoint at)
{
    if (!watching() || bytes.empty())
        return;
    m_now = std::max(m_now, at);
    m_heardAt = at;
    if (m_decoder->heard(bytes)) {
        m_unanswered.reset();
        m_answeredAt = at;
    }
}

void MsRules::judge(const Sent &sent, const std::string &)
{
    neverLeaves(sent);
    if (sent.goesOn)
        return onlyStopAndStatesDuringAStop(sent);
    if (mayRest(sent))
        return;
    onlyMotorsThatAreThere(sent);
    oneInFlight(sent);
    nothingActsUnarmed(sent);
    firstRequestOnlyReads(sent);
    onlyStopAndStatesDuringAStop(sent);
    heartbeatsOnlyWhileArmed(sent);
    firstStartsAreAsked(sent);
    setPointsAreBounded(sent);
    nothingActsUnasked(sent);
    if (sent.kind != Kind::LinkControl)
        m_requested = true;
    if (sent.kind == Kind::Start) {
        ++m_counts.starts;
        (wasUnderWay() ? m_agreedBefore : m_agreed).startedOnce = true;
    }
    if (sent.kind == Kind::SetPoint) {
        ++m_counts.setPoints;
        m_counts.rpm = sent.rpm;
    }
    if (sent.kind == Kind::Write && sent.value)
        m_counts.written[sent.target] = *sent.value;
    if (sent.kind == Kind::Stop)
        m_stopSent[sent.motor] = m_now;
    if (sent.kind == Kind::Stop && m_stop) {
        OpenStop::Of &of = m_stop->motors[sent.motor];
        of.sent = m_now;
        of.late = false;
    }
}

/// A set-point goes to rest by itself with a Stop, where nothing turns by it, and when the drive is not known any more;
/// under a motor that is driven that is a step that was not asked for.
bool MsRules::mayRest(const Sent &sent) const
{
    const auto truth = m_truth.find(sent.motor);
    return sent.rests && (m_over || truth == m_truth.end() || !truth->second.driven);
}

bool MsRules::acts(Kind kind) const
{
    return kind == Kind::Start || kind == Kind::SetPoint || kind == Kind::Mode
        || kind == Kind::Write || kind == Kind::Acknowledge || kind == Kind::StopRamp;
}

void MsRules::act(const Act &act)
{
    m_now = std::max(m_now, act.at);
    ++m_counts.acts;
    ++m_moment;
    switch (act.kind) {
    case Act::Kind::Open:
        m_open = true;
        m_opened = act.at;
        m_identified = m_requested = false;
        m_agreed = {};
        forgetActs();
        m_heardAt.reset();
        m_unanswered.reset();
        return;
    case Act::Kind::Unplugged:
        if (m_decoder)
            m_decoder->reset(); // what was under way never ends
        [[fallthrough]];
    case Act::Kind::Close:
        m_open = false;
        m_stop.reset();
        m_alarming.clear();
        return forgetActs();
    case Act::Kind::Arm:
        if (!stopGoesOn())
            return arm();
        m_armedEarly = act.at; // first the stop that was asked for
        return;
    case Act::Kind::Disarm:
        return forgetActs();
    case Act::Kind::Stop:
        return onStop(act);
    case Act::Kind::Restore:
        if (act.id == 0) // of a window, where input allows what follows it
            m_acts.clear();
        m_acts.push_back({act});
        return;
    case Act::Kind::Confirm:
        m_agreed.confirmed = act.at;
        return;
    case Act::Kind::AgreeToSeries:
        m_seriesAgreed = m_armed;
        m_agreed.confirmed = act.at;
        [[fallthrough]];
    case Act::Kind::Series:
        if (m_seriesAgreed) {
            m_acts.push_back({act});
            m_acts.back().act.kind = Act::Kind::Series;
        }
        return;
    case Act::Kind::AgreeToHold:
        m_agreed.hold = true;
        return;
    case Act::Kind::Hold:
        m_held = act.at;
        m_acts.push_back({act});
        m_acts.back().act.kind = Act::Kind::Input;
        return;
    case Act::Kind::Leave:
        m_leave = act.at;
        return;
    case Act::Kind::Limits:
        m_user[m_moment] = {act.rpm.value_or(0.0), act.amps.value_or(0.0)};
        return;
    case Act::Kind::Scale:
        m_line.ampsPerDigit = act.amps.value_or(0.0) / 32768.0;
        return;
    default:
        if (m_now - act.at <= m_line.fresh) // what is asked for too late is not asked for
            m_acts.push_back({act});
    }
}

bool MsRules::stopGoesOn() const
{
    return m_stop && std::any_of(m_stop->motors.begin(), m_stop->motors.end(), [](const auto &of) {
        return !of.second.rested;
    });
}

void MsRules::arm()
{
    ++m_counts.arms;
    m_armed = m_open;
    m_over = false;
    m_stop.reset();
    m_armedEarly.reset();
}

void MsRules::onStop(const Act &act)
{
    ++m_counts.stops;
    m_over = true;
    if (!wasUnderWay()) // when it was pressed before
        m_agreedBefore = m_agreed;
    m_agreed = {};
    forgetActs();
    m_open = m_open || m_link != LinkState::Closed; // a Stop interrupts the disconnecting
    if (!m_open)
        return;
    if (!stopGoesOn()) {
        m_stop = OpenStop{act.at, act.at, m_moment, act.at, {}};
        for (int motor = 1; motor <= m_line.motors; ++motor)
            m_stop->motors[motor].alarmed = m_alarming.contains(motor);
    }
    m_stop->latest = act.at;
}

/// It is not armed any more, and nothing is asked for.
void MsRules::forgetActs()
{
    m_armedEarly.reset();
    m_seriesAgreed = false;
    if (std::exchange(m_armed, false)) {
        m_disarmed = m_moment;
        m_disarmedAt = m_now;
    }
    for (Pending &one : m_acts)
        if (!one.voided) {
            one.voided = m_moment;
            one.voidedAt = m_now;
        }
    std::erase_if(
        m_acts, [this](const Pending &one) { return *one.voided + kKeptMoments < m_moment; });
}

void MsRules::asked(std::uint64_t wish, TimePoint at)
{
    m_now = std::max(m_now, at);
    if (wish != 0)
        m_wishes.insert(wish);
}

void MsRules::saidEnded(std::uint64_t wish, TimePoint at)
{
    m_now = std::max(m_now, at);
    if (wish == 0)
        return;
    if (!m_wishes.contains(wish))
        violate("ends once", "wish " + std::to_string(wish) + " ended and was never asked for");
    if (!m_ended.insert(wish).second)
        violate("ends once", "wish " + std::to_string(wish) + " ended again");
    ++m_moment;
    for (Pending &one : m_acts)
        if (one.act.id == wish && !one.voided) {
            one.voided = m_moment;
            one.voidedAt = m_now;
        }
    std::erase_if(m_acts,
        [this](const Pending &one) { return one.voided && *one.voided + kKeptMoments < m_moment; });
}

void MsRules::settle(TimePoint now)
{
    m_now = std::max(m_now, now);
    for (const std::uint64_t wish : m_wishes)
        if (!m_ended.contains(wish))
            violate("ends once", "wish " + std::to_string(wish) + " never ended");
}

void MsRules::said(LinkState link, TimePoint at)
{
    m_now = std::max(m_now, at);
    if (link == LinkState::Lost || link == LinkState::Closed) {
        m_identified = m_requested = false;
        m_over = true;
        ++m_moment;
        forgetActs();
    }
    if (link == LinkState::Connected && m_link != LinkState::Connected)
        m_heardAt = at;
    m_link = link;
}

void MsRules::saidIdentified(int motors, TimePoint at)
{
    m_now = std::max(m_now, at);
    m_identified = motors > 0;
    m_over = m_over || motors == 0;
}

bool MsRules::restedLately(int motor, double rpm, TimePoint at) const
{
    const auto seen = m_seen.find(motor);
    const auto truth = m_truth.find(motor);
    if (seen == m_seen.end() || truth == m_truth.end())
        return true; // the truth is not known
    return rpm > 0.0 ? seen->second.everRested && at - seen->second.restAt <= kEvidence
                     : seen->second.everIdle && at - seen->second.idleAt <= kEvidence;
}

void MsRules::look(TimePoint now, const std::vector<Motor> &truth)
{
    if (!watching())
        return;
    m_now = std::max(m_now, now);
    const auto pass = [&](TimePoint &since) { // what came within a gap waited for its end only
        const Duration gap = now - std::max(m_lookedAt, since);
        since += gap > kGap ? gap : Duration{};
        return gap > kGap;
    };
    if (m_lookedAt != TimePoint{}) {
        if (m_heardAt)
            pass(*m_heardAt);
        if (m_stop)
            pass(m_stop->latest);
        if (m_stop && pass(m_stop->first))
            for (auto &of : m_stop->motors)
                of.second.allowed = now;
    }
    m_lookedAt = now;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        m_truth[number] = truth[i];
        Seen &seen = m_seen[number];
        if (truth[i].idle) {
            seen.idleAt = now;
            seen.everIdle = true;
        }
        if (std::abs(truth[i].rpm) < 30.0) { // the product's bound is 10, and noise is on it
            seen.restAt = now;
            seen.everRested = true;
        }
        if (m_stop && truth[i].idle)
            m_stop->motors[number].rested = true;
    }
    // Armed while the last motor came to rest: what the line's thread found when the word reached it is not known here.
    if (m_armedEarly && !stopGoesOn() && now - *m_armedEarly < m_line.grace)
        arm();
    stopsLeaveInTime(now);
    silenceIsTold(now);
}

} // namespace judge

#include "drive/wish_drive.h"

#include "drive/set_point_check.h"

namespace drive {

std::optional<Feature> featureOf(const Wish &wish)
{
    if (const auto setPoint = setPointOf(wish.what))
        return setPoint->feature;
    if (std::holds_alternative<PositionRamp>(wish.what))
        return Feature::PositionRamp;
    if (std::holds_alternative<Stream>(wish.what))
        return Feature::Stream;
    return std::holds_alternative<CyclicSetPoints>(wish.what)
        ? std::optional(Feature::CyclicSetPoints)
        : std::nullopt;
}

void WishDrive::beginStop(TimePoint now)
{
    m_mode = Mode::Open;
    m_workedAt = now;
    setArmed(false);
    if (!m_stop.open()) {
        m_stopAsked = now;
        m_stopsSent.clear();
    }
    m_stop.begin(m_facts.motors, now, motorsToStop());
    lookAtOnce(now);
}

void WishDrive::arm()
{
    if (m_mode != Mode::Open || !m_facts.identified || !m_facts.knownFirmware || m_lost
        || m_doubtedAt)
        return;
    if (m_stop.open())
        return; // first the stop that was asked for has to be confirmed
    m_stop.end();
    setArmed(true);
}

void WishDrive::doubt(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_workedAt = now;
    disarm();
    m_doubtedAt = now;
    m_facts.lately.clear();
    lookAtOnce(now);
    tellLink(m_toldState, m_toldReason);
}

void WishDrive::setArmed(bool armed)
{
    if (std::exchange(m_armed, armed) == armed)
        return;
    MotionEntry entry;
    entry.act = armed ? MotionAct::Arm : MotionAct::Disarm;
    entry.asked = entry.ended = m_workedAt;
    m_events.emplace_back(std::move(entry));
}

void WishDrive::endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now)
{
    if (auto motion = motionOf(wish, *m_facts.catalog, now)) {
        motion->outcome = outcome;
        motion->reason = reason;
        m_events.emplace_back(std::move(*motion));
    }
    if (wish.id != 0)
        m_events.emplace_back(
            Ended{wish.id, outcome, std::move(reason), {}, outcome == Outcome::Refused});
}

std::string WishDrive::accept(const UserLimits &limits)
{
    if (!isPlausible(limits))
        return "no limit is like that";
    if (std::exchange(m_facts.user, limits) != limits)
        limitsChanged();
    return {};
}

std::string WishDrive::accept(const ExpertMode &expert)
{
    if (!m_facts.identified || !m_facts.hasMotor(expert.motor))
        return "there is no such motor";
    if (gapsIn(m_facts.limitsOf(expert.motor)).empty())
        return "every limit of this motor is known";
    m_facts.expert.insert(expert.motor);
    return {};
}

std::string WishDrive::accept(const CurrentScale &scale)
{
    if (!m_facts.identified || !m_facts.hasMotor(scale.motor))
        return "there is no such motor";
    return isPlausible(scale) ? acceptScale(scale) : "no full-scale current is like that";
}

bool WishDrive::handleAtOnce(const Wish &wish, TimePoint now)
{
    const auto *watched = std::get_if<Watch>(&wish.what);
    const auto *expert = std::get_if<ExpertMode>(&wish.what);
    const auto *scale = std::get_if<CurrentScale>(&wish.what);
    // What is said of a board that was met: of the next one nothing is known before it is.
    const bool ofTheBoard = expert != nullptr || scale != nullptr;
    Outcome otherwise = Outcome::Refused; // than Ok, with a reason
    std::string why;
    if (watched != nullptr) {
        watch(*watched, now);
    } else if (const auto *limits = std::get_if<UserLimits>(&wish.what)) {
        why = accept(*limits);
    } else if (m_mode != Mode::Open || m_lost
        || (m_toldState == LinkState::Connecting && ofTheBoard)) {
        why = "not connected";
        otherwise = Outcome::NotSent;
    } else if (expert != nullptr) {
        why = accept(*expert);
    } else if (scale != nullptr) {
        why = accept(*scale);
    } else if (why = refuseAcknowledge(wish); why.empty()) {
        return false;
    }
    endNow(wish, why.empty() ? Outcome::Ok : otherwise, why, now);
    if (watched != nullptr)
        work(now);
    return true;
}

/// Firmware answers OK and clears what it remembers of a fault that is still there; some start again then.
std::string WishDrive::refuseAcknowledge(const Wish &wish) const
{
    const auto *command = std::get_if<Command>(&wish.what);
    if (command == nullptr || command->action != MotorAction::AcknowledgeFaults)
        return {};
    const auto at = m_faultNow.find(command->motor);
    return at != m_faultNow.end() && at->second
        ? "the fault is still present; remove its cause first"
        : "";
}

void WishDrive::followStatuses(std::vector<MotorStatus> statuses, TimePoint askedAt)
{
    const bool all = statuses.size() >= static_cast<std::size_t>(m_facts.motors);
    if (m_doubtedAt && all && askedAt >= *m_doubtedAt)
        m_doubtedAt.reset();
    for (MotorStatus &status : statuses) {
        // An answer from before a gap tells nothing of now.
        if (!m_doubtedAt || askedAt >= *m_doubtedAt)
            m_stop.acceptStatus(status, askedAt);
        m_faultNow[status.motor] =
            status.state == MotorState::FaultNow || !status.faultsNow.empty();
        m_events.emplace_back(std::move(status));
    }
}

bool WishDrive::followStop(TimePoint now)
{
    using Count = StopSequence::Count;
    if (m_facts.motorsCounted)
        m_memory.motors = m_facts.motors;
    m_stop.follow(m_facts.motors, m_facts.motorsCounted ? Count::Exactly : Count::AtLeast, now);
    return m_mode == Mode::Open && m_stop.active();
}

void WishDrive::noteStop(int motor, ByteView request, TimePoint now)
{
    m_stop.stopSent(motor, now);
    noteSent(m_stopsSent[motor], request);
}

void WishDrive::collectStop()
{
    for (const StopProgress &progress : m_stop.takeProgress()) {
        m_events.emplace_back(
            entryOf(progress, m_stopAsked, std::exchange(m_stopsSent[progress.motor], {})));
        m_events.emplace_back(progress);
    }
}

void WishDrive::tell(LinkState state, LinkReason reason)
{
    if (state == LinkState::Closed || state == LinkState::Lost || state == LinkState::Connecting)
        m_doubtedAt.reset(); // what follows begins with everything anew
    m_toldState = state;
    m_toldReason = reason;
    m_events.emplace_back(LinkChanged{state, reason});
}

void WishDrive::tellLink(LinkState state, LinkReason reason)
{
    if (m_doubtedAt && state == LinkState::Connected)
        return tellLink(LinkState::Suspect, LinkReason::None);
    if (state != m_toldState || reason != m_toldReason)
        tell(state, reason);
}

void WishDrive::tellCounters(const LinkCounters &counters, TimePoint now)
{
    constexpr Duration kCountersEvery = std::chrono::milliseconds(250);
    if (now < m_countersAt || counters == m_counters)
        return;
    m_counters = counters;
    m_countersAt = now + kCountersEvery;
    m_events.emplace_back(counters);
}

} // namespace drive

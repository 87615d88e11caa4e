#include "drive/wish_drive.h"

#include "drive/motion_of.h"

#include <algorithm>

namespace drive {

namespace {

constexpr Duration kCountersEvery = std::chrono::milliseconds(250);

} // namespace

void WishDrive::stop(TimePoint now)
{
    if (m_mode == Mode::Closed)
        return;
    m_mode = Mode::Open;
    m_workedAt = now;
    setArmed(false);
    m_cutAfterAnswer = m_task != nullptr;
    m_wishes.cutAll("stopped", dynamic_cast<WishTask *>(m_task));
    if (!m_stop.open()) {
        m_stopAsked = now;
        m_stopsSent.clear();
    }
    m_stop.begin(m_facts.motors, now);
    lookAtOnce(now);
    work(now);
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

void WishDrive::disarm()
{
    setArmed(false);
    m_wishes.cutArmed("disarmed", dynamic_cast<WishTask *>(m_task));
    m_wishes.collect(m_events, m_workedAt);
}

void WishDrive::doubt(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_workedAt = now;
    disarm();
    m_doubtedAt = now;
    lookAtOnce(now);
    tellLink(m_toldState, m_toldReason);
}

void WishDrive::cutAllWishes(const std::string &reason)
{
    m_wishes.cutAll(reason, nullptr);
    if (m_wishes.contains(m_task))
        m_task = &m_nobody;
    m_cutAfterAnswer = false;
    m_wishes.collect(m_events, m_workedAt);
}

void WishDrive::setArmed(bool armed)
{
    if (std::exchange(m_armed, armed) == armed)
        return;
    MotionRecord record;
    record.act = armed ? MotionAct::Arm : MotionAct::Disarm;
    record.asked = record.ended = m_workedAt;
    m_events.emplace_back(std::move(record));
}

void WishDrive::endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now)
{
    if (auto motion = motionOf(wish, *m_facts.catalog, now)) {
        motion->outcome = outcome;
        motion->reason = reason;
        m_events.emplace_back(std::move(*motion));
    }
    if (wish.id != 0)
        m_events.emplace_back(Ended{wish.id, outcome, std::move(reason), {}});
}

void WishDrive::takeLimits(const Wish &wish, const UserLimits &limits, TimePoint now)
{
    if (!isPlausible(limits))
        return endNow(wish, Outcome::Refused, "no limit is like that", now);
    m_facts.user = limits;
    endNow(wish, Outcome::Ok, {}, now);
}

void WishDrive::takeExpert(const Wish &wish, const ExpertMode &expert, TimePoint now)
{
    if (!m_facts.identified || !m_facts.hasMotor(expert.motor))
        return endNow(wish, Outcome::Refused, "there is no such motor", now);
    if (gapsIn(m_facts.limitsOf(expert.motor)).empty())
        return endNow(wish, Outcome::Refused, "every limit of this motor is known", now);
    m_facts.expert.insert(expert.motor);
    endNow(wish, Outcome::Ok, {}, now);
}

void WishDrive::takeScale(const Wish &wish, const CurrentScale &scale, TimePoint now)
{
    std::string why;
    if (!m_facts.identified || !m_facts.hasMotor(scale.motor))
        why = "there is no such motor";
    else if (!isPlausible(scale))
        why = "no full-scale current is like that";
    else
        why = takeScale(scale, now);
    endNow(wish, why.empty() ? Outcome::Ok : Outcome::Refused, why, now);
}

std::string WishDrive::takeScale(const CurrentScale &, TimePoint)
{
    return m_facts.reasonAgainst(Feature::CurrentScale);
}

bool WishDrive::takeAtOnce(const Wish &wish, TimePoint now)
{
    if (const auto *watched = std::get_if<Watch>(&wish.what)) {
        watch(*watched, now);
        endNow(wish, Outcome::Ok, {}, now);
        work(now);
    } else if (const auto *limits = std::get_if<UserLimits>(&wish.what)) {
        takeLimits(wish, *limits, now);
    } else if (m_mode != Mode::Open || m_lost) {
        endNow(wish, Outcome::NotSent, "not connected", now);
    } else if (const auto *expert = std::get_if<ExpertMode>(&wish.what)) {
        takeExpert(wish, *expert, now);
    } else if (const auto *scale = std::get_if<CurrentScale>(&wish.what)) {
        takeScale(wish, *scale, now);
    } else {
        return false;
    }
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

void WishDrive::submit(Wish wish, TimePoint now)
{
    if (takeAtOnce(wish, now))
        return;
    if (auto why = refuseAcknowledge(wish); !why.empty())
        return endNow(wish, Outcome::Refused, std::move(why), now);
    std::unique_ptr<WishTask> task = taskFor(wish);
    if (task->permission() == Permission::Armed && !m_armed)
        return endNow(wish, Outcome::NotSent,
            m_stop.active() ? "stopped; arm again first" : "not armed", now);
    task->freshen(std::min(wish.madeAt.value_or(now), now));
    if (task->expired(now))
        return endNow(wish, Outcome::NotSent, kTooLate, now);
    task->motion() = motionOf(wish, *m_facts.catalog, now);
    if (const auto *write = std::get_if<Write>(&wish.what))
        m_wishes.supersede(*write);
    if (!m_wishes.add(std::move(task)))
        return endNow(wish, Outcome::NotSent, "too many wishes wait already", now);
    work(now);
}

void WishDrive::takeAnswer(ByteView answer, TimePoint now)
{
    m_task->takeResponse(answer, now);
    if (auto *wish = dynamic_cast<WishTask *>(m_task))
        wish->freshen(now);
}

void WishDrive::afterTask(TimePoint now)
{
    auto *wish = dynamic_cast<WishTask *>(std::exchange(m_task, nullptr));
    const bool cut = std::exchange(m_cutAfterAnswer, false);
    if (wish == nullptr)
        return;
    if (cut)
        wish->cut("stopped");
    if (wish->finished() && wish->permission() == Permission::Armed)
        lookAtOnce(now); // whatever became of it
}

void WishDrive::sendNext(Task &vitals, Task &watch, TimePoint now)
{
    const bool open = m_mode == Mode::Open;
    if (open) {
        if (m_stop.open() && !m_facts.motorsCounted && sendFirst(now))
            return; // a motor that nobody knows of cannot be stopped
        if (m_stop.active() && give(vitals, now))
            return;
        if (stopHoldsBack(now) || sendFirst(now) || give(vitals, now))
            return;
    }
    if (!giveToWish(now) && open)
        give(watch, now);
}

bool WishDrive::giveToWish(TimePoint now)
{
    while (WishTask *wish = m_wishes.next(m_armed, now)) {
        if (give(*wish, now)) {
            wish->begin();
            return true;
        }
        if (!wish->finished())
            return false; // waits for something else; no other wish overtakes it
        m_wishes.collect(m_events, m_workedAt);
    }
    return false;
}

void WishDrive::takeStatuses(std::vector<MotorStatus> statuses, TimePoint askedAt)
{
    const bool all = statuses.size() >= static_cast<std::size_t>(m_facts.motors);
    if (m_doubtedAt && all && askedAt >= *m_doubtedAt)
        m_doubtedAt.reset();
    for (MotorStatus &status : statuses) {
        m_stop.takeStatus(status, askedAt);
        m_faultNow[status.motor] =
            status.state == MotorState::FaultNow || !status.faultsNow.empty();
        m_events.emplace_back(std::move(status));
    }
}

bool WishDrive::followStop(TimePoint now)
{
    using Count = StopSequence::Count;
    m_stop.follow(m_facts.motors, m_facts.motorsCounted ? Count::Exactly : Count::AtLeast, now);
    return m_mode == Mode::Open && m_stop.active();
}

void WishDrive::noteStop(int motor, ByteView request, TimePoint now)
{
    m_stop.stopSent(motor, now);
    noteSent(m_stopsSent[motor], request);
}

void WishDrive::collectWishes()
{
    m_wishes.collect(m_events, m_workedAt);
    for (const StopProgress &progress : m_stop.takeProgress()) {
        m_events.emplace_back(
            recordOf(progress, m_stopAsked, std::exchange(m_stopsSent[progress.motor], {})));
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
    if (now < m_countersAt || counters == m_counters)
        return;
    m_counters = counters;
    m_countersAt = now + kCountersEvery;
    m_events.emplace_back(counters);
}

} // namespace drive

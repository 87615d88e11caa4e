#include "session/link/dead_man.h"

#include <algorithm>

namespace session {

void Stamps::attend(TimePoint now)
{
    const Ticks at = now.time_since_epoch().count();
    const Ticks before = m_attended.exchange(at);
    // Both may have stood still and this side have woken first: the silence must not be lost by that.
    if (before != kNever && at - before > m_longest.load())
        m_longest.store(at - before);
}

void Stamps::hold(int motor, TimePoint now)
{
    m_held.store(now.time_since_epoch().count());
    if (m_hold.load() == 0 && motor > 0)
        m_hold.store(++m_holds * kMotors + static_cast<std::uint64_t>(motor) % kMotors);
}

Stamps::Seen Stamps::take()
{
    Seen seen;
    seen.hold = m_hold.load();
    seen.motor = static_cast<int>(seen.hold % kMotors);
    seen.held = TimePoint(Duration(m_held.load()));
    seen.longestSilence = Duration(m_longest.exchange(0));
    if (const Ticks at = m_attended.load(); at != kNever)
        seen.attended = TimePoint(Duration(at));
    return seen;
}

void DeadMan::begin(TimePoint now)
{
    m_begun = m_attended = now;
    m_states.clear();
    m_ours = false;
    m_absence.reset();
    m_idleBy.reset();
}

void DeadMan::stopped()
{
    if (m_absence)
        m_absence->stopped = true;
    for (Interruption &news : m_news)
        news.stopped = true;
}

bool DeadMan::driven(int motor) const
{
    const auto found = m_states.find(motor);
    return found == m_states.end() || !drive::rests(found->second); // not known: it may be
}

bool DeadMan::driven() const
{
    return m_states.empty()
        || std::ranges::any_of(m_states, [this](const auto &motor) { return driven(motor.first); });
}

Duration DeadMan::silence(const Stamps::Seen &seen, Duration gap, TimePoint now) const
{
    if (m_attendance == Attendance::OwnThread)
        return gap; // unattended while nothing ran
    return std::max(now - m_attended, seen.longestSilence);
}

DeadMan::Verdict DeadMan::judge(const Stamps::Seen &seen, bool armed, Duration gap, TimePoint now)
{
    Verdict verdict;
    m_attended = std::max(seen.attended.value_or(m_begun), m_begun);
    const Duration silent = silence(seen, gap, now);
    if (silent > kAbsentAfter) {
        if (!m_absence)
            m_absence = Interruption{Interruption::Cause::Interface, {}, false, false};
        m_absence->length = std::max(m_absence->length, silent);
        m_absence->disarmed = m_absence->disarmed || armed;
        if (gap > Duration::zero())
            m_absence->cause = Interruption::Cause::Gap;
        verdict.disarm = armed;
    }
    if (silent > kGoneAfter && m_ours && driven() && !m_absence->stopped)
        verdict.stopAll = m_absence->stopped = true;
    const bool back = m_attendance == Attendance::OwnThread || now - m_attended <= kAbsentAfter;
    if (gap > Duration::zero() && !m_absence && (armed || m_ours))
        m_news.push_back({Interruption::Cause::Gap, gap, armed, false});
    if (m_absence && back) {
        if (m_absence->disarmed || m_absence->stopped)
            m_news.push_back(*m_absence);
        m_absence.reset();
    }
    judgeHold(seen, verdict, now);
    if (!armed && !driven())
        m_ours = false; // what turns next was not begun here
    return verdict;
}

void DeadMan::judgeHold(const Stamps::Seen &seen, Verdict &verdict, TimePoint now)
{
    m_hold = seen.hold == m_endedHold ? 0 : seen.hold;
    m_held = seen.held;
    if (m_hold != 0 && now - seen.held > kHoldsFor) {
        m_endedHold = std::exchange(m_hold, 0);
        m_endedMotor = verdict.stopMotor = seen.motor;
        m_idleBy = now + kIdleWithin;
        m_news.push_back({Interruption::Cause::Hold, now - seen.held, false, true});
    }
    if (m_idleBy && now >= *m_idleBy) {
        m_idleBy.reset();
        verdict.stopAll = verdict.stopAll || driven(m_endedMotor);
    }
}

std::optional<Duration> DeadMan::nextLook(bool armed, TimePoint now) const
{
    std::optional<Duration> next;
    const auto sooner = [&next](Duration other) {
        const Duration wait = std::max(other, Duration(1));
        if (!next || wait < *next)
            next = wait;
    };
    const Duration after(1); // only what is longer than a limit is late
    const bool toTell = m_absence && (m_absence->disarmed || m_absence->stopped);
    if (m_attendance == Attendance::Stamped && (armed || m_ours || toTell)) {
        sooner(kLook); // at what is held, and whether the interface is back
        if (!m_absence)
            sooner(m_attended + kAbsentAfter + after - now);
        else if (!m_absence->stopped && now <= m_attended + kGoneAfter)
            sooner(m_attended + kGoneAfter + after - now);
    }
    if (m_hold != 0)
        sooner(m_held + kHoldsFor + after - now);
    if (m_idleBy)
        sooner(*m_idleBy - now);
    return next;
}

} // namespace session

#include "scope/acquisition.h"

#include <algorithm>
#include <cmath>

namespace scope {

namespace {
AcquisitionSettings bounded(AcquisitionSettings settings)
{
    settings.length = std::max<Nanos>(settings.length, 1);
    settings.holdOff = std::max<Nanos>(settings.holdOff, 0);
    settings.autoAfter = std::max<Nanos>(settings.autoAfter, 1);
    settings.preTrigger =
        std::isfinite(settings.preTrigger) ? std::clamp(settings.preTrigger, 0.0, 1.0) : 0.5;
    return settings;
}

bool matches(const EventTrigger &trigger, const Happening &happening)
{
    if (trigger.kind != happening.kind)
        return false;
    if (!trigger.which)
        return true;
    // Fault bits come together.
    return trigger.kind == EventTrigger::Kind::Fault ? (*trigger.which & happening.which) != 0
                                                     : *trigger.which == happening.which;
}
} // namespace

Nanos heldUntil(const capture::Channel &channel)
{
    const Index last = channel.end() - 1;
    if (channel.info().kind == capture::ChannelInfo::Kind::Polled)
        return channel.timeOf(last) + 1; // that it may hold longer is a guess
    return channel.holdUntil(last);
}

Acquisition::Acquisition(const AcquisitionSettings &settings)
    : m_settings(bounded(settings))
{
}

void Acquisition::configure(const AcquisitionSettings &settings, const capture::Channel *source)
{
    const bool running = m_running;
    if (running)
        stop();
    m_settings = bounded(settings);
    if (running)
        run(source);
}

void Acquisition::run(const capture::Channel *source)
{
    stop();
    m_running = true;
    m_automatic = false;
    m_candidate.reset();
    m_search.reset();
    m_source.reset();
    m_waitingSince.reset();
    m_notBefore = kNoTime;
    m_held = kNoTime; // the samples before may have been those of a file, later than all that comes
    if (source && !source->empty()) {
        m_waitingSince = m_notBefore = m_held = heldUntil(*source);
        m_source = source->info().id;
        m_search.emplace(m_settings.condition, source->end());
    }
}

void Acquisition::stop()
{
    if (m_current)
        finish(Record::State::Cut);
    m_running = false;
    m_candidate.reset();
}

void Acquisition::force(Nanos now)
{
    if (!m_running || m_settings.mode == Mode::Roll || (m_current && !isAutomatic()))
        return;
    if (m_held == kNoTime)
        return;
    m_current.reset();
    m_candidate.reset();
    begin(std::min(now, std::max(m_held, m_notBefore)), Record::Cause::Forced);
}

void Acquisition::event(const Happening &happening)
{
    const auto *const wanted = std::get_if<EventTrigger>(&m_settings.condition.what);
    if (!m_running || m_settings.mode == Mode::Roll || !wanted || !matches(*wanted, happening))
        return;
    if (happening.time < m_notBefore || m_candidate)
        return;
    m_candidate = {happening.time, happening.time, Record::Cause::Event};
    if (!m_current || isAutomatic())
        while (step(m_held)) { }
}

void Acquisition::advance(const capture::Channel &source)
{
    if (source.empty() || !m_running)
        return;
    if (m_source != source.info().id) {
        m_source = source.info().id;
        m_search.emplace(m_settings.condition, source.begin());
        if (!m_waitingSince)
            m_waitingSince = source.timeOf(source.begin());
    }
    m_held = std::max(m_held, heldUntil(source));
    if (m_current)
        m_current->held = m_held;
    do {
        look(source);
    } while (m_running && step(m_held));
}

/// Searches on for the next candidate, as long as there is none.
void Acquisition::look(const capture::Channel &source)
{
    if (m_candidate || m_settings.mode == Mode::Roll)
        return;
    if (const auto hit = m_search->next(source, m_notBefore))
        m_candidate = {hit->time, source.timeOf(hit->sample), Record::Cause::Condition};
}

/// Does the next thing in the order of time, if the samples reach that far. What comes first is decided by the times
/// of samples, which are there or not, and not by interpolated ones.
bool Acquisition::step(Nanos held)
{
    if (!m_running || m_settings.mode == Mode::Roll)
        return false;
    if (m_current) {
        const bool pushedOut = isAutomatic() && m_candidate && m_candidate->decided < m_current->to;
        if (pushedOut) {
            m_current.reset();
            begin(m_candidate->time, m_candidate->cause);
            return true;
        }
        if (held < m_current->to)
            return false;
        finish(Record::State::Complete);
        return m_running;
    }
    if (m_candidate && m_candidate->time < m_notBefore) {
        m_candidate.reset();
        return true;
    }
    const bool isAuto = m_settings.mode == Mode::Auto && m_waitingSince;
    const Nanos deadline = isAuto ? *m_waitingSince + m_settings.autoAfter : 0;
    if (m_candidate && (!isAuto || m_candidate->decided < deadline)) {
        begin(m_candidate->time, m_candidate->cause);
        return true;
    }
    if (isAuto && held >= deadline) {
        begin(deadline, Record::Cause::Automatic);
        return true;
    }
    return false;
}

void Acquisition::begin(Nanos time, Record::Cause cause)
{
    const auto before = static_cast<Nanos>(
        std::llround(m_settings.preTrigger * static_cast<double>(m_settings.length)));
    Record record;
    record.id = m_nextId++;
    record.trigger = time;
    record.from = time - before;
    record.to = record.from + m_settings.length;
    record.held = m_held;
    record.cause = cause;
    m_current = record;
    m_automatic = cause == Record::Cause::Automatic;
    if (m_automatic)
        return; // a hit may still push it out
    m_candidate.reset();
    m_notBefore = std::max(record.to, time + std::max<Nanos>(m_settings.holdOff, 1));
}

void Acquisition::finish(Record::State state)
{
    m_current->state = state;
    m_over.push_back(*m_current);
    if (m_over.size() > kMostUntaken)
        m_over.erase(m_over.begin());
    m_waitingSince = std::max(m_current->to, m_current->trigger);
    m_current.reset();
    if (m_settings.mode == Mode::Single)
        m_running = false;
}

AcquisitionState Acquisition::state() const
{
    if (!m_running)
        return AcquisitionState::Stop;
    if (m_settings.mode == Mode::Roll)
        return AcquisitionState::Roll;
    if (m_current && !isAutomatic())
        return AcquisitionState::Triggered;
    return m_automatic ? AcquisitionState::Auto : AcquisitionState::Armed;
}

} // namespace scope

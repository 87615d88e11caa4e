#include "widgets/scope/trigger/trigger.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

namespace {
constexpr double kShortest = 1e-5; ///< seconds, of a record
constexpr double kLongest = 60.0;
constexpr double kLately = 1.0; ///< seconds that decide the middle
constexpr double kHysteresisShare = 0.02; ///< of the swing
} // namespace

Trigger::Trigger(const capture::Capture &capture, std::function<double()> now, QObject *parent)
    : QObject(parent)
    , m_capture(capture)
    , m_now(std::move(now))
    , m_acquisition(settingsOf(m_setup, {}))
{
    m_acquisition.run(nullptr);
}

const capture::Channel *Trigger::sourceChannel() const
{
    return m_source ? m_capture.channel(m_source->id) : nullptr;
}

void Trigger::adoptSource(const std::optional<capture::ChannelInfo> &source)
{
    const bool same = source && m_source && source->id == m_source->id;
    if (same || (!source && !m_source))
        return;
    const bool other = !m_source || !source || source->registerId != m_source->registerId;
    m_source = source;
    m_axis.forget();
    configure();
    if (other && m_source)
        levelToMiddle();
    Q_EMIT changed();
}

void Trigger::setSource(capture::ChannelId channel)
{
    const auto info = m_capture.info(channel);
    if (!info || (m_source && m_source->id == channel))
        return;
    m_source = info;
    m_axis.forget();
    levelToMiddle();
}

void Trigger::setSetup(const TriggerSetup &setup)
{
    if (setup == m_setup)
        return;
    const scope::Mode before = m_setup.mode;
    m_setup = setup;
    m_setup.mode = before;
    m_setup.preTrigger = std::clamp(setup.preTrigger, 0.0, 1.0);
    m_setup.length = std::clamp(setup.length, kShortest, kLongest);
    configure();
    if (setup.mode != before)
        setMode(setup.mode);
    else
        Q_EMIT changed();
}

void Trigger::configure()
{
    const scope::AcquisitionSettings settings = settingsOf(m_setup, m_source);
    Watched watched{m_setup, m_source ? m_source->registerId : 0};
    watched.setup.mode = {};
    watched.setup.preTrigger = watched.setup.holdOff = watched.setup.length = 0.0;
    if (watched != m_watched) {
        m_watched = watched;
        Q_EMIT conditionChanged();
    }
    m_error = scope::check(settings.condition);
    if (!m_error)
        m_acquisition.configure(settings, sourceChannel());
    Q_EMIT configured();
    follow();
}

void Trigger::setAwaitsSamples(bool awaits)
{
    if (std::exchange(m_awaits, awaits) != awaits)
        Q_EMIT changed();
}

void Trigger::setMode(scope::Mode mode)
{
    if (m_awaits || mode == scope::Mode::Roll) { // else what is shown stays
        m_setup.mode = mode;
        configure();
        m_running = true;
        run();
        follow();
    }
    Q_EMIT changed();
}

void Trigger::setRunning(bool running)
{
    if (std::exchange(m_running, running) != running)
        run();
}

void Trigger::run()
{
    if (m_running)
        m_acquisition.run(sourceChannel());
    else
        m_acquisition.stop();
}

void Trigger::force()
{
    if (!triggered() || !m_running || !m_awaits)
        return;
    m_acquisition.force(capture::toNanos(now()));
    advance();
}

void Trigger::event(scope::EventTrigger::Kind kind, double seconds, quint32 which)
{
    m_acquisition.event({capture::toNanos(m_axis.of(seconds)), kind, which});
    advance();
}

void Trigger::hear(const capture::Channel &source)
{
    if (std::exchange(m_heard, source.end()) != source.end() && !source.empty())
        m_axis.heard(m_now(), capture::toSeconds(source.timeOf(source.end() - 1)));
}

void Trigger::written(double seconds, const QStringList &names)
{
    const bool waited = std::any_of(names.begin(), names.end(),
        [this](const QString &name) { return plainName(name) == m_setup.written; });
    if (m_setup.written.isEmpty() || waited)
        event(scope::EventTrigger::Kind::RegisterWrite, seconds, 0);
}

void Trigger::advance()
{
    if (const capture::Channel *source = sourceChannel()) {
        hear(*source);
        if (m_running)
            m_acquisition.advance(*source);
    }
    const std::vector<scope::Record> records = m_acquisition.takeRecords();
    for (const scope::Record &record : records)
        m_history.add(record);
    Q_EMIT advanced(records);
    for (const scope::Record &record : records)
        if (record.state == scope::Record::State::Complete)
            Q_EMIT recordCompleted(record);
    if (!records.empty())
        Q_EMIT historyChanged();
    release();
    follow();
}

/// Marks the records whose samples were let go: those of the source, for a register that was read once is kept for
/// ever.
void Trigger::release()
{
    const capture::Channel *source = sourceChannel();
    const bool some = source && source->begin() > 0 && !source->empty();
    if (some && m_history.release(source->oldest()))
        Q_EMIT historyChanged();
}

void Trigger::forget()
{
    run();
    static_cast<void>(m_acquisition.takeRecords()); // what was cut has no samples either
    m_history.clear();
    Q_EMIT forgotten();
    m_told = state();
    Q_EMIT historyChanged();
    Q_EMIT stateChanged();
}

/// Tells of a new state, and stops behind a single record.
void Trigger::follow()
{
    const scope::AcquisitionState now = state();
    if (now == scope::AcquisitionState::Stop && triggered() && m_running
        && m_setup.mode == scope::Mode::Single) {
        setRunning(false);
        Q_EMIT stopped();
    }
    if (now != m_told) {
        m_told = now;
        Q_EMIT stateChanged();
    }
}

void Trigger::setPinned(scope::RecordId id, bool pinned)
{
    if (m_history.setPinned(id, pinned))
        Q_EMIT historyChanged();
}

void Trigger::setLabel(scope::RecordId id, const QString &label)
{
    if (m_history.setLabel(id, label.toStdString()))
        Q_EMIT historyChanged();
}

void Trigger::levelToMiddle()
{
    const capture::Channel *source = sourceChannel();
    const auto span = source ? source->timeSpan() : std::nullopt;
    if (span) {
        const capture::MinMax swing =
            source->extremes(std::max(span->from, span->to - kLately), span->to);
        if (!swing.empty()) {
            const double low = double(swing.min);
            const double high = double(swing.max);
            const double known = std::abs(source->info().digit());
            const double digit = known > 0.0 ? known : std::max((high - low) * 1e-3, 1e-6);
            m_setup.level = low + (high - low) / 2;
            if (fieldsOf(m_setup.type).upper) {
                m_setup.level = low + (high - low) * 0.1;
                m_setup.upper = std::max(low + (high - low) * 0.9, m_setup.level + digit);
            }
            m_setup.hysteresis = std::max((high - low) * kHysteresisShare, digit);
        }
    }
    configure();
    Q_EMIT changed();
}

scope::RecordId Trigger::nextRecord() const
{
    const auto &all = m_history.records();
    const scope::Record *filling = m_acquisition.current();
    return std::max(all.empty() ? 0 : all.back().id, filling ? filling->id : 0) + 1;
}

} // namespace widgets

#include "widgets/scope/trigger_control.h"

#include "widgets/scope/scope_view.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

namespace {
constexpr double kShortest = 1e-5; ///< seconds, of a record
constexpr double kLongest = 60.0;
/// Records longer than this are shown while they fill.
constexpr capture::Nanos kSlow = 200'000'000;
constexpr double kLately = 1.0; ///< seconds that decide the middle
constexpr int kNewestAlpha = 120; ///< of the record before the shown one, of 255
constexpr int kOldestAlpha = 36; ///< still seen, on light and on dark ground
constexpr double kHysteresisShare = 0.02; ///< of the swing
} // namespace

TriggerControl::TriggerControl(
    ScopeView &scope, const capture::Capture &capture, std::function<double()> now, QObject *parent)
    : QObject(parent)
    , m_scope(scope)
    , m_capture(capture)
    , m_now(std::move(now))
    , m_acquisition(settingsOf(m_setup, {}))
{
    connect(&scope, &ScopeView::captureAdvanced, this, &TriggerControl::advance);
    connect(&scope, &ScopeView::channelsChanged, this, &TriggerControl::findSource);
    connect(&scope, &ScopeView::runningChanged, this, &TriggerControl::runningChanged);
    connect(&scope, &ScopeView::visibleRangeChanged, this, &TriggerControl::adoptRange);
    connect(&scope, &ScopeView::triggerLevelMoved, this, &TriggerControl::moveLevel);
    connect(&scope, &ScopeView::triggerPositionMoved, this, &TriggerControl::movePosition);
    connect(&scope, &ScopeView::followingChanged, this, [this](bool following) {
        if (following && triggered())
            setMode(scope::Mode::Roll);
        else if (following)
            leaveRecord();
    });
    m_acquisition.run(nullptr);
    findSource();
}

scope::AcquisitionState TriggerControl::state() const { return m_acquisition.state(); }

const scope::Record *TriggerControl::shown() const { return m_shown ? &*m_shown : nullptr; }

const capture::Channel *TriggerControl::sourceChannel() const
{
    return m_source ? m_capture.channel(m_source->id) : nullptr;
}

/// Keeps the source while its register is shown, if only in another channel; else takes the first trace.
void TriggerControl::findSource()
{
    const QList<capture::ChannelId> shown = m_scope.channels();
    std::optional<capture::ChannelInfo> found;
    for (const capture::ChannelId id : shown) {
        const auto info = m_capture.info(id);
        if (info && m_source && info->registerId == m_source->registerId)
            found = info;
    }
    if (!found && !shown.isEmpty())
        found = m_capture.info(shown.first());
    const bool same = found && m_source && found->id == m_source->id;
    if (same || (!found && !m_source))
        return;
    const bool other = !m_source || !found || found->registerId != m_source->registerId;
    m_source = found;
    configure();
    if (other && m_source)
        levelToMiddle();
    Q_EMIT changed();
}

void TriggerControl::setSource(capture::ChannelId channel)
{
    const auto info = m_capture.info(channel);
    if (!info || (m_source && m_source->id == channel))
        return;
    m_source = info;
    levelToMiddle();
}

void TriggerControl::setSetup(const TriggerSetup &setup)
{
    if (setup == m_setup)
        return;
    const scope::Mode before = m_setup.mode;
    m_setup = setup;
    m_setup.mode = before;
    m_setup.preTrigger = std::clamp(setup.preTrigger, 0.0, 1.0);
    m_setup.length = std::clamp(setup.length, kShortest, kLongest);
    configure();
    if (setup.mode != before) {
        setMode(setup.mode);
        return;
    }
    Q_EMIT changed();
}

void TriggerControl::configure()
{
    const scope::AcquisitionSettings settings = settingsOf(m_setup, m_source);
    Watched watched{m_setup, m_source ? m_source->registerId : 0};
    watched.setup.mode = {};
    watched.setup.preTrigger = watched.setup.holdOff = watched.setup.length = 0.0;
    if (watched != m_watched) {
        m_watched = watched;
        m_persistFrom = nextRecord();
    }
    m_error = scope::check(settings.condition);
    if (!m_error)
        m_acquisition.configure(settings, sourceChannel());
    markPicture();
    follow();
}

void TriggerControl::setAwaitsSamples(bool awaits)
{
    if (std::exchange(m_awaits, awaits) != awaits)
        Q_EMIT changed();
}

void TriggerControl::setMode(scope::Mode mode)
{
    if (!m_awaits && mode != scope::Mode::Roll) {
        Q_EMIT changed(); // what is shown stays
        return;
    }
    const bool wasRoll = !triggered();
    m_setup.mode = mode;
    if (triggered() && wasRoll)
        m_rollSpan = m_scope.visibleRange().to - m_scope.visibleRange().from;
    configure();
    const QScopedValueRollback showing(m_showing, true);
    if (triggered()) {
        m_scope.setFollowing(false);
        if (wasRoll) { // until a record comes: the newest stretch of its length
            const double to = m_scope.visibleRange().to;
            m_scope.setVisibleRange(to - m_setup.length, to);
        }
    } else {
        leaveRecord();
        const double to = m_scope.visibleRange().to;
        m_scope.setVisibleRange(to - m_rollSpan, to);
        m_scope.setFollowing(true);
    }
    if (m_scope.running())
        m_acquisition.run(sourceChannel());
    else
        m_scope.setRunning(true);
    markPicture();
    follow();
    Q_EMIT changed();
}

void TriggerControl::single()
{
    setMode(scope::Mode::Single); // arms anew, if it was single already
}

void TriggerControl::force()
{
    if (!triggered() || !m_scope.running() || !m_awaits)
        return;
    m_acquisition.force(capture::toNanos(m_now()));
    advance();
}

void TriggerControl::event(scope::EventTrigger::Kind kind, double seconds, quint32 which)
{
    m_acquisition.event({capture::toNanos(seconds), kind, which});
    advance();
}

void TriggerControl::runningChanged(bool running)
{
    if (running)
        m_acquisition.run(sourceChannel());
    else
        m_acquisition.stop();
    if (running && triggered() && m_shown) { // back to where records come
        const QScopedValueRollback showing(m_showing, true);
        m_scope.setFollowing(false);
    } else if (running && !triggered()) {
        leaveRecord();
    }
    advance();
}

/// In Roll a record may be looked at; when the picture goes on it counts in the session's time again.
void TriggerControl::leaveRecord()
{
    if (!m_shown)
        return;
    m_shown.reset();
    showPersistence();
    m_scope.setTimeOrigin(0.0);
    markPicture();
    Q_EMIT stateChanged();
}

void TriggerControl::advance()
{
    if (const capture::Channel *source = sourceChannel(); source && m_scope.running())
        m_acquisition.advance(*source);
    const std::vector<scope::Record> records = m_acquisition.takeRecords();
    for (const scope::Record &record : records)
        m_history.add(record);
    if (triggered()) {
        const scope::Record *filling = m_acquisition.current();
        if (filling && filling->to - filling->from >= kSlow && m_scope.running())
            show(*filling);
        else if (!records.empty() && m_scope.running())
            show(records.back());
    }
    for (const scope::Record &record : records)
        if (record.state == scope::Record::State::Complete)
            Q_EMIT recordCompleted(record);
    if (!records.empty())
        Q_EMIT historyChanged();
    release();
    follow();
}

/// Marks the records whose samples were let go: those of the source, for a register that was read once is kept for ever.
void TriggerControl::release()
{
    const capture::Channel *source = sourceChannel();
    const bool some = source && source->begin() > 0 && !source->empty();
    if (some && m_history.release(source->oldest()))
        Q_EMIT historyChanged();
}

void TriggerControl::forget()
{
    if (m_scope.running())
        m_acquisition.run(sourceChannel());
    else
        m_acquisition.stop();
    static_cast<void>(m_acquisition.takeRecords()); // what was cut has no samples either
    m_history.clear();
    m_shown.reset();
    showPersistence();
    m_scope.setTimeOrigin(0.0);
    markPicture();
    m_told = state();
    Q_EMIT historyChanged();
    Q_EMIT stateChanged();
}

/// Tells of a new state, and stops the picture after a single record.
void TriggerControl::follow()
{
    const scope::AcquisitionState now = state();
    if (now == scope::AcquisitionState::Stop && triggered() && m_scope.running()
        && m_setup.mode == scope::Mode::Single)
        m_scope.setRunning(false);
    if (now != m_told) {
        m_told = now;
        Q_EMIT stateChanged();
    }
}

void TriggerControl::show(const scope::Record &record)
{
    const bool other = !m_shown || m_shown->id != record.id || m_shown->state != record.state;
    const std::optional<scope::Record> before = std::exchange(m_shown, record);
    if (!other)
        return;
    const QScopedValueRollback showing(m_showing, true);
    m_scope.setTimeOrigin(capture::toSeconds(record.trigger));
    m_scope.setVisibleRange(capture::toSeconds(record.from), capture::toSeconds(record.to));
    if (before && before->id != record.id) // cursors stay where they are from the trigger
        m_scope.cursors().shift(capture::toSeconds(record.trigger - before->trigger));
    markPicture();
    showPersistence();
    Q_EMIT stateChanged();
}

void TriggerControl::showRecord(scope::RecordId id)
{
    const scope::Record *record = m_history.find(id);
    if (!record)
        return;
    const scope::Record copy = *record;
    m_scope.setRunning(false);
    show(copy);
    markPicture();
    Q_EMIT stateChanged();
}

void TriggerControl::step(int records)
{
    const auto &all = m_history.records();
    if (all.empty())
        return;
    const auto now = std::find_if(all.begin(), all.end(),
        [this](const scope::Record &record) { return m_shown && record.id == m_shown->id; });
    const std::ptrdiff_t last = std::ptrdiff_t(all.size()) - 1;
    const std::ptrdiff_t from = now == all.end() ? last + 1 : now - all.begin();
    showRecord(all[std::size_t(std::clamp<std::ptrdiff_t>(from + records, 0, last))].id);
}

void TriggerControl::setPinned(scope::RecordId id, bool pinned)
{
    if (m_history.setPinned(id, pinned))
        Q_EMIT historyChanged();
}

void TriggerControl::setLabel(scope::RecordId id, const QString &label)
{
    if (m_history.setLabel(id, label.toStdString()))
        Q_EMIT historyChanged();
}

/// A person zoomed or moved a picture that runs: the next record is to look like it.
void TriggerControl::adoptRange(double from, double to)
{
    if (m_showing || !triggered() || !m_scope.running())
        return;
    m_setup.length = std::clamp(to - from, kShortest, kLongest);
    if (m_shown) {
        const double before = capture::toSeconds(m_shown->trigger) - from;
        m_setup.preTrigger = std::clamp(before / m_setup.length, 0.0, 1.0);
    }
    configure();
    Q_EMIT changed();
}

void TriggerControl::moveLevel(int which, double value)
{
    TriggerSetup setup = m_setup;
    (which == 0 ? setup.level : setup.upper) = value;
    setSetup(setup);
}

/// The flag at the top was dragged: the trigger keeps its time, the picture moves under it.
void TriggerControl::movePosition(double seconds)
{
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    TriggerSetup setup = m_setup;
    setup.preTrigger = std::clamp((seconds - seen.from) / (seen.to - seen.from), 0.0, 1.0);
    setSetup(setup);
    if (m_shown) {
        const QScopedValueRollback showing(m_showing, true);
        const double from =
            capture::toSeconds(m_shown->trigger) - m_setup.preTrigger * (seen.to - seen.from);
        m_scope.setVisibleRange(from, from + (seen.to - seen.from));
    }
    markPicture();
}

void TriggerControl::levelToMiddle()
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

/// The least id that no record has yet, neither a complete one nor one that is being filled.
scope::RecordId TriggerControl::nextRecord() const
{
    const auto &all = m_history.records();
    const scope::Record *filling = m_acquisition.current();
    return std::max(all.empty() ? 0 : all.back().id, filling ? filling->id : 0) + 1;
}

void TriggerControl::clearPersistence()
{
    m_persistFrom = m_shown ? m_shown->id : nextRecord();
    showPersistence();
}

void TriggerControl::setPersistence(int records)
{
    m_persistence = std::max(records, 0);
    showPersistence();
}

/// The records before the shown one, the older the paler; not across a clearing or another trigger, under which the
/// same moment of a signal stood elsewhere.
void TriggerControl::showPersistence()
{
    std::vector<Ghost> ghosts;
    const auto &all = m_history.records();
    for (auto record = all.rbegin(); m_shown && record != all.rend(); ++record) {
        const bool earlier = record->id < m_shown->id;
        const bool there = record->state != scope::Record::State::Released;
        if (std::ptrdiff_t(ghosts.size()) >= m_persistence)
            break;
        const bool together = (record->id < m_persistFrom) == (m_shown->id < m_persistFrom);
        if (!earlier || !there || !together)
            continue;
        const int age = static_cast<int>(ghosts.size());
        const double shift = capture::toSeconds(record->trigger - m_shown->trigger);
        const int fade = (kNewestAlpha - kOldestAlpha) * age / std::max(1, m_persistence - 1);
        ghosts.push_back({nullptr, shift, kNewestAlpha - fade});
    }
    m_scope.setGhosts(std::move(ghosts));
}

/// The level's arrow and the position's flag in the picture.
void TriggerControl::markPicture()
{
    TriggerMarks marks;
    if (triggered()) {
        const TriggerFields fields = fieldsOf(m_setup.type);
        if (fields.source && m_source) {
            marks.source = m_source->id;
            marks.levels.push_back(m_setup.level);
            if (fields.upper)
                marks.levels.push_back(m_setup.upper);
        }
        const ScopeView::TimeRange seen = m_scope.visibleRange();
        marks.position = m_shown ? capture::toSeconds(m_shown->trigger)
                                 : seen.from + m_setup.preTrigger * (seen.to - seen.from);
    }
    m_scope.setTriggerMarks(marks);
}

} // namespace widgets

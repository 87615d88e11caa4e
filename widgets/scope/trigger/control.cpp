#include "widgets/scope/trigger/control.h"

#include "widgets/scope/ghosts.h"
#include "widgets/scope/view.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace widgets {

namespace {
/// Records longer than this are shown while they fill.
constexpr capture::Nanos kSlow = 200'000'000;
constexpr int kNewestAlpha = 120; ///< of the record before the shown one, of 255
constexpr int kOldestAlpha = 36; ///< still seen, on light and on dark ground
} // namespace

TriggerControl::TriggerControl(
    Trigger &trigger, ScopeView &scope, const capture::Capture &capture, QObject *parent)
    : QObject(parent)
    , m_trigger(trigger)
    , m_scope(scope)
    , m_capture(capture)
{
    connect(&trigger, &Trigger::changed, this, &TriggerControl::changed);
    connect(&trigger, &Trigger::stateChanged, this, &TriggerControl::stateChanged);
    connect(&trigger, &Trigger::configured, this, &TriggerControl::markPicture);
    connect(&trigger, &Trigger::conditionChanged, this,
        [this] { m_persistFrom = m_trigger.nextRecord(); });
    connect(&trigger, &Trigger::advanced, this, &TriggerControl::showNewest);
    connect(&trigger, &Trigger::stopped, &scope, [&scope] { scope.setRunning(false); });
    connect(&trigger, &Trigger::forgotten, this, [this] {
        m_shown.reset();
        showPersistence();
        m_scope.time().setOrigin(0.0);
        markPicture();
    });
    connect(&scope, &ScopeView::channelsChanged, this, &TriggerControl::findSource);
    connect(&scope, &ScopeView::runningChanged, this, &TriggerControl::runningChanged);
    connect(&scope.time(), &TimeWindow::changed, this, &TriggerControl::adoptRange);
    connect(&scope, &ScopeView::triggerLevelMoved, this, &TriggerControl::moveLevel);
    connect(&scope, &ScopeView::triggerPositionMoved, this, &TriggerControl::movePosition);
    connect(&scope.time(), &TimeWindow::followingChanged, this, [this](bool following) {
        if (following && m_trigger.triggered()) {
            const scope::Mode mode = m_trigger.setup().mode;
            setMode(scope::Mode::Roll);
            Q_EMIT leftForRoll(mode);
        } else if (following) {
            leaveRecord();
        }
    });
    findSource();
}

double TriggerControl::rollSpan() const
{
    return m_trigger.triggered() ? m_rollSpan : m_scope.visibleRange().span();
}

/// Keeps the source while its register is shown, if only in another channel; else takes the first trace.
void TriggerControl::findSource()
{
    const QList<capture::ChannelId> shown = m_scope.channels();
    const std::optional<capture::ChannelInfo> source = m_trigger.source();
    std::optional<capture::ChannelInfo> found;
    for (const capture::ChannelId id : shown) {
        const auto info = m_capture.info(id);
        if (info && source && info->registerId == source->registerId)
            found = info;
    }
    if (!found && !shown.isEmpty())
        found = m_capture.info(shown.first());
    m_trigger.adoptSource(found);
}

void TriggerControl::setSetup(const TriggerSetup &setup)
{
    TriggerSetup framed = setup;
    framed.mode = m_trigger.setup().mode;
    m_trigger.setSetup(framed);
    if (setup.mode != framed.mode)
        setMode(setup.mode);
}

void TriggerControl::setMode(scope::Mode mode)
{
    const bool wasRoll = !m_trigger.triggered();
    const bool goes = m_trigger.awaitsSamples() || mode == scope::Mode::Roll;
    if (goes && mode != scope::Mode::Roll && wasRoll)
        m_rollSpan = m_scope.visibleRange().to - m_scope.visibleRange().from;
    m_trigger.setMode(mode);
    if (!goes)
        return;
    const QScopedValueRollback showing(m_showing, true);
    if (m_trigger.triggered()) {
        m_scope.time().setFollowing(false);
        if (wasRoll) { // until a record comes: the newest stretch of its length
            const double to = m_scope.visibleRange().to;
            m_scope.setVisibleRange(to - m_trigger.setup().length, to);
        }
    } else {
        leaveRecord();
        const double to = m_scope.visibleRange().to;
        m_scope.setVisibleRange(to - m_rollSpan, to);
        m_scope.time().setFollowing(true);
    }
    m_scope.setRunning(true);
    markPicture();
    Q_EMIT changed();
}

void TriggerControl::runningChanged(bool running)
{
    m_trigger.setRunning(running);
    if (running && m_trigger.triggered() && m_shown) { // back to where records come
        const QScopedValueRollback showing(m_showing, true);
        m_scope.time().setFollowing(false);
    } else if (running && !m_trigger.triggered()) {
        leaveRecord();
    }
    m_trigger.advance();
}

/// In Roll a record may be looked at; when the picture goes on it counts in the session's time again.
void TriggerControl::leaveRecord()
{
    if (!m_shown)
        return;
    m_shown.reset();
    showPersistence();
    m_scope.time().setOrigin(0.0);
    markPicture();
    Q_EMIT stateChanged();
}

void TriggerControl::showNewest(const std::vector<scope::Record> &records)
{
    if (!m_trigger.triggered() || !m_scope.running())
        return;
    const scope::Record *filling = m_trigger.filling();
    if (filling && filling->to - filling->from >= kSlow)
        show(*filling);
    else if (!records.empty())
        show(records.back());
}

void TriggerControl::show(const scope::Record &record)
{
    const bool other = !m_shown || m_shown->id != record.id || m_shown->state != record.state;
    const std::optional<scope::Record> before = std::exchange(m_shown, record);
    if (!other)
        return;
    const QScopedValueRollback showing(m_showing, true);
    m_scope.time().setOrigin(capture::toSeconds(record.trigger));
    m_scope.setVisibleRange(capture::toSeconds(record.from), capture::toSeconds(record.to));
    if (before && before->id != record.id) // cursors stay where they are from the trigger
        m_scope.cursors().shift(capture::toSeconds(record.trigger - before->trigger));
    markPicture();
    showPersistence();
    Q_EMIT stateChanged();
}

void TriggerControl::showRecord(scope::RecordId id)
{
    const scope::Record *record = m_trigger.history().find(id);
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
    const auto &all = m_trigger.history().records();
    if (all.empty())
        return;
    const auto now = std::find_if(all.begin(), all.end(),
        [this](const scope::Record &record) { return m_shown && record.id == m_shown->id; });
    const std::ptrdiff_t last = std::ptrdiff_t(all.size()) - 1;
    const std::ptrdiff_t from = now == all.end() ? last + 1 : now - all.begin();
    showRecord(all[std::size_t(std::clamp<std::ptrdiff_t>(from + records, 0, last))].id);
}

/// The user zoomed or moved a picture that runs: the next record is to look like it.
void TriggerControl::adoptRange(double from, double to)
{
    if (m_showing || !m_trigger.triggered() || !m_scope.running())
        return;
    TriggerSetup setup = m_trigger.setup();
    setup.length = to - from;
    if (m_shown)
        setup.preTrigger = (capture::toSeconds(m_shown->trigger) - from) / setup.length;
    m_trigger.setSetup(setup);
}

void TriggerControl::moveLevel(int which, double value)
{
    TriggerSetup setup = m_trigger.setup();
    (which == 0 ? setup.level : setup.upper) = value;
    setSetup(setup);
}

/// The flag at the top was dragged: the trigger keeps its time, the picture moves under it.
void TriggerControl::movePosition(double seconds)
{
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    TriggerSetup setup = m_trigger.setup();
    setup.preTrigger = std::clamp((seconds - seen.from) / (seen.to - seen.from), 0.0, 1.0);
    setSetup(setup);
    if (m_shown) {
        const QScopedValueRollback showing(m_showing, true);
        const double from = capture::toSeconds(m_shown->trigger)
            - m_trigger.setup().preTrigger * (seen.to - seen.from);
        m_scope.setVisibleRange(from, from + (seen.to - seen.from));
    }
    markPicture();
}

void TriggerControl::clearPersistence()
{
    m_persistFrom = m_shown ? m_shown->id : m_trigger.nextRecord();
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
    const auto &all = m_trigger.history().records();
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
    m_scope.ghosts().setRecords(std::move(ghosts));
}

/// The level's arrow and the position's flag in the picture.
void TriggerControl::markPicture()
{
    TriggerMarks marks;
    if (m_trigger.triggered()) {
        const auto source = m_trigger.source();
        const TriggerFields fields = fieldsOf(m_trigger.setup().type);
        if (fields.source && source) {
            marks.source = source->id;
            marks.levels.push_back(m_trigger.setup().level);
            if (fields.upper)
                marks.levels.push_back(m_trigger.setup().upper);
        }
        const ScopeView::TimeRange seen = m_scope.visibleRange();
        marks.position = m_shown ? capture::toSeconds(m_shown->trigger)
                                 : seen.from + m_trigger.setup().preTrigger * (seen.to - seen.from);
    }
    m_scope.setTriggerMarks(marks);
}

} // namespace widgets

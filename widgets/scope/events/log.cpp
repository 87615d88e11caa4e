#include "widgets/scope/events/log.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/events/icon.h"

#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr std::size_t kForgottenAtOnce = 500;
/// Seconds; all lines alike, so that they can be compared at a glance.
constexpr double kTimeStep = 1e-4;
} // namespace

QString eventKindText(EventKind kind)
{
    switch (kind) {
    case EventKind::Command:
        return EventLog::tr("Command");
    case EventKind::Write:
        return EventLog::tr("Write", "an event: a register was written");
    case EventKind::State:
        return EventLog::tr("State");
    case EventKind::Marker:
        return EventLog::tr("Marker");
    case EventKind::Recovery:
        return EventLog::tr("Recovery");
    case EventKind::Loss:
        return EventLog::tr("Loss");
    case EventKind::Fault:
        return EventLog::tr("Fault");
    }
    return {};
}

EventLog::EventLog(QObject *parent)
    : RowTable(parent,
        {tr("Time"), tr("What", "heading of a column: the kind of an event"), tr("Event or note")})
{
    connect(this, &QAbstractItemModel::rowsInserted, this, &EventLog::changed);
    connect(this, &QAbstractItemModel::rowsRemoved, this, &EventLog::changed);
    connect(this, &QAbstractItemModel::dataChanged, this, &EventLog::changed);
    connect(this, &QAbstractItemModel::modelReset, this, &EventLog::changed);
}

EventLog::Range EventLog::in(double from, double to) const
{
    const auto before = [](const ScopeEvent &event, double time) { return event.seconds < time; };
    const auto after = [](double time, const ScopeEvent &event) { return time < event.seconds; };
    const auto first = std::lower_bound(m_events.begin(), m_events.end(), from, before);
    const auto last = std::upper_bound(first, m_events.end(), to, after);
    return {std::size_t(first - m_events.begin()), std::size_t(last - m_events.begin())};
}

std::optional<std::size_t> EventLog::indexOf(quint32 id) const
{
    const auto found = std::find_if(
        m_events.begin(), m_events.end(), [id](const ScopeEvent &event) { return event.id == id; });
    if (found == m_events.end())
        return std::nullopt;
    return std::size_t(found - m_events.begin());
}

const ScopeEvent *EventLog::find(quint32 id) const
{
    const auto index = indexOf(id);
    return index ? &m_events[*index] : nullptr;
}

std::size_t EventLog::markerCount() const
{
    return std::size_t(std::count_if(m_events.begin(), m_events.end(),
        [](const ScopeEvent &event) { return event.kind == EventKind::Marker; }));
}

quint32 EventLog::add(EventKind kind, double seconds, const QString &text)
{
    if (!std::isfinite(seconds) || (kind == EventKind::Marker && markerCount() >= kMostMarkers))
        return 0;
    makeRoom();
    // Most come in order; one that was told late goes where it belongs.
    const auto place = std::upper_bound(m_events.begin(), m_events.end(), seconds,
        [](double time, const ScopeEvent &event) { return time < event.seconds; });
    const int row = static_cast<int>(place - m_events.begin());
    beginInsertRows({}, row, row);
    m_events.insert(place, {++m_lastId, seconds, kind, text.left(kTextLength)});
    endInsertRows();
    return m_lastId;
}

void EventLog::makeRoom()
{
    if (m_events.size() < kMost)
        return;
    std::size_t forgotten = 0;
    for (std::size_t i = 0; i < m_events.size() && forgotten < kForgottenAtOnce;) {
        if (m_events[i].kind == EventKind::Marker) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < m_events.size() && m_events[end].kind != EventKind::Marker
            && forgotten + (end - i) < kForgottenAtOnce)
            ++end;
        beginRemoveRows({}, static_cast<int>(i), static_cast<int>(end) - 1);
        m_events.erase(m_events.begin() + static_cast<std::ptrdiff_t>(i),
            m_events.begin() + static_cast<std::ptrdiff_t>(end));
        endRemoveRows();
        forgotten += end - i;
    }
}

void EventLog::setText(quint32 id, const QString &text)
{
    const auto index = indexOf(id);
    if (!index)
        return;
    m_events[*index].text = text.left(kTextLength);
    const QModelIndex cell = this->index(static_cast<int>(*index), TextColumn);
    Q_EMIT dataChanged(cell, cell);
}

void EventLog::setEvents(std::vector<ScopeEvent> events)
{
    std::erase_if(events, [](const ScopeEvent &event) { return !std::isfinite(event.seconds); });
    std::stable_sort(events.begin(), events.end(),
        [](const ScopeEvent &a, const ScopeEvent &b) { return a.seconds < b.seconds; });
    std::size_t markers = 0;
    std::erase_if(events, [&markers](const ScopeEvent &event) {
        return event.kind == EventKind::Marker && ++markers > kMostMarkers;
    });
    std::size_t toForget = events.size() - std::min(events.size(), kMost);
    std::erase_if(events, [&toForget](const ScopeEvent &event) {
        if (event.kind == EventKind::Marker || toForget == 0)
            return false;
        --toForget;
        return true;
    });
    for (ScopeEvent &event : events) {
        event.id = ++m_lastId;
        event.text.truncate(kTextLength);
    }
    beginResetModel();
    m_events = std::move(events);
    endResetModel();
}

bool EventLog::removeMarker(quint32 id)
{
    const auto index = indexOf(id);
    if (!index || m_events[*index].kind != EventKind::Marker)
        return false;
    const int row = static_cast<int>(*index);
    beginRemoveRows({}, row, row);
    m_events.erase(m_events.begin() + row);
    endRemoveRows();
    return true;
}

QString EventLog::freeMarkerName() const
{
    for (std::size_t number = markerCount() + 1;; ++number) {
        const QString name = tr("Marker %1").arg(number);
        const auto taken = [&name](const ScopeEvent &event) {
            return event.kind == EventKind::Marker && event.text == name;
        };
        if (std::none_of(m_events.begin(), m_events.end(), taken))
            return name;
    }
}

void EventLog::setTimeOrigin(double seconds)
{
    if (seconds == m_origin)
        return;
    m_origin = seconds;
    cellsChanged(TimeColumn, TimeColumn);
}

QVariant EventLog::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const ScopeEvent &event = m_events[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        if (index.column() == TimeColumn)
            return timeLabel(event.seconds - m_origin, kTimeStep, 1.0, plainLocale());
        return index.column() == KindColumn ? eventKindText(event.kind) : event.text;
    case Qt::EditRole:
        return index.column() == TextColumn ? QVariant(event.text) : QVariant();
    case Qt::DecorationRole:
        return index.column() == KindColumn
            ? QVariant(eventIcon(event.kind, QGuiApplication::palette()))
            : QVariant();
    case Qt::TextAlignmentRole:
        return index.column() == TimeColumn ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                            : QVariant();
    case KindRole:
        return static_cast<int>(event.kind);
    case SecondsRole:
        return event.seconds;
    case IdRole:
        return event.id;
    default:
        return {};
    }
}

bool EventLog::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const QString text = value.toString().simplified();
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable) || text.isEmpty())
        return false;
    setText(m_events[std::size_t(index.row())].id, text);
    return true;
}

Qt::ItemFlags EventLog::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = RowTable::flags(index);
    const bool note = index.isValid() && index.row() < rowCount() && index.column() == TextColumn
        && m_events[std::size_t(index.row())].kind == EventKind::Marker;
    return note ? usual | Qt::ItemIsEditable : usual;
}

Markers markersOf(const EventLog &events)
{
    Markers all;
    for (const ScopeEvent &event : events.events())
        if (event.kind == EventKind::Marker)
            all[capture::toNanos(event.seconds)] = event.text;
    return all;
}

} // namespace widgets

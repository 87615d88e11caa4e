// What happened, on the clock of the traces: commands, register writes, states, faults, lost samples, recoveries, and
// the markers that the user set. A table in the order of time; only markers can be edited and removed. Bounded: of what
// a program noted the oldest is forgotten, a marker never.
#pragma once

#include "capture/tick_time.h"
#include "widgets/base/row_table.h"

#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace widgets {

enum class EventKind : std::uint8_t { Command, Write, State, Marker, Recovery, Loss, Fault };

struct ScopeEvent {
    quint32 id = 0;
    double seconds = 0.0; ///< on the session's axis
    EventKind kind = EventKind::Command;
    QString text; ///< plain; names of a device are made fit to be shown
};

QString eventKindText(EventKind kind);

class EventLog : public RowTable {
    Q_OBJECT
public:
    enum Column { TimeColumn, KindColumn, TextColumn };
    enum Role { KindRole = Qt::UserRole, SecondsRole, IdRole };
    static constexpr std::size_t kMost = 10'000;
    static constexpr std::size_t kMostMarkers = 1'000;
    static constexpr int kTextLength = 200;

    explicit EventLog(QObject *parent = nullptr);

    const std::vector<ScopeEvent> &events() const { return m_events; } ///< by time
    /// The events in [from, to] as a range of events().
    struct Range {
        std::size_t first = 0, last = 0; ///< last: not included
    };
    Range in(double from, double to) const;
    const ScopeEvent *find(quint32 id) const;

    /// Returns the id; 0 if it was not taken (no time, or too many markers).
    quint32 add(EventKind kind, double seconds, const QString &text);
    /// Replaces all by these, in one step. Of more than kMost the newest are kept, markers before all others; of
    /// markers the first kMostMarkers. Their ids are given here, their order is that of time.
    void setEvents(std::vector<ScopeEvent> events);
    void setText(quint32 id, const QString &text);
    void clear() { setEvents({}); } ///< markers, too: another recording is shown
    bool removeMarker(quint32 id); ///< false if there is no such marker
    QString freeMarkerName() const;
    void setTimeOrigin(double seconds); ///< what the time column calls zero

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

Q_SIGNALS:
    void changed(); ///< anything

private:
    std::size_t rowsHeld() const override { return m_events.size(); }
    std::optional<std::size_t> indexOf(quint32 id) const;
    void makeRoom();
    std::size_t markerCount() const;

    std::vector<ScopeEvent> m_events;
    quint32 m_lastId = 0;
    double m_origin = 0.0;
};

/// Markers by their times: what a recording or a list has of them, or should have.
using Markers = std::map<capture::Nanos, QString>;
Markers markersOf(const EventLog &events);

} // namespace widgets

// SignalSelection: the signals on the scope: those of the plan while a board or a replay is told, those of a file that
// a user chose else. It keeps the picture in step with the plan.
#pragma once

#include "widgets/scope/signals/plan.h"
#include "widgets/scope/signals/polled_rates.h"

#include <QObject>

#include <set>

class QMenu;

namespace widgets {

class ScopeView;

class SignalSelection : public QObject {
    Q_OBJECT
public:
    /// All four outlive it.
    SignalSelection(Device &device, capture::Capture &capture, SignalPlan &plan, ScopeView &scope,
        QObject *parent = nullptr);

    SignalPlan &plan() { return m_plan; }
    const SignalPlan &plan() const { return m_plan; }
    QString nameOf(catalog::RegisterId id) const;
    QColor colorOf(catalog::RegisterId id) const;
    void fillColors(QMenu &menu, catalog::RegisterId id); ///< also before it is drawn
    /// Shows what was read from a file, in the place of everything recorded; until the next connection.
    /// @return  signals for which the scope has no room
    int showFile(capture::Capture file);
    /// Shows or hides one of the file's signals.
    void showOfFile(capture::ChannelId id, bool shown);
    /// A file's signals, those that were streamed first; the ticked ones are shown.
    void fillFileSignals(QMenu &menu);

public Q_SLOTS:
    /// `plot` as in ScopeView::addChannel(); -1: a plot that already has its unit, or a new one.
    void add(quint32 id, int plot = -1);
    void remove(quint32 id);

Q_SIGNALS:
    void changed(); ///< the plan or what the scope shows
    void noticed(const QString &sentence); ///< what was wished for is not shown

private:
    void follow();
    void fill();
    void syncScope();
    void rememberPlots();
    void show(const WantedSignal &signal, capture::ChannelId channel);
    int plotFor(catalog::RegisterId id) const;
    void takeOffScope();
    bool isFullOfFile() const;
    void showReplayed();

    Device &m_device;
    capture::Capture &m_capture;
    SignalPlan &m_plan;
    ScopeView &m_scope;
    std::set<capture::ChannelId> m_offered; ///< of a replay, that were shown once
    int m_left = 0; ///< of a file's signals, for which there was no room
    bool m_unfilled = false; ///< a file's signals are still to be shown
};

} // namespace widgets

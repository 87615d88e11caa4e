// SignalSelection: the signals a person wants on the scope, and what follows from that: the stream the board is asked
// for, the registers that are polled instead, the channels that the scope shows. It keeps these three in step.
#pragma once

#include "capture/capture.h"
#include "widgets/base/device.h"
#include "widgets/scope/channel_plan.h"
#include "widgets/scope/polled_rates.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <set>

class QMenu;

namespace widgets {

class ScopeView;

class SignalSelection : public QObject {
    Q_OBJECT
public:
    /// All three outlive it.
    SignalSelection(
        Device &device, capture::Capture &capture, ScopeView &scope, QObject *parent = nullptr);

    const std::vector<WantedSignal> &wanted() const { return m_wanted; }
    const ChannelPlan &plan() const { return m_plan; }
    unsigned fastEvery() const { return m_fastEvery; }
    /// The signals of a first look: two phase currents, Iq and the speed.
    void addDefaults();
    QString nameOf(catalog::RegisterId id) const;
    QColor colorOf(catalog::RegisterId id) const;
    void fillColors(QMenu &menu, catalog::RegisterId id); ///< also before it is drawn
    /// Shows what was read from a file, in the place of everything recorded; until the next connection.
    /// @return  signals for which the scope has no room
    int showFile(capture::Capture file);
    bool showsFile() const { return m_fromFile; }
    /// Shows or hides one of the file's signals.
    void showOfFile(capture::ChannelId id, bool shown);

public Q_SLOTS:
    /// `plot` as in ScopeView::addChannel(); -1: a plot that already has its unit, or a new one.
    void add(quint32 id, int plot = -1);
    void remove(quint32 id);
    void setRoute(quint32 id, widgets::Route route);
    void setFastEvery(unsigned ticks);
    void clearRecorded(); ///< forgets all samples; recording goes on

Q_SIGNALS:
    void changed(); ///< wanted(), plan() or what the scope shows
    void forgot(); ///< all samples that were there are gone
    void failed(const QString &sentence); ///< the board did not take the stream
    /// What was wished for does not fit, and what is done instead; before it starts.
    void noticed(const QString &sentence);

private:
    void replan(); ///< now
    void replanSoon();
    void sendStream();
    void tellWhatDoesNotFit(const ChannelPlan &before);
    void takeReadings(const std::vector<drive::Reading> &readings);
    void syncScope();
    void rememberPlots();
    int shownPlotOf(const WantedSignal &signal) const;
    int plotFor(catalog::RegisterId id) const;
    std::optional<capture::ChannelId> channelOf(catalog::RegisterId id) const;
    void boardChanged();
    void takeOffScope();
    bool isFullOfFile() const;
    void leaveFile();
    void opened(const session::Endpoint &endpoint);
    void showReplayed();

    Device &m_device;
    capture::Capture &m_capture;
    ScopeView &m_scope;
    std::vector<WantedSignal> m_wanted;
    ChannelPlan m_plan;
    unsigned m_fastEvery = 1;
    std::map<catalog::RegisterId, double> m_polledFactors; ///< by which values were scaled last
    drive::WishId m_streamWish = 0; ///< the one that has not ended
    bool m_streamStale = false; ///< the plan changed while it was under way
    bool m_fromFile = false; ///< the capture is a file's
    bool m_replaying = false; ///< it grows as the file is told
    std::set<capture::ChannelId> m_offered; ///< of a replay, that were shown once
    bool m_newBoard = false; ///< what does not fit was not told since it is there
    bool m_streamed = false; ///< something may be streaming that has to be ended
    QTimer m_soon;
};

} // namespace widgets

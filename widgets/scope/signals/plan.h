// SignalPlan: the signals that are wanted of a board, and what follows from that: the stream that the board is asked
// for, the registers that are polled instead, and what of both comes into the capture. It knows no picture.
#pragma once

#include "capture/capture.h"
#include "widgets/base/device.h"
#include "widgets/scope/signals/channel_plan.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <optional>

namespace widgets {

class SignalPlan : public QObject {
    Q_OBJECT
public:
    /// Both outlive it. The owner feeds it what the device tells.
    SignalPlan(Device &device, capture::Capture &capture, QObject *parent = nullptr);

    const std::vector<WantedSignal> &wanted() const { return m_wanted; }
    const WantedSignal *find(catalog::RegisterId id) const; ///< nullptr: it is not wanted
    /// What is wanted, by name; where no board was known yet what waits for one.
    std::vector<NamedSignal> named() const;
    /// In the place of what is wanted, as far as the board has it; without a board once there is one. None: as before.
    void setNamed(std::vector<NamedSignal> names);
    const ChannelPlan &planned() const { return m_plan; }
    unsigned fastEvery() const { return m_fastEvery; }
    std::optional<capture::ChannelId> channelOf(catalog::RegisterId id) const;
    bool showsFile() const { return m_fromFile; } ///< the capture is a file's
    bool replaying() const { return m_replaying; } ///< it grows as the file is told
    /// Takes what was read from a file in the place of everything recorded; until the next connection.
    void adopt(capture::Capture file);

    void boardChanged();
    void begin(const capture::StreamLayout &layout);
    void accept(const std::vector<drive::Reading> &readings);

public Q_SLOTS:
    /// @param plot  of the picture; only kept. One that is wanted already stays where it is.
    void add(quint32 id, int plot = 0);
    void addDefaults(); ///< those of a first look: two phase currents, Iq and the speed
    void remove(quint32 id);
    void setPlot(quint32 id, int plot);
    void setRoute(quint32 id, widgets::Route route);
    void setFastEvery(unsigned ticks);
    /// What a Stop broke off, or whose answer was lost, is asked for again a second later.
    void refresh(widgets::Milliseconds now);
    void clear(); ///< forgets all samples; recording goes on

Q_SIGNALS:
    void changed(); ///< wanted(), planned(), showsFile() or which channels there are
    void forgetting(); ///< all samples are about to go
    void forgot(); ///< all samples that were there are gone
    void renewed(); ///< behind forgot() and changed(): what is recorded is another's
    void boardReplaced(); ///< another one is there than the samples before are of
    void begunAnew(); ///< a connection has taken the place of a file, or a replay that of anything
    void failed(const QString &sentence); ///< the board did not take the stream
    /// What was wished for does not fit, and what is done instead; before it starts.
    void noticed(const QString &sentence);

private:
    void opened(const session::Endpoint &endpoint);
    void meet();
    void endPolled(); ///< of all registers: nothing is known until the next value
    /// Of the main sensor, at the full rate where the board streams it; empty: the board has none.
    std::optional<catalog::RegisterId> mainSpeed(int motor) const;
    std::string nameOf(catalog::RegisterId id) const;
    void resolveNames();
    void replan(); ///< now
    void replanSoon() { m_soon.start(); }
    void sendStream();
    bool doubted() const;
    void tellWhatDoesNotFit(const ChannelPlan &before);

    Device &m_device;
    capture::Capture &m_capture;
    std::vector<WantedSignal> m_wanted;
    std::vector<NamedSignal> m_names; ///< that wait for a board
    std::shared_ptr<const catalog::Catalog> m_catalog; ///< whose registers are wanted
    std::vector<std::string> m_speeds; ///< of the main sensors of its motors
    ChannelPlan m_plan;
    unsigned m_fastEvery = 1;
    std::optional<drive::Identity> m_met; ///< the board that the samples are of
    std::map<catalog::RegisterId, double> m_polledFactors; ///< by which values were scaled last
    drive::WishId m_streamWish = 0; ///< the one that has not ended
    /// The plan changed while it was under way, or the board did not answer.
    bool m_streamStale = false;
    int m_brokenOff = 0; ///< times in a row that it did not come to the board
    std::optional<Milliseconds> m_againAt; ///< when it is asked for again; empty: not known yet
    bool m_fromFile = false;
    bool m_replaying = false;
    bool m_newBoard = false; ///< what does not fit was not told since it is there
    bool m_streamed = false; ///< something may be streaming that has to be ended
    QTimer m_soon;
};

} // namespace widgets

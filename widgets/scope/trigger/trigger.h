// Trigger: arms the trigger of core/scope, feeds it what was recorded and what happened, and keeps the last records. It
// knows no picture; TriggerControl joins it with one.
#pragma once

#include "capture/capture.h"
#include "drive/set_points/times.h"
#include "widgets/scope/trigger/setup.h"

#include <QObject>

#include <functional>

namespace widgets {

class Trigger : public QObject {
    Q_OBJECT
public:
    /// @param capture  outlives it. @param now  seconds on the axis of what is streamed
    Trigger(
        const capture::Capture &capture, std::function<double()> now, QObject *parent = nullptr);

    const TriggerSetup &setup() const { return m_setup; }
    std::optional<capture::ChannelInfo> source() const { return m_source; }
    /// What is wrong with the setup; then the old condition stays in effect. nullopt: nothing.
    std::optional<scope::ConditionError> error() const { return m_error; }
    scope::AcquisitionState state() const { return m_acquisition.state(); }
    const scope::RecordHistory &history() const { return m_history; }
    /// The record that is being filled; nullptr if there is none.
    const scope::Record *filling() const { return m_acquisition.current(); }
    /// The least id that no record has yet, neither a complete one nor one that is being filled.
    scope::RecordId nextRecord() const;
    /// Seconds on the axis of the source's samples.
    double now() const { return m_axis.of(m_now()); }
    bool triggered() const { return m_setup.mode != scope::Mode::Roll; }
    bool running() const { return m_running; }
    /// false: a file is shown. It is searched in a replay, where samples come.
    bool awaitsSamples() const { return m_awaits; }
    void setAwaitsSamples(bool awaits);

public Q_SLOTS:
    void setSetup(const widgets::TriggerSetup &setup);
    void setSource(capture::ChannelId channel);
    /// The same register, perhaps in another channel, or another one, or none.
    void adoptSource(const std::optional<capture::ChannelInfo> &source);
    void setMode(scope::Mode mode); ///< also lets it run
    void setRunning(bool running);
    void force(); ///< a trigger now
    void levelToMiddle(); ///< of what the source did lately, with a hysteresis that suits its noise
    /// @param seconds  on the axis of what is streamed
    void event(scope::EventTrigger::Kind kind, double seconds, quint32 which);
    /// @param names  of the registers of one write
    void written(double seconds, const QStringList &names);
    void setPinned(scope::RecordId id, bool pinned);
    void setLabel(scope::RecordId id, const QString &label);
    /// The samples of all records are gone: so are the records, pinned ones too, for they would show others' samples.
    void forget();
    void advance(); ///< searches what was recorded since

Q_SIGNALS:
    void changed(); ///< setup, source or error
    void configured(); ///< with them, before the state follows
    void conditionChanged(); ///< what decides where the trigger lies in a record
    void stateChanged(); ///< state()
    void stopped(); ///< by itself, behind a single record
    void advanced(const std::vector<scope::Record> &records); ///< those that are new
    void recordCompleted(const scope::Record &record); ///< each once, whether it is shown or not
    void historyChanged();
    void forgotten(); ///< before historyChanged()

private:
    /// What decides where the trigger lies in a record.
    struct Watched {
        TriggerSetup setup; ///< without what only frames the record
        catalog::RegisterId source = 0;
        bool operator==(const Watched &) const = default;
    };
    void configure();
    void follow();
    void release();
    void run();
    void hear(const capture::Channel &source);
    const capture::Channel *sourceChannel() const;

    const capture::Capture &m_capture;
    std::function<double()> m_now;
    drive::SampleAxis m_axis; ///< of the source, which need not be what is streamed
    capture::Index m_heard = 0; ///< where the source ended
    TriggerSetup m_setup;
    std::optional<capture::ChannelInfo> m_source;
    std::optional<scope::ConditionError> m_error;
    scope::Acquisition m_acquisition;
    scope::RecordHistory m_history;
    scope::AcquisitionState m_told = scope::AcquisitionState::Roll;
    Watched m_watched;
    bool m_running = true;
    bool m_awaits = true;
};

} // namespace widgets

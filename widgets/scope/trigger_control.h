// Joins the trigger of core/scope with the scope's picture: arms it, feeds it what was recorded and what happened, shows
// its records and keeps the last ones. In mode Roll it leaves the picture alone.
//
// While a triggered picture runs, the picture is the setting: zooming changes the record's length, moving the trigger
// along the time axis the share before it. Stopped, a person may look around in the recording.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/trigger_setup.h"

#include <QObject>

#include <functional>

namespace widgets {

class ScopeView;

class TriggerControl : public QObject {
    Q_OBJECT
public:
    /// Both outlive it. @param now  seconds on the session's axis
    TriggerControl(ScopeView &scope, const capture::Capture &capture, std::function<double()> now,
        QObject *parent = nullptr);

    const TriggerSetup &setup() const { return m_setup; }
    std::optional<capture::ChannelInfo> source() const { return m_source; }
    /// What is wrong with the setup; then the old condition stays in effect. nullopt: nothing.
    std::optional<scope::ConditionError> error() const { return m_error; }
    scope::AcquisitionState state() const;
    const scope::RecordHistory &history() const { return m_history; }
    /// The record in the picture; nullptr if there is none.
    const scope::Record *shown() const;
    double now() const { return m_now(); }
    /// false: a file is shown. It is searched in a replay, where samples come.
    bool awaitsSamples() const { return m_awaits; }
    void setAwaitsSamples(bool awaits);

public Q_SLOTS:
    void setSetup(const widgets::TriggerSetup &setup);
    void setSource(capture::ChannelId channel);
    void setMode(scope::Mode mode); ///< also lets the picture run
    void single(); ///< S: one record, then stop
    void force(); ///< T: a trigger now
    void levelToMiddle(); ///< of what the source did lately, with a hysteresis that suits its noise
    void event(scope::EventTrigger::Kind kind, double seconds, quint32 which);
    void showRecord(scope::RecordId id); ///< stops the picture
    void step(int records); ///< to an earlier (< 0) or later record of the history
    void setPinned(scope::RecordId id, bool pinned);
    void setPersistence(int records); ///< so many earlier ones stay behind the newest; 0: none
    void clearPersistence(); ///< those there are now; later ones stay again
    void setLabel(scope::RecordId id, const QString &label);
    /// The samples of all records are gone: so are the records, pinned ones too, for they would show others' samples.
    void forget();

Q_SIGNALS:
    void changed(); ///< setup, source or error
    void stateChanged(); ///< state(), shown()
    void historyChanged();
    void recordCompleted(const scope::Record &record); ///< each once, whether it is shown or not

private:
    /// What decides where the trigger lies in a record.
    struct Watched {
        TriggerSetup setup; ///< without what only frames the record
        catalog::RegisterId source = 0;
        bool operator==(const Watched &) const = default;
    };
    void advance();
    void release();
    void configure();
    void follow();
    void show(const scope::Record &record);
    void adoptRange(double from, double to);
    void moveLevel(int which, double value);
    void movePosition(double seconds);
    void runningChanged(bool running);
    void leaveRecord();
    void findSource();
    void markPicture();
    void showPersistence();
    scope::RecordId nextRecord() const;
    bool triggered() const { return m_setup.mode != scope::Mode::Roll; }
    const capture::Channel *sourceChannel() const;

    ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::function<double()> m_now;
    TriggerSetup m_setup;
    std::optional<capture::ChannelInfo> m_source;
    std::optional<scope::ConditionError> m_error;
    scope::Acquisition m_acquisition;
    scope::RecordHistory m_history;
    std::optional<scope::Record> m_shown;
    scope::AcquisitionState m_told = scope::AcquisitionState::Roll;
    double m_rollSpan = 5.0; ///< seconds; what roll shows when it is chosen again
    bool m_awaits = true;
    int m_persistence = 0;
    Watched m_watched;
    scope::RecordId m_persistFrom =
        0; ///< earlier records do not stay behind this one and later ones
    bool m_showing = false; ///< the picture moves because of a record, not of a person
};

} // namespace widgets

// Joins the trigger with the scope's picture: shows its records, and lets the picture set it. In mode Roll it leaves
// the picture alone.
//
// While a triggered picture runs, the picture is the setting: zooming changes the record's length, moving the trigger
// along the time axis the share before it. Stopped, the user may look around in the recording.
#pragma once

#include "widgets/scope/trigger/trigger.h"

namespace widgets {

class ScopeView;

class TriggerControl : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    TriggerControl(Trigger &trigger, ScopeView &scope, const capture::Capture &capture,
        QObject *parent = nullptr);

    Trigger &trigger() { return m_trigger; }
    const Trigger &trigger() const { return m_trigger; }
    double rollSpan() const; ///< seconds; what the picture shows, or will when it rolls again
    /// The record in the picture; nullptr if there is none.
    const scope::Record *shown() const { return m_shown ? &*m_shown : nullptr; }

public Q_SLOTS:
    void setSetup(const widgets::TriggerSetup &setup);
    void setMode(scope::Mode mode); ///< also lets the picture run
    /// S: one record, then stop. Arms anew if it was single already.
    void single() { setMode(scope::Mode::Single); }
    void showRecord(scope::RecordId id); ///< stops the picture
    void step(int records); ///< to an earlier (< 0) or later record of the history
    void setPersistence(int records); ///< so many earlier ones stay behind the newest; 0: none
    void clearPersistence(); ///< those there are now; later ones stay again

Q_SIGNALS:
    void changed(); ///< setup, source or error
    void stateChanged(); ///< of the trigger, or shown()
    void leftForRoll(scope::Mode mode); ///< because the newest samples are to be followed

private:
    void showNewest(const std::vector<scope::Record> &records);
    void show(const scope::Record &record);
    void adoptRange(double from, double to);
    void moveLevel(int which, double value);
    void movePosition(double seconds);
    void runningChanged(bool running);
    void leaveRecord();
    void findSource();
    void markPicture();
    void showPersistence();

    Trigger &m_trigger;
    ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::optional<scope::Record> m_shown;
    double m_rollSpan = 5.0; ///< seconds; what roll shows when it is chosen again
    int m_persistence = 0;
    /// Earlier records do not stay behind this one and later ones.
    scope::RecordId m_persistFrom = 0;
    bool m_showing = false; ///< the picture moves because of a record, not of the user
};

} // namespace widgets

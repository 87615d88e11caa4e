// Tools: which forms there are below the scope, with their keys, what each of them works on, and what they remember.
#pragma once

#include "widgets/base/banner.h"
#include "widgets/base/motor_description.h"
#include "widgets/lab/identification.h"
#include "widgets/lab/loop/tuning.h"
#include "widgets/registers/panel.h"
#include "widgets/window/settings.h"
#include "widgets/window/tool_docks.h"

namespace widgets {

class ChannelStrip;
class EventPanel;
class FilePrompt;
class MathPanel;
class MeasurePanel;
class NotesPanel;
class Opening;
class RampForm;
class RunKeeper;
class ScopeView;
class SignalSelection;
class SnapshotActions;
class SnapshotPanel;
class SpectrumPanel;
class TriggerControl;
class XyPanel;

class Tools : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        ScopeView &scope;
        TriggerControl &trigger;
        ChannelStrip &strip; ///< shows what is computed, too
        SignalSelection &selection;
        RegisterPanel::Actions edits;
        Opening &opening; ///< whose snapshots can be compared
        FilePrompt &files;
        QMainWindow &window;
    };
    Tools(const Parts &parts, const Settings &settings);

    ToolDocks &docks() { return m_docks; }
    QList<QAction *> snapshotActions() const; ///< for the menu of the device
    void keep(Settings &settings) const; ///< what was set in them
    QList<NamedMeasure> measures() const;
    void setMeasures(const QList<NamedMeasure> &measures);
    QString notes() const;
    void setNotes(const QString &notes);

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);
    void inertiasChanged(const widgets::Inertias &inertias);

private:
    void addScopeTools();
    void addSnapshots();
    void addForms();
    void addLab();
    void addRunBook();
    void rememberInertia(const QString &motor, double inertia_kgm2);
    void showComputed(QAction *openMath);
    void offerToMath();
    void fillTraceMenu(QMenu &menu, quint32 channel);
    void measure(quint32 channel, const QList<scope::Quantity> &quantities);
    int motor() const; ///< whose constants apply to what is shown; 0: that of a file

    Parts m_parts;
    Device &m_device;
    Settings m_settings; ///< those that forms are made with
    MotorDescription m_description; ///< of a file, and what was measured
    Identification m_identification; ///< for all pages of the lab, as the next one
    LoopTuning m_tuning;
    ToolDocks m_docks;
    EventPanel *m_events = nullptr; ///< like all of them, when it is made
    MathPanel *m_math = nullptr;
    MeasurePanel *m_measures = nullptr;
    SpectrumPanel *m_spectrum = nullptr;
    XyPanel *m_xy = nullptr;
    QAction *m_openMeasures = nullptr;
    QAction *m_openSpectrum = nullptr;
    QAction *m_openXy = nullptr;
    QAction *m_openSnapshots = nullptr;
    NotesPanel *m_notes = nullptr;
    SnapshotPanel *m_snapshots = nullptr;
    RampForm *m_ramps = nullptr;
    RunKeeper *m_runs = nullptr;
    SnapshotActions *m_snapshotActions = nullptr;
};

} // namespace widgets

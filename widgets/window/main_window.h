// MainWindow: menus, docks and what is outside them: the connect bar, the stop button, the banner. It places panels
// and connects actions; decisions are the panels' own.
#pragma once

#include "session/transports/port_list.h"
#include "widgets/base/banner.h"
#include "widgets/scope/signals/signal_selection.h"
#include "widgets/snapshots/recorded_snapshots.h"
#include "widgets/window/leaving.h"
#include "widgets/window/settings.h"
#include "widgets/window/workbench.h"

#include <QMainWindow>

#include <functional>
#include <vector>

class QDockWidget;
class QMenu;
class QMenuBar;
class QStackedWidget;

namespace widgets {

class BigNumbers;
class ConnectBar;
class ControlPanel;
class CurrentScales;
class EventPanel;
class FileJob;
class FilePrompt;
class FirstSteps;
class Form;
class MarkerFile;
class MathChannels;
class RampForm;
class RecordControl;
class Replacing;
struct ExportOrder;
struct OpenedRecording;
class RegisterPanel;
class ScopeTools;
class ScopeView;
class TriggerControl;
class SampleRoom;
class SnapshotActions;
class SnapshotPanel;
class StatusStrip;
class StopAlarm;

class MainWindow : public QMainWindow {
    Q_OBJECT
public:
    /// All three outlive the window.
    MainWindow(Workbench &workbench, const session::PortSource &ports, FilePrompt &files,
        const Settings &settings, QWidget *parent = nullptr);
    ~MainWindow() override;

    Settings settings() const; ///< as they are now, to be saved
    ConnectBar *connectBar() const { return m_connectBar; }
    ScopeView *scope() const { return m_scope; }
    SignalSelection *selection() const { return m_selection; }
    /// Makes now what is made after the first picture; a second call costs nothing.
    void finishTools();
    static constexpr char kExportJob[] = "exportJob"; ///< its object's name

public Q_SLOTS:
    void warn(const QString &sentence); ///< in the banner
    void exportCsv();
    /// A capture is in this file; its motion log goes into the other one, if that has a name.
    void exported(const QString &path, const QString &motionLog);

Q_SIGNALS:
    void closed(); ///< the window has agreed to close
    void settled(); ///< once, soon after the first picture, which does without what comes then

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void childEvent(QChildEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QWidget *makeTop();
    QWidget *makeCentre();
    QWidget *makeScopeBar();
    void showRunning(bool running);
    QString sourceText() const;
    void makeDocks();
    void makeTools();
    void makeScopeTools();
    void makeSnapshots();
    bool anyToolOpen() const;
    void makeRecording();
    void say(Banner::Kind kind, const QString &sentence);
    void runExport(const ExportOrder &order);
    void copyPicture();
    void askForCsv();
    void askForRecording();
    void askForReplay();
    void tellReleased();
    void fillFileSignals();
    static QString leftText(int signalsLeft);
    void showImported(const QString &path, capture::Capture &imported);
    void openRecording(const QString &path);
    capture::Capture::Config forFiles() const;
    void askForRoom();
    void showRecording(OpenedRecording &opened);
    /// A dock whose content is made later.
    struct Tool {
        QDockWidget *dock = nullptr;
        std::function<Form *()> make;
        Form *form = nullptr; ///< until it is made
    };

    /// The action opens it; `makeForm` gives the form no parent, and is called once.
    QAction *addTool(const QString &title, const char *name, const QKeySequence &keys,
        std::function<Form *()> makeForm);
    Form *formOf(Tool &tool);
    void showComputedChips(QAction *openMath); ///< the chips of math channels, and what they do
    void makeNextTool();
    void makeScopeActions();
    void makeMenus(QMenuBar &bar);
    void fillEditMenu(QMenu *menu);
    void fillViewMenu(QMenu *menu);
    void fillMotorMenu(QMenu *menu);
    void fillToolsMenu(QMenu *menu);
    void connectParts();
    /// What the banner was last used for.
    enum class Told : std::uint8_t {
        Other,
        Done, ///< goes when the next connection or replay begins
        Link, ///< goes when the link changes
        Loss, ///< stays until the board answers again
    };
    struct LinkMessage {
        Banner::Kind kind = Banner::Kind::Note;
        QString sentence; ///< empty: nothing to say
        Told told = Told::Other;
    };

    void linkChanged();
    void portChanged();
    void tellLink();
    LinkMessage linkMessage() const;
    Leaving::Act another(std::function<void()> go);
    void askForLimits();
    void askForCurrentScale();
    void showBigNumbers(bool shown);
    void stopAdvanced(const drive::StopProgress &progress);
    void updateFrame();
    FileJob *exportUnderWay() const;
    void askAboutExport(FileJob &job);
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &keys = {});

    Workbench &m_workbench;
    Device &m_device;
    FilePrompt &m_files;
    Settings m_settings;
    ScopeView *m_scope;
    SignalSelection *m_selection;
    ScopeTools *m_scopeTools = nullptr;
    MathChannels &m_math;
    EventPanel *m_events = nullptr;
    TriggerControl *m_trigger;
    ConnectBar *m_connectBar = nullptr;
    ControlPanel *m_control = nullptr;
    CurrentScales *m_scales = nullptr;
    BigNumbers *m_bigNumbers = nullptr;
    QStackedWidget *m_pages = nullptr; ///< the picture, or the large numbers in its place
    RegisterPanel *m_registerPanel = nullptr;
    RampForm *m_ramps = nullptr;
    QDockWidget *m_registerDock = nullptr;
    SnapshotPanel *m_snapshotPanel = nullptr; ///< like all tools, made after the first picture
    SnapshotActions *m_snapshots = nullptr;
    RecordedSnapshots m_recordedSnapshots; ///< of the recording opened last
    Banner *m_banner = nullptr;
    FirstSteps *m_firstSteps = nullptr;
    StatusStrip *m_status = nullptr;
    RecordControl *m_record = nullptr;
    SampleRoom *m_room = nullptr;
    MarkerFile *m_markers = nullptr;
    bool m_toldReleased = false;
    bool m_leaveMarkers = false; ///< the window closes without them
    bool m_closeAfterExport = false;
    StopAlarm *m_alarm;
    QuestionBoxes m_questions{*this};
    Leaving *m_leaving;
    Replacing *m_replacing = nullptr;
    QWidget *m_frame = nullptr; ///< a red line while a real board is armed
    QWidget *m_scopeBar = nullptr;
    QAction *m_run = nullptr;
    QAction *m_follow = nullptr;
    QAction *m_fit = nullptr;
    QAction *m_fitValues = nullptr;
    QAction *m_zoomIn = nullptr;
    QAction *m_zoomOut = nullptr;
    QAction *m_export = nullptr;
    QAction *m_open = nullptr;
    QAction *m_import = nullptr;
    QAction *m_replayFile = nullptr;
    QAction *m_copyPicture = nullptr;
    QMenu *m_fileSignals = nullptr;
    QList<QAction *> m_dockActions;
    QList<QAction *> m_toolActions;
    std::vector<Tool> m_tools; ///< tabs beside one another, as long as nobody moves them
    bool m_painted = false;
    Told m_told = Told::Other;
};

} // namespace widgets

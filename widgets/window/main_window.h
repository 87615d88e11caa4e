// MainWindow: menus, docks and what is outside them: the connect bar, the stop button, the banner. It places panels and
// connects actions; what takes several steps is a flow of its own, and decisions are theirs and the panels'.
#pragma once

#include "session/transports/port_list.h"
#include "widgets/base/question.h"
#include "widgets/window/settings.h"
#include "widgets/window/workbench.h"

#include <QMainWindow>

#include <memory>

class QDockWidget;
class QMenu;
class QMenuBar;
class QStackedWidget;

namespace widgets {

class BigNumbers;
class ConnectBar;
class ControlPanel;
class CurrentScales;
class Exporting;
class FilePrompt;
class FirstSteps;
class Leaving;
class LinkNews;
class MarkerFile;
class Opening;
class RecentFiles;
class RecordingControl;
class RegisterPanel;
class Replacing;
class SampleRoom;
class ScopePage;
class ScopeView;
class Searching;
class SignalSelection;
class StatusStrip;
class StopAlarm;
class Tools;
class TriggerControl;
class Workspaces;

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
    /// Shows it; where the screen has no room for it and its frame, it takes all there is.
    void showWithin(const QSize &screen);

public Q_SLOTS:
    void warn(const QString &sentence); ///< in the banner
    void openFile(const QString &path); ///< a recording, CSV or a workspace, by its suffix

Q_SIGNALS:
    void closed(); ///< the window has agreed to close
    void settled(); ///< once, soon after the first picture, which does without what comes then

protected:
    void closeEvent(QCloseEvent *event) override;
    void changeEvent(QEvent *event) override;
    void childEvent(QChildEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void makeFlows();
    void makeFileActions();
    QWidget *makeTop();
    QWidget *makeCentre();
    void makeDocks();
    void makeTools();
    void makeWorkspaces();
    void makeMenus(QMenuBar &bar);
    void fillFileMenu(QMenu *menu);
    void fillEditMenu(QMenu *menu);
    void fillViewMenu(QMenu *menu);
    void fillThemes(QMenu *menu);
    void fillDeviceMenu(QMenu *menu);
    void fillMotorMenu(QMenu *menu);
    void fillScopeMenu(QMenu *menu);
    QAction *addAction(QMenu *menu, const QString &text, const QKeySequence &keys = {},
        const char *icon = nullptr);
    void connectParts();
    void connectFlows();
    void connectAlarm();
    void connectWatchList();

    void linkChanged();
    void tellReleased();
    void updateFrame();
    void stopAdvanced(const drive::StopProgress &progress);
    void explainFaults();
    void askForLimits();
    void askForCurrentScale();
    void askForRoom();

    Workbench &m_workbench;
    Device &m_device;
    FilePrompt &m_files;
    Settings m_settings;
    ScopeView *m_scope;
    SignalSelection *m_selection;
    TriggerControl *m_trigger;
    ConnectBar *m_connectBar;
    StopAlarm *m_alarm;
    QuestionBoxes m_questions{*this};

    // The flows, in the order in which they use each other.
    Leaving *m_leaving;
    RecordingControl *m_record = nullptr;
    MarkerFile *m_markers = nullptr;
    Replacing *m_replacing = nullptr;
    Exporting *m_exporting = nullptr;
    Searching *m_searching = nullptr;
    Opening *m_opening = nullptr;
    SampleRoom *m_room = nullptr;
    CurrentScales *m_scales = nullptr;
    LinkNews *m_news = nullptr;
    Workspaces *m_workspaces = nullptr;
    RecentFiles *m_recent = nullptr;

    ScopePage *m_page = nullptr;
    BigNumbers *m_bigNumbers = nullptr;
    QStackedWidget *m_pages = nullptr; ///< the picture, or the large numbers in its place
    FirstSteps *m_firstSteps = nullptr;
    RegisterPanel *m_registerPanel = nullptr;
    QDockWidget *m_registerDock = nullptr;
    ControlPanel *m_control = nullptr;
    StatusStrip *m_status = nullptr;
    QWidget *m_frame = nullptr; ///< a red line while a real board is armed
    QMenu *m_recentMenu = nullptr;
    QList<QAction *> m_openActions;
    QList<QAction *> m_exportActions; ///< a file, the clipboard
    QList<QAction *> m_dockActions;
    bool m_toldReleased = false;
    bool m_painted = false;
    std::unique_ptr<Tools> m_tools; ///< goes before their docks
};

} // namespace widgets

// Workspaces: takes the workspace that the window shows, puts another one in its place, reads and writes them as files,
// and has three ready arrangements. Nothing of it is sent to a motor: signals are recorded, no register is written.
#pragma once

#include "widgets/base/banner.h"
#include "widgets/window/workspace.h"

#include <QObject>

class QMainWindow;

namespace widgets {

class FilePrompt;
class QuestionPrompt;
class ScopeView;
class Tools;
class TriggerControl;
class Workbench;

class Workspaces : public QObject {
    Q_OBJECT
public:
    static constexpr int kLayoutVersion = 2; ///< raise it when docks come or go

    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        ScopeView &scope;
        TriggerControl &trigger;
        Tools &tools;
        FilePrompt &files;
        QuestionPrompt &prompt;
        QMainWindow &window;
    };
    explicit Workspaces(const Parts &parts, QObject *parent = nullptr);

    Workspace now() const;
    /// Signals, trigger and measurements that a board or its traces have to be known for follow once they are.
    void apply(const Workspace &workspace);
    /// false: it was told why not, and all is as before. Notes that are in no file are asked about first.
    bool open(const QString &path);
    static QString filter(); ///< of its files, for a dialog

    enum class Arrangement { Tune, Record, StartUp };

public Q_SLOTS:
    void askForOpen();
    void askForSave();
    /// Which tools stand below the scope, how long its picture is, and its trigger; the signals stay.
    void arrange(widgets::Workspaces::Arrangement arrangement);

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);
    void used(const QString &path); ///< was opened or saved

private:
    void askAboutNotes(const QString &path, Workspace workspace);
    void adopt(const QString &path, const Workspace &workspace);
    void save(const QString &path);
    void showSpan(double seconds);
    void findTriggerSource();
    bool isCurrent(capture::ChannelId id) const;

    Parts m_parts;
    QString m_folder; ///< of the last file
    QString m_keptNotes; ///< as the last file has them
    QString m_waitsForSource; ///< a trace that the trigger waits for
    TriggerSetup m_waitingSetup;
};

} // namespace widgets

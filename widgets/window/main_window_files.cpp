// Files in the main window: recordings, export and import, and what of a file is shown where.
#include "session/transports/recording_transport.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/value_text.h"
#include "widgets/files/event_recorder.h"
#include "widgets/files/export_order.h"
#include "widgets/files/file_job.h"
#include "widgets/files/import_csv.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/open_recording.h"
#include "widgets/files/record_control.h"
#include "widgets/files/sample_room.h"
#include "widgets/files/sample_room_dialog.h"
#include "widgets/files/scope_picture.h"
#include "widgets/scope/scope_view.h"
#include "widgets/snapshots/snapshot_panel.h"
#include "widgets/snapshots/snapshot_recorder.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/leaving.h"
#include "widgets/window/main_window.h"
#include "widgets/window/replacing.h"

#include <QAction>
#include <QClipboard>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QPointer>

#include <algorithm>
#include <utility>

namespace widgets {

void MainWindow::makeRecording()
{
    m_record = new RecordControl({m_workbench.recording(), m_device, m_workbench.events(), m_files,
                                     [this] { return m_workbench.eventRecorder().now(); }},
        m_settings.recordFolder, this);
    const auto make = [this](const QString &text, const char *name, const QKeySequence &keys,
                          void (MainWindow::*slot)()) {
        auto *action = new QAction(text, this);
        action->setObjectName(QLatin1String(name));
        action->setShortcut(keys);
        QMainWindow::addAction(action);
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    m_open = make(tr("&Open a recording\u2026"), "openRecording", Qt::CTRL | Qt::Key_O,
        &MainWindow::askForRecording);
    m_replayFile = make(tr("Re&play a recording\u2026"), "replayRecording",
        Qt::CTRL | Qt::SHIFT | Qt::Key_R, &MainWindow::askForReplay);
    m_import = make(tr("&Import CSV\u2026"), "importCsv", Qt::CTRL | Qt::SHIFT | Qt::Key_O,
        &MainWindow::askForCsv);
    m_copyPicture = make(tr("&Copy the picture"), "copyPicture", Qt::CTRL | Qt::SHIFT | Qt::Key_C,
        &MainWindow::copyPicture);
    connect(m_record, &RecordControl::said, this, &MainWindow::say);
    new SnapshotRecorder(
        m_device, m_workbench.recording(), m_workbench.snapshots(),
        [this] { return m_workbench.eventRecorder().now(); }, this);
    m_markers = new MarkerFile(m_workbench.events(), m_files, *m_record, this);
    connect(m_markers, &MarkerFile::said, this, &MainWindow::say);
    m_replacing = new Replacing({m_workbench, *m_markers, *m_record, m_questions}, this);
    connect(m_replacing, &Replacing::exportWanted, this, &MainWindow::exportCsv);
    // Those of a connection stay for the next one.
    m_connectBar->setBeforeOpening([this](std::function<void()> goOn) {
        m_leaving->before(another([this, goOn = std::move(goOn)] {
            if (m_workbench.signalPlan().showsFile())
                m_replacing->beforeMarkersGo(goOn);
            else
                goOn();
        }));
    });
    m_room = new SampleRoom(m_workbench.capture(), *m_workbench.archive(), this);
    m_room->setWanted(m_settings.samplesOnDiskGB);
    connect(m_room, &SampleRoom::said, this, &MainWindow::say);
    connect(&m_workbench, &Workbench::heartbeat, m_room, &SampleRoom::refresh);
    connect(&m_workbench.replay(), &session::Replay::happened, this,
        [this, writes = ReplayedWrites()](const session::ReplayedEntry &entry) mutable {
            addReplayed(m_workbench.events(), entry);
            if (const auto seconds = writes.take(entry))
                m_workbench.trigger().event(scope::EventTrigger::Kind::RegisterWrite, *seconds, 0);
            if (std::holds_alternative<record::Note>(entry.entry))
                m_markers->replayed(entry.seconds);
        });
}

void MainWindow::say(Banner::Kind kind, const QString &sentence)
{
    m_told = kind == Banner::Kind::Note ? Told::Done : Told::Other;
    m_banner->say(kind, sentence);
}

/// Once: the room is bounded, and what was let go is only where somebody recorded it.
void MainWindow::tellReleased()
{
    const bool released = m_workbench.capture().released() > 0;
    if (released && !m_workbench.signalPlan().showsFile() && !m_toldReleased)
        say(Banner::Kind::Warning, m_room->fullText());
    m_toldReleased = released;
}

void MainWindow::askForRecording()
{
    if (m_connectBar->connecting()) {
        say(Banner::Kind::Warning,
            tr("Disconnect first (Ctrl+D): a recording takes the place of what the scope shows."));
        return;
    }
    OpenQuestion question;
    question.title = tr("Open a recording");
    question.folder = m_record->folder().isEmpty() ? QDir::homePath() : m_record->folder();
    question.filter = tr("Recordings (*.pcapng)");
    m_leaving->before(another([this, question] {
        m_replacing->before([this, question] {
            m_files.askOpen(this, question, [this](const QString &path) { openRecording(path); });
        });
    }));
}

/// What takes the place of a connection that is over, perhaps with a motor that turns.
Leaving::Act MainWindow::another(std::function<void()> go)
{
    return {tr("Stopping the motors before something else is opened\u2026"),
        tr("Open it all the same\u2026"), std::move(go)};
}

/// As if its board were there: the scope's trigger, its measurements and another recording see no difference.
void MainWindow::askForReplay()
{
    if (m_connectBar->connecting()) {
        say(Banner::Kind::Warning,
            tr("Disconnect first (Ctrl+D): a replay takes the place of a board."));
        return;
    }
    OpenQuestion question;
    question.title = tr("Replay a recording");
    question.folder = m_record->folder().isEmpty() ? QDir::homePath() : m_record->folder();
    question.filter = tr("Recordings (*.pcapng)");
    m_leaving->before(another([this, question] {
        m_replacing->before([this, question] {
            m_files.askOpen(this, question, [this](const QString &path) {
                if (!session::isRecordingFile(path))
                    say(Banner::Kind::Warning,
                        tr("%1 is no recording of Rotorscope.").arg(deviceText(path)));
                else
                    m_connectBar->openReplay(path);
            });
        });
    }));
}

void MainWindow::askForCsv()
{
    if (m_connectBar->connecting()) {
        say(Banner::Kind::Warning,
            tr("Disconnect first (Ctrl+D): what is imported takes the place of what the scope "
               "shows."));
        return;
    }
    OpenQuestion question;
    question.title = tr("Import CSV");
    question.folder =
        m_settings.exportFolder.isEmpty() ? QDir::homePath() : m_settings.exportFolder;
    question.filter = tr("CSV files (*.csv *.txt)");
    m_leaving->before(another([this, question] {
        m_replacing->before([this, question] {
            m_files.askOpen(this, question, [this](const QString &path) {
                importCsv(
                    path, this,
                    [this, path](capture::Capture &capture) { showImported(path, capture); },
                    [this](const QString &sentence) { say(Banner::Kind::Warning, sentence); },
                    forFiles());
            });
        });
    }));
}

/// Of a file's signals, that the scope has no room for so many.
QString MainWindow::leftText(int signalsLeft)
{
    return signalsLeft == 0 ? QString()
                            : QLatin1Char(' ')
            + tr("%n signal(s) of it are not shown: see Scope, Signals of the file.", nullptr,
                signalsLeft);
}

void MainWindow::showImported(const QString &path, capture::Capture &imported)
{
    if (m_connectBar->connecting()) // meanwhile: what lives goes first
        return;
    if (m_markers->changedSinceLeft()) { // while it was read
        m_replacing->beforeMarkersGo(
            [this, path, kept = std::make_shared<capture::Capture>(std::move(imported))] {
                showImported(path, *kept);
            });
        return;
    }
    const QString released = releasedText(imported);
    const int left = m_selection->showFile(std::move(imported));
    m_workbench.events().clear();
    const QString sentence = tr("Imported %1.").arg(deviceText(path)) + leftText(left);
    if (released.isEmpty())
        say(Banner::Kind::Note, sentence);
    else
        say(Banner::Kind::Warning, sentence + QLatin1Char(' ') + released);
}

void MainWindow::runExport(const ExportOrder &order)
{
    // Everything in it, as it is now: then nothing is lost when a file takes its place.
    const auto done = [this, order, revision = m_workbench.capture().revision()](
                          const ExportResult &result) {
        if (result.allInIt)
            m_replacing->exported(revision);
        if (!result.ok()) {
            m_closeAfterExport = false; // somebody has to read why
            say(Banner::Kind::Warning, exportErrorText(order, result));
        } else if (order.picture) {
            m_settings.exportFolder = QFileInfo(order.path).path();
            say(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(order.path)));
        } else {
            exported(order.parts.first().path, order.motionLog);
        }
    };
    if (order.picture) {
        ExportResult result;
        result.path = order.path;
        result.last.file = writePicture(*m_scope, *order.picture, order.path);
        done(result);
        return;
    }
    auto *job = new FileJob(
        tr("Exporting %1").arg(deviceText(QFileInfo(order.path).fileName())),
        [order, done](const FileJob::Proceed &proceed) -> FileJob::Finish {
            const ExportResult result = carryOut(order, proceed);
            return [result, done] { done(result); };
        },
        this);
    job->setObjectName(QLatin1String(kExportJob));
    connect(job, &FileJob::over, this, [this] {
        if (std::exchange(m_closeAfterExport, false))
            close();
    });
}

void MainWindow::copyPicture()
{
    QGuiApplication::clipboard()->setImage(scopeImage(*m_scope));
    say(Banner::Kind::Note, tr("The picture of the scope is in the clipboard."));
}

void MainWindow::openRecording(const QString &path)
{
    widgets::openRecording(
        path, this, [this](OpenedRecording &opened) { showRecording(opened); },
        [this](const QString &sentence) { say(Banner::Kind::Warning, sentence); }, forFiles());
}

/// A file has time to wait for the disk.
capture::Capture::Config MainWindow::forFiles() const
{
    return {.maxBytes = kMostMemoryOfFile, .archive = m_workbench.archive(), .patient = true};
}

void MainWindow::askForRoom()
{
    auto *dialog = new SampleRoomDialog(*m_room, this);
    connect(dialog, &SampleRoomDialog::chosen, m_room, &SampleRoom::setWanted);
    dialog->open();
}

/// A file's signals, those that were streamed first; the ticked ones are shown.
void MainWindow::fillFileSignals()
{
    m_fileSignals->clear();
    m_fileSignals->setEnabled(m_workbench.signalPlan().showsFile());
    if (!m_workbench.signalPlan().showsFile())
        return;
    std::vector<capture::ChannelInfo> all = m_workbench.capture().channels();
    std::stable_sort(all.begin(), all.end(), [](const auto &one, const auto &other) {
        return one.kind != capture::ChannelInfo::Kind::Polled
            && other.kind == capture::ChannelInfo::Kind::Polled;
    });
    for (const capture::ChannelInfo &info : all) {
        QString text = deviceText(info.name);
        if (!info.unit.empty())
            text += QStringLiteral(" [%1]").arg(deviceText(info.unit));
        if (info.kind == capture::ChannelInfo::Kind::Polled)
            text = tr("%1, read one by one", "a signal").arg(text);
        QAction *action =
            m_fileSignals->addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setCheckable(true);
        action->setChecked(m_scope->plotOf(info.id) >= 0);
        connect(action, &QAction::triggered, this,
            [this, id = info.id](bool on) { m_selection->showOfFile(id, on); });
    }
}

void MainWindow::showRecording(OpenedRecording &opened)
{
    if (m_connectBar->connecting()) // meanwhile: what lives goes first
        return;
    if (m_markers->changedSinceLeft()) { // while it was read
        m_replacing->beforeMarkersGo(
            [this, kept = std::make_shared<OpenedRecording>(std::move(opened))] {
                showRecording(*kept);
            });
        return;
    }
    bool whole = true;
    QString sentence = openedText(opened, whole);
    sentence += leftText(m_selection->showFile(std::move(opened.capture)));
    fillEvents(m_workbench.events(), opened.report);
    m_markers->opened(opened.path, opened.report.bytes);
    m_recordedSnapshots = {opened.path, std::move(opened.report.snapshots)};
    if (m_snapshotPanel)
        m_snapshotPanel->offerRecorded(m_recordedSnapshots);
    say(whole ? Banner::Kind::Note : Banner::Kind::Warning, sentence);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_leaving->mayTurn()) {
        event->ignore();
        m_leaving->before({tr("Stopping the motors before Rotorscope ends\u2026"),
            tr("End Rotorscope all the same\u2026"), [this] { close(); }});
        return;
    }
    if (m_markers->changed() && !m_leaveMarkers) {
        event->ignore();
        m_replacing->beforeMarkersGo([this] {
            m_leaveMarkers = true;
            close();
            m_leaveMarkers = false;
        });
        return;
    }
    if (FileJob *job = exportUnderWay()) {
        event->ignore();
        askAboutExport(*job);
        return;
    }
    m_device.close();
    event->accept();
    Q_EMIT closed();
}

FileJob *MainWindow::exportUnderWay() const
{
    const auto jobs =
        findChildren<FileJob *>(QLatin1String(kExportJob), Qt::FindDirectChildrenOnly);
    const auto found =
        std::find_if(jobs.begin(), jobs.end(), [](const FileJob *job) { return job->underWay(); });
    return found == jobs.end() ? nullptr : *found;
}

/// Closing ends it, and with it the file that is not whole yet.
void MainWindow::askAboutExport(FileJob &job)
{
    const auto cancel = [this, job = QPointer(&job)] {
        m_closeAfterExport = false;
        if (job)
            job->cancel();
        close();
    };
    m_questions.ask({.name = "exportQuestion",
        .title = tr("Export"),
        .text = tr("An export is under way."),
        .more = tr("Without it there is no file."),
        .answers = {{Answer::Kind::Go, tr("Close when it is written"),
                        [this] { m_closeAfterExport = true; }},
            {Answer::Kind::Force, tr("Close without it"), cancel},
            {Answer::Kind::Stay, {}, [this] { m_closeAfterExport = false; }}}});
    connect(&job, &FileJob::over, this, [this] { m_questions.withdraw("exportQuestion"); });
}

} // namespace widgets

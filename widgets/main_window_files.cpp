// Files in the main window: recordings, export and import, and what of a file is shown where.
#include "widgets/connect_bar.h"
#include "widgets/device_text.h"
#include "widgets/event_recorder.h"
#include "widgets/export_order.h"
#include "widgets/file_job.h"
#include "widgets/file_prompt.h"
#include "widgets/import_csv.h"
#include "widgets/main_window.h"
#include "widgets/open_recording.h"
#include "widgets/record_control.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope_picture.h"

#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>

namespace widgets {

void MainWindow::makeRecording()
{
    m_record = new RecordControl({m_workbench.recording(), m_device, m_scope->events(), m_files,
                                     [this] { return m_recorder->now(); }},
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
    m_import = make(tr("&Import CSV\u2026"), "importCsv", Qt::CTRL | Qt::SHIFT | Qt::Key_O,
        &MainWindow::askForCsv);
    m_copyPicture = make(tr("&Copy the picture"), "copyPicture", Qt::CTRL | Qt::SHIFT | Qt::Key_C,
        &MainWindow::copyPicture);
    connect(m_record, &RecordControl::said, this, &MainWindow::say);
}

void MainWindow::say(Banner::Kind kind, const QString &sentence)
{
    m_told = Told::Other;
    m_banner->say(kind, sentence);
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
    m_files.askOpen(this, question, [this](const QString &path) { openRecording(path); });
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
    m_files.askOpen(this, question, [this](const QString &path) {
        importCsv(
            path, this,
            [this, path](capture::Capture &capture) {
                if (m_connectBar->connecting())
                    return;
                m_selection->showFile(std::move(capture));
                m_scope->events().clear();
                say(Banner::Kind::Note, tr("Imported %1.").arg(deviceText(path)));
            },
            [this](const QString &sentence) { say(Banner::Kind::Warning, sentence); });
    });
}

void MainWindow::runExport(const ExportOrder &order)
{
    const auto done = [this, order](const ExportResult &result) {
        if (!result.ok()) {
            say(Banner::Kind::Warning, exportErrorText(result));
        } else if (isPicture(order.format)) {
            m_settings.exportFolder = QFileInfo(order.path).path();
            say(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(order.path)));
        } else {
            exported(order.parts.first().path);
        }
    };
    if (isPicture(order.format)) {
        ExportResult result;
        result.file = writePicture(*m_scope, order.format, order.path);
        done(result);
        return;
    }
    new FileJob(
        tr("Exporting %1").arg(deviceText(QFileInfo(order.path).fileName())),
        [order, done](const FileJob::Proceed &proceed) -> FileJob::Finish {
            const ExportResult result = carryOut(order, proceed);
            return [result, done] { done(result); };
        },
        this);
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
        [this](const QString &sentence) { say(Banner::Kind::Warning, sentence); });
}

void MainWindow::showRecording(OpenedRecording &opened)
{
    if (m_connectBar->connecting()) // meanwhile: what lives goes first
        return;
    bool whole = true;
    const QString sentence = openedText(opened, whole);
    m_selection->showFile(std::move(opened.capture));
    fillEvents(m_scope->events(), opened.report);
    say(whole ? Banner::Kind::Note : Banner::Kind::Warning, sentence);
}

} // namespace widgets

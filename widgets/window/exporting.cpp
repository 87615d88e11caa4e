#include "widgets/window/exporting.h"

#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/files/export_dialog.h"
#include "widgets/files/scope_picture.h"
#include "widgets/scope/view.h"
#include "widgets/window/replacing.h"
#include "widgets/window/workbench.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>

#include <algorithm>
#include <utility>
#include <vector>

namespace widgets {

Exporting::Exporting(const Parts &parts, const QString &folder, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
    , m_folder(folder)
{
}

void Exporting::ask()
{
    if (m_outline) {
        Q_EMIT said(Banner::Kind::Warning,
            tr("The recording is still being read: its outline is not exported."));
        return;
    }
    auto *dialog = new ExportDialog(
        m_parts.workbench.capture(), m_parts.scope, m_parts.files, m_folder, m_parts.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // What was asked of this session's motors says nothing about a file's samples.
    dialog->setMotionLog([this] {
        return !m_parts.workbench.signalPlan().showsFile()
            && m_parts.workbench.motionLog().rowCount() > 0;
    });
    connect(dialog, &ExportDialog::wanted, this, &Exporting::carryOut);
    ScopeView &scope = m_parts.scope;
    if (scope.running()) {
        scope.setRunning(false);
        connect(dialog, &QDialog::finished, &scope, [&scope] { scope.setRunning(true); });
    }
    dialog->open();
}

void Exporting::carryOut(const ExportOrder &order)
{
    // Everything in it, as it is now: then nothing is lost when a file takes its place.
    const auto done = [this, order, revision = m_parts.workbench.capture().revision()](
                          const ExportResult &result) {
        if (result.allInIt)
            m_parts.replacing.exported(revision);
        ended(order, result);
    };
    if (order.picture) {
        ExportResult result;
        result.path = order.path;
        result.last.file = writePicture(m_parts.scope, *order.picture, order.path);
        done(result);
        return;
    }
    std::vector<session::LoggedMotion> log; // as it is now, too
    const std::size_t leftOut = m_parts.workbench.motionLog().leftOut();
    if (!order.motionLog.isEmpty())
        log = m_parts.workbench.motionLog().log();
    write(tr("Exporting %1").arg(fileNameText(order.path)),
        [order, done, leftOut, log = std::move(log)](
            const FileJob::Proceed &proceed) -> FileJob::Finish {
            ExportResult result = widgets::carryOut(order, proceed);
            if (result.ok() && !order.motionLog.isEmpty())
                result.logWrong = session::writeWholeFile(
                    order.motionLog, session::motionLogText(log, MotionLogModel::who(), leftOut));
            return [result, done] { done(result); };
        });
}

void Exporting::write(const QString &title, FileJob::Work work)
{
    auto *job = new FileJob(title, std::move(work), m_parts.window);
    m_jobs.removeAll(nullptr);
    m_jobs.append(job);
    connect(job, &FileJob::over, this, [this] {
        if (std::exchange(m_closeAfter, false))
            Q_EMIT closeWanted();
    });
}

void Exporting::ended(const ExportOrder &order, const ExportResult &result)
{
    if (!result.ok()) {
        m_closeAfter = false; // the user has to read why
        Q_EMIT said(Banner::Kind::Warning, exportErrorText(order, result));
    } else if (order.picture) {
        m_folder = QFileInfo(order.path).path();
        Q_EMIT said(Banner::Kind::Note, tr("Exported to %1.").arg(deviceText(order.path)));
    } else if (result.rows == 0) { // a file with headings alone
        m_folder = QFileInfo(order.path).path();
        Q_EMIT said(Banner::Kind::Warning,
            tr("%1 holds no samples: there are none in the chosen range.")
                .arg(deviceText(order.parts.first().path)));
    } else {
        tellCapture(order.parts.first().path, order.motionLog, result.logWrong);
    }
}

/// A capture is in this file; its motion log is in the other one, if that has a name.
void Exporting::tellCapture(const QString &path, const QString &motionLog, const QString &wrong)
{
    const QFileInfo file(path);
    m_folder = file.path();
    QString sentence = tr("Exported to %1.").arg(deviceText(file.filePath()));
    Banner::Kind kind = Banner::Kind::Note;
    if (!motionLog.isEmpty()) {
        const QString name = fileNameText(motionLog);
        if (!wrong.isEmpty())
            kind = Banner::Kind::Warning;
        sentence += QLatin1Char(' ')
            + (wrong.isEmpty()
                    ? tr("The motion log is in %1.").arg(name)
                    : tr("The motion log %1 could not be written (%2).").arg(name, wrong));
    }
    Q_EMIT said(kind, sentence);
    Q_EMIT exported();
}

void Exporting::copyPicture()
{
    QGuiApplication::clipboard()->setImage(scopeImage(m_parts.scope));
    Q_EMIT said(Banner::Kind::Note, tr("The picture of the scope is in the clipboard."));
}

FileJob *Exporting::underWay() const
{
    const auto found = std::find_if(m_jobs.begin(), m_jobs.end(),
        [](const QPointer<FileJob> &job) { return job && job->underWay(); });
    return found == m_jobs.end() ? nullptr : *found;
}

/// Closing ends it, and with it the file that is not whole yet.
bool Exporting::mayClose()
{
    FileJob *job = underWay();
    if (!job)
        return true;
    const auto cancel = [this, job = QPointer(job)] {
        m_closeAfter = false;
        if (job)
            job->cancel();
        Q_EMIT closeWanted();
    };
    m_parts.prompt.ask({.name = "exportQuestion",
        .title = tr("Export"),
        .text = tr("An export is under way."),
        .more = tr("Without it there is no file."),
        .answers = {
            {Answer::Kind::Go, tr("Close when it is written"), [this] { m_closeAfter = true; }},
            {Answer::Kind::Force, tr("Close without it"), cancel},
            {Answer::Kind::Stay, {}, [this] { m_closeAfter = false; }}}});
    // There is nothing to be asked any more.
    connect(job, &FileJob::over, this, [this] { m_parts.prompt.withdraw("exportQuestion"); });
    return false;
}

} // namespace widgets

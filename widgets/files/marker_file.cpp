#include "widgets/files/marker_file.h"

#include "widgets/base/device_text.h"
#include "widgets/files/file_job.h"
#include "widgets/files/file_prompt.h"
#include "widgets/scope/event_log.h"

#include <QAction>
#include <QFileInfo>

namespace widgets {

namespace {

/// What a file that has `saved` must be told so that it has `now`.
std::vector<record::Note> differences(
    const std::map<record::Nanos, QString> &saved, const std::map<record::Nanos, QString> &now)
{
    std::vector<record::Note> notes;
    for (const auto &[at, text] : now) {
        const auto before = saved.find(at);
        if (before == saved.end() || before->second != text)
            notes.push_back({at, at, text.toStdString()});
    }
    for (const auto &[at, text] : saved)
        if (!now.contains(at))
            notes.push_back(record::noNote(at));
    return notes;
}

} // namespace

MarkerFile::MarkerFile(
    EventLog &events, FilePrompt &files, std::function<bool()> shown, QWidget *window)
    : QObject(window)
    , m_events(events)
    , m_files(files)
    , m_shown(std::move(shown))
    , m_window(window)
    , m_save(new QAction(tr("&Save the markers\u2026"), this))
{
    m_save->setObjectName(QStringLiteral("saveMarkers"));
    m_save->setShortcut(Qt::CTRL | Qt::Key_S);
    window->addAction(m_save);
    connect(m_save, &QAction::triggered, this, &MarkerFile::ask);
    connect(&events, &QAbstractItemModel::modelReset, this, [this] {
        m_path.clear();
        update();
    });
    connect(&events, &EventLog::changed, this, &MarkerFile::update);
    update();
}

void MarkerFile::opened(const QString &path, qint64 bytes)
{
    m_path = path;
    m_known = {bytes, {}, {}};
    m_saved = markers();
    m_left.reset();
    update();
}

MarkerFile::Markers MarkerFile::markers() const
{
    Markers all;
    for (const ScopeEvent &event : m_events.events())
        if (event.kind == EventKind::Marker)
            all[capture::toNanos(event.seconds)] = event.text;
    return all;
}

bool MarkerFile::changed() const { return !m_path.isEmpty() && m_shown() && markers() != m_saved; }

void MarkerFile::leave() { m_left = markers(); }

bool MarkerFile::changedSinceLeft() const { return changed() && m_left != markers(); }

void MarkerFile::update()
{
    const bool possible = !m_path.isEmpty() && m_shown();
    m_save->setEnabled(changed());
    m_save->setToolTip(!possible
            ? tr("Markers are saved in recordings that are open; those of a connection are in its "
                 "recording (Ctrl+S)")
            : m_save->isEnabled()
            ? tr("Writes the markers into the recording, or into a copy of it (Ctrl+S)")
            : tr("The recording has the markers as they are (Ctrl+S)"));
}

void MarkerFile::ask()
{
    SaveQuestion question;
    question.title = tr("Save the recording with its markers");
    question.folder = QFileInfo(m_path).path();
    question.suggestedName = QFileInfo(m_path).fileName();
    question.filter = tr("Recordings (*.pcapng)");
    question.suffix = QStringLiteral("pcapng");
    m_files.askSave(m_window, question, [this](const QString &path) { saveAs(path); });
}

QString MarkerFile::refusal(const QString &path, const session::NotesResult &result) const
{
    if (result.outcome == session::NotesResult::Outcome::BeingWritten)
        return tr(
            "%1 has no end and changed just now: it seems that it is still being recorded, and "
            "what "
            "comes would be lost. Save a copy under another name, or wait until the recording has "
            "ended.")
            .arg(deviceText(path));
    return tr("The markers could not be saved to %1 (%2). What was there is as it was.")
        .arg(deviceText(path), deviceText(result.why));
}

void MarkerFile::saveAs(const QString &path)
{
    if (m_path.isEmpty())
        return; // meanwhile
    const Markers now = markers();
    new FileJob(
        tr("Saving %1").arg(deviceText(QFileInfo(path).fileName())),
        [this, path, now, source = m_path, known = m_known, notes = differences(m_saved, now)](

            const FileJob::Proceed &proceed) -> FileJob::Finish {
            bool cancelled = false;
            const auto result = session::saveNotes(source, path, notes,
                [&](double fraction) {
                    cancelled = !proceed(fraction);
                    return !cancelled;
                },
                {known.bytes, known.ownTime, QDateTime::currentDateTimeUtc()});
            if (cancelled)
                return {};
            return [this, path, now, source, result] {
                if (result.outcome != session::NotesResult::Outcome::Saved) {
                    Q_EMIT said(Banner::Kind::Warning, refusal(path, result));
                    return;
                }
                if (m_path == source) {
                    m_path = path;
                    m_known = result.target;
                    m_saved = now;
                    update();
                }
                Q_EMIT said(
                    Banner::Kind::Note, tr("Saved with its markers: %1.").arg(deviceText(path)));
            };
        },
        m_window);
}

} // namespace widgets

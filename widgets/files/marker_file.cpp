#include "widgets/files/marker_file.h"

#include "capture/csv_export.h"
#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/files/job.h"
#include "widgets/files/recording_control.h"
#include "widgets/scope/events/log.h"

#include <QAction>
#include <QFileInfo>

#include <algorithm>

namespace widgets {

namespace {

/// What a file that has `saved` must be told so that it has `now`.
std::vector<recorded::Note> differences(const Markers &saved, const Markers &now)
{
    std::vector<recorded::Note> notes;
    for (const auto &[at, text] : now) {
        const auto before = saved.find(at);
        if (before == saved.end() || before->second != text)
            notes.push_back({at, at, text.toStdString()});
    }
    for (const auto &[at, text] : saved)
        if (!now.contains(at))
            notes.push_back(recorded::noNote(at));
    return notes;
}

bool has(const Markers &markers, capture::Nanos at, const QString &text)
{
    const auto found = markers.find(at);
    return found != markers.end() && found->second == text;
}

/// As comma-separated text: a heading, then seconds and words, a line each; what a spreadsheet would take for a formula
/// gets a leading apostrophe (docs/csv.md).
QByteArray markerList(const Markers &markers)
{
    QByteArray list("time [s],marker\n");
    capture::ChannelInfo words; // headings are marked the same way
    for (const auto &[at, text] : markers) {
        words.name = text.toStdString();
        list += QByteArray::fromStdString(capture::csvTime(at)) + ','
            + QByteArray::fromStdString(capture::csvHeading(words)) + '\n';
    }
    return list;
}

} // namespace

MarkerFile::MarkerFile(
    EventLog &events, FilePrompt &files, RecordingControl &record, QWidget *window)
    : QObject(window)
    , m_events(events)
    , m_files(files)
    , m_record(record)
    , m_window(window)
    , m_save(new QAction(tr("&Save the markers\u2026"), this))
{
    m_save->setObjectName(QStringLiteral("saveMarkers"));
    m_save->setShortcut(Qt::CTRL | Qt::Key_S);
    window->addAction(m_save);
    connect(m_save, &QAction::triggered, this, [this] { saveThen({}); });
    connect(&record, &RecordingControl::ended, this, &MarkerFile::ended);
    connect(record.toggle(), &QAction::changed, this, &MarkerFile::update);
    connect(&events, &QAbstractItemModel::modelReset, this, [this] {
        m_path.clear();
        m_opened = false;
        m_saved.clear();
        m_elsewhere.clear();
        m_left.reset();
        update();
    });
    // Most of what happens is no marker.
    connect(&events, &QAbstractItemModel::rowsInserted, this, &MarkerFile::updateFor);
    connect(&events, &QAbstractItemModel::dataChanged, this,
        [this](const QModelIndex &from, const QModelIndex &to) {
            updateFor({}, from.row(), to.row());
        });
    connect(&events, &QAbstractItemModel::rowsAboutToBeRemoved, this,
        [this](
            const QModelIndex &, int first, int last) { m_markerGoes = anyMarker(first, last); });
    connect(&events, &QAbstractItemModel::rowsRemoved, this, [this] {
        if (std::exchange(m_markerGoes, false))
            update();
    });
    update();
}

void MarkerFile::opened(const QString &path, qint64 bytes)
{
    m_path = path;
    m_opened = true;
    m_known = {bytes, {}, {}};
    m_saved = markersOf(m_events);
    m_left.reset();
    update();
}

void MarkerFile::replayed(double seconds)
{
    constexpr capture::Nanos kSame = 1000; // as addReplayed() takes times for the same
    const capture::Nanos at = capture::toNanos(seconds);
    const Markers now = markersOf(m_events);
    for (auto found = now.lower_bound(at - kSame); found != now.end() && found->first <= at + kSame;
         ++found)
        m_elsewhere[found->first] = found->second;
    update();
}

/// Of what is shown; an earlier recording of it keeps what it has.
void MarkerFile::ended(const QString &path, qint64 bytes, const Markers &markers)
{
    for (const auto &[at, text] : m_saved)
        m_elsewhere[at] = text;
    m_path = path;
    m_opened = false;
    m_known = {bytes, {}, {}};
    m_saved = markers;
    update();
}

/// As it was when it ended, or when markers were saved into it last.
bool MarkerFile::isThere() const
{
    return !m_path.isEmpty() && QFileInfo(m_path).size() == m_known.bytes;
}

MarkerFile::Place MarkerFile::place() const
{
    return m_opened       ? Place::Opened
        : m_record.told() ? Place::Running
        : isThere()       ? Place::Recorded
                          : Place::List;
}

bool MarkerFile::changed() const
{
    const Markers now = markersOf(m_events);
    if (m_opened)
        return now != m_saved;
    const Markers *told = m_record.told();
    const bool there = isThere();
    const auto kept = [&](const auto &marker) {
        const auto &[at, text] = marker;
        return has(m_elsewhere, at, text) || (told && has(*told, at, text))
            || (there && has(m_saved, at, text));
    };
    if (!std::all_of(now.begin(), now.end(), kept))
        return true;
    return !told && there
        && std::any_of(m_saved.begin(), m_saved.end(),
            [&now](const auto &marker) { return !now.contains(marker.first); });
}

void MarkerFile::leave() { m_left = markersOf(m_events); }

bool MarkerFile::changedSinceLeft() const { return changed() && m_left != markersOf(m_events); }

bool MarkerFile::anyMarker(int first, int last) const
{
    const auto &events = m_events.events();
    return std::any_of(events.begin() + first, events.begin() + last + 1,
        [](const ScopeEvent &event) { return event.kind == EventKind::Marker; });
}

void MarkerFile::updateFor(const QModelIndex &, int first, int last)
{
    if (anyMarker(first, last))
        update();
}

void MarkerFile::update()
{
    m_save->setEnabled(changed());
    if (!m_save->isEnabled()) {
        m_save->setToolTip(markersOf(m_events).empty()
                ? tr("There are no markers; M sets one (Ctrl+S)")
                : tr("All markers are saved as they are (Ctrl+S)"));
        return;
    }
    m_save->setToolTip(m_opened
            ? tr("Writes the markers into the recording, or into a copy of it (Ctrl+S)")
            : place() == Place::List
            ? tr("Writes times and words of the markers to a list, because there is no recording "
                 "that takes them (Ctrl+S)")
            : tr("Writes the markers into the recording of the connection (Ctrl+S)"));
}

void MarkerFile::saveThen(std::function<void()> goOn)
{
    switch (place()) {
    case Place::Opened:
        askForCopy(std::move(goOn));
        break;
    case Place::Recorded:
        saveAs(m_path, std::move(goOn));
        break;
    case Place::List:
        askForList(std::move(goOn));
        break;
    case Place::Running:
        m_record.tellMarkers();
        update();
        if (changed()) {
            Q_EMIT said(Banner::Kind::Warning,
                tr("The recording is just being ended. Save the markers again when it has."));
            break;
        }
        Q_EMIT said(Banner::Kind::Note, tr("The markers are in the recording that runs."));
        if (goOn)
            goOn();
        break;
    }
}

void MarkerFile::askForCopy(std::function<void()> goOn)
{
    const QFileInfo file(m_path);
    const SaveQuestion question{tr("Save the recording with its markers"), file.path(),
        file.fileName(), tr("Recordings (*.pcapng)"), QStringLiteral("pcapng")};
    m_files.askSave(m_window, question,
        [this, goOn = std::move(goOn)](const QString &path) { saveAs(path, goOn); });
}

void MarkerFile::askForList(std::function<void()> goOn)
{
    const QString time =
        QLocale::c().toString(QDateTime::currentDateTime(), QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    const SaveQuestion question{tr("Save the markers as a list"), orHome(m_record.folder()),
        time + QStringLiteral("_markers.csv"), tr("CSV files (*.csv)"), QStringLiteral("csv")};
    m_files.askSave(m_window, question, [this, goOn = std::move(goOn)](const QString &path) {
        const Markers now = markersOf(m_events);
        if (const QString why = session::writeWholeFile(path, markerList(now)); !why.isEmpty()) {
            Q_EMIT said(Banner::Kind::Warning,
                tr("The markers could not be saved to %1 (%2). What was there is as it was.")
                    .arg(deviceText(path), deviceText(why)));
            return;
        }
        m_elsewhere = now;
        update();
        Q_EMIT said(Banner::Kind::Note, tr("The markers are in %1.").arg(deviceText(path)));
        if (goOn)
            goOn();
    });
}

QString MarkerFile::refusal(const QString &path, const session::NotesResult &result) const
{
    if (result.outcome == session::NotesResult::Outcome::BeingWritten)
        return tr(
            "%1 is still being recorded, as it seems, and what comes would be lost. Save a copy "
            "under another name, or wait until the recording has ended.")
            .arg(deviceText(path));
    return tr("The markers could not be saved to %1 (%2). What was there is as it was.")
        .arg(deviceText(path), deviceText(result.why));
}

void MarkerFile::saveAs(const QString &path, std::function<void()> goOn)
{
    if (m_path.isEmpty())
        return; // meanwhile
    const Markers now = markersOf(m_events);
    new FileJob(
        tr("Saving %1").arg(fileNameText(path)),
        [this, path, now, goOn = std::move(goOn), source = m_path, known = m_known,
            notes = differences(m_saved, now)](const FileJob::Proceed &proceed) -> FileJob::Finish {
            bool cancelled = false;
            const auto result = session::saveNotes(source, path, notes,
                [&](double fraction) {
                    cancelled = !proceed(fraction);
                    return !cancelled;
                },
                {known.bytes, known.ownTime, QDateTime::currentDateTimeUtc()});
            if (cancelled)
                return {};
            return
                [this, path, now, source, result, goOn] { saved(source, path, now, result, goOn); };
        },
        m_window);
}

void MarkerFile::saved(const QString &source, const QString &path, const Markers &markers,
    const session::NotesResult &result, const std::function<void()> &goOn)
{
    if (result.outcome != session::NotesResult::Outcome::Saved) {
        Q_EMIT said(Banner::Kind::Warning, refusal(path, result));
        return;
    }
    m_record.markersSaved(path, result.target.bytes);
    if (m_path == source) {
        m_path = path;
        m_known = result.target;
        m_saved = markers;
        update();
    }
    Q_EMIT said(Banner::Kind::Note, tr("Saved with its markers: %1.").arg(deviceText(path)));
    if (goOn && !changed()) // meanwhile
        goOn();
}

} // namespace widgets

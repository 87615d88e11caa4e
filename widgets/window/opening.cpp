#include "widgets/window/opening.h"

#include "session/transports/recording_transport.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/question.h"
#include "widgets/files/import_csv.h"
#include "widgets/files/job.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/open_recording.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/window/leaving.h"
#include "widgets/window/replacing.h"
#include "widgets/window/workbench.h"

#include <QFileInfo>

#include <algorithm>
#include <limits>
#include <utility>

namespace widgets {
namespace {

/// Of a file's signals, that the scope has no room for so many.
QString leftText(int signalsLeft)
{
    return signalsLeft == 0 ? QString()
                            : QLatin1Char(' ')
            + Opening::tr("%n signal(s) of it are not shown: see Scope, Signals of the file.",
                nullptr, signalsLeft);
}

} // namespace

Opening::Opening(Parts parts, QObject *parent)
    : QObject(parent)
    , m_parts(std::move(parts))
{
    connect(
        &m_parts.workbench.device(), &Device::portStateChanged, this,
        [this] {
            if (m_next && !m_parts.connecting())
                std::exchange(m_next, nullptr)();
        },
        Qt::QueuedConnection); // others are told of the end first
}

void Opening::warn(const QString &sentence) { Q_EMIT said(Banner::Kind::Warning, sentence); }

void Opening::whenDisconnected(std::function<void()> goOn)
{
    if (m_parts.connecting())
        m_next = std::move(goOn);
    else
        goOn();
}

/// What is connected goes first, if that is wanted; then it begins again. What its samples are worth is asked before:
/// a user who cancels keeps the board.
/// @param lay  what can be done beside it; none: nothing
bool Opening::isFree(const QString &title, const QString &text, const std::function<void()> &again,
    const std::function<void()> &lay)
{
    m_next = nullptr;
    if (!m_parts.connecting())
        return true;
    m_agreed = false; // to what was held then
    if (m_parts.prompt.asks("disconnectQuestion"))
        return false;
    const auto leave = [this, again] {
        m_parts.replacing.before([this, again] {
            Q_EMIT disconnectWanted([this, again] {
                m_agreed = true;
                again();
            });
        });
    };
    QList<Answer> answers{
        {Answer::Kind::Go, tr("&Disconnect and go on"), leave, "disconnectAndGoOn"}};
    if (lay && m_parts.lay)
        answers.append({Answer::Kind::Go, tr("Open as a &reference"), lay, "layAsReference"});
    answers.append(Answer());
    m_parts.prompt.ask({.name = "disconnectQuestion",
        .title = title,
        .text = text,
        .more = {},
        .answers = answers});
    return false;
}

/// What takes the place of a connection that is over, perhaps with a motor that turns.
void Opening::leaveThen(std::function<void()> go)
{
    m_parts.leaving.before({tr("Stopping the motors before something else is opened\u2026"),
        tr("Open it all the same\u2026"), std::move(go)});
}

/// The same, and what the scope holds goes, which is asked once: here, or before the connection was left.
void Opening::replaceThen(std::function<void()> go)
{
    leaveThen([this, agreed = std::exchange(m_agreed, false), go = std::move(go)] {
        agreed ? go() : m_parts.replacing.before(go);
    });
}

/// Markers of a connection stay for the next one.
void Opening::beforeConnecting(std::function<void()> goOn)
{
    leaveThen([this, goOn = std::move(goOn)] {
        if (m_parts.workbench.signalPlan().showsFile())
            m_parts.replacing.beforeMarkersGo(goOn);
        else
            goOn();
    });
}

void Opening::ask(const OpenQuestion &question, Opened open)
{
    replaceThen([this, question, open = std::move(open)] {
        m_parts.files.askOpen(m_parts.window, question, open);
    });
}

void Opening::askForRecording()
{
    if (!isFree(
            tr("Open a recording"), tr("A recording takes the place of what the scope shows."),
            [this] { askForRecording(); }, [this] { askForReference(); }))
        return;
    ask({tr("Open a recording"), orHome(m_parts.recordFolder()), tr("Recordings (*.pcapng)")},
        [this](const QString &path) { open(path); });
}

void Opening::askForReference()
{
    m_parts.files.askOpen(m_parts.window,
        {tr("Open a recording as a reference"), orHome(m_parts.recordFolder()),
            tr("Recordings (*.pcapng)")},
        [this](const QString &path) { layBeside(path); });
}

/// What is connected, and what was recorded of it, stay as they are.
void Opening::layBeside(const QString &path)
{
    openRecording(
        path, m_parts.window,
        [this](OpenedRecording &opened) {
            bool good = false;
            const QString sentence = m_parts.lay(opened, good);
            Q_EMIT said(good ? Banner::Kind::Note : Banner::Kind::Warning, sentence);
            if (good)
                Q_EMIT used(opened.path);
        },
        [this](const QString &sentence) { warn(sentence); }, forFiles());
}

/// The scope's trigger, its measurements and another recording see no difference to a board.
void Opening::askForReplay()
{
    if (!isFree(tr("Replay a recording"), tr("A replay takes the place of a board."),
            [this] { askForReplay(); }))
        return;
    ask({tr("Replay a recording"), orHome(m_parts.recordFolder()), tr("Recordings (*.pcapng)")},
        [this](const QString &path) { replay(path); });
}

void Opening::askForCsv()
{
    if (!isFree(tr("Import CSV"), tr("What is imported takes the place of what the scope shows."),
            [this] { askForCsv(); }))
        return;
    ask({tr("Import CSV"), orHome(m_parts.exportFolder()), tr("CSV files (*.csv *.txt)")},
        [this](const QString &path) { import(path); });
}

void Opening::openPath(const QString &path)
{
    const bool csv = path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive)
        || path.endsWith(QLatin1String(".txt"), Qt::CaseInsensitive);
    const auto beside = csv ? std::function<void()>() : [this, path] { layBeside(path); };
    if (!isFree(
            tr("Open a recording"), tr("A recording takes the place of what the scope shows."),
            [this, path] { openPath(path); }, beside))
        return;
    replaceThen([this, path, csv] { csv ? import(path) : open(path); });
}

/// A large one has an outline of itself at its end, which is there at once.
void Opening::open(const QString &path)
{
    if (QFileInfo(path).size() < m_parts.outlineFrom)
        return read(path);
    new FileJob(
        tr("Opening %1").arg(fileNameText(path)),
        [this, path](const FileJob::Proceed &) -> FileJob::Finish {
            const auto outline = std::make_shared<capture::Capture>();
            const bool there = session::readOverview(path, *outline);
            return [this, path, outline, there] {
                if (there)
                    showOutline(path, *outline);
                read(path);
            };
        },
        m_parts.window);
}

void Opening::read(const QString &path)
{
    FileJob *job = openRecording(
        path, m_parts.window, [this](OpenedRecording &opened) { show(opened); },
        [this](const QString &sentence) { warn(sentence); }, forFiles());
    connect(job, &FileJob::over, this, [this] {
        if (!std::exchange(m_outline, false))
            return;
        Q_EMIT outlineShown(false);
        if (m_parts.connecting())
            return;
        // It was not read: an outline is no recording.
        m_parts.selection.showFile(capture::Capture());
        m_shown.clear();
    });
}

void Opening::showOutline(const QString &path, capture::Capture &outline)
{
    if (m_parts.connecting() || m_parts.markers.changedSinceLeft())
        return; // what is to become of that is asked once it is read
    m_outline = true;
    m_shown = path;
    m_parts.selection.showFile(std::move(outline));
    m_parts.workbench.events().clear();
    Q_EMIT outlineShown(true);
    Q_EMIT said(Banner::Kind::Note,
        tr("%1 is being read. Until then its outline is shown: the extremes of its fast signals.")
            .arg(deviceText(path)));
}

void Opening::replay(const QString &path)
{
    if (session::isRecordingFile(path))
        Q_EMIT replayWanted(path);
    else
        warn(tr("%1 is no recording of Rotorscope.").arg(deviceText(path)));
}

void Opening::import(const QString &path)
{
    importCsv(
        path, m_parts.window,
        [this, path](capture::Capture &imported, std::uint64_t leftOut) {
            showImported(path, imported, leftOut);
        },
        [this](const QString &sentence) { warn(sentence); }, forFiles());
}

/// A file has time to wait for the disk.
capture::Capture::Config Opening::forFiles() const
{
    return {.maxBytes = kMostMemoryOfFile, .archive = m_parts.workbench.archive(), .patient = true};
}

void Opening::show(OpenedRecording &opened)
{
    if (m_parts.connecting()) // meanwhile: what lives goes first
        return;
    if (m_parts.markers.changedSinceLeft()) { // while it was read
        m_parts.replacing.beforeMarkersGo(
            [this, kept = std::make_shared<OpenedRecording>(std::move(opened))] { show(*kept); });
        return;
    }
    if (std::exchange(m_outline, false))
        Q_EMIT outlineShown(false);
    m_shown = opened.path;
    bool whole = true;
    QString sentence = openedText(opened, whole);
    sentence += leftText(m_parts.selection.showFile(std::move(opened.capture)));
    fillEvents(m_parts.workbench.events(), opened.report);
    m_parts.markers.opened(opened.path, opened.report.bytes);
    m_snapshots = {opened.path, std::move(opened.report.snapshots)};
    Q_EMIT used(opened.path);
    Q_EMIT snapshotsChanged();
    Q_EMIT said(whole ? Banner::Kind::Note : Banner::Kind::Warning, sentence);
}

void Opening::showImported(const QString &path, capture::Capture &imported, std::uint64_t leftOut)
{
    if (m_parts.connecting()) // meanwhile: what lives goes first
        return;
    if (m_parts.markers.changedSinceLeft()) { // while it was read
        m_parts.replacing.beforeMarkersGo(
            [this, path, leftOut, kept = std::make_shared<capture::Capture>(std::move(imported))] {
                showImported(path, *kept, leftOut);
            });
        return;
    }
    m_shown = path;
    QStringList lacks{releasedText(imported)};
    if (leftOut > 0)
        lacks.append(tr("%n row(s) have the time of the row before and were left out.", nullptr,
            static_cast<int>(std::min<std::uint64_t>(leftOut, std::numeric_limits<int>::max()))));
    lacks.removeAll(QString());
    const int left = m_parts.selection.showFile(std::move(imported));
    m_parts.workbench.events().clear();
    Q_EMIT used(path);
    const QString sentence = tr("Imported %1.").arg(deviceText(path)) + leftText(left);
    if (lacks.isEmpty())
        Q_EMIT said(Banner::Kind::Note, sentence);
    else
        warn(sentence + QLatin1Char(' ') + lacks.join(QLatin1Char(' ')));
}

} // namespace widgets

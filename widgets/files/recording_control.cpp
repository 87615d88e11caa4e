#include "widgets/files/recording_control.h"

#include "session/files/problems.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/lamp.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"
#include "widgets/scope/events/log.h"

#include <QAction>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>

#include <algorithm>

namespace widgets {
namespace {

constexpr double kMega = 1e6;
constexpr double kLongest = 100.0 * 3600.0; ///< seconds left on the disk that are worth a number

} // namespace

QString suggestedRecordingName(const QDateTime &now)
{
    return QLocale::c().toString(now, QStringLiteral("yyyy-MM-dd_HH-mm-ss"))
        + QStringLiteral("_motor.pcapng");
}

QString durationText(double seconds)
{
    const auto whole = static_cast<qint64>(std::max(0.0, seconds));
    return QStringLiteral("%1:%2:%3")
        .arg(QString::number(whole / 3600),
            QString::number(whole / 60 % 60).rightJustified(2, QLatin1Char('0')),
            QString::number(whole % 60).rightJustified(2, QLatin1Char('0')));
}

RecordingControl::RecordingControl(Parts parts, const QString &folder, QWidget *window)
    : QObject(window)
    , m_parts(std::move(parts))
    , m_folder(folder)
    , m_toggle(named(new QAction(this), "record"))
    , m_withLink(named(new QAction(tr("With the bytes of the &line"), this), "recordLink"))
    , m_line(named(new Lamp(tr("Recording"), window), "recordLine"))
{
    m_toggle->setCheckable(true);
    m_toggle->setShortcut(Qt::CTRL | Qt::Key_R);
    window->addAction(m_toggle);
    m_withLink->setCheckable(true);
    m_withLink->setToolTip(tr("Twice the size; keeps what was on the line byte for byte"));
    m_line->setContentsMargins(kGrid, 0, kGrid, kHalfGrid);
    m_line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // never makes the window wider
    keepPlace(*m_line); // what is below stays where it is
    m_line->hide();

    using session::Recording;
    const Recording *recording = &m_parts.recording;
    connect(m_toggle, &QAction::triggered, this, &RecordingControl::ask);
    connect(recording, &Recording::started, this, &RecordingControl::started);
    connect(recording, &Recording::progressed, this, &RecordingControl::progressed);
    connect(recording, &Recording::finished, this, &RecordingControl::finished);
    connect(&m_parts.device, &Device::portStateChanged, this, [this] {
        // Closed by the user; an unplugged cable comes back, and the recording waits for it.
        const bool wanted = m_parts.device.portError().problem == session::PortProblem::None;
        if (!m_parts.device.portOpen() && wanted)
            m_parts.recording.stop();
        update();
    });
    connect(
        &m_parts.events, &QAbstractItemModel::rowsInserted, this, &RecordingControl::recordMarks);
    connect(&m_parts.events, &QAbstractItemModel::rowsAboutToBeRemoved, this,
        [this](const QModelIndex &, int first, int last) { takeBackMarks(first, last); });
    // What comes is of something else.
    connect(&m_parts.events, &QAbstractItemModel::modelReset, this, [this] { m_told.reset(); });
    connect(&m_parts.events, &QAbstractItemModel::dataChanged, this,
        [this](const QModelIndex &from, const QModelIndex &to) {
            if (from.column() == EventLog::TextColumn)
                recordMarks({}, from.row(), to.row());
        });
    update();
}

QStringList RecordingControl::signs()
{
    return {tr("REC", "a recording can begin"), tr("End", "the recording")};
}

void RecordingControl::update()
{
    const bool running = m_parts.recording.running();
    m_toggle->setChecked(running);
    m_toggle->setEnabled(running || m_parts.device.portOpen());
    setLineIcon(*m_toggle, running ? "record-end" : "record");
    m_toggle->setText(running ? tr("E&nd the recording") : tr("&Record to disk\u2026"));
    // The bar has little room; menus and screen readers get the words, and the shape says which it is.
    m_toggle->setIconText(signs().at(running ? 1 : 0));
    m_toggle->setToolTip(running ? tr("Ends the file on the disk (Ctrl+R)")
            : m_parts.device.portOpen()
            ? tr("Writes all samples, values and events to a file while they come (Ctrl+R)")
            : tr("Connect first: a recording is of a connection (Ctrl+R)"));
    m_withLink->setEnabled(!running);
}

void RecordingControl::ask()
{
    update(); // what the click switched is not yet so
    if (m_parts.recording.running()) {
        m_parts.recording.stop();
        return;
    }
    const SaveQuestion question{tr("Record to disk"), orHome(m_folder),
        suggestedRecordingName(QDateTime::currentDateTime()), tr("Recordings (*.pcapng)"),
        QStringLiteral("pcapng")};
    m_parts.files.askSave(m_line->window(), question, [this](const QString &path) { start(path); });
}

void RecordingControl::start(const QString &path)
{
    using Content = session::RecordingTap::Content;
    const session::Endpoint &endpoint = m_parts.device.endpoint();
    m_kept.reset();
    m_told.emplace();
    const bool simulated = endpoint.kind == session::Endpoint::Kind::Simulator;
    m_parts.recording.start(path,
        m_withLink->isChecked() ? Content::SamplesAndLink : Content::Samples,
        QStringLiteral("Rotorscope ") + QCoreApplication::applicationVersion(),
        simulated ? QStringLiteral("simulated board") : endpoint.path);
    update();
}

void RecordingControl::started(const QString &path)
{
    m_folder = QFileInfo(path).path();
    m_start = m_parts.now();
    m_name = fileNameText(path);
    m_line->show(Lamp::Light::On, m_name);
    m_line->setToolTip(deviceText(path).toHtmlEscaped());
    m_line->setVisible(true);
    m_parts.events.add(EventKind::Command, m_start, tr("Recording to %1").arg(fileNameText(path)));
    update();
}

void RecordingControl::progressed(const session::RecordingProgress &progress)
{
    QString text = tr("%1, %2 MB", "duration, size")
                       .arg(durationText(m_parts.now() - m_start),
                           numberText(static_cast<double>(progress.counts.bytes) / kMega, 1));
    const double left = progress.roomBytes < 0 || progress.bytesPerSecond <= 0.0
        ? kLongest
        : static_cast<double>(progress.roomBytes) / progress.bytesPerSecond;
    if (left < kLongest)
        text += tr(", disk full in %1", "duration").arg(durationText(left));
    else if (progress.freeBytes >= 0)
        text += tr(", %1 GB free", "on the disk")
                    .arg(numberText(static_cast<double>(progress.freeBytes) / 1e9, 1));
    const bool lost = progress.lost != recorded::Lost{};
    if (lost)
        text += tr(", %1 lost", "samples and more")
                    .arg(session::lostText(progress.lost, translatedFileProblem));
    m_line->show(progress.lowSpace || lost ? Lamp::Light::Waiting : Lamp::Light::On,
        m_name + QStringLiteral(": ") + text);
}

void RecordingControl::finished(const session::RecordingResult &result)
{
    using session::RecordingOutcome;
    const QString name = fileNameText(result.path);
    const QString why = deviceText(result.systemText);
    const std::optional<Markers> told = std::exchange(m_told, {});
    update();
    if (result.complete)
        m_kept = {result.path, static_cast<qint64>(result.last.counts.bytes), result.coverage};
    // What a disk took that failed is not known.
    if (told && result.outcome != RecordingOutcome::CannotOpen)
        Q_EMIT ended(result.path, QFileInfo(result.path).size(),
            result.outcome == RecordingOutcome::Stopped ? *told : Markers());
    if (result.outcome == RecordingOutcome::CannotOpen) {
        Q_EMIT said(Banner::Kind::Warning,
            tr("%1 cannot be recorded (%2). Choose a name that is not there yet, in a folder that "
               "takes files.")
                .arg(name, why));
        return;
    }
    const QString size = numberText(static_cast<double>(result.last.counts.bytes) / kMega, 1);
    m_line->setVisible(result.outcome != RecordingOutcome::Stopped);
    switch (result.outcome) {
    case RecordingOutcome::CannotOpen:
        break;
    case RecordingOutcome::Stopped:
        m_parts.events.add(EventKind::Command, m_parts.now(), tr("Recording ended: %1").arg(name));
        if (result.last.lost == recorded::Lost{})
            Q_EMIT said(Banner::Kind::Note,
                tr("Recorded to %1: %2 MB.", "path, size").arg(deviceText(result.path), size));
        else
            Q_EMIT said(Banner::Kind::Warning,
                tr("Recorded to %1: %2 MB, without %3, because the disk was too slow.")
                    .arg(deviceText(result.path), size,
                        session::lostText(result.last.lost, translatedFileProblem)));
        break;
    case RecordingOutcome::DiskFull:
        m_line->show(Lamp::Light::Bad, m_name + QStringLiteral(": ") + tr("ended, disk full"));
        m_parts.events.add(EventKind::Loss, m_parts.now(), tr("Recording ended: disk full"));
        Q_EMIT said(Banner::Kind::Bad,
            tr("The disk is full: the recording %1 ends here, with %2 MB. What was recorded is in "
               "it, and the connection goes on.")
                .arg(name, size));
        break;
    case RecordingOutcome::WriteFailed:
        m_line->show(Lamp::Light::Bad, m_name + QStringLiteral(": ") + tr("ended, disk failed"));
        m_parts.events.add(EventKind::Loss, m_parts.now(), tr("Recording ended: disk failed"));
        Q_EMIT said(Banner::Kind::Bad,
            tr("The disk failed (%3): the recording %1 ends here, with %2 MB. What was recorded is "
               "in it, and the connection goes on.")
                .arg(name, size, why));
        break;
    }
}

bool RecordingControl::holds(const capture::Capture &capture) const
{
    return m_kept && QFileInfo(m_kept->path).size() == m_kept->bytes
        && m_kept->coverage.holds(capture);
}

void RecordingControl::markersSaved(const QString &path, qint64 bytes)
{
    if (m_kept && m_kept->path == path)
        m_kept->bytes = bytes;
}

const Markers *RecordingControl::told() const
{
    return m_told && m_parts.recording.running() ? &*m_told : nullptr;
}

void RecordingControl::tellMarkers()
{
    if (!m_told)
        return;
    const auto &events = m_parts.events.events();
    for (int row = 0; row < static_cast<int>(events.size()); ++row) {
        const ScopeEvent &event = events[static_cast<std::size_t>(row)];
        const auto told = m_told->find(capture::toNanos(event.seconds));
        if (told == m_told->end() || told->second != event.text)
            recordMarks({}, row, row);
    }
}

/// Markers that the user deletes while their recording runs are not in it, either.
void RecordingControl::takeBackMarks(int first, int last)
{
    const auto &events = m_parts.events.events();
    for (auto row = static_cast<std::size_t>(first);
         row <= static_cast<std::size_t>(last) && row < events.size(); ++row) {
        const recorded::Nanos at = capture::toNanos(events[row].seconds);
        if (events[row].kind == EventKind::Marker && m_told && m_told->contains(at)
            && m_parts.recording.add(at, recorded::noNote(at)))
            m_told->erase(at);
    }
}

/// A marker, or a new text of one: opening the recording takes the last note of a time.
void RecordingControl::recordMarks(const QModelIndex &, int first, int last)
{
    const auto &events = m_parts.events.events();
    for (auto row = static_cast<std::size_t>(first);
         row <= static_cast<std::size_t>(last) && row < events.size(); ++row) {
        const ScopeEvent &event = events[row];
        if (event.kind != EventKind::Marker)
            continue;
        const recorded::Nanos at = capture::toNanos(event.seconds);
        if (m_told && m_parts.recording.add(at, recorded::Note{at, at, event.text.toStdString()}))
            (*m_told)[at] = event.text;
    }
}

} // namespace widgets

#include "recording_work.h"

#include "output.h"
#include "session/archive/disk_archive.h"
#include "session/files/problems.h"
#include "session/files/snapshot_json.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QTimer>

namespace cli {

using namespace std::chrono_literals;
using session::RecordingOutcome;

namespace {
constexpr auto kOpenWithin = 10s;
constexpr auto kCloseWithin = 60s; ///< a slow disk may have a lot to write
constexpr std::size_t kMostMemory = 4'000'000'000; ///< of samples

/// What does not fit into memory waits on a disk, as in the window.
capture::Capture::Config roomForAFile()
{
    const QString folder = session::archiveFolder();
    auto archive =
        std::make_shared<session::DiskArchive>(session::DiskArchive::Config{.folder = folder});
    archive->setBudget(session::usualArchiveBudget(folder));
    return {.maxBytes = kMostMemory, .archive = std::move(archive), .patient = true};
}

/// About samples that there was no room for.
QString roomText(const capture::Capture &capture)
{
    const auto span = capture.timeSpan();
    if (capture.released() == 0 || !span)
        return {};
    return QStringLiteral("%1 samples before %2 s are left out, because there is no room for them; "
                          "make some in %3")
        .arg(QString::number(capture.released()), numberText(span->from), session::archiveFolder());
}

} // namespace

Outcome<std::unique_ptr<OpenedRecording>> openRecording(const QString &path)
{
    auto opened =
        std::make_unique<OpenedRecording>(OpenedRecording{capture::Capture(roomForAFile()), {}});
    auto report = session::readRecording(path, opened->capture);
    if (!report)
        return failure(kFileError,
            QStringLiteral("%1 cannot be read: %2; check its name.").arg(path, report.error()));
    opened->report = std::move(*report);
    return opened;
}

Outcome<std::unique_ptr<ImportedCsv>> importCsv(const QString &path)
{
    QFile file(path);
    const auto refused = [&path](const QString &why) {
        return failure(kFileError, QStringLiteral("%1 cannot be read: %2.").arg(path, why));
    };
    if (!file.open(QIODevice::ReadOnly))
        return refused(file.errorString());
    auto csv = std::make_unique<ImportedCsv>(ImportedCsv{capture::Capture(roomForAFile())});
    capture::CsvImport import(csv->capture);
    bool goesOn = true;
    while (goesOn && !file.atEnd()) {
        const QByteArray piece = file.read(1 << 20);
        goesOn = import.feed({piece.constData(), static_cast<std::size_t>(piece.size())});
    }
    if (!import.finish())
        return refused(session::csvProblemText(*import.error()));
    csv->leftOut = import.leftOut();
    return csv;
}

QString lackText(const ImportedCsv &csv)
{
    QStringList lacks{roomText(csv.capture)};
    if (csv.leftOut == 1)
        lacks.append(QStringLiteral("1 row has the time of the row before and was left out"));
    else if (csv.leftOut > 0)
        lacks.append(QStringLiteral("%1 rows have the time of the row before and were left out")
                         .arg(csv.leftOut));
    lacks.removeAll(QString());
    return lacks.join(QStringLiteral("; "));
}

QString lackText(const OpenedRecording &recording)
{
    const session::RecordingReport &report = recording.report;
    QStringList lacks;
    if (const QString room = roomText(recording.capture); !room.isEmpty())
        lacks.append(room);
    if (!report.damage.empty()) {
        QString first = session::damageText(report.damage.front());
        if (report.damagedPlaces > 1)
            first += QStringLiteral(", and %1 more places; rotorscope-cli show lists them")
                         .arg(report.damagedPlaces - 1);
        lacks.append(first);
    }
    if (report.lost != recorded::Lost{})
        lacks.append(QStringLiteral("it lacks %1, because the disk was too slow")
                         .arg(session::lostText(report.lost)));
    if (report.leftOut > 0)
        lacks.append(
            QStringLiteral("%1 events, snapshots and notes are left out, because they take "
                           "more than %2 MiB")
                .arg(QString::number(report.leftOut),
                    QString::number(session::RecordingReport::kMostKeptBytes >> 20)));
    return lacks.join(QStringLiteral("; "));
}

Outcome<bool> checkRecordingName(const QString &path)
{
    if (path.endsWith(QLatin1String(".pcapng"), Qt::CaseInsensitive))
        return true;
    return failure(kUsage,
        QStringLiteral("Let the name of the recording end in .pcapng, not as in \"%1\".")
            .arg(path));
}

QString recordingName(const QString &path, bool kept)
{
    return kept ? path : QStringLiteral("The recording");
}

ConversationRecording::ConversationRecording(
    Conversation &talk, const QString &path, bool withLink, bool kept)
    : m_talk(talk)
    , m_path(path)
    , m_withLink(withLink)
    , m_kept(kept)
    , m_recording(talk.tap())
{
    using session::Recording;
    QObject::connect(&m_recording, &Recording::started, &talk, [this] {
        m_started = true;
        Q_EMIT m_talk.changed();
    });
    QObject::connect(
        &m_recording, &Recording::finished, &talk, [this](const session::RecordingResult &result) {
            m_result = result;
            m_last = result.last;
            Q_EMIT m_talk.changed();
        });
}

Outcome<int> ConversationRecording::start(const QString &source)
{
    using Content = session::RecordingTap::Content;
    const QString program = QStringLiteral("Rotorscope ") + QCoreApplication::applicationVersion();
    m_recording.start(
        m_path, m_withLink ? Content::SamplesAndLink : Content::Samples, program, source);
    const auto waited =
        m_talk.waitUntil([this] { return m_started || m_result.has_value(); }, kOpenWithin);
    if (!waited)
        return tl::make_unexpected(waited.error());
    if (m_started)
        return kDone;
    QString todo = QStringLiteral("choose a name that is not there yet");
    if (!m_kept)
        todo =
            QStringLiteral("make room in %1, or set TMPDIR to another place").arg(QDir::tempPath());
    else if (m_result && m_result->outcome != RecordingOutcome::CannotOpen)
        todo = QStringLiteral("choose another place");
    else if (!QFileInfo(QFileInfo(m_path).path()).isDir())
        todo = QStringLiteral("its folder is not there, make it first or choose another one");
    return failure(kFileError,
        QStringLiteral("%1 cannot be recorded: %2; %3.")
            .arg(m_kept ? m_path : QStringLiteral("The experiment"),
                m_result ? m_result->systemText : QStringLiteral("the disk does not answer"),
                todo));
}

void ConversationRecording::add(TimePoint at, const snapshots::Snapshot &registers)
{
    m_recording.add(at.time_since_epoch().count(),
        recorded::RegisterSnapshot{
            "all registers", session::snapshotJson(registers).toStdString()});
}

void ConversationRecording::add(TimePoint at, const recorded::Happening &happening)
{
    m_recording.add(at.time_since_epoch().count(), happening);
}

Outcome<int> ConversationRecording::finish()
{
    m_recording.stop();
    // Not waitUntil(): the file is ended after an interrupt and a broken connection, too.
    QEventLoop loop;
    QObject::connect(&m_recording, &session::Recording::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(kCloseWithin, &loop, &QEventLoop::quit);
    if (!m_result)
        loop.exec();
    const QString name = recordingName(m_path, m_kept);
    if (!m_result)
        return failure(kFileError, QStringLiteral("%1: the disk does not answer.").arg(name));
    if (m_result->outcome != RecordingOutcome::Stopped)
        return failure(kFileError,
            QStringLiteral("%1 ends early: %2%3.")
                .arg(name, m_result->systemText,
                    m_kept ? QStringLiteral("; what was recorded until then is in it")
                           : QString()));
    if (m_last.lost != recorded::Lost{})
        return failure(kDataLost,
            QStringLiteral("%1 lacks %2, because the disk was too slow.")
                .arg(name, session::lostText(m_last.lost)));
    return kDone;
}

} // namespace cli

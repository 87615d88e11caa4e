#include "session/files/run_writer.h"

#include "drive/values.h"
#include "lab/evaluation/finding.h"
#include "recorded/gain_stretches.h"
#include "session/files/finding_json.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "session/recording/reader.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>

#include <algorithm>

namespace session {
namespace {

int nextNumber(const QString &folder)
{
    int last = 0;
    const QStringList files = QDir(folder).entryList({QStringLiteral("run-*")}, QDir::Files);
    for (const QString &file : files)
        last = std::max(last, runNumberOf(file));
    return last + 1;
}

/// What is tuned most often, to be seen without opening the snapshot.
QMap<QString, double> gainsOf(const snapshots::Snapshot &registers, int motor)
{
    QMap<QString, double> gains;
    for (const snapshots::Entry &entry : registers.entries)
        if (const auto number = drive::asNumber(entry.value);
            number && entry.motor == motor && recorded::isGain(entry.name))
            gains[QString::fromStdString(entry.name)] = *number;
    return gains;
}

QString systemTextOf(const RecordingFile &file)
{
    return file.failure() ? QString::fromStdString(file.failure()->text)
                          : QStringLiteral("the disk takes no more");
}

} // namespace

RunWriter::RunWriter(QString folder, Run run)
    : m_folder(std::move(folder))
    , m_run(std::move(run))
{
}

RunWriter::~RunWriter()
{
    m_file.reset();
    if (m_made)
        for (const auto path : {recordingOf, registersOf, runFileOf})
            QFile::remove(path(m_folder, m_run.number));
}

QString RunWriter::begin(const recorded::Begin &begin)
{
    if (!QDir().mkpath(m_folder))
        return QStringLiteral("there is no such folder");
    constexpr int kAttempts = 10; // another program may keep its runs there, too
    m_run.number = nextNumber(m_folder);
    QString why;
    auto sink = makeDiskSink(recordingOf(m_folder, m_run.number), why);
    for (int i = 1; !sink && i < kAttempts; ++i)
        sink = makeDiskSink(recordingOf(m_folder, ++m_run.number), why);
    if (!sink)
        return why;
    m_made = true;
    m_file = std::make_unique<RecordingFile>(std::move(sink), begin);
    return m_file->open() ? QString() : systemTextOf(*m_file);
}

Result<Run, QString> RunWriter::end(const std::optional<snapshots::Snapshot> &registers)
{
    if (m_file->isOver() || !m_file->end())
        return fail(systemTextOf(*m_file));
    m_file.reset();
    if (registers) {
        m_run.gains = gainsOf(*registers, m_run.motor);
        const QString why =
            writeWholeFile(registersOf(m_folder, m_run.number), snapshotJson(*registers));
        if (!why.isEmpty())
            return fail(why);
        m_run.registers = true;
    }
    evaluate();
    if (const QString why = writeWholeFile(runFileOf(m_folder, m_run.number), runJson(m_run));
        !why.isEmpty())
        return fail(why);
    m_made = false; // they are the user's now
    return m_run;
}

void RunWriter::evaluate()
{
    capture::Capture capture;
    const auto report = readRecording(recordingOf(m_folder, m_run.number), capture);
    if (!report) {
        m_run.notes.append(report.error());
        return;
    }
    const auto found = lab::findingIn(capture, report->happenings);
    if (!found) {
        if (m_run.experiment != QLatin1String(kStretch)) // which need not have one
            m_run.notes.append(QString::fromStdString(found.error()));
        return;
    }
    m_run.result = QJsonDocument::fromJson(findingJson(*found)).object();
    if (const std::string lack = lab::lackOf(*found); !lack.empty())
        m_run.notes.append(QString::fromStdString(lack));
    for (const std::string &note : lab::notesOf(*found))
        m_run.notes.append(QString::fromStdString(note));
}

} // namespace session

#include "session/files/run_book.h"

#include "drive/values.h"
#include "lab/evaluation/finding.h"
#include "session/files/finding_json.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "session/recording/recording_file.h"
#include "session/recording/recording_reader.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace session {
namespace {

constexpr char kFormat[] = "rotorscope-run";
constexpr int kVersion = 1;
constexpr qint64 kMostBytes = 1 << 20; ///< of a run's own file
constexpr int kMostNumber = 1'000'000;
constexpr std::array kEnds{"complete", "refused", "aborted", "interrupted", "lost"};

QString key(const char *name) { return QString::fromLatin1(name); }
QString text(const std::string &utf8) { return QString::fromStdString(utf8); }

QString stemOf(const QString &folder, int number)
{
    return folder + QStringLiteral("/run-%1").arg(number, 4, 10, QLatin1Char('0'));
}

QString runFile(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral(".json");
}

/// Of files of this name; 0: it is another one's.
int numberOf(const QString &fileName)
{
    static const QRegularExpression shape(
        QStringLiteral("^run-(\\d{4,7})(-registers)?\\.(json|pcapng)$"));
    const auto match = shape.match(fileName);
    const int number = match.hasMatch() ? match.captured(1).toInt() : 0;
    return number <= kMostNumber ? number : 0;
}

int nextNumber(const QString &folder)
{
    int last = 0;
    const QStringList files = QDir(folder).entryList({QStringLiteral("run-*")}, QDir::Files);
    for (const QString &file : files)
        last = std::max(last, numberOf(file));
    return last + 1;
}

/// What is tuned most often, to be seen without opening the snapshot.
QMap<QString, double> gainsOf(const snapshots::Snapshot &registers, int motor)
{
    QMap<QString, double> gains;
    for (const snapshots::Entry &entry : registers.entries) {
        const QString name = text(entry.name);
        const bool gain = name.endsWith(QLatin1String("_KP")) || name.endsWith(QLatin1String("_KI"))
            || name.endsWith(QLatin1String("_KD"));
        if (const auto number = drive::asNumber(entry.value);
            gain && number && entry.motor == motor)
            gains[name] = *number;
    }
    return gains;
}

QJsonObject toJson(const Run &run)
{
    QJsonObject plan, gains;
    for (const auto &[name, value] : run.plan)
        plan[name] = value;
    for (auto gain = run.gains.begin(); gain != run.gains.end(); ++gain)
        gains[gain.key()] = gain.value();
    return {{key("format"), key(kFormat)}, {key("version"), kVersion}, {key("at"), run.at},
        {key("board"), run.board}, {key("motor"), run.motor}, {key("motor_name"), run.motorName},
        {key("experiment"), run.experiment}, {key("plan"), plan}, {key("end"), run.end},
        {key("reason"), run.reason}, {key("gains"), gains},
        {key("result"), run.result.isEmpty() ? QJsonValue() : QJsonValue(run.result)},
        {key("notes"), QJsonArray::fromStringList(run.notes)}, {key("note"), run.note},
        {key("starred"), run.starred}};
}

Result<Run, QString> fromJson(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonObject object = QJsonDocument::fromJson(json, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(error.errorString());
    if (object[key("format")] != QJsonValue(key(kFormat)))
        return fail(QStringLiteral("it is no run"));
    if (object[key("version")].toInt() != kVersion)
        return fail(QStringLiteral("it is of a later version"));
    Run run;
    run.at = object[key("at")].toInteger();
    run.board = object[key("board")].toString();
    run.motor = object[key("motor")].toInt(1);
    run.motorName = object[key("motor_name")].toString();
    run.experiment = object[key("experiment")].toString();
    run.end = object[key("end")].toString();
    run.reason = object[key("reason")].toString();
    run.result = object[key("result")].toObject();
    run.note = object[key("note")].toString();
    run.starred = object[key("starred")].toBool();
    const QJsonObject plan = object[key("plan")].toObject();
    for (auto field = plan.begin(); field != plan.end(); ++field)
        run.plan.append({field.key(), field.value().toString()});
    const QJsonObject gains = object[key("gains")].toObject();
    for (auto gain = gains.begin(); gain != gains.end(); ++gain)
        if (gain.value().isDouble())
            run.gains[gain.key()] = gain.value().toDouble();
    const QJsonArray notes = object[key("notes")].toArray();
    for (const QJsonValue &note : notes)
        run.notes.append(note.toString());
    return run;
}

/// @return  empty, or the system's words
QString writeRecording(std::unique_ptr<BlockSink> sink, const EndedRun &ended)
{
    RecordingFile file(std::move(sink), ended.begin);
    bool good = file.open() && file.add(ended.plan.first, ended.plan.second);
    for (const ToldPtr &told : ended.told)
        for (const record::Entry &entry : told->entries)
            good = good && file.add(told->at, entry);
    if (good && ended.registers)
        good = file.add(ended.end.first,
            record::RegisterSnapshot{
                "behind the run", snapshotJson(*ended.registers).toStdString()});
    if (good && file.add(ended.end.first, ended.end.second) && file.end())
        return {};
    return file.failure() ? text(file.failure()->text) : QStringLiteral("the disk takes no more");
}

void evaluate(Run &run, const QString &recording)
{
    capture::Capture capture;
    const auto report = readRecording(recording, capture);
    if (!report) {
        run.notes.append(report.error());
        return;
    }
    lab::Happenings happenings;
    for (const auto &[at, what] : report->happenings)
        happenings.emplace_back(at, what);
    const auto found = lab::findingIn(capture, happenings);
    if (!found) {
        run.notes.append(text(found.error()));
        return;
    }
    run.result = QJsonDocument::fromJson(findingJson(*found)).object();
    if (const std::string lack = lab::lackOf(*found); !lack.empty())
        run.notes.append(text(lack));
    for (const std::string &note : lab::notesOf(*found))
        run.notes.append(text(note));
}

void removeRun(const QString &folder, int number)
{
    for (const QString &path :
        {recordingOf(folder, number), registersOf(folder, number), runFile(folder, number)})
        QFile::remove(path);
}

} // namespace

QString recordingOf(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral(".pcapng");
}

QString registersOf(const QString &folder, int number)
{
    return stemOf(folder, number) + QStringLiteral("-registers.json");
}

Result<Run, QString> keepRun(const QString &folder, const EndedRun &ended)
{
    if (!QDir().mkpath(folder))
        return fail(QStringLiteral("there is no such folder"));
    Run run;
    run.number = nextNumber(folder);
    run.at = ended.at;
    run.board = ended.board;
    run.motor = ended.motor;
    run.motorName = ended.motorName;
    run.experiment = text(ended.plan.second.name);
    for (const auto &[name, value] : ended.plan.second.fields)
        run.plan.append({text(name), text(value)});
    std::sort(run.plan.begin(), run.plan.end()); // as they are read back
    run.end = key(kEnds.at(static_cast<std::size_t>(ended.outcome.end)));
    run.reason = text(ended.outcome.reason);
    QString why;
    auto sink = makeDiskSink(recordingOf(folder, run.number), why);
    if (!sink)
        return fail(why);
    why = writeRecording(std::move(sink), ended);
    if (why.isEmpty() && ended.registers) {
        run.gains = gainsOf(*ended.registers, run.motor);
        why = writeWholeFile(registersOf(folder, run.number), snapshotJson(*ended.registers));
        run.registers = why.isEmpty();
    }
    if (why.isEmpty()) {
        evaluate(run, recordingOf(folder, run.number));
        why = writeWholeFile(runFile(folder, run.number), QJsonDocument(toJson(run)).toJson());
    }
    if (why.isEmpty())
        return run;
    removeRun(folder, run.number);
    return fail(why);
}

Result<RunBook, QString> readRunBook(
    const QString &folder, const std::function<bool(double)> &proceed)
{
    const QDir dir(folder);
    if (!dir.exists())
        return fail(QStringLiteral("there is no such folder"));
    RunBook book;
    const QStringList files = dir.entryList({QStringLiteral("run-*")}, QDir::Files, QDir::Name);
    const QSet<QString> there(files.begin(), files.end());
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString &file = files[i];
        const int number = numberOf(file);
        if (number == 0 || dir.filePath(file) != runFile(dir.path(), number))
            continue;
        const auto content = readWholeFile(dir.filePath(file), kMostBytes);
        auto run = content ? fromJson(*content) : Result<Run, QString>(fail(content.error()));
        if (!run) {
            book.problems.append(QStringLiteral("%1: %2").arg(file, run.error()));
        } else {
            run->number = number;
            run->registers = there.contains(QFileInfo(registersOf(folder, number)).fileName());
            book.runs.push_back(std::move(*run));
        }
        if (proceed && !proceed(double(i + 1) / double(files.size())))
            break;
    }
    std::sort(book.runs.begin(), book.runs.end(),
        [](const Run &one, const Run &other) { return one.number < other.number; });
    return book;
}

QString annotateRun(const QString &folder, int number, const QString &note, bool starred)
{
    const QString path = runFile(folder, number);
    const auto content = readWholeFile(path, kMostBytes);
    if (!content)
        return content.error();
    if (const auto run = fromJson(*content); !run)
        return run.error();
    QJsonObject object = QJsonDocument::fromJson(*content).object();
    object[key("note")] = note;
    object[key("starred")] = starred;
    return writeWholeFile(path, QJsonDocument(object).toJson());
}

} // namespace session

#include "session/files/run_book.h"

#include "session/files/run_writer.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSet>

#include <algorithm>
#include <array>

namespace session {
namespace {

constexpr std::array kEnds{"complete", "refused", "aborted", "interrupted", "lost"};

Run runOf(const EndedRun &ended)
{
    Run run;
    run.at = ended.at;
    run.board = ended.board;
    run.motor = ended.motor;
    run.motorName = ended.motorName;
    run.experiment = QString::fromStdString(ended.plan.name);
    for (const auto &[name, value] : ended.plan.fields)
        run.plan.append({QString::fromStdString(name), QString::fromStdString(value)});
    std::ranges::sort(run.plan); // as they are read back
    run.end = QString::fromLatin1(kEnds.at(static_cast<std::size_t>(ended.outcome.end)));
    run.reason = QString::fromStdString(ended.outcome.reason);
    return run;
}

} // namespace

Result<Run, QString> keepRun(const QString &folder, const EndedRun &ended)
{
    RunWriter writer(folder, runOf(ended));
    if (const QString why = writer.begin(ended.begin); !why.isEmpty())
        return fail(why);
    bool good = true;
    for (const ToldPtr &told : ended.told)
        for (const recorded::Entry &entry : told->entries)
            good = good && writer.add(told->at, entry);
    if (good && ended.registers && !ended.told.empty())
        (void)writer.add(ended.told.back()->at,
            recorded::RegisterSnapshot{
                "behind the run", snapshotJson(*ended.registers).toStdString()});
    return writer.end(ended.registers); // which says why, if it is over
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
        const int number = runNumberOf(file);
        if (number == 0 || dir.filePath(file) != runFileOf(dir.path(), number))
            continue;
        const auto content = readWholeFile(dir.filePath(file), kMostText);
        auto run = content ? readRunJson(*content) : Result<Run, QString>(fail(content.error()));
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
    std::ranges::sort(book.runs, {}, &Run::number);
    return book;
}

QString annotateRun(const QString &folder, int number, const QString &note, bool starred)
{
    const QString path = runFileOf(folder, number);
    const auto content = readWholeFile(path, kMostText);
    if (!content)
        return content.error();
    if (const auto run = readRunJson(*content); !run)
        return run.error();
    QJsonObject object = QJsonDocument::fromJson(*content).object();
    object[QStringLiteral("note")] = note;
    object[QStringLiteral("starred")] = starred;
    return writeWholeFile(path, QJsonDocument(object).toJson());
}

} // namespace session

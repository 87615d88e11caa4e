#include "snapshot_work.h"

#include "sentences.h"

#include "session/files/problems.h"
#include "session/files/whole_file.h"

#include <algorithm>

namespace cli {

Outcome<BoardSnapshot> readBoard(Desk &desk, snapshots::Scope scope)
{
    const auto ids = snapshots::snapshotRegisters(desk.catalog(), scope);
    const auto readings = desk.talk.read(ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    BoardSnapshot result;
    for (const drive::Reading &reading : *readings) {
        result.at = std::max(result.at, reading.at);
        if (reading.status != drive::ReadStatus::Ok && reading.at == TimePoint{})
            result.unanswered.append(QString::fromStdString(desk.catalog().nameOf(reading.id)));
    }
    result.snapshot = snapshots::snapshotOf(desk.board.identity, desk.catalog(), *readings);
    return result;
}

Outcome<int> saveFile(const QString &path, const QByteArray &content)
{
    const QString why = session::writeWholeFile(path, content);
    if (why.isEmpty())
        return kDone;
    return failure(kFileError,
        QStringLiteral("%1 was not written: %2; choose another place with -o.").arg(path, why));
}

Outcome<QByteArray> loadFile(const QString &path)
{
    const auto content = session::readWholeFile(path);
    if (content)
        return *content;
    return failure(kFileError,
        QStringLiteral("%1 cannot be read: %2; check the name.").arg(path, content.error()));
}

Outcome<snapshots::Snapshot> loadSnapshot(const QString &path)
{
    const auto content = loadFile(path);
    if (!content)
        return tl::make_unexpected(content.error());
    auto snapshot = session::readSnapshotJson(*content);
    if (snapshot)
        return std::move(*snapshot);
    snapshot.error().name = plainText(snapshot.error().name.toStdString());
    return failure(kFileError,
        session::snapshotProblemText(path, snapshot.error())
            + QStringLiteral(" rotorscope-cli snapshot makes such a file."));
}

Outcome<bool> parseOutput(const Given &given, Arguments &arguments)
{
    arguments.tuning.file = given.value("output");
    if (arguments.tuning.file.isEmpty())
        return usage(QStringLiteral("Name the file to write with -o FILE."));
    return true;
}

Outcome<bool> parseOnly(const Given &given, Arguments &arguments)
{
    arguments.tuning.only = given.list("only");
    if (given.has("only") && arguments.tuning.only.isEmpty())
        return usage(QStringLiteral(
            "Name a group or a register behind --only, such as --only \"Speed loop\"."));
    return true;
}

Outcome<snapshots::Selection> selectionOf(
    const Arguments &arguments, const snapshots::Snapshot &a, const snapshots::Snapshot &b)
{
    std::vector<std::string> names;
    for (const QString &name : arguments.tuning.only)
        names.push_back(name.toStdString());
    const snapshots::Selection selection(names);
    const auto notInA = selection.unmatched(a), notInB = selection.unmatched(b);
    for (const std::string &name : notInA)
        if (std::find(notInB.begin(), notInB.end(), name) != notInB.end())
            return failure(kUsage,
                QStringLiteral("There is no group and no register \"%1\"; rotorscope-cli registers "
                               "--json lists both.")
                    .arg(QString::fromStdString(name)));
    return selection;
}

} // namespace cli

#include "snapshot_work.h"

#include "session/snapshot_json.h"
#include "session/whole_file.h"

#include <algorithm>

namespace cli {

Outcome<BoardSnapshot> readBoard(Desk &desk, tuning::Scope scope)
{
    const auto ids = tuning::snapshotRegisters(desk.catalog(), scope);
    const auto readings = desk.talk.read(ids);
    if (!readings)
        return tl::make_unexpected(readings.error());
    BoardSnapshot result;
    for (const drive::Reading &reading : *readings)
        if (reading.status != drive::ReadStatus::Ok && reading.at == TimePoint{})
            result.unanswered.append(QString::fromStdString(desk.catalog().nameOf(reading.id)));
    result.snapshot = tuning::snapshotOf(desk.board.identity, desk.catalog(), *readings);
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

Outcome<tuning::Snapshot> loadSnapshot(const QString &path)
{
    const auto content = loadFile(path);
    if (!content)
        return tl::make_unexpected(content.error());
    auto snapshot = session::readSnapshotJson(*content);
    if (snapshot)
        return std::move(*snapshot);
    return failure(kFileError,
        QStringLiteral("%1 cannot be used: %2; rotorscope-cli snapshot makes such a file.")
            .arg(path, snapshot.error()));
}

Outcome<tuning::Selection> selectionOf(
    const Arguments &arguments, const tuning::Snapshot &a, const tuning::Snapshot &b)
{
    std::vector<std::string> names;
    for (const QString &name : arguments.tuning.only)
        names.push_back(name.toStdString());
    const tuning::Selection selection(names);
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

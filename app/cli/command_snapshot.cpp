#include "session/files/snapshot_json.h"
#include "snapshot_work.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace cli {

namespace {

Outcome<int> runSnapshot(Desk &desk)
{
    const QString &path = desk.arguments.tuning.file;
    const auto board = readBoard(desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(board.error());
    const auto &entries = board->snapshot.entries;
    const auto saved = saveFile(path, session::snapshotJson(board->snapshot));
    if (!saved)
        return saved;
    const auto tunable = std::count_if(entries.begin(), entries.end(),
        [](const snapshots::Entry &entry) { return entry.tunable; });
    if (desk.out.json())
        desk.out.line(QJsonObject{{QStringLiteral("file"), path},
            {QStringLiteral("registers"), static_cast<qint64>(entries.size())},
            {QStringLiteral("tunable"), static_cast<qint64>(tunable)},
            {QStringLiteral("unanswered"), QJsonArray::fromStringList(board->unanswered)}});
    else
        desk.out.line(QStringLiteral("%1: %2 registers, %3 of them tunable.")
                          .arg(path, QString::number(entries.size()), QString::number(tunable)));
    if (!board->unanswered.isEmpty())
        return failure(kDataLost,
            QStringLiteral("%1 is without %2, which never answered; take it again.")
                .arg(path, board->unanswered.join(QStringLiteral(", "))));
    return kDone;
}

} // namespace

const Command kSnapshot{.name = "snapshot",
    .words = "-o FILE.json",
    .help = "Saves every register that can be read, with the name of board and firmware.",
    .options = {&kOutputOption, 1},
    .read = parseOutput,
    .run = runSnapshot};

} // namespace cli

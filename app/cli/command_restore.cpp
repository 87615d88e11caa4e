#include "sentences.h"
#include "snapshot_work.h"
#include "snapshots/restore.h"
#include "write_report.h"

#include <QJsonArray>

#include <array>

namespace cli {

namespace {

const char *wordOf(snapshots::NotRestored why)
{
    constexpr std::array kWords{"not on this board", "something else in this firmware",
        "moves a motor", "the motor is not idle",
        "firmware reads it in another form than it writes"};
    return kWords.at(static_cast<std::size_t>(why));
}

Outcome<int> checkHardware(const Desk &desk, const snapshots::Snapshot &snapshot)
{
    const auto others = snapshots::otherHardware(snapshot.board, desk.board.identity);
    if (others.empty() || desk.arguments.tuning.force)
        return kDone;
    QStringList names;
    for (const std::string &name : others)
        names.append(QString::fromStdString(name).simplified());
    return failure(kRefused,
        QStringLiteral("%1 was taken of other hardware (%2); restore it all the same with --force.")
            .arg(desk.arguments.words[0], names.join(QStringLiteral(", "))));
}

Outcome<std::vector<int>> movingMotors(Desk &desk)
{
    std::vector<int> moving;
    for (int motor = 1; motor <= desk.board.identity.motors; ++motor) {
        const auto status = desk.talk.status(motor);
        if (!status)
            return tl::make_unexpected(status.error());
        if (!drive::rests(status->state))
            moving.push_back(motor);
    }
    return moving;
}

Outcome<int> runRestore(Desk &desk)
{
    const auto wanted = loadSnapshot(desk.arguments.words[0]);
    if (!wanted)
        return tl::make_unexpected(wanted.error());
    const auto sameHardware = checkHardware(desk, *wanted);
    if (!sameHardware)
        return sameHardware;
    const auto board = readBoard(desk, snapshots::Scope::All);
    if (!board)
        return tl::make_unexpected(board.error());
    const auto selection = selectionOf(desk.arguments, *wanted, board->snapshot);
    if (!selection)
        return tl::make_unexpected(selection.error());
    const auto moving = movingMotors(desk);
    if (!moving)
        return tl::make_unexpected(moving.error());
    const snapshots::RestorePlan plan =
        snapshots::planRestore(*wanted, board->snapshot, desk.catalog(), *selection, *moving);

    Outcome<int> done = kDone;
    if (!plan.writes.empty())
        done = writeAndReport(desk, drive::Write{plan.writes, drive::Reach::Parameters},
            Digits::Shown, QStringLiteral("The restore"));
    else if (desk.out.json())
        desk.out.line(QJsonArray());
    else if (plan.left.empty())
        desk.out.line(QStringLiteral("The board holds these values already."));
    if (!done)
        return done;
    QStringList left, acting;
    for (const auto &[name, why] : plan.left) {
        if (why == snapshots::NotRestored::Moves)
            acting.append(plainText(name));
        else
            left.append(QStringLiteral("%1 (%2)").arg(plainText(name), QLatin1String(wordOf(why))));
    }
    if (!acting.isEmpty() && !desk.out.json()) // as it should be, so no failure
        desk.out.line(QStringLiteral("Not restored, because it moves a motor: %1.")
                          .arg(acting.join(QStringLiteral(", "))));
    if (left.isEmpty())
        return done;
    return failure(kRefused,
        QStringLiteral("Not restored: %1; everything else is.")
            .arg(left.join(QStringLiteral(", "))));
}

constexpr OptionText kRestoreOptions[] = {
    kOnlyOption, {"force", "", "Also a snapshot of other hardware."}};

Outcome<bool> readRestore(const Given &given, Arguments &arguments)
{
    arguments.tuning.force = given.has("force");
    return parseOnly(given, arguments);
}

} // namespace

const Command kRestore{.name = "restore",
    .words = "FILE.json",
    .help =
        "Writes back what differs from a snapshot, in as few requests as fit, and reads it back.",
    .least = 1,
    .most = 1,
    .options = kRestoreOptions,
    .read = readRestore,
    .canMove = true,
    .run = runRestore};

} // namespace cli

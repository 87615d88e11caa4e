#include "motor_facts.h"
#include "snapshot_work.h"
#include "snapshots/drive_parameters.h"

#include <QJsonObject>

namespace cli {

namespace {

Outcome<int> runHeader(Desk &desk)
{
    const auto board = readBoard(desk, snapshots::Scope::Tunable);
    if (!board)
        return tl::make_unexpected(board.error());
    if (!board->unanswered.isEmpty())
        return failure(kDataLost,
            QStringLiteral("The board never answered for %1, so nothing was written; try again.")
                .arg(board->unanswered.join(QStringLiteral(", "))));
    const auto facts = readMotorFacts(desk);
    if (!facts)
        return tl::make_unexpected(facts.error());
    const QByteArray text = QByteArray::fromStdString(snapshots::driveParametersHeader(
        board->snapshot, desk.arguments.motor, facts->ampsPerDigit));
    const auto macros = text.count("\n#define ") - 1; // without the guard
    if (macros <= 0)
        return failure(kRefused,
            QStringLiteral("This board has none of the values of drive_parameters.h; nothing was "
                           "written."));
    const QString &path = desk.arguments.tuning.file;
    const auto saved = saveFile(path, text);
    if (!saved)
        return saved;
    if (desk.out.json())
        desk.out.line(QJsonObject{{QStringLiteral("file"), path},
            {QStringLiteral("macros"), static_cast<qint64>(macros)}});
    else
        desk.out.line(QStringLiteral("%1: %2 macros.").arg(path, QString::number(macros)));
    return kDone;
}

} // namespace

const Command kHeader{.name = "header",
    .words = "-o drive_parameters.h",
    .help = "Writes the tuned values as a C header in the names of ST's drive_parameters.h.",
    .options = {&kOutputOption, 1},
    .read = parseOutput,
    .ofOneMotor = true,
    .run = runHeader};

} // namespace cli

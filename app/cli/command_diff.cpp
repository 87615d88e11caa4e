// diff: of two files, or of a file and the board.
#include "snapshot_work.h"
#include "values.h"

#include <QJsonArray>

#include <cmath>

namespace cli {

namespace {

/// Whether a word means the board instead of a file.
bool isDevice(const QString &word) { return word == QLatin1String("device"); }

using snapshots::Entry;

/// The value as people read it; "-" if there is none.
QString textOf(const Entry *entry)
{
    if (entry == nullptr)
        return QStringLiteral("-");
    if (const auto *bytes = std::get_if<Bytes>(&entry->value))
        return bytesText(*bytes);
    if (const auto *text = std::get_if<std::string>(&entry->value))
        return QString::fromStdString(*text).simplified();
    const QString number = QString::number(entry->shown.value_or(std::nan("")), 'g', 7);
    return entry->unit.empty() ? number
                               : number + QLatin1Char(' ') + QString::fromStdString(entry->unit);
}

QJsonValue shownJson(const Entry *entry)
{
    if (entry == nullptr)
        return {};
    if (entry->shown)
        return std::isfinite(*entry->shown) ? QJsonValue(*entry->shown) : QJsonValue();
    return textOf(entry);
}

QJsonValue rawJson(const Entry *entry)
{
    if (entry == nullptr)
        return {};
    if (const auto *whole = std::get_if<std::int64_t>(&entry->value))
        return static_cast<qint64>(*whole);
    if (const auto *number = std::get_if<double>(&entry->value))
        return std::isfinite(*number) ? QJsonValue(*number) : QJsonValue(QString::number(*number));
    return textOf(entry);
}

QString nameOf(const Entry &entry, int motors)
{
    const QString name = QString::fromStdString(entry.name);
    return entry.motor > 0 && motors > 1
        ? QStringLiteral("%1@%2").arg(name, QString::number(entry.motor))
        : name;
}

QJsonObject jsonOf(const snapshots::Difference &difference, const QString &name)
{
    const Entry &either = difference.either();
    return {{QStringLiteral("name"), name}, {QStringLiteral("motor"), either.motor},
        {QStringLiteral("id"), idText(either.id)},
        {QStringLiteral("group"), QString::fromStdString(either.group)},
        {QStringLiteral("unit"), QString::fromStdString(either.unit)},
        {QStringLiteral("a"), shownJson(difference.a)},
        {QStringLiteral("b"), shownJson(difference.b)},
        {QStringLiteral("a_raw"), rawJson(difference.a)},
        {QStringLiteral("b_raw"), rawJson(difference.b)}};
}

Outcome<int> printDifferences(const Arguments &arguments, const snapshots::Snapshot &a,
    const snapshots::Snapshot &b, Output &out)
{
    const auto selection = selectionOf(arguments, a, b);
    if (!selection)
        return tl::make_unexpected(selection.error());
    const auto scope = arguments.tuning.all ? snapshots::Scope::All : snapshots::Scope::Tunable;
    const auto list = snapshots::differences(a, b, scope, *selection);
    const int motors = std::max(a.board.motors, b.board.motors);
    if (out.json()) {
        QJsonArray array;
        for (const snapshots::Difference &difference : list)
            array.append(jsonOf(difference, nameOf(difference.either(), motors)));
        out.line(array);
        return kDone;
    }
    qsizetype nameWidth = 0, aWidth = 0;
    for (const snapshots::Difference &difference : list) {
        nameWidth = std::max(nameWidth, nameOf(difference.either(), motors).size());
        aWidth = std::max(aWidth, textOf(difference.a).size());
    }
    for (const snapshots::Difference &difference : list)
        out.line(nameOf(difference.either(), motors).leftJustified(nameWidth + 2)
            + textOf(difference.a).leftJustified(aWidth + 2) + textOf(difference.b));
    if (list.empty())
        out.line(QStringLiteral("No differences."));
    return kDone;
}

Outcome<int> runDiffOfFiles(const Arguments &arguments, Output &out)
{
    const auto a = loadSnapshot(arguments.words[0]);
    if (!a)
        return tl::make_unexpected(a.error());
    const auto b = loadSnapshot(arguments.words[1]);
    if (!b)
        return tl::make_unexpected(b.error());
    return printDifferences(arguments, *a, *b, out);
}

Outcome<int> runDiff(Desk &desk)
{
    const auto scope =
        desk.arguments.tuning.all ? snapshots::Scope::All : snapshots::Scope::Tunable;
    std::vector<snapshots::Snapshot> sides;
    QStringList unanswered;
    for (const QString &word : desk.arguments.words) {
        if (isDevice(word)) {
            auto board = readBoard(desk, scope);
            if (!board)
                return tl::make_unexpected(board.error());
            unanswered += board->unanswered;
            sides.push_back(std::move(board->snapshot));
        } else {
            auto file = loadSnapshot(word);
            if (!file)
                return tl::make_unexpected(file.error());
            sides.push_back(std::move(*file));
        }
    }
    const auto printed = printDifferences(desk.arguments, sides[0], sides[1], desk.out);
    if (printed && !unanswered.isEmpty())
        return failure(kDataLost,
            QStringLiteral("The board never answered for %1; try again.")
                .arg(unanswered.join(QStringLiteral(", "))));
    return printed;
}

constexpr OptionText kDiffOptions[] = {kOnlyOption, {"all", "", "Measured registers, too."}};

Outcome<bool> readDiff(const Given &given, Arguments &arguments)
{
    arguments.tuning.all = given.has("all");
    arguments.tuning.device = std::any_of(arguments.words.begin(), arguments.words.end(), isDevice);
    return parseOnly(given, arguments);
}

} // namespace

const Command kDiff{.name = "diff",
    .words = "A.json B.json|device",
    .help = "Lists the registers that differ between two snapshots, or a snapshot and the board.",
    .least = 2,
    .most = 2,
    .options = kDiffOptions,
    .read = readDiff,
    .needsPort = false,
    .run = runDiff,
    .runAlone = runDiffOfFiles};

} // namespace cli

#include "tuning_arguments.h"

#include <QCommandLineParser>

namespace cli {

namespace {

bool isOneOf(const QString &command, std::initializer_list<const char *> names)
{
    return std::any_of(names.begin(), names.end(),
        [&](const char *name) { return command == QLatin1String(name); });
}

bool isSet(const QCommandLineParser &parser, const char *option)
{
    return parser.optionNames().contains(QLatin1String(option));
}

} // namespace

void addTuningOptions(QCommandLineParser &parser, const QString &command)
{
    if (isOneOf(command, {"snapshot", "header"}))
        parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
            QStringLiteral("The file to write; it appears whole or not at all."),
            QStringLiteral("FILE")});
    if (isOneOf(command, {"diff", "restore"}))
        parser.addOption({QStringLiteral("only"),
            QStringLiteral("Only this group or register; several are separated by commas."),
            QStringLiteral("GROUP")});
    if (isOneOf(command, {"diff"}))
        parser.addOption({QStringLiteral("all"), QStringLiteral("Measured registers, too.")});
    if (isOneOf(command, {"restore"}))
        parser.addOption(
            {QStringLiteral("force"), QStringLiteral("Also a snapshot of other hardware.")});
}

Outcome<TuningArguments> tuningOf(
    const QCommandLineParser &parser, const QString &command, const QStringList &words)
{
    TuningArguments arguments;
    if (isOneOf(command, {"snapshot", "header"})) {
        arguments.file = parser.value(QStringLiteral("output"));
        if (arguments.file.isEmpty())
            return failure(kUsage, QStringLiteral("Name the file to write with -o FILE."));
    }
    if (isSet(parser, "only")) {
        for (const QString &name :
            parser.value(QStringLiteral("only")).split(QLatin1Char(','), Qt::SkipEmptyParts))
            arguments.only.append(name.trimmed());
        if (arguments.only.isEmpty())
            return failure(kUsage,
                QStringLiteral("Name a group or a register behind --only, such as --only \"Speed "
                               "loop\"."));
    }
    arguments.all = isSet(parser, "all");
    arguments.force = isSet(parser, "force");
    arguments.device =
        command == QLatin1String("diff") && std::any_of(words.begin(), words.end(), isDevice);
    return arguments;
}

} // namespace cli

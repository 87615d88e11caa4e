#include "recording_arguments.h"

#include "tuning_arguments.h"

#include <QCommandLineParser>

namespace cli {

namespace {

bool isSet(const QCommandLineParser &parser, const char *option)
{
    return parser.optionNames().contains(QLatin1String(option));
}

} // namespace

void addRecordingOptions(QCommandLineParser &parser, const QString &command)
{
    if (command == QLatin1String("show"))
        parser.addOption({QStringLiteral("events"),
            QStringLiteral("Prints what happened, line by line, with its time.")});
    if (command != QLatin1String("export"))
        return;
    parser.addOptions({
        {{QStringLiteral("o"), QStringLiteral("output")},
            QStringLiteral("The file to write; its ending says the format."),
            QStringLiteral("FILE")},
        {QStringLiteral("signals"),
            QStringLiteral("Only these signals, in this order; separated by commas."),
            QStringLiteral("A,B")},
        {QStringLiteral("from"), QStringLiteral("From this second of the session on."),
            QStringLiteral("S")},
        {QStringLiteral("to"), QStringLiteral("Up to this second of the session."),
            QStringLiteral("S")},
        {QStringLiteral("continental"),
            QStringLiteral("CSV with ; and a decimal comma, for spreadsheets that expect them.")},
    });
}

Outcome<RecordingArguments> recordingOf(const QCommandLineParser &parser, const QString &command)
{
    RecordingArguments arguments;
    arguments.events = isSet(parser, "events");
    if (command != QLatin1String("export"))
        return arguments;
    arguments.file = parser.value(QStringLiteral("output"));
    if (arguments.file.isEmpty())
        return failure(
            kUsage, QStringLiteral("Name the file to write with -o FILE, such as -o run.csv."));
    arguments.continental = isSet(parser, "continental");
    if (isSet(parser, "signals")) {
        for (const QString &name :
            parser.value(QStringLiteral("signals")).split(QLatin1Char(','), Qt::SkipEmptyParts))
            arguments.only.append(name.trimmed());
    }
    for (const auto &[option, place] :
        {std::pair{"from", &arguments.from}, std::pair{"to", &arguments.to}}) {
        if (!isSet(parser, option))
            continue;
        const QString text = parser.value(QLatin1String(option));
        *place = plainNumber(text);
        if (!*place)
            return failure(kUsage,
                QStringLiteral("--%1 must be a number of seconds, with a point, not \"%2\".")
                    .arg(QLatin1String(option), text));
    }
    if (arguments.from && arguments.to && *arguments.from >= *arguments.to)
        return failure(kUsage, QStringLiteral("--from must lie before --to."));
    return arguments;
}

} // namespace cli

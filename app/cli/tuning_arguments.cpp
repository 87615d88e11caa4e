#include "tuning_arguments.h"

#include <QCommandLineParser>

#include <algorithm>
#include <charconv>
#include <cmath>

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

Outcome<double> positive(const QCommandLineParser &parser, const char *option, double least)
{
    if (!isSet(parser, option))
        return 0.0;
    const QString text = parser.value(QLatin1String(option));
    const auto number = plainNumber(text);
    if (number && *number > least && *number < 1e9)
        return *number;
    return failure(kUsage,
        QStringLiteral("--%1 must be a number above %2 and below 1e9, with a point, not \"%3\".")
            .arg(QLatin1String(option), QString::number(least), text));
}

Outcome<bool> takeGains(const QCommandLineParser &parser, TuningArguments &arguments)
{
    using Row = std::tuple<const char *, double TuningArguments::*, double>;
    for (const auto &[option, member, least] :
        {Row{"bandwidth", &TuningArguments::bandwidth_radps, 0.0},
            Row{"damping", &TuningArguments::damping, 1.0},
            Row{"inertia", &TuningArguments::inertia_kgm2, 0.0},
            Row{"ke", &TuningArguments::ke_vrmsPerKrpm, 0.0}}) {
        const auto number = positive(parser, option, least);
        if (!number)
            return tl::make_unexpected(number.error());
        arguments.*member = *number;
    }
    if (isSet(parser, "delay")) {
        constexpr double kLongest_ms = 1000.0;
        const auto delay_ms = plainNumber(parser.value(QStringLiteral("delay")));
        if (!delay_ms || *delay_ms < 0.0 || *delay_ms > kLongest_ms)
            return failure(kUsage,
                QStringLiteral(
                    "--delay must be a number of milliseconds from 0 to 1000, not \"%1\".")
                    .arg(parser.value(QStringLiteral("delay"))));
        arguments.speedDelay_s = *delay_ms / 1e3;
    }
    if (arguments.bandwidth_radps == 0.0)
        return failure(kUsage,
            QStringLiteral("Say how fast the current loop is to be with --bandwidth W in rad/s, "
                           "such as 1500."));
    arguments.apply = isSet(parser, "apply");
    return true;
}

Outcome<bool> takeTorque(const QStringList &words, TuningArguments &arguments)
{
    const auto amps = plainNumber(words[0]);
    bool ok = false;
    const int time = words[1].toInt(&ok);
    if (!amps || !ok || time < 0 || time > 65535)
        return failure(kUsage,
            QStringLiteral("Write torque AMPS MS, such as torque 1.5 500; MS is at most 65535."));
    arguments.amps = *amps;
    arguments.milliseconds = time;
    return true;
}

} // namespace

std::optional<double> plainNumber(const QString &text)
{
    const QByteArray bytes = text.trimmed().toLatin1();
    double number = 0.0;
    const char *end = bytes.constData() + bytes.size();
    const auto read = std::from_chars(bytes.constData(), end, number);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(number))
        return std::nullopt;
    return number;
}

void addTuningOptions(QCommandLineParser &parser, const QString &command)
{
    if (isOneOf(command, {"snapshot", "header", "motor"}))
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
    if (isOneOf(command, {"revup"}))
        parser.addOption({QStringLiteral("set"),
            QStringLiteral(
                "Writes stages RPM,A,MS, or those of a file as revup --json prints them.")});
    if (isOneOf(command, {"gains"}))
        parser.addOptions({
            {QStringLiteral("bandwidth"), QStringLiteral("Of the current loop, in rad/s."),
                QStringLiteral("W")},
            {QStringLiteral("damping"),
                QStringLiteral("Of the speed loop: 2 is quick, 4 is calm. Left out: it stays."),
                QStringLiteral("D")},
            {QStringLiteral("inertia"),
                QStringLiteral("Of rotor and load in kg m2; few boards know it."),
                QStringLiteral("J")},
            {QStringLiteral("ke"),
                QStringLiteral("V rms per 1000 rpm, if the board's own is wrong."),
                QStringLiteral("K")},
            {QStringLiteral("delay"),
                QStringLiteral("Of the measured speed in ms. Left out: half the average that ST's "
                               "generator takes for the board's sensor."),
                QStringLiteral("MS")},
            {QStringLiteral("apply"), QStringLiteral("Writes them and reads them back.")},
        });
}

Outcome<TuningArguments> tuningOf(
    const QCommandLineParser &parser, const QString &command, const QStringList &words)
{
    TuningArguments arguments;
    if (isOneOf(command, {"snapshot", "header", "motor"})) {
        arguments.file = parser.value(QStringLiteral("output"));
        if (arguments.file.isEmpty() && command != QLatin1String("motor"))
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
    if (command == QLatin1String("gains"))
        if (const auto taken = takeGains(parser, arguments); !taken)
            return tl::make_unexpected(taken.error());
    if (command == QLatin1String("torque"))
        if (const auto taken = takeTorque(words, arguments); !taken)
            return tl::make_unexpected(taken.error());
    arguments.set = isSet(parser, "set");
    if (command == QLatin1String("revup") && arguments.set == words.isEmpty())
        return failure(kUsage,
            QStringLiteral(
                "Write revup, or revup --set and the stages as RPM,A,MS, such as 0,2.5,1000 "
                "1200,2.5,1500."));
    arguments.all = isSet(parser, "all");
    arguments.force = isSet(parser, "force");
    arguments.device =
        command == QLatin1String("diff") && std::any_of(words.begin(), words.end(), isDevice);
    return arguments;
}

} // namespace cli

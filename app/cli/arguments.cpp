#include "commands.h"
#include "drive/protocol_table.h"
#include "interrupt.h"
#include "session/transports/port_list.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace cli {

QString otherBoards()
{
    QStringList words;
    for (const session::PortChoice &choice : session::simulatedBoards())
        if (!choice.title.isEmpty())
            words.append(choice.path);
    return words.join(QStringLiteral(", "));
}

namespace {

constexpr OptionText kMotorOption{"motor", "N", "Number of the motor, 1 if not given."};
constexpr OptionText kFullScaleOption{"full-scale-current", "A",
    "Current in A (peak) of 32768 digits, for boards that do not tell the scale of their "
    "currents."};
constexpr OptionText kLimitOptions[] = {
    {"max-rpm", "R", "Refuses speeds beyond R, even where the board's own limit is higher."},
    {"max-amps", "A", "Refuses currents beyond A (peak), likewise."},
    {"expert", "",
        "Moves motors although the board does not tell all their limits; with set: also writes "
        "what "
        "nothing here bounds, such as open-loop voltages."},
};

QString commandList(std::span<const Command *const> commands)
{
    QString list = QStringLiteral("Talks to a motor drive. The command is the confirmation: "
                                  "nothing is asked.\n\nCommands:\n");
    for (const Command *command : commands) {
        const QString call =
            QLatin1String(command->name) + QLatin1Char(' ') + QLatin1String(command->words);
        list += QStringLiteral("  %1 %2\n")
                    .arg(call.trimmed().leftJustified(42), QLatin1String(command->help));
    }
    return list + QLatin1Char('\n') + QLatin1String(Interrupt::help())
        + QStringLiteral(
            "\nExit status: 0 done, 1 refused by the board, 2 usage, 3 no connection, 4 data "
            "lost, 5 file error, 6 stopped by its own bounds, 128 + signal when interrupted.");
}

/// The words of --protocol.
QString protocolWords(const QString &between)
{
    QStringList words;
    for (const drive::ProtocolRow &row : drive::protocolTable())
        words.append(QString::fromLatin1(row.choice.word.data(), int(row.choice.word.size())));
    return words.join(between);
}

void addCommonOptions(QCommandLineParser &parser)
{
    parser.addOptions({
        {QStringLiteral("port"),
            QStringLiteral(
                "Device path of a serial port, or sim for a simulated board; those of other "
                "protocols are %1.")
                .arg(otherBoards()),
            QStringLiteral("PORT")},
        {QStringLiteral("baud"),
            QStringLiteral("Bits per second, %1 if not given; with --protocol, what its boards "
                           "have.")
                .arg(Arguments().baud),
            QStringLiteral("N")},
        {QStringLiteral("protocol"),
            QStringLiteral("What is spoken on the line, auto if not given: it is found out."),
            protocolWords(QStringLiteral("|"))},
        {QStringLiteral("patience"),
            QStringLiteral("How many milliseconds later than usual an answer may come, 0 if not "
                           "given; for computers that stall."),
            QStringLiteral("MS")},
        {QStringLiteral("json"), QStringLiteral("Prints JSON instead of text.")},
        {{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Prints this help.")},
        {{QStringLiteral("v"), QStringLiteral("version")}, QStringLiteral("Prints the version.")},
    });
}

void addCommandOptions(QCommandLineParser &parser, const Command &command)
{
    if (command.ofOneMotor)
        addOption(parser, kMotorOption);
    if (command.needsPort || command.run != nullptr)
        addOption(parser, kFullScaleOption);
    if (command.canMove)
        for (const OptionText &option : kLimitOptions)
            addOption(parser, option);
    for (const OptionText &option : command.options)
        addOption(parser, option);
}

/// Options may stand before or behind the command's name; the later one counts.
Outcome<bool> parseCommon(const QCommandLineParser &parser, Arguments &arguments)
{
    const Given given(parser);
    if (given.has("port"))
        arguments.port = given.value("port");
    if (given.has("json"))
        arguments.json = true;
    if (given.has("protocol")) {
        const QString word = given.value("protocol");
        const auto protocol = drive::protocolOf(word.toStdString());
        if (!protocol)
            return usage(QStringLiteral("--protocol is one of %1, not \"%2\".")
                             .arg(protocolWords(QStringLiteral(", ")), word));
        arguments.protocol = *protocol;
        const std::uint32_t usual = drive::rowOf(*protocol).baud;
        if (arguments.baud == Arguments().baud && usual != 0)
            arguments.baud = usual;
    }
    int baud = static_cast<int>(arguments.baud);
    const auto numbers = readNumbers(given,
        {{"baud", &baud, 1200, 20'000'000}, {"patience", &arguments.patience_ms, 0, 10'000}});
    if (!numbers)
        return numbers;
    arguments.baud = static_cast<std::uint32_t>(baud);
    if (parser.isSet(QStringLiteral("version")))
        arguments.text = QCoreApplication::applicationName() + QLatin1Char(' ')
            + QCoreApplication::applicationVersion();
    else if (parser.isSet(QStringLiteral("help")))
        arguments.text = parser.helpText().trimmed();
    return arguments.text.has_value();
}

Outcome<bool> parseLimits(const Given &given, Arguments &arguments)
{
    for (const auto &[option, limit] : {std::pair{"max-rpm", &arguments.limits.maxSpeedRpm},
             std::pair{"max-amps", &arguments.limits.maxCurrentAmps},
             std::pair{"full-scale-current", &arguments.fullScaleCurrent_a}}) {
        if (!given.has(option))
            continue;
        const QString text = given.value(option);
        const auto number = plainNumber(text);
        if (!number || !(*number > 0.0))
            return usage(QStringLiteral("--%1 must be a number above 0, with a point, not \"%2\".")
                             .arg(QLatin1String(option), text));
        *limit = *number;
    }
    arguments.cyclicSetPoints = given.has("cyclic-setpoints");
    arguments.expert = given.has("expert");
    return true;
}

/// A speed may be negative and is no option then. (indexOf() wants the whole word to match.)
QStringList protectNegativeNumbers(QStringList line)
{
    static const QRegularExpression number(QStringLiteral("-[0-9.].*"));
    const auto first = line.indexOf(number);
    if (first > 0 && !line.contains(QStringLiteral("--")))
        line.insert(first, QStringLiteral("--"));
    return line;
}

Outcome<bool> parseCommand(const Command &command, const QStringList &line, Arguments &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QLatin1String(command.help));
    addCommonOptions(parser);
    addCommandOptions(parser, command);
    const QString name = QLatin1String(command.name);
    parser.addPositionalArgument(name, {}, name + QLatin1Char(' ') + QLatin1String(command.words));
    const QString seeHelp = QStringLiteral("see rotorscope-cli %1 --help.").arg(name);
    if (!parser.parse(command.numbers ? protectNegativeNumbers(line) : line))
        return usage(parser.errorText().remove(QRegularExpression(QStringLiteral("\\.$")))
            + QStringLiteral("; ") + seeHelp);
    for (const QString &option : parser.optionNames())
        if (parser.values(option).contains(QString()))
            return usage(
                QStringLiteral("%1%2 has an empty value; ")
                    .arg(option.size() > 1 ? QStringLiteral("--") : QStringLiteral("-"), option)
                + seeHelp);
    const auto common = parseCommon(parser, arguments);
    if (!common || *common)
        return common;
    const Given given(parser);
    arguments.words = given.words();
    if (arguments.words.size() < command.least || arguments.words.size() > command.most)
        return usage(QStringLiteral("Write: rotorscope-cli %1%2 %3; ")
                         .arg(command.needsPort ? QStringLiteral("--port PORT ") : QString(), name,
                             QLatin1String(command.words))
            + seeHelp);
    arguments.raw = given.has("raw");
    if (const auto motor = readNumbers(given, {{"motor", &arguments.motor, 1, 7}}); !motor)
        return motor;
    if (const auto limits = parseLimits(given, arguments); !limits)
        return limits;
    if (command.read != nullptr)
        if (const auto taken = command.read(given, arguments); !taken)
            return taken;
    if ((command.needsPort || arguments.tuning.device) && arguments.port.isEmpty())
        return usage(QStringLiteral(
            "Say where the board is with --port PORT, or --port sim for a simulated one; "
            "rotorscope-cli ports lists them."));
    return false;
}

} // namespace

Outcome<RampArguments> rampOf(const QString &rpm, const QString &milliseconds)
{
    const auto speed = wholeNumber(rpm, -1'000'000, 1'000'000, QStringLiteral("RPM"));
    if (!speed)
        return tl::make_unexpected(speed.error());
    const auto time = wholeNumber(milliseconds, 0, 65535, QStringLiteral("MS"));
    if (!time)
        return tl::make_unexpected(time.error());
    return RampArguments{*speed, *time};
}

Outcome<Arguments> parseArguments(const QStringList &line, std::span<const Command *const> commands)
{
    Arguments arguments;
    QCommandLineParser parser;
    parser.setApplicationDescription(commandList(commands));
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsPositionalArguments);
    addCommonOptions(parser);
    parser.addPositionalArgument(
        QStringLiteral("command"), {}, QStringLiteral("COMMAND [ARGUMENT...]"));
    if (!parser.parse(line))
        return usage(parser.errorText().remove(QRegularExpression(QStringLiteral("\\.$")))
            + QStringLiteral("; see rotorscope-cli --help."));
    const auto common = parseCommon(parser, arguments);
    if (!common)
        return tl::make_unexpected(common.error());
    if (*common)
        return arguments;
    const QStringList words = parser.positionalArguments();
    if (words.isEmpty())
        return usage(QStringLiteral("Say what to do; rotorscope-cli --help lists the commands."));
    const auto command = std::find_if(commands.begin(), commands.end(),
        [&](const Command *each) { return words.first() == QLatin1String(each->name); });
    if (command == commands.end())
        return usage(QStringLiteral("There is no command \"%1\"; rotorscope-cli --help lists them.")
                         .arg(words.first()));
    arguments.command = *command;
    return parseCommand(**command, words, arguments).map([&arguments](bool) { return arguments; });
}

} // namespace cli

#include "arguments.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

namespace cli {

namespace {

struct CommandText {
    const char *name = "";
    const char *words = ""; ///< after the name
    const char *help = "";
    int least = 0, most = 0; ///< number of words
    bool needsPort = true;
};

constexpr int kAny = 1'000'000;

const CommandText kCommands[] = {
    {"ports", "", "Lists the serial ports; those of ST-LINK debuggers are marked.", 0, 0, false},
    {"info", "", "Says what the board is, what was negotiated, and what its motors do.", 0, 0},
    {"registers", "", "Lists the registers that the board's firmware has.", 0, 0},
    {"get", "NAME[@MOTOR]...",
        "Reads registers, in A, V, rpm, degrees; with --raw as the numbers on the wire.", 1, kAny},
    {"set", "NAME[@MOTOR]=VALUE...",
        "Writes registers and prints each as old -> new, as read back. Values are in the unit that "
        "get shows, with --raw "
        "the numbers on the wire; the decimal sign is a point; structures are hexadecimal.",
        1, kAny},
    {"start", "", "Starts the motor.", 0, 0},
    {"stop", "", "Stops every motor and waits until they stand still.", 0, 0},
    {"ack", "", "Acknowledges the motor's faults.", 0, 0},
    {"ramp", "RPM MS", "Ramps the speed set-point to RPM within MS milliseconds.", 2, 2},
    {"capture", "--hf A,B --seconds S -o FILE.csv",
        "Records signals into a CSV file, which appears whole or not at all.", 0, 0},
    {"snapshot", "-o FILE.json",
        "Saves every register that can be read, with the name of board and firmware.", 0, 0},
    {"diff", "A.json B.json|device",
        "Lists the registers that differ between two snapshots, or a snapshot and the board.", 2, 2,
        false},
    {"restore", "FILE.json",
        "Writes back what differs from a snapshot, in as few requests as fit, and reads it back.",
        1, 1},
    {"revup", "[--set FILE|RPM,A,MS...]",
        "Shows the stages of the start-up and what is wrong with them, or writes others.", 0, 5},
    {"torque", "AMPS MS", "Ramps the torque set-point to AMPS of Iq within MS milliseconds.", 2, 2},
    {"gains", "--bandwidth W",
        "Computes gains of the current and speed loops from the motor's values, and applies them.",
        0, 0},
    {"motor", "[FILE.json] [-o FILE.json]",
        "Shows what the board says of its motor and what follows from it, beside a motor file or "
        "into one.",
        0, 1},
    {"header", "-o drive_parameters.h",
        "Writes the tuned values as a C header in the names of ST's drive_parameters.h.", 0, 0},
    {"show", "FILE.pcapng", "Says what is in a recording, and what is missing from it.", 1, 1,
        false},
    {"export", "FILE.pcapng -o FILE.csv|.mat|.wav|.json",
        "Writes the signals of a recording, or of a CSV file, in another format; or its registers.",
        1, 1, false},
    {"decode", "TRACE.jsonl", "Decodes a recorded session and prints one JSON object per packet.",
        1, 1, false},
};

const CommandText *findCommand(const QString &name)
{
    for (const CommandText &command : kCommands) {
        if (name == QLatin1String(command.name))
            return &command;
    }
    return nullptr;
}

QString commandList()
{
    QString list = QStringLiteral("Talks to a motor drive. The command is the confirmation: "
                                  "nothing is asked.\n\nCommands:\n");
    for (const CommandText &command : kCommands) {
        const QString call =
            QLatin1String(command.name) + QLatin1Char(' ') + QLatin1String(command.words);
        list += QStringLiteral("  %1 %2\n")
                    .arg(call.trimmed().leftJustified(42), QLatin1String(command.help));
    }
    return list
        + QStringLiteral("\nCtrl-C stops the motor that this run started.\n"
                         "Exit status: 0 done, 1 refused by the board, 2 usage, 3 no connection, 4 "
                         "data lost, 5 file "
                         "error, 128 + signal when interrupted.");
}

/// The words of --protocol.
QString protocolWords(const QString &between)
{
    QStringList words;
    for (const drive::ProtocolChoice &choice : drive::protocolChoices())
        words.append(QString::fromLatin1(choice.word.data(), int(choice.word.size())));
    return words.join(between);
}

void addCommonOptions(QCommandLineParser &parser)
{
    parser.addOptions({
        {QStringLiteral("port"),
            QStringLiteral(
                "Device path of a serial port, or sim for a simulated board; sim:legacy and "
                "sim:powerpc speak the older protocol."),
            QStringLiteral("PORT")},
        {QStringLiteral("baud"),
            QStringLiteral(
                "Bits per second, 1843200 if not given; 115200 with --protocol legacy or "
                "powerpc."),
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

/// Commands that can move a motor, or write what moves it.
bool canMove(const QString &command)
{
    static const QStringList kMoving{QStringLiteral("start"), QStringLiteral("ramp"),
        QStringLiteral("torque"), QStringLiteral("capture"), QStringLiteral("set"),
        QStringLiteral("restore")};
    return kMoving.contains(command);
}

/// Commands that need a board at the other end.
bool meetsBoard(const QString &command)
{
    static const QStringList kAlone{QStringLiteral("ports"), QStringLiteral("decode"),
        QStringLiteral("show"), QStringLiteral("export")};
    return !command.isEmpty() && !kAlone.contains(command);
}

void addCommandOptions(QCommandLineParser &parser, const QString &command)
{
    if (command == QLatin1String("get") || command == QLatin1String("set"))
        parser.addOption(
            {QStringLiteral("raw"), QStringLiteral("Numbers as they are on the wire.")});
    if (command == QLatin1String("start") || command == QLatin1String("ack")
        || command == QLatin1String("ramp") || command == QLatin1String("capture")
        || command == QLatin1String("revup") || command == QLatin1String("torque")
        || command == QLatin1String("gains") || command == QLatin1String("header")
        || command == QLatin1String("motor"))
        parser.addOption({QStringLiteral("motor"),
            QStringLiteral("Number of the motor, 1 if not given."), QStringLiteral("N")});
    if (meetsBoard(command))
        parser.addOption({QStringLiteral("full-scale-current"),
            QStringLiteral("Current in A (peak) of 32768 digits, for boards that do not tell the "
                           "scale of their currents."),
            QStringLiteral("A")});
    if (canMove(command))
        parser.addOptions({
            {QStringLiteral("max-rpm"),
                QStringLiteral(
                    "Refuses speeds beyond R, even where the board's own limit is higher."),
                QStringLiteral("R")},
            {QStringLiteral("max-amps"),
                QStringLiteral("Refuses currents beyond A (peak), likewise."), QStringLiteral("A")},
            {QStringLiteral("expert"),
                QStringLiteral("Moves motors although the board does not tell all their limits; "
                               "with set: also writes what nothing here bounds, such as open-loop "
                               "voltages.")},
        });
    if (command == QLatin1String("ramp") || command == QLatin1String("capture"))
        parser.addOption({QStringLiteral("cyclic-setpoints"),
            QStringLiteral("Set-points travel with every exchange (MCB); begins while the motor "
                           "stands.")});
    addTuningOptions(parser, command);
    addRecordingOptions(parser, command);
    if (command != QLatin1String("capture"))
        return;
    parser.addOptions({
        {QStringLiteral("hf"), QStringLiteral("Signals at the rate of the control loop."),
            QStringLiteral("A,B")},
        {QStringLiteral("hf-rate"),
            QStringLiteral("One sample every N + 1 control periods, 0 if not given."),
            QStringLiteral("N")},
        {QStringLiteral("mf"), QStringLiteral("Signals recorded less often."),
            QStringLiteral("C,D")},
        {QStringLiteral("mf-rate"),
            QStringLiteral(
                "One --mf group every N + 1 samples, 15 if not given; 254: one in each packet."),
            QStringLiteral("N")},
        {QStringLiteral("seconds"), QStringLiteral("How long to record."), QStringLiteral("S")},
        {{QStringLiteral("o"), QStringLiteral("output")}, QStringLiteral("The file to write."),
            QStringLiteral("FILE.csv")},
        {QStringLiteral("record"),
            QStringLiteral("Records samples, values and events into this file while they come."),
            QStringLiteral("FILE.pcapng")},
        {QStringLiteral("link"),
            QStringLiteral("With --record: the bytes of the line, too; twice the size.")},
        {QStringLiteral("start"),
            QStringLiteral(
                "Starts the motor first, waits until it runs, and stops it at the end.")},
        {QStringLiteral("ramp"),
            QStringLiteral("Ramps to RPM within MS milliseconds before recording."),
            QStringLiteral("RPM,MS")},
        {QStringLiteral("from-start"),
            QStringLiteral(
                "Begins to record before --start and --ramp; --seconds count from then.")},
        {QStringLiteral("keep-running"), QStringLiteral("Leaves the motor running at the end.")},
    });
}

auto usage(const QString &sentence) { return failure(kUsage, sentence); }

Outcome<int> wholeNumber(const QString &text, int least, int most, const QString &what)
{
    bool ok = false;
    const int number = text.trimmed().toInt(&ok);
    if (!ok || number < least || number > most)
        return usage(QStringLiteral("%1 must be a whole number from %2 to %3, not \"%4\".")
                         .arg(what, QString::number(least), QString::number(most), text));
    return number;
}

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

QStringList namesOf(const QString &list)
{
    QStringList names = list.split(QLatin1Char(','), Qt::SkipEmptyParts);
    for (QString &name : names)
        name = name.trimmed();
    return names;
}

Outcome<CaptureArguments> captureOf(const QCommandLineParser &parser)
{
    CaptureArguments capture;
    capture.fast = namesOf(parser.value(QStringLiteral("hf")));
    capture.slow = namesOf(parser.value(QStringLiteral("mf")));
    if (capture.fast.isEmpty() && capture.slow.isEmpty())
        return usage(QStringLiteral("Name the signals to record, for example --hf I_A,I_B."));
    for (const auto &[option, rate, most] : {std::tuple{"hf-rate", &capture.fastRate, 255},
             std::tuple{"mf-rate", &capture.slowRate, 254}}) {
        const QString name = QLatin1String(option);
        if (!parser.isSet(name))
            continue;
        const auto number = wholeNumber(parser.value(name), 0, most, QStringLiteral("--") + name);
        if (!number)
            return tl::make_unexpected(number.error());
        *rate = static_cast<unsigned>(*number);
    }
    bool ok = false;
    capture.seconds = parser.value(QStringLiteral("seconds")).toDouble(&ok);
    if (!ok || !std::isfinite(capture.seconds) || capture.seconds <= 0 || capture.seconds > 86400)
        return usage(QStringLiteral(
            "Say how long to record with --seconds S, more than 0 and at most 86400."));
    capture.file = parser.value(QStringLiteral("output"));
    capture.recording = parser.value(QStringLiteral("record"));
    capture.recordLink = parser.isSet(QStringLiteral("link"));
    if (capture.file.isEmpty() && capture.recording.isEmpty())
        return usage(QStringLiteral(
            "Name the file to write with -o FILE.csv, or --record FILE.pcapng, or both."));
    if (capture.recordLink && capture.recording.isEmpty())
        return usage(QStringLiteral("--link belongs to --record FILE.pcapng."));
    capture.start = parser.isSet(QStringLiteral("start"));
    capture.fromStart = parser.isSet(QStringLiteral("from-start"));
    capture.keepRunning = parser.isSet(QStringLiteral("keep-running"));
    if (parser.isSet(QStringLiteral("ramp"))) {
        const QStringList parts = parser.value(QStringLiteral("ramp")).split(QLatin1Char(','));
        if (parts.size() != 2)
            return usage(
                QStringLiteral("Write the ramp as --ramp RPM,MS, for example --ramp 1500,500."));
        const auto ramp = rampOf(parts[0], parts[1]);
        if (!ramp)
            return tl::make_unexpected(ramp.error());
        capture.ramp = *ramp;
    }
    return capture;
}

/// Options may stand before or behind the command's name; the later one counts.
Outcome<bool> takeCommon(const QCommandLineParser &parser, Arguments &arguments)
{
    if (parser.isSet(QStringLiteral("port")))
        arguments.port = parser.value(QStringLiteral("port"));
    if (parser.isSet(QStringLiteral("json")))
        arguments.json = true;
    if (parser.isSet(QStringLiteral("protocol"))) {
        const QString word = parser.value(QStringLiteral("protocol"));
        const auto protocol = drive::protocolOf(word.toStdString());
        if (!protocol)
            return usage(QStringLiteral("--protocol is one of %1, not \"%2\".")
                             .arg(protocolWords(QStringLiteral(", ")), word));
        arguments.protocol = *protocol;
        constexpr std::uint32_t kOlderBaud = 115200; // of every generated project seen
        if (arguments.baud == Arguments().baud
            && (*protocol == drive::Protocol::Legacy || *protocol == drive::Protocol::PowerPc))
            arguments.baud = kOlderBaud;
    }
    if (parser.isSet(QStringLiteral("baud"))) {
        const auto baud = wholeNumber(
            parser.value(QStringLiteral("baud")), 1200, 20'000'000, QStringLiteral("--baud"));
        if (!baud)
            return tl::make_unexpected(baud.error());
        arguments.baud = static_cast<std::uint32_t>(*baud);
    }
    if (parser.isSet(QStringLiteral("patience"))) {
        const auto patience = wholeNumber(
            parser.value(QStringLiteral("patience")), 0, 10'000, QStringLiteral("--patience"));
        if (!patience)
            return tl::make_unexpected(patience.error());
        arguments.patience_ms = *patience;
    }
    if (parser.isSet(QStringLiteral("version")))
        arguments.text = QCoreApplication::applicationName() + QLatin1Char(' ')
            + QCoreApplication::applicationVersion();
    else if (parser.isSet(QStringLiteral("help")))
        arguments.text = parser.helpText().trimmed();
    return arguments.text.has_value();
}

Outcome<bool> takeLimits(const QCommandLineParser &parser, Arguments &arguments)
{
    for (const auto &[option, limit] : {std::pair{"max-rpm", &arguments.limits.maxSpeedRpm},
             std::pair{"max-amps", &arguments.limits.maxCurrentAmps},
             std::pair{"full-scale-current", &arguments.fullScaleCurrent_a}}) {
        if (!parser.optionNames().contains(QLatin1String(option)))
            continue;
        const QString text = parser.value(QLatin1String(option));
        const auto number = plainNumber(text);
        if (!number || !(*number > 0.0))
            return usage(QStringLiteral("--%1 must be a number above 0, with a point, not \"%2\".")
                             .arg(QLatin1String(option), text));
        *limit = *number;
    }
    arguments.canMove = canMove(arguments.command);
    arguments.cyclicSetPoints = parser.optionNames().contains(QStringLiteral("cyclic-setpoints"));
    arguments.expert = parser.optionNames().contains(QStringLiteral("expert"));
    return true;
}

bool takesNegativeNumbers(const QString &command)
{
    return command == QLatin1String("ramp") || command == QLatin1String("torque")
        || command == QLatin1String("revup");
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

Outcome<bool> takeCommand(const CommandText &command, const QStringList &line, Arguments &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QLatin1String(command.help));
    addCommonOptions(parser);
    addCommandOptions(parser, arguments.command);
    parser.addPositionalArgument(
        arguments.command, {}, arguments.command + QLatin1Char(' ') + QLatin1String(command.words));
    const QString seeHelp = QStringLiteral("see rotorscope-cli %1 --help.").arg(arguments.command);
    if (!parser.parse(
            takesNegativeNumbers(arguments.command) ? protectNegativeNumbers(line) : line))
        return usage(parser.errorText().remove(QRegularExpression(QStringLiteral("\\.$")))
            + QStringLiteral("; ") + seeHelp);
    const auto common = takeCommon(parser, arguments);
    if (!common || *common)
        return common;
    arguments.words = parser.positionalArguments();
    if (arguments.words.size() < command.least || arguments.words.size() > command.most)
        return usage(QStringLiteral("Write: rotorscope-cli --port PORT %1 %2; ")
                         .arg(arguments.command, QLatin1String(command.words))
            + seeHelp);
    arguments.raw = parser.optionNames().contains(QStringLiteral("raw"));
    if (parser.optionNames().contains(QStringLiteral("motor"))) {
        const auto motor =
            wholeNumber(parser.value(QStringLiteral("motor")), 1, 7, QStringLiteral("--motor"));
        if (!motor)
            return tl::make_unexpected(motor.error());
        arguments.motor = *motor;
    }
    if (arguments.command == QLatin1String("ramp")) {
        const auto ramp = rampOf(arguments.words[0], arguments.words[1]);
        if (!ramp)
            return tl::make_unexpected(ramp.error());
        arguments.ramp = *ramp;
    }
    if (const auto limits = takeLimits(parser, arguments); !limits)
        return tl::make_unexpected(limits.error());
    auto tuning = tuningOf(parser, arguments.command, arguments.words);
    if (!tuning)
        return tl::make_unexpected(tuning.error());
    arguments.tuning = std::move(*tuning);
    auto recording = recordingOf(parser, arguments.command);
    if (!recording)
        return tl::make_unexpected(recording.error());
    arguments.recording = std::move(*recording);
    if (arguments.command == QLatin1String("capture")) {
        auto capture = captureOf(parser);
        if (!capture)
            return tl::make_unexpected(capture.error());
        arguments.capture = std::move(*capture);
    }
    if ((command.needsPort || arguments.tuning.device) && arguments.port.isEmpty())
        return usage(QStringLiteral(
            "Say where the board is with --port PORT, or --port sim for a simulated one; "
            "rotorscope-cli ports lists them."));
    return false;
}

} // namespace

Outcome<Arguments> parseArguments(const QStringList &line)
{
    Arguments arguments;
    QCommandLineParser parser;
    parser.setApplicationDescription(commandList());
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsPositionalArguments);
    addCommonOptions(parser);
    parser.addPositionalArgument(
        QStringLiteral("command"), {}, QStringLiteral("COMMAND [ARGUMENT...]"));
    if (!parser.parse(line))
        return usage(parser.errorText().remove(QRegularExpression(QStringLiteral("\\.$")))
            + QStringLiteral("; see rotorscope-cli --help."));
    const auto common = takeCommon(parser, arguments);
    if (!common)
        return tl::make_unexpected(common.error());
    if (*common)
        return arguments;
    const QStringList words = parser.positionalArguments();
    if (words.isEmpty())
        return usage(QStringLiteral("Say what to do; rotorscope-cli --help lists the commands."));
    const CommandText *command = findCommand(words.first());
    if (command == nullptr)
        return usage(QStringLiteral("There is no command \"%1\"; rotorscope-cli --help lists them.")
                         .arg(words.first()));
    arguments.command = words.first();
    const auto taken = takeCommand(*command, words, arguments);
    if (!taken)
        return tl::make_unexpected(taken.error());
    return arguments;
}

} // namespace cli

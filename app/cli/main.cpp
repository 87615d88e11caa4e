// rotorscope-cli: one command, one board, one exit status. Its words are a contract that scripts depend on, so they
// are English in every language.
#include "commands.h"
#include "own_limits.h"
#include "session/limits_file.h"

#include <QCoreApplication>

namespace cli {

namespace {

struct LinkCommand {
    const char *name;
    Outcome<int> (*run)(Desk &);
};

const LinkCommand kLinkCommands[] = {
    {"info", runInfo},
    {"registers", runRegisters},
    {"get", runGet},
    {"set", runSet},
    {"start", runStart},
    {"ack", runAcknowledge},
    {"ramp", runRamp},
    {"capture", runCapture},
    {"snapshot", runSnapshot},
    {"diff", runDiff},
    {"restore", runRestore},
    {"revup", runRevUp},
    {"torque", runTorque},
    {"gains", runGains},
    {"header", runHeader},
    {"motor", runMotor},
};

/// A capture that stops what it started stops it also if it is killed. All else is meant to last longer than the program.
std::shared_ptr<session::Guardian> guardianFor(const Arguments &arguments)
{
    const bool owns = arguments.command == QLatin1String("capture") && arguments.capture.start
        && !arguments.capture.keepRunning;
    const char *why = nullptr;
    std::shared_ptr<session::Guardian> guardian;
    if (owns && !(guardian = session::startGuardian(why)))
        Output::error(QString::fromLatin1(why));
    return guardian;
}

Outcome<int> runLinkCommand(const Arguments &arguments, Output &out)
{
    const std::shared_ptr<session::Guardian> guardian = guardianFor(arguments);
    const Interrupt interrupt;
    Conversation talk(arguments, interrupt, guardian);
    const auto met = talk.connect();
    if (!met)
        return tl::make_unexpected(met.error());
    const auto board = talk.scaled(*met);
    if (!board)
        return tl::make_unexpected(board.error());
    if (const auto bounded = talk.bound(*board); !bounded)
        return tl::make_unexpected(bounded.error());
    Desk desk{arguments, talk, *board, out};
    for (const LinkCommand &command : kLinkCommands) {
        if (arguments.command == QLatin1String(command.name))
            return command.run(desk);
    }
    return kUsage; // parseArguments() lets no other name through
}

Outcome<int> run(const QStringList &line)
{
    auto arguments = parseArguments(line);
    if (!arguments)
        return tl::make_unexpected(arguments.error());
    if (const auto bounded = addOwnLimits(*arguments, session::limitsPath()); !bounded)
        return tl::make_unexpected(bounded.error());
    Output out(arguments->json);
    Outcome<int> status = kDone;
    if (arguments->text)
        out.ownText(*arguments->text);
    else if (arguments->command == QLatin1String("ports"))
        status = runPorts(out);
    else if (arguments->command == QLatin1String("decode"))
        status = runDecode(*arguments, out);
    else if (arguments->command == QLatin1String("show"))
        status = runShow(*arguments, out);
    else if (arguments->command == QLatin1String("export"))
        status = runExport(*arguments, out);
    else if (arguments->command == QLatin1String("diff") && !arguments->tuning.device)
        status = runDiffOfFiles(*arguments, out);
    else if (arguments->command == QLatin1String("stop"))
        status = runStop(*arguments, out);
    else
        status = runLinkCommand(*arguments, out);
    if (!out.flush() && status && *status == kDone)
        return failure(
            kFileError, QStringLiteral("The output could not be written; check where it goes."));
    return status;
}

} // namespace

} // namespace cli

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("rotorscope-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ROTORSCOPE_VERSION));
    const auto status = cli::run(QCoreApplication::arguments());
    if (status)
        return *status;
    cli::Output::error(status.error().sentence);
    return status.error().status;
}

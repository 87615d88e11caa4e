// rotorscope-cli: one command, one board, one exit status. Its words are a contract that scripts depend on, so they
// are English in every language.
#include "commands.h"
#include "own_limits.h"
#include "session/limits_file.h"

#include <QCoreApplication>

namespace cli {

namespace {

/// In the order of the help.
const Command *const kCommands[] = {&kPorts, &kInfo, &kRegisters, &kGet, &kSet, &kStart, &kStop,
    &kAcknowledge, &kRamp, &kCapture, &kSnapshot, &kDiff, &kRestore, &kRevUp, &kTorque, &kGains,
    &kMotor, &kHeader, &kShow, &kExport, &kDecode};

/// A capture that stops what it started stops it also if it is killed. All else is meant to last longer than the program.
std::shared_ptr<session::Guardian> guardianFor(const Arguments &arguments)
{
    const bool owns = arguments.capture.start && !arguments.capture.keepRunning;
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
    return arguments.command->run(desk);
}

Outcome<int> run(const QStringList &line)
{
    auto arguments = parseArguments(line, kCommands);
    if (!arguments)
        return tl::make_unexpected(arguments.error());
    if (const auto bounded = addOwnLimits(*arguments, session::limitsPath()); !bounded)
        return tl::make_unexpected(bounded.error());
    Output out(arguments->json);
    Outcome<int> status = kDone;
    if (arguments->text)
        out.ownText(*arguments->text);
    else if (arguments->command->runAlone != nullptr && !arguments->tuning.device)
        status = arguments->command->runAlone(*arguments, out);
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

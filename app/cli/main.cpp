// rotorscope-cli: one command, one board, one exit status. Its words are a contract that scripts depend on, so they
// are English in every language.
#include "commands.h"
#include "session/files/limits_file.h"

#include <QCoreApplication>

#include <algorithm>
#include <filesystem>
#include <type_traits>

namespace cli {

namespace {

/// In the order of the help.
const Command *const kCommands[] = {&kPorts, &kInfo, &kRegisters, &kGet, &kSet, &kStart, &kStop,
    &kAcknowledge, &kRamp, &kCapture, &kSnapshot, &kDiff, &kRestore, &kRevUp, &kTorque, &kGains,
    &kMotor, &kHeader, &kStep, &kIdentify, &kPolePairs, &kResponse, &kAutotune, &kExperiment,
    &kEvaluate, &kShow, &kExport, &kDecode};

/// The limits that the user has set in the window hold here, too: those of the file are added to the arguments of a
/// command that can move a motor, which is said on standard error. A file that cannot be read ends such a command,
/// unless both limits are given.
Outcome<bool> addOwnLimits(Arguments &arguments, const QString &file)
{
    drive::UserLimits &limits = arguments.limits;
    if (arguments.command == nullptr || !arguments.command->canMove
        || (limits.maxSpeedRpm > 0.0 && limits.maxCurrentAmps > 0.0))
        return true;
    const auto own = session::loadLimits(file);
    if (!own)
        return failure(kFileError,
            QStringLiteral(
                "Your own limits in %1 cannot be read (%2); set them again in the window, "
                "or give --max-rpm and --max-amps.")
                .arg(file, own.error()));
    if (!*own)
        return true;
    QStringList taken;
    const auto take = [&taken](double &limit, double its, const QString &unit) {
        if (limit > 0.0 || !(its > 0.0))
            return;
        limit = its;
        taken.append(numberText(its) + QLatin1Char(' ') + unit);
    };
    take(limits.maxSpeedRpm, (*own)->maxSpeedRpm, QStringLiteral("rpm"));
    take(limits.maxCurrentAmps, (*own)->maxCurrentAmps, QStringLiteral("A"));
    if (!taken.isEmpty())
        Output::error(QStringLiteral("Your own limits hold: %1 (from %2).")
                          .arg(taken.join(QStringLiteral(", ")), file));
    return true;
}

/// What stops what it started stops it also if it is killed. All else is meant to last longer than the program.
std::shared_ptr<session::Guardian> guardianFor(const Arguments &arguments)
{
    const bool owns =
        arguments.command->ownsMotor || (arguments.capture.start && !arguments.capture.keepRunning);
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
    if (auto bounded = talk.bound(*board); !bounded)
        return bounded;
    const int motors = board->identity.motors;
    if (arguments.command->ofOneMotor && arguments.motor > motors)
        return failure(kUsage,
            QStringLiteral("The board has no motor %1, only %2.")
                .arg(QString::number(arguments.motor), QString::number(motors)));
    Desk desk{arguments, talk, *board, out};
    return arguments.command->run(desk);
}

/// Bytes that are no text would become the name of another file. Only where names of files are bytes: elsewhere Qt does
/// not take the arguments from here.
Outcome<bool> checkTyped(std::span<char *const> typed)
{
    if constexpr (std::is_same_v<std::filesystem::path::value_type, char>)
        for (const char *word : typed)
            if (const QString text = QString::fromLocal8Bit(word); text.toLocal8Bit() != word)
                return usage(
                    QStringLiteral("\"%1\" is not UTF-8 as it was typed; write it so, or rename "
                                   "what is called so.")
                        .arg(text));
    return true;
}

Outcome<int> run(const QStringList &line, std::span<char *const> typed)
{
    if (const auto text = checkTyped(typed); !text)
        return tl::make_unexpected(text.error());
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
    const auto status =
        cli::run(QCoreApplication::arguments(), {argv + std::min(argc, 1), argv + argc});
    if (status)
        return *status;
    cli::Output::error(status.error().sentence);
    return status.error().status;
}

// start, stop, ack, ramp and torque.
#include "commands.h"
#include "motor_facts.h"
#include "sentences.h"

#include <QJsonObject>

#include <cmath>

namespace cli {

using namespace std::chrono_literals;

namespace {

constexpr auto kCoastsFor = 10s; ///< a motor may coast

/// Carries out a wish for the motor that is meant and prints the state that follows.
/// @param atRest  what else is to be known where the motor stands, for people
Outcome<int> commandMotor(Desk &desk, const decltype(drive::Wish::what) &wish, const QString &what,
    const QString &atRest = {})
{
    if (auto armed = desk.talk.armToMove(); !armed)
        return armed;
    if (auto ended = desk.talk.command(wish, what); !ended)
        return ended;
    const auto status = desk.talk.nextStatus(desk.arguments.motor);
    if (!status)
        return tl::make_unexpected(status.error());
    printStatus(desk.out, *status);
    if (drive::rests(status->state) && !atRest.isEmpty() && !desk.out.json())
        desk.out.line(atRest);
    return kDone;
}

QString targetText(const drive::StartTarget &target)
{
    return target.rpm ? QStringLiteral("Start -> %1 rpm").arg(numberText(std::round(*target.rpm)))
        : target.amps ? QStringLiteral("Start -> Iq of %1 A")
                            .arg(numberText(std::round(*target.amps * 1e3) / 1e3))
                      : QStringLiteral("Start; what it goes to is not known.");
}

Outcome<int> runStart(Desk &desk)
{
    const auto target = startTarget(desk);
    if (!target)
        return tl::make_unexpected(target.error());
    if (!desk.out.json())
        desk.out.line(targetText(*target));
    const auto done =
        commandMotor(desk, drive::Command{drive::MotorAction::Start, desk.arguments.motor},
            QStringLiteral("The start"));
    // Interrupted half-way, the motor may be on its way: it is this run's to stop.
    if (!done && done.error().status > kInterrupted)
        (void)desk.talk.stop(0ms);
    return done;
}

Outcome<int> runStop(const Arguments &arguments, Output &out)
{
    const Interrupt interrupt;
    Conversation talk(arguments, interrupt);
    const auto stopped = talk.stopAtOnce(kCoastsFor);
    if (!stopped)
        return tl::make_unexpected(stopped.error());
    const bool still = *stopped == drive::StopWord::Standstill;
    if (out.json())
        out.line(
            QJsonObject{{QStringLiteral("stopped"), true}, {QStringLiteral("standstill"), still}});
    else
        out.line(still ? QStringLiteral("Standstill measured.")
                : *stopped == drive::StopWord::MayCoast
                ? QStringLiteral(
                    "The drive is idle. Its speed is not measurable: the rotor may coast.")
                : QStringLiteral("The drive is idle; no standstill was measured yet."));
    return kDone;
}

Outcome<int> runAcknowledge(Desk &desk)
{
    const auto done = commandMotor(desk,
        drive::Command{drive::MotorAction::AcknowledgeFaults, desk.arguments.motor},
        QStringLiteral("The acknowledgement"));
    if (!done)
        return done;
    const auto status = desk.talk.status(desk.arguments.motor);
    if (status && !status->faultsNow.empty())
        return failure(kRefused,
            QStringLiteral("The fault is still present: %1; remove its cause first.")
                .arg(stateText(*status)));
    return done;
}

Outcome<int> runRamp(Desk &desk)
{
    const RampArguments &ramp = desk.arguments.ramp;
    return commandMotor(desk,
        drive::SpeedRamp{.motor = desk.arguments.motor,
            .rpm = ramp.rpm,
            .duration = std::chrono::milliseconds(ramp.milliseconds)},
        QStringLiteral("The ramp"),
        QStringLiteral("The motor stands: the speed is for its next start."));
}

Outcome<int> runTorque(Desk &desk)
{
    const TuningArguments &torque = desk.arguments.tuning;
    if (desk.arguments.limits.maxSpeedRpm > 0.0 && torque.amps != 0.0)
        Output::error(
            QStringLiteral("In torque control nothing keeps the speed within --max-rpm."));
    return commandMotor(desk,
        drive::TorqueRamp{.motor = desk.arguments.motor,
            .amps = torque.amps,
            .duration = std::chrono::milliseconds(torque.milliseconds)},
        QStringLiteral("The ramp"),
        QStringLiteral("The motor stands: the current is for its next start."));
}

constexpr OptionText kRampOptions[] = {kCyclicOption};

Outcome<bool> readRamp(const Given &given, Arguments &arguments)
{
    const auto ramp = rampOf(given.words()[0], given.words()[1]);
    if (!ramp)
        return tl::make_unexpected(ramp.error());
    arguments.ramp = *ramp;
    return true;
}

Outcome<bool> readTorque(const Given &given, Arguments &arguments)
{
    const QStringList words = given.words();
    const auto amps = plainNumber(words[0]);
    bool ok = false;
    const int time = words[1].toInt(&ok);
    if (!amps || !ok || time < 0 || time > 65535)
        return usage(
            QStringLiteral("Write torque AMPS MS, such as torque 1.5 500; MS is at most 65535."));
    arguments.tuning.amps = *amps;
    arguments.tuning.milliseconds = time;
    return true;
}

} // namespace

const Command kStart{.name = "start",
    .help = "Starts the motor.",
    .canMove = true,
    .ofOneMotor = true,
    .run = runStart};

/// Meets no board first: the STOPs leave as soon as the port is open.
const Command kStop{.name = "stop",
    .help = "Stops every motor and waits until they stand still.",
    .runAlone = runStop};

const Command kAcknowledge{.name = "ack",
    .help = "Acknowledges the motor's faults.",
    .ofOneMotor = true,
    .run = runAcknowledge};

const Command kRamp{.name = "ramp",
    .words = "RPM MS",
    .help = "Ramps the speed set-point to RPM within MS milliseconds.",
    .least = 2,
    .most = 2,
    .options = kRampOptions,
    .read = readRamp,
    .canMove = true,
    .ofOneMotor = true,
    .numbers = true,
    .run = runRamp};

const Command kTorque{.name = "torque",
    .words = "AMPS MS",
    .help = "Ramps the torque set-point to AMPS of Iq within MS milliseconds.",
    .least = 2,
    .most = 2,
    .read = readTorque,
    .canMove = true,
    .ofOneMotor = true,
    .numbers = true,
    .run = runTorque};

} // namespace cli

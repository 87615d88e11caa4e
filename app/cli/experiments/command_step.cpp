// step: brings the motor to one speed, steps it to another and back, and says how its speed loop followed. Afterwards the
// motor is as it was.
#include "experiments/experiment_run.h"

namespace cli {

namespace {

Outcome<int> runStep(Desk &desk)
{
    const StepArguments &asked = desk.arguments.step;
    ExperimentRun run(desk);
    const auto subject = run.subject();
    if (!subject)
        return tl::make_unexpected(subject.error());
    const lab::StepPlan plan{.fromRpm = asked.fromRpm,
        .toRpm = asked.toRpm,
        .repeat = asked.repeat,
        .hold = std::chrono::milliseconds(asked.hold_ms),
        .caps = desk.arguments.limits};
    return run.run(*subject, {plan});
}

constexpr OptionText kOptions[] = {
    {"from", "RPM", "The speed to step from."},
    {"to", "RPM", "The speed to step to."},
    {"repeat", "N", "Steps up, and as many down; 5 if not given."},
    {"hold", "MS", "How long each speed is held; 500 if not given."},
    kRunOption,
};

Outcome<bool> readStep(const Given &given, Arguments &arguments)
{
    StepArguments &step = arguments.step;
    if (given.words().first() != QLatin1String("speed"))
        return usage(QStringLiteral("Only speed can be stepped, not \"%1\": write step speed "
                                    "--from A --to B.")
                         .arg(given.words().first()));
    if (!given.has("from") || !given.has("to"))
        return usage(
            QStringLiteral("Say between which speeds, for example --from 1000 --to 1500."));
    constexpr int kMostRpm = 1'000'000;
    constexpr int kMostRepeats = 100, kMostHold_ms = 10'000;
    const auto numbers = readNumbers(given,
        {{"from", &step.fromRpm, -kMostRpm, kMostRpm}, {"to", &step.toRpm, -kMostRpm, kMostRpm},
            {"repeat", &step.repeat, 1, kMostRepeats}, {"hold", &step.hold_ms, 50, kMostHold_ms}});
    if (!numbers)
        return numbers;
    return readRunFile(given, arguments);
}

} // namespace

const Command kStep{.name = "step",
    .words = "speed --from A --to B",
    .help = "Steps the speed up and down and says how its loop followed; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kOptions,
    .read = readStep,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runStep};

} // namespace cli

// identify: measures the motor itself; so far its inertia and its friction. Afterwards the motor is as it was.
#include "experiments/experiment_run.h"

namespace cli {

namespace {

Outcome<int> runIdentify(Desk &desk)
{
    ExperimentRun run(desk);
    const auto subject = run.subject();
    if (!subject)
        return tl::make_unexpected(subject.error());
    const lab::SpinPlan plan = lab::spinPlanFor(*subject, desk.arguments.limits);
    return run.run({plan, *subject}, lab::entryOf(plan, *subject));
}

constexpr OptionText kOptions[] = {kRunOption};

Outcome<bool> readIdentify(const Given &given, Arguments &arguments)
{
    if (given.words().first() != QLatin1String("mechanical"))
        return usage(QStringLiteral("Only the mechanics can be identified, not \"%1\": write "
                                    "identify mechanical.")
                         .arg(given.words().first()));
    return readRunFile(given, arguments);
}

} // namespace

const Command kIdentify{.name = "identify",
    .words = "mechanical",
    .help = "Accelerates the motor and lets it coast: inertia and friction; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kOptions,
    .read = readIdentify,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runIdentify};

} // namespace cli

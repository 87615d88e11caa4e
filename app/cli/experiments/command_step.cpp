// step: lets a speed, a torque or the current along the magnets jump to and fro, and says how its loop followed; or
// holds a speed while its load comes and goes.
// Afterwards the motor is as it was.
#include "experiments/run.h"

#include <cmath>

namespace cli {

namespace {

using Kind = StepArguments::Kind;

lab::Plan planFor(const StepArguments &asked, const lab::Subject &subject, const Desk &desk)
{
    const drive::UserLimits &limits = desk.arguments.limits;
    if (asked.kind == Kind::Speed) {
        lab::StepPlan plan{
            .fromRpm = asked.fromRpm, .toRpm = asked.toRpm, .repeat = asked.repeat, .caps = limits};
        if (asked.hold_ms > 0)
            plan.hold = std::chrono::milliseconds(asked.hold_ms);
        return plan;
    }
    if (asked.kind == Kind::Load) {
        lab::LoadPlan plan = lab::loadPlanFor(subject, limits);
        if (asked.hold_ms > 0)
            plan.hold = std::chrono::milliseconds(asked.hold_ms) / 2;
        if (asked.rpm)
            plan.fromRpm = plan.toRpm = *asked.rpm;
        return plan;
    }
    lab::CurrentStepPlan plan = lab::currentStepPlanFor(
        subject, asked.kind == Kind::Flux, asked.fromAmps, asked.toAmps, limits);
    plan.repeat = asked.repeat;
    if (asked.hold_ms > 0)
        plan.hold = std::chrono::milliseconds(asked.hold_ms);
    if (asked.rpm)
        plan.rpm = *asked.rpm;
    return plan;
}

Outcome<int> runStep(Desk &desk)
{
    ExperimentRun run(desk);
    const auto subject = run.subject(desk.arguments.step.kind == Kind::Speed);
    if (!subject)
        return tl::make_unexpected(subject.error());
    const lab::Plan plan = planFor(desk.arguments.step, *subject, desk);
    if (const auto *load = std::get_if<lab::LoadPlan>(&plan))
        Output::error(QStringLiteral("The speed will be held for %1 s: put the load on and take it "
                                     "off meanwhile, and wait until the speed is back each time.")
                          .arg(load->length() / std::chrono::seconds(1)));
    return run.run(*subject, {plan});
}

constexpr OptionText kStepOptions[] = {
    {"from", "RPM|A", "The speed to step from; amps of a torque or a flux."},
    {"to", "RPM|A", "The speed to step to; amps of a torque or a flux."},
    {"repeat", "N", "Steps up, and as many down; 5 if not given."},
    {"hold", "MS",
        "How long each is held; 500 if not given, 20 of a torque or a flux, 10000 of a load."},
    {"speed", "RPM",
        "Of a torque or a flux: at which the motor turns; 0.35 of what is allowed if not given, "
        "0.45 without a sensor. Of a load: 0.5."},
    kRunOption,
};

Outcome<bool> readAmps(const Given &given, StepArguments &step)
{
    constexpr double kMost = 1e5;
    for (const auto &[name, amps] :
        {std::pair("from", &step.fromAmps), std::pair("to", &step.toAmps)}) {
        const auto number = plainNumber(given.value(name));
        if (!number || std::abs(*number) > kMost)
            return usage(QStringLiteral("--%1 %2 is no current in amps.")
                             .arg(QLatin1String(name), given.value(name)));
        *amps = *number;
    }
    return true;
}

Outcome<bool> readStep(const Given &given, Arguments &arguments)
{
    StepArguments &step = arguments.step;
    const QString what = given.words().first();
    if (what == QLatin1String("torque"))
        step.kind = Kind::Torque;
    else if (what == QLatin1String("flux"))
        step.kind = Kind::Flux;
    else if (what == QLatin1String("load"))
        step.kind = Kind::Load;
    else if (what != QLatin1String("speed"))
        return usage(QStringLiteral("There is no \"%1\" to step: write step speed, step torque, "
                                    "step flux or step load.")
                         .arg(what));
    const bool speed = step.kind == Kind::Speed, load = step.kind == Kind::Load;
    if (load && (given.has("from") || given.has("to") || given.has("repeat")))
        return usage(
            QStringLiteral("--from, --to and --repeat are not for a load: you change it."));
    if (!load && (!given.has("from") || !given.has("to")))
        return usage(speed
                ? QStringLiteral("Say between which speeds, for example --from 1500 --to 1800.")
                : QStringLiteral("Say between which currents, for example --from 0.5 --to 2."));
    if (speed && given.has("speed"))
        return usage(
            QStringLiteral("--speed is for torque, flux and load: a speed has --from and --to."));
    constexpr int kMostRpm = 1'000'000;
    constexpr int kMostRepeats = 100;
    const std::pair<int, int> hold_ms = speed ? std::pair(50, 10'000)
        : load                                ? std::pair(2'000, 30'000)
                                              : std::pair(10, 500);
    int rpm = 0;
    const auto numbers = readNumbers(given,
        {{"repeat", &step.repeat, 1, kMostRepeats},
            {"hold", &step.hold_ms, hold_ms.first, hold_ms.second},
            {"speed", &rpm, -kMostRpm, kMostRpm}});
    if (!numbers)
        return numbers;
    if (given.has("speed"))
        step.rpm = rpm;
    const auto ends = speed ? readNumbers(given,
                          {{"from", &step.fromRpm, -kMostRpm, kMostRpm},
                              {"to", &step.toRpm, -kMostRpm, kMostRpm}})
        : load              ? Outcome<bool>(true)
                            : readAmps(given, step);
    return ends ? readRunFile(given, arguments) : ends;
}

} // namespace

const Command kStep{.name = "step",
    .words = "speed|torque|flux --from A --to B, or step load",
    .help = "Steps a speed or a current up and down and says how its loop followed, or how a speed "
            "takes a load that you change; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kStepOptions,
    .read = readStep,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runStep};

} // namespace cli

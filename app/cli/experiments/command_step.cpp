// step: lets a speed, a torque or the current along the magnets jump to and fro, or moves the shaft by an angle and
// back, and says how the loop followed; or holds a speed while its load comes and goes.
// Afterwards the motor is as it was.
#include "experiments/run.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

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
    if (asked.kind == Kind::Position) {
        lab::PositionPlan plan{
            .byDegrees = asked.byDegrees, .repeat = asked.repeat, .caps = limits};
        if (asked.in_ms > 0)
            plan.ramp = std::chrono::milliseconds(asked.in_ms);
        if (asked.hold_ms > 0)
            plan.hold = std::chrono::milliseconds(asked.hold_ms);
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
    {"by", "DEGREES", "Of a position: how far the shaft is moved, from where it rests."},
    {"in", "MS", "Of a position: the time of each move; 300 if not given."},
    {"repeat", "N", "Steps up, and as many down; 5 if not given."},
    {"hold", "MS",
        "How long each is held; 500 if not given, 20 of a torque or a flux, 10000 of a load."},
    {"speed", "RPM",
        "Of a torque or a flux: at which the motor turns; 0.35 of what is allowed if not given, "
        "0.45 without a sensor. Of a load: 0.5."},
    kRunOption,
};

/// What can be stepped, and which options it has besides --hold and --output.
struct Stepped {
    const char *word;
    Kind kind;
    std::pair<int, int> hold_ms; ///< from, to
    std::initializer_list<const char *> needs, may;
    const char *example; ///< of what it needs
};
const Stepped kStepped[] = {
    {"speed", Kind::Speed, {50, 10'000}, {"from", "to"}, {"repeat"},
        "Say between which speeds, for example --from 1500 --to 1800."},
    {"torque", Kind::Torque, {10, 500}, {"from", "to"}, {"repeat", "speed"},
        "Say between which currents, for example --from 0.5 --to 2."},
    {"flux", Kind::Flux, {10, 500}, {"from", "to"}, {"repeat", "speed"},
        "Say between which currents, for example --from 0.5 --to 2."},
    {"load", Kind::Load, {2'000, 30'000}, {}, {"speed"}, ""},
    {"position", Kind::Position, {100, 10'000}, {"by"}, {"in", "repeat"},
        "Say how far the shaft is to be moved, for example --by 90."},
};

/// A number that may have a fraction. @param what  it is, for the refusal
Outcome<bool> readReal(
    const Given &given, const char *name, double most, const char *what, double &into)
{
    const auto number = plainNumber(given.value(name));
    if (!number || std::abs(*number) > most)
        return usage(QStringLiteral("--%1 %2 is no %3.")
                         .arg(QLatin1String(name), given.value(name), QLatin1String(what)));
    into = *number;
    return true;
}

Outcome<bool> readEnds(const Given &given, StepArguments &step)
{
    constexpr int kMostRpm = 1'000'000;
    constexpr double kMostAmps = 1e5, kMostDegrees = 1e6;
    switch (step.kind) {
    case Kind::Speed:
        return readNumbers(given,
            {{"from", &step.fromRpm, -kMostRpm, kMostRpm},
                {"to", &step.toRpm, -kMostRpm, kMostRpm}});
    case Kind::Torque:
    case Kind::Flux:
        if (auto from = readReal(given, "from", kMostAmps, "current in amps", step.fromAmps); !from)
            return from;
        return readReal(given, "to", kMostAmps, "current in amps", step.toAmps);
    case Kind::Position:
        return readReal(given, "by", kMostDegrees, "angle in degrees", step.byDegrees);
    case Kind::Load:
        break;
    }
    return true;
}

Outcome<bool> readStep(const Given &given, Arguments &arguments)
{
    StepArguments &step = arguments.step;
    const QString what = given.words().first();
    const auto of = std::ranges::find_if(
        kStepped, [&](const Stepped &one) { return what == QLatin1String(one.word); });
    if (of == std::end(kStepped))
        return usage(QStringLiteral("There is no \"%1\" to step: write step speed, step torque, "
                                    "step flux, step load or step position.")
                         .arg(what));
    step.kind = of->kind;
    const auto among = [](std::initializer_list<const char *> names, std::string_view name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (const char *name : {"from", "to", "by", "in", "repeat", "speed"})
        if (given.has(name) && !among(of->needs, name) && !among(of->may, name))
            return usage(QStringLiteral("--%1 is not for step %2.").arg(QLatin1String(name), what));
    for (const char *name : of->needs)
        if (!given.has(name))
            return usage(QLatin1String(of->example));
    constexpr int kMostRpm = 1'000'000, kMostRepeats = 100, kMost_ms = 10'000;
    int rpm = 0;
    const auto numbers = readNumbers(given,
        {{"repeat", &step.repeat, 1, kMostRepeats},
            {"hold", &step.hold_ms, of->hold_ms.first, of->hold_ms.second},
            {"in", &step.in_ms, 1, kMost_ms}, {"speed", &rpm, -kMostRpm, kMostRpm}});
    if (!numbers)
        return numbers;
    if (given.has("speed"))
        step.rpm = rpm;
    const auto ends = readEnds(given, step);
    return ends ? readRunFile(given, arguments) : ends;
}

} // namespace

const Command kStep{.name = "step",
    .words = "speed|torque|flux|position|load",
    .help = "Steps a speed, a current or a position there and back and says how its loop followed, "
            "or how a speed takes a load that you change; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kStepOptions,
    .read = readStep,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runStep};

} // namespace cli

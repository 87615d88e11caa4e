// identify: measures the motor itself: its inertia and its friction, or what its windings and its magnets are.
// Afterwards the motor is as it was.
#include "experiments/run.h"

namespace cli {

namespace {

constexpr QLatin1String kMechanical("mechanical"), kElectrical("electrical");

/// With what an ampere is worth where the board does not tell it.
Outcome<lab::Subject> subjectOf(const Desk &desk, const ExperimentRun &run, bool mechanical)
{
    auto subject = run.subject(mechanical);
    const double given_nm = desk.arguments.torqueConstant_nm;
    if (subject && !subject->records() && subject->registers.current != 0 && given_nm == 0.0)
        return failure(kRefused,
            QStringLiteral("This board does not tell which torque an ampere makes: give it with "
                           "--torque-constant."));
    if (!subject || given_nm == 0.0)
        return subject;
    if (subject->records())
        return failure(kRefused,
            QStringLiteral("This board tells its torque constant itself: leave --torque-constant "
                           "out."));
    subject->limits.torquePerAmp = given_nm;
    return subject;
}

Outcome<int> runIdentify(Desk &desk)
{
    ExperimentRun run(desk);
    const bool mechanical = desk.arguments.words.first() == kMechanical;
    const auto subject = subjectOf(desk, run, mechanical);
    if (!subject)
        return tl::make_unexpected(subject.error());
    const drive::UserLimits &limits = desk.arguments.limits;
    if (mechanical) {
        const lab::SpinPlan plan = lab::spinPlanFor(*subject, limits);
        return desk.arguments.bothDirections ? run.run(*subject, {plan, lab::otherWay(plan)})
                                             : run.run(*subject, {plan});
    }
    return run.run(
        *subject, {lab::restPlanFor(*subject, limits), lab::fluxPlanFor(*subject, limits)});
}

constexpr const char *kBothDirections = "both-directions", *kTorqueConstant = "torque-constant";
constexpr OptionText kIdentifyOptions[] = {
    {kBothDirections, "",
        "Of mechanical: backwards, too, each from rest, which tells friction from a torque that is "
        "always there."},
    {kTorqueConstant, "NM",
        "Of mechanical, for boards that record nothing: torque in N m for an ampere of Iq, which "
        "is 1.5 x pole pairs x flux."},
    kRunOption,
};

Outcome<bool> readIdentify(const Given &given, Arguments &arguments)
{
    const QString what = given.words().first();
    if (what != kMechanical && what != kElectrical)
        return usage(QStringLiteral("There is no \"%1\" to identify: write identify mechanical or "
                                    "identify electrical.")
                         .arg(what));
    arguments.bothDirections = given.has(kBothDirections);
    if (arguments.bothDirections && what != kMechanical)
        return usage(QStringLiteral("--both-directions is for identify mechanical."));
    if (given.has(kTorqueConstant)) {
        const auto number = plainNumber(given.value(kTorqueConstant));
        if (what != kMechanical || !number || !(*number > 0.0))
            return usage(QStringLiteral("--torque-constant is a number of N m above 0, with a "
                                        "point, of identify mechanical."));
        arguments.torqueConstant_nm = *number;
    }
    return readRunFile(given, arguments);
}

} // namespace

const Command kIdentify{.name = "identify",
    .words = "mechanical|electrical",
    .help = "Measures inertia and friction, or resistance, inductances and flux, for which a motor "
            "that runs is stopped and started again; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kIdentifyOptions,
    .read = readIdentify,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runIdentify};

} // namespace cli

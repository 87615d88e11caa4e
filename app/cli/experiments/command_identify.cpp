// identify: measures the motor itself: its inertia and its friction, or what its windings and its magnets are.
// Afterwards the motor is as it was.
#include "experiments/run.h"

namespace cli {

namespace {

constexpr QLatin1String kMechanical("mechanical"), kElectrical("electrical");

Outcome<int> runIdentify(Desk &desk)
{
    ExperimentRun run(desk);
    const auto subject = run.subject();
    if (!subject)
        return tl::make_unexpected(subject.error());
    const drive::UserLimits &limits = desk.arguments.limits;
    if (desk.arguments.words.first() == kMechanical) {
        const lab::SpinPlan plan = lab::spinPlanFor(*subject, limits);
        return desk.arguments.bothDirections ? run.run(*subject, {plan, lab::otherWay(plan)})
                                             : run.run(*subject, {plan});
    }
    return run.run(
        *subject, {lab::restPlanFor(*subject, limits), lab::fluxPlanFor(*subject, limits)});
}

constexpr const char *kBothDirections = "both-directions";
constexpr OptionText kIdentifyOptions[] = {
    {kBothDirections, "",
        "Of mechanical: backwards, too, each from rest, which tells friction from a torque that is "
        "always there."},
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

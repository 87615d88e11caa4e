// response: lets the speed go to and fro, and says how motor and speed loop, or the current loop, follow each
// frequency. Afterwards the motor is as it was.
#include "experiments/run.h"

namespace cli {

namespace {

Outcome<int> runResponse(Desk &desk)
{
    const ResponseArguments &asked = desk.arguments.response;
    ExperimentRun run(desk);
    const auto subject = run.subject(!asked.current);
    if (!subject)
        return tl::make_unexpected(subject.error());
    const drive::UserLimits &limits = desk.arguments.limits;
    lab::ResponsePlan plan = asked.current ? lab::currentResponsePlanFor(*subject, limits)
                                           : lab::responsePlanFor(*subject, limits);
    if (asked.seconds > 0)
        plan.length = std::chrono::seconds(asked.seconds);
    if (asked.rpm) {
        plan.rpm = *asked.rpm;
        plan.amplitudeRpm = lab::usualAmplitudeRpm(*subject, plan.rpm);
    }
    if (asked.amplitude_rpm > 0)
        plan.amplitudeRpm = asked.amplitude_rpm;
    return run.run(*subject, {plan});
}

constexpr OptionText kResponseOptions[] = {
    {"seconds", "S", "How long it takes, 4 to 40; 16 if not given, 6 of a current."},
    {"speed", "RPM", "Around which it goes; 0.4 of what is allowed if not given."},
    {"amplitude", "RPM",
        "How far to either side; 3 % of the speed, at least ten digits, if not given."},
    kRunOption,
};

Outcome<bool> readResponse(const Given &given, Arguments &arguments)
{
    ResponseArguments &response = arguments.response;
    const QString what = given.words().first();
    response.current = what == QLatin1String("current");
    if (!response.current && what != QLatin1String("speed"))
        return usage(QStringLiteral("There is no response of \"%1\": write response speed or "
                                    "response current.")
                         .arg(what));
    constexpr int kMostRpm = 1'000'000;
    int rpm = 0;
    const auto numbers = readNumbers(given,
        {{"seconds", &response.seconds, 4, 40}, {"speed", &rpm, -kMostRpm, kMostRpm},
            {"amplitude", &response.amplitude_rpm, 1, kMostRpm}});
    if (!numbers)
        return numbers;
    if (given.has("speed"))
        response.rpm = rpm;
    return readRunFile(given, arguments);
}

} // namespace

const Command kResponse{.name = "response",
    .words = "speed|current",
    .help =
        "Measures how motor and speed loop, or the current loop, follow each frequency; then all "
        "is as before.",
    .least = 1,
    .most = 1,
    .options = kResponseOptions,
    .read = readResponse,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runResponse};

} // namespace cli

#include "widgets/lab/step_question.h"

#include "lab/caps.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>

namespace widgets {
namespace {

struct StepQuestion {
    Q_DECLARE_TR_FUNCTIONS(StepQuestion)
};

constexpr double kSettles_s = 0.2; ///< at the first speed, before the first step

double secondsOf(std::chrono::milliseconds time)
{
    return std::chrono::duration<double>(time).count();
}

QString rpmText(double rpm) { return numberText(rpm, 0) + QChar(0x202f) + StepQuestion::tr("rpm"); }

QString msText(std::chrono::milliseconds time)
{
    return QString::number(time.count()) + QStringLiteral("\u202fms");
}

} // namespace

SpeedPlan speedPlan(const lab::Experiment &experiment, const MotorBefore &before)
{
    const auto &plan = std::get<lab::StepPlan>(experiment.plan);
    const lab::Caps caps = lab::capsOf(experiment, before.rpm);
    SpeedPlan picture{{}, {}, caps.leastRpm, caps.mostRpm};
    double at = 0.0;
    const auto to = [&](double rpm, double seconds) {
        at += seconds;
        picture.seconds.append(at);
        picture.rpm.append(rpm);
    };
    to(before.rpm, 0.0);
    to(plan.fromRpm, secondsOf(plan.approach));
    to(plan.fromRpm, kSettles_s);
    for (int i = 0; i < plan.repeat; ++i)
        for (const int rpm : {plan.toRpm, plan.fromRpm}) {
            to(rpm, 0.0);
            to(rpm, secondsOf(plan.hold));
        }
    to(before.rpm, secondsOf(plan.approach));
    return picture;
}

Confirmation stepQuestion(const lab::Experiment &experiment, const MotorBefore &before)
{
    const auto &plan = std::get<lab::StepPlan>(experiment.plan);
    const lab::Caps caps = lab::capsOf(experiment, before.rpm);
    Confirmation question;
    question.objectName = "stepQuestion";
    question.title = StepQuestion::tr("Steps");
    question.text =
        StepQuestion::tr("This will move motor %1 by itself. Go on?").arg(experiment.subject.motor);
    const QString from = rpmText(plan.fromRpm), approach = msText(plan.approach);
    question.lines.append(before.runs
            ? StepQuestion::tr("It runs: from %1 to %2 in %3.")
                  .arg(rpmText(before.rpm), from, approach)
            : StepQuestion::tr("It rests: start, then to %1 in %2.").arg(from, approach));
    question.lines.append(
        StepQuestion::tr("%n time(s): at once to %1, and at once back to %2, each held for %3.",
            nullptr, plan.repeat)
            .arg(rpmText(plan.toRpm), from, msText(plan.hold)));
    question.lines.append(before.runs
            ? StepQuestion::tr("Then back to %1 in %2.").arg(rpmText(before.rpm), approach)
            : StepQuestion::tr("Then the motor is stopped, and its old set-point comes back."));
    const QString amps = caps.mostAmps > 0.0
        ? numberText(caps.mostAmps, 1) + QStringLiteral("\u202fA")
        : StepQuestion::tr("no bound", "of the current");
    question.lines.append(StepQuestion::tr(
        "Stopped at once: below %1 or above %2, beyond %3 of Iq, and where the bus "
        "voltage, the temperature or the link is not as it should be.")
                              .arg(rpmText(caps.leastRpm), rpmText(caps.mostRpm), amps));
    if (!before.runs)
        question.lines.append(StepQuestion::tr("While it starts, only %1 and the current bound it.")
                                  .arg(rpmText(lab::allowedRpm(experiment))));
    question.lines.append(StepQuestion::tr("Series within these caps are not asked about again "
                                           "until disarmed. Esc stops every motor at any time."));
    question.yesName = "stepConfirm";
    question.yes = StepQuestion::tr("Run steps");
    question.picture = new PlanPicture(speedPlan(experiment, before));
    return question;
}

} // namespace widgets

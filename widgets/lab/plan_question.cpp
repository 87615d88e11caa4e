#include "widgets/lab/plan_question.h"

#include "base/overloaded.h"
#include "lab/caps.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace widgets {
namespace {

struct PlanQuestion {
    Q_DECLARE_TR_FUNCTIONS(PlanQuestion)
};

using std::chrono::milliseconds;

constexpr double kSettles_s = 0.2; ///< at the first speed, before the course
constexpr double kStart_s = 3.0; ///< usually, with an alignment or a rev-up

double secondsOf(milliseconds time) { return std::chrono::duration<double>(time).count(); }

QString msText(milliseconds time)
{
    return QString::number(time.count()) + QStringLiteral("\u202fms");
}

QString secondsText(milliseconds time)
{
    return numberText(secondsOf(time), 0) + QStringLiteral("\u202fs");
}

QString ampsText(double amps) { return numberText(amps, 2) + QStringLiteral("\u202fA"); }

QString stepWords(const lab::StepPlan &plan)
{
    return PlanQuestion::tr("%n time(s): at once to %1, and at once back to %2, each held for %3.",
        nullptr, plan.repeat)
        .arg(rpmText(plan.toRpm), rpmText(plan.fromRpm), msText(plan.hold));
}

QString spinWords(const lab::SpinPlan &plan, const lab::Subject &subject)
{
    const QString length = secondsText(plan.length);
    const QString low = rpmText(plan.lowRpm), high = rpmText(plan.highRpm);
    if (!subject.records())
        return PlanQuestion::tr("For %1 ramps lead it from %2 to %3 and back; an ampere is taken "
                                "for %4.")
            .arg(length, low, high, siText(subject.limits.torquePerAmp, QStringLiteral("N m")));
    if (plan.highRpm < 0 && !(plan.fluxAmps > 0.0))
        return PlanQuestion::tr("Backwards, for %1: its torque drives it or lets it coast, between "
                                "%2 and %3; it is never braked.")
            .arg(length, low, high);
    return plan.fluxAmps > 0.0
        ? PlanQuestion::tr("For %1 its torque jumps and drives it or lets it coast, between %2 and "
                           "%3; the current along the magnets jumps within \u00b1%4.")
              .arg(length, low, high, ampsText(plan.fluxAmps))
        : PlanQuestion::tr("For %1 its torque drives it or lets it coast, between %2 and %3; it is "
                           "never braked.")
              .arg(length, low, high);
}

QString responseWords(const lab::ResponsePlan &plan, const lab::Subject &subject)
{
    QString words = PlanQuestion::tr("For %1 its speed jumps at random between %2 and %3.")
                        .arg(secondsText(plan.length), rpmText(plan.rpm - plan.amplitudeRpm),
                            rpmText(plan.rpm + plan.amplitudeRpm));
    if (subject.exchanged)
        words += QLatin1Char(' ')
            + PlanQuestion::tr("Its set-points leave with every exchange meanwhile.");
    return plan.kp == 0 ? words
                        : words + QLatin1Char(' ')
            + PlanQuestion::tr("Its gains are Kp %1 and Ki %2 meanwhile.")
                  .arg(QString::number(plan.kp), QString::number(plan.ki));
}

QString restWords(const lab::RestPlan &plan, const lab::Subject &subject)
{
    const QString low = ampsText(plan.lowAmps), high = ampsText(plan.highAmps);
    return subject.seesRotor()
        ? PlanQuestion::tr("At rest: currents from %1 to %2 along the magnets.").arg(low, high)
        : PlanQuestion::tr("In its start-up, whose stages are borrowed and do not turn: currents "
                           "of %1 and %2; then it is stopped.")
              .arg(low, high);
}

QString currentStepWords(const lab::CurrentStepPlan &plan)
{
    return PlanQuestion::tr(
        "%n time(s): its current jumps from %1 to %2 and back.", nullptr, plan.repeat)
        .arg(ampsText(plan.fromAmps), ampsText(plan.toAmps));
}

QString positionWords(const lab::PositionPlan &plan)
{
    return PlanQuestion::tr(
        "%n time(s): its shaft is moved by %1 and back, each way in %2.", nullptr, plan.repeat)
        .arg(numberText(plan.byDegrees, 1) + QChar(0xb0), msText(plan.ramp));
}

/// What is done once the motor is where it begins.
QString workWords(const lab::Experiment &experiment)
{
    return std::visit(
        Overloaded{[](const lab::StepPlan &plan) { return stepWords(plan); },
            [&](const lab::SpinPlan &plan) { return spinWords(plan, experiment.subject); },
            [&](const lab::ResponsePlan &plan) { return responseWords(plan, experiment.subject); },
            [&](const lab::RestPlan &plan) { return restWords(plan, experiment.subject); },
            [](const lab::CurrentStepPlan &plan) { return currentStepWords(plan); },
            [](const lab::PowerPlan &plan) {
                const QString length = secondsText(plan.length());
                return PlanQuestion::tr("For %1 it is held at %2.")
                    .arg(length, rpmText(plan.fromRpm));
            },
            [](const lab::LoadPlan &plan) {
                const QString length = secondsText(plan.length());
                return PlanQuestion::tr("For %1 it is held at %2, while you change its load.")
                    .arg(length, rpmText(plan.fromRpm));
            },
            [](const lab::PositionPlan &plan) { return positionWords(plan); }},
        experiment.plan);
}

QString mostAmpsText(const lab::Caps &caps)
{
    return caps.mostAmps > 0.0 ? numberText(caps.mostAmps, 1) + QStringLiteral("\u202fA")
                               : PlanQuestion::tr("no bound", "of the current");
}

QString currentBoundText(const lab::Experiment &experiment)
{
    const QString factor = numberText(lab::kCurrentAboveBoard, 2);
    switch (lab::currentBoundOf(experiment)) {
    case lab::CurrentBound::Nominal:
        return PlanQuestion::tr("%1 times the nominal current").arg(factor);
    case lab::CurrentBound::Board:
        return PlanQuestion::tr("%1 times the greatest current of the board").arg(factor);
    case lab::CurrentBound::User:
        return PlanQuestion::tr("your own limit of the current");
    case lab::CurrentBound::None:
        break;
    }
    return PlanQuestion::tr("no bound", "of the current");
}

/// Why the caps are not the limits that stand beside the set-points.
QString capsFrom(const std::vector<lab::Experiment> &experiments)
{
    double margin_rpm = 0.0;
    for (const lab::Experiment &experiment : experiments)
        margin_rpm = std::max(margin_rpm, lab::conditionsOf(experiment).margin_rpm);
    return PlanQuestion::tr("The limits in the control panel bound what is asked for, these caps "
                            "what is measured: up to %1 beyond the plan, and %2.")
        .arg(rpmText(margin_rpm), currentBoundText(experiments.front()));
}

/// Steps down lift the bus, which a board need not tell.
QStringList busWords(const std::vector<lab::Experiment> &experiments)
{
    const bool told = experiments.front().subject.registers.bus != 0;
    const bool brakes =
        std::any_of(experiments.begin(), experiments.end(), [](const lab::Experiment &experiment) {
            return std::holds_alternative<lab::StepPlan>(experiment.plan)
                || std::holds_alternative<lab::ResponsePlan>(experiment.plan);
        });
    const bool ramps =
        std::any_of(experiments.begin(), experiments.end(), [](const lab::Experiment &experiment) {
            return !experiment.subject.records()
                && std::holds_alternative<lab::SpinPlan>(experiment.plan);
        });
    const bool moves = std::holds_alternative<lab::PositionPlan>(experiments.front().plan);
    QStringList lines;
    if (moves)
        lines.append(PlanQuestion::tr("Each move ends by braking, which feeds the bus."));
    if (ramps)
        lines.append(PlanQuestion::tr("A ramp down brakes a heavy rotor, which feeds the bus."));
    if (!told)
        lines.append(
            PlanQuestion::tr("This board does not tell its bus voltage: nothing bounds it."));
    if (brakes)
        lines.append(told ? PlanQuestion::tr("A step down brakes the motor, which feeds the bus: "
                                             "only the cap of the bus voltage bounds that.")
                          : PlanQuestion::tr("A step down brakes the motor, which feeds the bus."));
    return lines;
}

bool beginsAtSpeed(const lab::Conditions &conditions)
{
    return conditions.beginning == lab::Beginning::AtSpeed;
}

QString wayThere(const lab::Conditions &conditions, const MotorBefore &before)
{
    const QString to = rpmText(conditions.firstRpm), in = msText(conditions.approach);
    if (!beginsAtSpeed(conditions))
        return PlanQuestion::tr("It rests.");
    return before.runs
        ? PlanQuestion::tr("It runs: from %1 to %2 in %3.").arg(rpmText(before.rpm), to, in)
        : PlanQuestion::tr("It rests: start, then to %1 in %2.").arg(to, in);
}

QString startWords(const lab::Experiment &experiment)
{
    const bool current = lab::currentBoundOf(experiment) != lab::CurrentBound::None;
    return (current ? PlanQuestion::tr("While it starts, only %1 and the current bound it.")
                    : PlanQuestion::tr("While it starts, only %1 bound it.", "a speed"))
        .arg(rpmText(lab::allowedRpm(experiment)));
}

QStringList wordsOfOne(const lab::Experiment &experiment, const MotorBefore &before)
{
    const lab::Caps caps = lab::capsOf(experiment, before.rpm);
    const lab::Conditions conditions = lab::conditionsOf(experiment);
    QStringList lines{wayThere(conditions, before), workWords(experiment)};
    lines.append(before.runs
            ? PlanQuestion::tr("Then back to %1 in %2.")
                  .arg(rpmText(before.rpm), msText(conditions.approach))
            : PlanQuestion::tr("Then the motor is stopped, and its old set-point comes back."));
    lines.append(PlanQuestion::tr(
        "Stopped at once: below %1 or above %2, beyond %3 of Iq, and where the bus "
        "voltage, the temperature or the link is not as it should be.")
                     .arg(rpmText(caps.leastRpm), rpmText(caps.mostRpm), mostAmpsText(caps)));
    if (!before.runs)
        lines.append(startWords(experiment));
    return lines;
}

QStringList wordsOfAll(const std::vector<lab::Experiment> &experiments, const MotorBefore &before)
{
    QStringList lines;
    lines.append(before.runs
            ? PlanQuestion::tr("It runs: from %1, and back there after each of these.")
                  .arg(rpmText(before.rpm))
            : PlanQuestion::tr(
                "It rests: it is started for each of these, and stopped afterwards."));
    for (const lab::Experiment &experiment : experiments) {
        const lab::Caps caps = lab::capsOf(experiment, before.rpm);
        lines.append(PlanQuestion::tr(
            "%1. %2 Stopped below %3, above %4, beyond %5.", "number, what is done, caps")
                         .arg(QString::number(lines.size()), workWords(experiment),
                             rpmText(caps.leastRpm), rpmText(caps.mostRpm), mostAmpsText(caps)));
    }
    lines.append(PlanQuestion::tr("Also stopped where the bus voltage, the temperature or the link "
                                  "is not as it should be."));
    if (!before.runs)
        lines.append(startWords(experiments.front()));
    return lines;
}

/// Adds what one experiment asks of the speed.
class Picture {
public:
    explicit Picture(SpeedPlan &into)
        : m_into(into)
    {
    }
    /// At rest it is known which currents flow.
    void rest(const lab::RestPlan &plan, milliseconds length)
    {
        const auto levels = length / (plan.rise + plan.hold);
        amps(0.0, 0.0);
        for (int level = 0; level < levels; ++level) {
            const double share = double(level) / double(levels - 1);
            amps(plan.lowAmps + share * (plan.highAmps - plan.lowAmps), secondsOf(plan.rise));
            amps(m_into.amps.last(), secondsOf(plan.hold));
        }
        amps(0.0, 0.0);
    }
    void to(double rpm, double seconds)
    {
        m_at += seconds;
        m_into.seconds.append(m_at);
        m_into.rpm.append(rpm);
    }
    void course(const lab::Experiment &experiment)
    {
        std::visit(Overloaded{[&](const lab::StepPlan &plan) {
                                  for (int i = 0; i < plan.repeat; ++i)
                                      for (const int rpm : {plan.toRpm, plan.fromRpm}) {
                                          to(rpm, 0.0);
                                          to(rpm, secondsOf(plan.hold));
                                      }
                              },
                       [&](const lab::SpinPlan &plan) {
                           if (!experiment.subject.records())
                               return ramps(plan);
                           swing(plan.lowRpm, plan.highRpm, plan.length, 0.25, 0.25);
                       },
                       [&](const lab::ResponsePlan &plan) {
                           swing(plan.rpm - plan.amplitudeRpm, plan.rpm + plan.amplitudeRpm,
                               plan.length, 0.0, 0.06);
                       },
                       [&](const lab::RestPlan &plan) {
                           rest(plan, lab::conditionsOf(experiment).length);
                       },
                       [&](const lab::PositionPlan &plan) {
                           moves(plan, lab::conditionsOf(experiment).mostRpm);
                       },
                       [&](const auto &) {
                           const lab::Conditions conditions = lab::conditionsOf(experiment);
                           to(conditions.firstRpm, secondsOf(conditions.length));
                       }},
            experiment.plan);
    }

private:
    void amps(double to_a, double seconds)
    {
        to(0.0, seconds);
        m_into.ampSeconds.append(m_at);
        m_into.amps.append(to_a);
    }
    /// To and fro. @param way_s  from one to the other; @param held_s  both together
    void swing(double low, double high, milliseconds length, double way_s, double held_s)
    {
        const double end = m_at + secondsOf(length);
        for (bool up = true; m_at < end; up = !up) {
            to(up ? high : low, way_s);
            if (way_s < held_s)
                to(up ? high : low, held_s - way_s);
        }
    }
    void ramps(const lab::SpinPlan &plan)
    {
        using lab::SpinPlan;
        for (auto left = plan.length / SpinPlan::kRound; left > 0; --left)
            for (const auto &[rpm, way] :
                {std::pair(plan.highRpm, SpinPlan::kUp), std::pair(plan.lowRpm, SpinPlan::kDown)}) {
                to(rpm, secondsOf(way));
                to(rpm, secondsOf(SpinPlan::kHold));
            }
    }
    /// There and back, at its fastest in the middle of each way.
    void moves(const lab::PositionPlan &plan, double peak)
    {
        const double half = secondsOf(plan.ramp) / 2;
        to(0.0, 0.0);
        for (int i = 0; i < plan.repeat; ++i)
            for (const double way : {plan.byDegrees, -plan.byDegrees}) {
                to(way > 0.0 ? peak : -peak, half);
                to(0.0, half);
                to(0.0, secondsOf(plan.hold));
            }
    }
    SpeedPlan &m_into;
    double m_at = 0.0;
};

} // namespace

QString rpmText(double rpm) { return numberText(rpm, 0) + QChar(0x202f) + PlanQuestion::tr("rpm"); }

QString experimentName(const lab::Experiment &experiment)
{
    return std::visit(
        Overloaded{[](const lab::StepPlan &) { return PlanQuestion::tr("Steps"); },
            [](const lab::SpinPlan &plan) {
                return plan.fluxAmps > 0.0 ? PlanQuestion::tr("Inductances and flux")
                                           : PlanQuestion::tr("Inertia and friction");
            },
            [](const lab::ResponsePlan &plan) {
                return plan.current != 0 ? PlanQuestion::tr("Response of the current")
                                         : PlanQuestion::tr("Response of the speed");
            },
            [](const lab::RestPlan &) { return PlanQuestion::tr("Resistance"); },
            [](const lab::CurrentStepPlan &) { return PlanQuestion::tr("Steps of the current"); },
            [](const lab::PowerPlan &) { return PlanQuestion::tr("Power"); },
            [](const lab::LoadPlan &) { return PlanQuestion::tr("Changes of the load"); },
            [](const lab::PositionPlan &) { return PlanQuestion::tr("Steps of the position"); }},
        experiment.plan);
}

milliseconds usualLength(const lab::Experiment &experiment, const MotorBefore &before)
{
    const lab::Conditions conditions = lab::conditionsOf(experiment);
    const milliseconds start(before.runs ? 0 : static_cast<int>(1e3 * kStart_s));
    return start + 2 * conditions.approach + conditions.length;
}

SpeedPlan speedPlan(const std::vector<lab::Experiment> &experiments, const MotorBefore &before)
{
    SpeedPlan picture;
    Picture draw(picture);
    draw.to(before.rpm, 0.0);
    for (const lab::Experiment &experiment : experiments) {
        const lab::Caps caps = lab::capsOf(experiment, before.rpm);
        const bool first = &experiment == &experiments.front();
        picture.leastRpm = first ? caps.leastRpm : std::min(picture.leastRpm, caps.leastRpm);
        picture.mostRpm = first ? caps.mostRpm : std::max(picture.mostRpm, caps.mostRpm);
        const lab::Conditions conditions = lab::conditionsOf(experiment);
        if (beginsAtSpeed(conditions)) {
            draw.to(conditions.firstRpm, secondsOf(conditions.approach));
            draw.to(conditions.firstRpm, kSettles_s);
        }
        draw.course(experiment);
        draw.to(before.rpm, secondsOf(conditions.approach));
    }
    return picture;
}

Confirmation planQuestion(
    const std::vector<lab::Experiment> &experiments, const MotorBefore &before)
{
    Confirmation question;
    question.objectName = "experimentQuestion";
    const lab::Experiment &first = experiments.front();
    question.title =
        experiments.size() == 1 ? experimentName(first) : PlanQuestion::tr("Experiments");
    question.text =
        PlanQuestion::tr("This will move motor %1 by itself. Go on?").arg(first.subject.motor);
    question.lines =
        experiments.size() == 1 ? wordsOfOne(first, before) : wordsOfAll(experiments, before);
    question.lines.append(busWords(experiments));
    question.lines.append(capsFrom(experiments));
    question.lines.append(
        PlanQuestion::tr("The like within these caps and this time is not asked about again until "
                         "disarmed. Esc stops every motor at any time."));
    question.yesName = "experimentConfirm";
    question.yes = PlanQuestion::tr("Run");
    question.picture = new PlanPicture(speedPlan(experiments, before));
    return question;
}

} // namespace widgets

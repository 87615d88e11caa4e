#include "widgets/lab/identification.h"

#include "lab/evaluation/finding.h"
#include "widgets/control/motion_allowed.h"
#include "widgets/lab/text.h"
#include "widgets/lab/told_figures.h"

namespace widgets {
namespace {

bool whole(const lab::Electrics &found) { return lab::lackOf(found).empty(); }
bool whole(const lab::Mechanics &) { return true; }

QString notConclusive(const QString &why)
{
    return Identification::tr("Not conclusive: %1").arg(why);
}

} // namespace

Identification::Identification(
    const Device &device, const Experiments &experiments, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_experiments(experiments)
{
    // What was measured is of one motor.
    connect(&device, &Device::identityChanged, &m_findings, &MotorFindings::clear);
    connect(&device, &Device::identityChanged, this, [this] { ++m_boards; });
    connect(&device, &Device::motorChanged, &m_findings, &MotorFindings::clear);
}

template <class Found>
ExperimentBar::Evaluate Identification::evaluation(int motor,
    Result<Found, std::string> (*evaluate)(const capture::Capture &, const lab::Happenings &))
{
    return [this, motor, board = m_boards, evaluate](
               const Experiments::Run &run) -> ExperimentBar::Show {
        const auto found = evaluate(run.capture, run.happenings);
        return [this, motor, board, found, end = run.outcome.end]() -> QStringList {
            if (board != m_boards || motor != m_device.motor())
                return {}; // the table is of another motor by now
            const bool complete = end == lab::End::Complete;
            if (!found) {
                if (end == lab::End::Refused)
                    return {}; // why is said already
                const QString why = notConclusive(labSentence(found.error()));
                if (complete)
                    m_findings.fail(std::is_same_v<Found, lab::Mechanics>, why);
                return {why};
            }
            m_findings.accept(*found, complete);
            const QStringList notes = labSentences(found->notes);
            if (whole(*found))
                return notes;
            return {notes.isEmpty() ? labSentence(lab::lackOf(*found))
                                    : notConclusive(notes.join(QLatin1Char(' ')))};
        };
    };
}

Result<ExperimentBar::Run, QString> Identification::electricalRun()
{
    const auto subject = m_experiments.subject();
    if (!subject)
        return fail(subject.error());
    const drive::UserLimits &caps = m_device.userLimits();
    return ExperimentBar::Run{{{lab::restPlanFor(*subject, caps), *subject},
                                  {lab::fluxPlanFor(*subject, caps), *subject}},
        evaluation<lab::Electrics>(subject->motor, &lab::evaluateElectrics)};
}

Result<ExperimentBar::Run, QString> Identification::mechanicalRun(bool bothWays)
{
    auto subject = m_experiments.subject(true);
    if (!subject)
        return fail(subject.error());
    if (!subject->records())
        subject->limits.torquePerAmp = m_findings.torqueConstant_nm();
    const lab::SpinPlan plan = lab::spinPlanFor(*subject, m_device.userLimits());
    ExperimentBar::Run run{
        {{plan, *subject}}, evaluation<lab::Mechanics>(subject->motor, &lab::evaluateMechanics)};
    if (bothWays)
        run.experiments.push_back({lab::otherWay(plan), *subject});
    return run;
}

QString Identification::countPolePairs(double tachometer_rpm)
{
    if (!m_device.answering() || !m_device.identified())
        return motionAllowed(m_device, drive::Feature::SpeedRamp).why;
    const auto found =
        lab::polePairsBy(*m_device.identified(), m_device.status(m_device.motor()), tachometer_rpm);
    if (!found)
        return labSentence(found.error());
    m_findings.setPolePairs(*found);
    return {};
}

Result<ExperimentBar::Run, QString> Identification::powerRun()
{
    const auto subject = m_experiments.subject();
    if (!subject)
        return fail(subject.error());
    lab::PowerPlan plan = lab::powerPlanFor(*subject, m_device.userLimits());
    const drive::MotorStatus status = m_device.status(subject->motor);
    if (status.state == drive::MotorState::Running)
        plan.fromRpm = plan.toRpm = qRound(status.speedRpm.value_or(plan.fromRpm));
    plan.rsOhm = m_findings.measured(MotorFindings::Resistance);
    plan.deadVolts = m_findings.measured(MotorFindings::DeadTime);
    return ExperimentBar::Run{{{plan, *subject}}, tellsFigures()};
}

} // namespace widgets

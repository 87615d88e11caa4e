#include "widgets/lab/loop/tuning.h"

#include "widgets/base/value_text.h"
#include "widgets/lab/text.h"

#include <algorithm>

namespace widgets {
namespace {

/// Takes a while.
LoopTuning::Measured measuredBy(
    const lab::SpeedResponse &response, const lab::SpeedLoop &loop, double nominalAmps)
{
    LoopTuning::Measured measured{response, loop, {}, {}, {}};
    if (const auto forecaster = lab::forecasterOf(response, loop.digits))
        measured.forecaster = *forecaster;
    if (const auto found = lab::proposeGains(response, loop.digits, nominalAmps))
        measured.candidates = *found;
    else
        measured.whyNone = found.error();
    return measured;
}

/// A proof is made with the same gains from the first sample of its response to the last one of its steps.
Result<lab::StepSeries, std::string> proofStepsOf(const Experiments::Run &run, int motor)
{
    if (std::ranges::any_of(run.happenings,
            [motor](const auto &one) { return lab::changesGains(motor, one.second); }))
        return fail(std::string(lab::kGainsChanged));
    return lab::stepSeries(run.capture, run.happenings);
}

QString gainsText(const LoopTuning::Gains &gains)
{
    return LoopTuning::tr("Kp %1, Ki %2", "digits")
        .arg(QString::number(gains.kp), QString::number(gains.ki));
}

} // namespace

LoopTuning::LoopTuning(Device &device, RegisterModel &registers, RegisterEdits &edits,
    const Experiments &experiments, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_edits(edits)
    , m_experiments(experiments)
    , m_facts(device, registers)
{
    connect(&registers, &RegisterModel::catalogSet, this, &LoopTuning::boardChanged);
    connect(&device, &Device::identityChanged, this, &LoopTuning::boardChanged);
    connect(&device, &Device::motorChanged, this, &LoopTuning::boardChanged);
    connect(&edits, &RegisterEdits::changed, this, &LoopTuning::changed);
    connect(&edits, &RegisterEdits::told, this, [this](const QString &sentence, bool good) {
        const auto writing = std::exchange(m_writing, std::nullopt);
        if (!writing)
            return;
        if (good)
            hold(*writing);
        Q_EMIT written(good, sentence);
        Q_EMIT changed();
    });
    connect(&edits, &RegisterEdits::declined, this, [this] {
        if (std::exchange(m_writing, std::nullopt))
            Q_EMIT changed();
    });
    boardChanged();
}

/// What was measured is of one motor.
void LoopTuning::boardChanged()
{
    m_facts.begin();
    m_measured.reset();
    m_current.reset();
    m_proof.reset();
    m_swinging.reset();
    m_old.reset();
    m_applied.reset();
    m_writing.reset();
    ++m_measurements;
    ++m_boards;
    Q_EMIT watchedRegistersChanged();
    Q_EMIT changed();
}

std::vector<catalog::RegisterId> LoopTuning::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids = m_facts.watched();
    if (const auto subject = m_experiments.subject())
        for (const drive::RegisterId id : lab::gainRegisters(*subject))
            ids.push_back(id);
    return ids;
}

void LoopTuning::refresh()
{
    if (!m_facts.refresh())
        return;
    Q_EMIT watchedRegistersChanged();
    Q_EMIT changed();
}

std::optional<LoopTuning::Gains> LoopTuning::present() const
{
    const auto subject = m_experiments.subject();
    const auto loop = subject ? m_facts.speedLoop(*subject) : std::nullopt;
    return loop ? std::optional(Gains{loop->proportional, loop->integral}) : std::nullopt;
}

std::optional<lab::GainCandidate> LoopTuning::candidate(lab::Goal goal) const
{
    if (m_measured)
        for (const lab::GainCandidate &one : m_measured->candidates)
            if (one.goal == goal)
                return one;
    return std::nullopt;
}

Result<ExperimentBar::Run, QString> LoopTuning::speedRun(std::chrono::milliseconds length)
{
    const auto subject = m_experiments.subject(true);
    if (!subject)
        return fail(subject.error());
    if (!lab::gainRegisters(*subject).empty() && (!present() || !m_facts.known()))
        return fail(tr("The gains are being read."));
    lab::ResponsePlan plan = lab::responsePlanFor(*subject, m_device.userLimits());
    plan.length = length;
    if (m_swinging && m_swinging->with == present()) {
        plan.kp = m_swinging->calmed.kp;
        plan.ki = m_swinging->calmed.ki;
    }
    return responseRun(*subject, plan, std::nullopt);
}

Result<ExperimentBar::Run, QString> LoopTuning::proofRun(
    std::chrono::milliseconds length, const Gains &gains)
{
    auto run = speedRun(length);
    if (!run)
        return run;
    const lab::Subject subject = run->experiments.front().subject;
    auto plan = std::get<lab::ResponsePlan>(run->experiments.front().plan);
    plan.kp = plan.ki = 0;
    ExperimentBar::Run proof = responseRun(subject, plan, gains);
    proof.experiments.push_back({lab::proofStepsFor(subject, m_device.userLimits()), subject});
    return proof;
}

Result<ExperimentBar::Run, QString> LoopTuning::currentRun(std::chrono::milliseconds length)
{
    const auto subject = m_experiments.subject();
    if (!subject)
        return fail(subject.error());
    lab::ResponsePlan plan = lab::currentResponsePlanFor(*subject, m_device.userLimits());
    plan.length = length;
    const auto loop = m_facts.speedLoop(*subject);
    const auto evaluate = [this, board = m_boards](
                              const Experiments::Run &run) -> ExperimentBar::Show {
        const auto found = lab::evaluateCurrentResponse(run.capture, run.happenings);
        return [this, board, found]() -> QStringList {
            if (board != m_boards)
                return {};
            if (!found)
                return {tr("Not conclusive: %1").arg(labSentence(found.error()))};
            m_current = *found;
            Q_EMIT changed();
            return labSentences(found->notes);
        };
    };
    return ExperimentBar::Run{
        {{plan, *subject}}, evaluate, loop ? loop->regulator : lab::SpeedRegulator()};
}

ExperimentBar::Run LoopTuning::responseRun(
    const lab::Subject &subject, const lab::ResponsePlan &plan, std::optional<Gains> toProve)
{
    const lab::SpeedLoop present = m_facts.speedLoop(subject).value_or(lab::SpeedLoop());
    const lab::SpeedLoop loop = plan.kp > 0 ? lab::withGains(present, plan.kp, plan.ki) : present;
    const double nominalAmps = subject.limits.nominalCurrentAmps;
    const auto evaluate = [this, board = m_boards, plan, loop, nominalAmps, toProve,
                              motor = subject.motor](
                              const Experiments::Run &run) -> ExperimentBar::Show {
        if (run.outcome.swings)
            return [this, plan, loop]() -> QStringList { return calm(plan, loop); };
        if (toProve && run.outcome.end != lab::End::Complete)
            return []() -> QStringList {
                return {tr("Nothing is proved: response and steps did not both come to their "
                           "end.")};
            };
        const auto response = lab::evaluateResponse(run.capture, run.happenings);
        std::string why = response ? std::string() : response.error();
        std::optional<lab::StepSeries> steps;
        if (toProve && response) {
            if (const auto found = proofStepsOf(run, motor))
                steps = *found;
            else
                why = found.error();
        }
        std::optional<Measured> measured;
        if (why.empty())
            measured = measuredBy(*response, loop, nominalAmps);
        return [=, this]() -> QStringList {
            if (board != m_boards)
                return {}; // the board is gone, and what is known of it
            if (!measured) // what was measured stays until something replaces it
                return {tr("Not conclusive: %1").arg(labSentence(why))};
            return adopt(*measured, steps, toProve);
        };
    };
    return {{{plan, subject}}, evaluate, loop.regulator};
}

/// @param steps  of a proof  @return  what has to be known of it
QStringList LoopTuning::adopt(const Measured &measured, const std::optional<lab::StepSeries> &steps,
    const std::optional<Gains> &toProve)
{
    const lab::SpeedResponse &response = measured.response;
    m_proof.reset();
    if (toProve && steps)
        m_proof = Proof{response, *steps, *toProve, m_promised,
            lab::keptBy(response, steps->overshoot_pct, m_promised)};
    QStringList more = labSentences(response.notes);
    if (m_proof)
        more = QStringList(verdict()) + more + labSentences(steps->notes);
    if (!m_proof || lab::missed(m_proof->kept)) {
        m_measured = measured;
        ++m_measurements;
    }
    Q_EMIT changed();
    return more;
}

/// For the next response.
QStringList LoopTuning::calm(const lab::ResponsePlan &plan, const lab::SpeedLoop &loop)
{
    const auto calmed = lab::calmer(plan, loop);
    const auto with = present();
    if (!calmed || !with)
        return {};
    m_swinging = Swinging{*with, {calmed->kp, calmed->ki}};
    return {tr("It swings with its gains. The next response is measured with %1, and the old gains "
               "come back afterwards.")
                .arg(gainsText(m_swinging->calmed))};
}

std::optional<lab::SpeedResponse> LoopTuning::predicted(const Gains &gains) const
{
    if (!m_measured || m_measured->response.regulator.proportional == 0.0)
        return std::nullopt;
    const lab::GainDigits &digits = m_measured->loop.digits;
    return lab::withRegulator(m_measured->response,
        {gains.kp * digits.proportional, gains.ki * digits.integral,
            m_measured->response.regulator.period_s});
}

std::optional<lab::LoopForecast> LoopTuning::forecast(const Gains &gains) const
{
    if (!m_measured || !m_measured->forecaster)
        return std::nullopt;
    return m_measured->forecaster(gains.kp, gains.ki);
}

lab::Promise LoopTuning::promised(const Gains &gains) const
{
    if (m_measured)
        for (const lab::GainCandidate &one : m_measured->candidates)
            if (one.proportional == gains.kp && one.integral == gains.ki)
                return lab::promiseOf(one, one.goal);
    return lab::promiseOf(forecast(gains).value_or(lab::LoopForecast()), std::nullopt);
}

QString LoopTuning::applyHint(const Gains &gains) const
{
    if (!m_measured)
        return tr("Measure the response of the speed first.");
    if (!m_measured->gainsKnown())
        return labSentence(m_measured->whyNone);
    if (m_experiments.running())
        return tr("An experiment is running.");
    if (gains == present())
        return tr("The board holds these gains.");
    return m_edits.writeHint();
}

void LoopTuning::apply(const Gains &gains)
{
    const auto before = present();
    if (!before || !m_measured)
        return;
    if (before == gains) { // there is nothing to write
        hold({gains, promised(gains)});
        Q_EMIT changed();
        return;
    }
    const auto loop = forecast(gains);
    if (!applyHint(gains).isEmpty() || (loop && !loop->stable))
        return;
    if (!m_old)
        m_old = before;
    write(gains, tr("gains of the speed loop, %1").arg(gainsText(gains)));
}

QString LoopTuning::backHint() const
{
    if (!m_old)
        return tr("No gains were written from here.");
    if (m_experiments.running())
        return tr("An experiment is running.");
    if (m_old == present())
        return tr("The board holds these gains.");
    return m_edits.writeHint();
}

void LoopTuning::back()
{
    if (!backHint().isEmpty())
        return;
    write(*m_old, tr("back to %1").arg(gainsText(*m_old)));
}

void LoopTuning::write(const Gains &gains, const QString &text)
{
    const auto subject = m_experiments.subject();
    if (!subject)
        return;
    m_writing = Promised{gains, promised(gains)};
    m_edits.write(text, lab::gainWrites(*subject, gains.kp, gains.ki));
}

/// The board has these: what was proved is of others.
void LoopTuning::hold(const Promised &written)
{
    m_applied = written.gains;
    m_promised = written.promise;
    m_proof.reset();
}

QString LoopTuning::verdict() const
{
    if (!m_proof)
        return {};
    const auto &response = m_proof->response;
    const lab::Promise &promised = m_proof->promised;
    const QString most = numberText(promised.ms, 2);
    switch (m_proof->kept) {
    case lab::Kept::TooLively:
        return tr("Worse than predicted: Ms %1, at most %2 promised. Nearer gains are proposed "
                  "from this response; \"Back to the old gains\" brings those back.")
            .arg(numberText(response.ms->value, 2), most);
    case lab::Kept::TooSlow:
        return tr("Slower than predicted: crossover %1 Hz instead of %2 Hz. Nearer gains are "
                  "proposed from this response; \"Back to the old gains\" brings those back.")
            .arg(numberText(response.crossover_hz->value, 1), numberText(promised.crossover_hz, 1));
    case lab::Kept::Overshoots:
        return tr("Worse than predicted: its steps overshoot by %1 % instead of %2 %. Nearer "
                  "gains are proposed from this response; \"Back to the old gains\" brings those "
                  "back.")
            .arg(numberText(m_proof->steps.overshoot_pct->value, 0),
                numberText(promised.overshoot_pct, 0));
    case lab::Kept::Unclear:
        if (response.ms && response.crossover_hz)
            return tr("Neither proved nor refuted: the overshoot of its steps could not be "
                      "measured. \"Back to the old gains\" brings them back.");
        return tr("Neither proved nor refuted: the loop's gain does not fall through 1 where it "
                  "could be measured. \"Back to the old gains\" brings them back.");
    case lab::Kept::Yes:
        break;
    }
    return tr("The loop keeps what was predicted: Ms %1, at most %2 promised.")
        .arg(numberText(response.ms->value, 2), most);
}

} // namespace widgets

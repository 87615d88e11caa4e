#include "widgets/lab/tour_page.h"

#include "widgets/base/device_text.h"
#include "widgets/base/fields/whole_spin.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/lab/text.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr int kLeast_s = 4, kMost_s = 40, kUsual_s = 16;
constexpr std::chrono::milliseconds kWriting{8000}; ///< the board's values are read and kept before

/// What is told of a figure in the table of the tour.
QString figureText(const MotorFindings &findings, MotorFindings::Row row)
{
    const auto cell = [&](int column) { return findings.index(row, column).data().toString(); };
    return cell(MotorFindings::QuantityColumn) + QLatin1Char(' ')
        + cell(MotorFindings::MeasuredColumn);
}

} // namespace

TourPage::TourPage(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_parts(parts)
    , m_table(new RowList("tourSteps", tr("Stations of the tour"), &m_steps, this))
    , m_bar(new ExperimentBar(parts.lab, "tour", this))
{
    setObjectName(QStringLiteral("tourPage"));
    m_table->setAlternatingRowColors(false);
    m_table->setMinimumHeight(80);
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->header()->setSectionResizeMode(TourSteps::ResultColumn, QHeaderView::Stretch);
    auto *layout = edged(new QVBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0}, kHalfGrid);
    layout->addWidget(makeChoices());
    layout->addWidget(m_table, 1);
    makeBar();
    Device &device = parts.lab.device;
    LoopTuning &tuning = parts.tuning;
    connect(&device, &Device::identityChanged, this, &TourPage::forget);
    connect(&device, &Device::motorChanged, this, &TourPage::forget);
    connect(
        &tuning, &LoopTuning::watchedRegistersChanged, this, &TourPage::watchedRegistersChanged);
    connect(&tuning, &LoopTuning::changed, this, &TourPage::showGains);
    connect(&tuning, &LoopTuning::changed, m_bar, &ExperimentBar::refresh);
    connect(&tuning, &LoopTuning::written, this, [this](bool good, const QString &sentence) {
        if (!good && isVisible())
            m_bar->tell(sentence);
    });
    connect(m_goal, &QComboBox::currentIndexChanged, this, &TourPage::showGains);
    connect(m_goal, &QComboBox::currentIndexChanged, m_bar, &ExperimentBar::refresh);
    connect(m_length, &QSpinBox::valueChanged, m_bar, &ExperimentBar::refresh);
    connect(m_bar, &ExperimentBar::began, this, &TourPage::began);
    connect(m_bar, &ExperimentBar::ended, this, &TourPage::ended);
    forget();
}

QWidget *TourPage::makeChoices()
{
    auto *choices = new QWidget(this);
    auto *row = bare(new QHBoxLayout(choices), kGrid);
    m_goal = named(new QComboBox(choices), "tourGoal");
    m_goal->setToolTip(
        tr("How near to instability the proposed gains go: Ms at most 1.4, 1.7, 2.0"));
    m_goal->addItems({tr("stiff"), tr("medium"), tr("quick")});
    m_goal->setCurrentIndex(1);
    new WheelGuard(m_goal);
    m_length = named(new WholeSpin(choices), "tourLength");
    m_length->setRange(kLeast_s, kMost_s);
    m_length->setValue(kUsual_s);
    m_length->setSuffix(QStringLiteral("\u202fs"));
    m_length->setToolTip(tr("Of each response; the longer, the narrower its error bars"));
    new WheelGuard(m_length);
    const auto labelled = [&](const QString &text, QWidget *field) {
        auto *label = new QLabel(text, choices);
        label->setBuddy(field);
        row->addWidget(label);
        row->addWidget(field);
    };
    labelled(tr("&Goal"), m_goal);
    labelled(tr("&Length"), m_length);
    row->addStretch(1);
    return choices;
}

void TourPage::makeBar()
{
    m_tour = m_bar->add({{}, "tourRun", {}, [this] { return wholeTour(); }});
    ExperimentBar::Button prove{tr("&Apply and prove"), "tourProveRun",
        tr("Writes the proposed gains as one step, which can be undone, reads them back, and "
           "measures the response and steps with them."),
        [this] { return proof(); }};
    prove.prepare = [this] {
        if (const auto gains = chosen())
            m_parts.tuning.apply(*gains);
    };
    prove.settled = [this] { // others may be held yet, from before
        return m_parts.tuning.holdsApplied() && m_parts.tuning.applied() == chosen();
    };
    prove.patience = kWriting;
    m_prove = m_bar->add(std::move(prove));
    m_bar->leaveOutObstacle(); // the first station has it
    m_back = named(new QPushButton(tr("&Back to the old gains"), m_bar), "tourBack");
    m_bar->addAside(m_back);
    connect(m_back, &QPushButton::clicked, this, [this] { m_parts.tuning.back(); });
}

std::vector<catalog::RegisterId> TourPage::watchedRegisters() const
{
    return m_parts.tuning.watchedRegisters();
}

void TourPage::refresh(Milliseconds)
{
    m_parts.tuning.refresh();
    check();
    m_bar->refresh();
}

void TourPage::focusFirst() { m_goal->setFocus(Qt::ShortcutFocusReason); }

void TourPage::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    check();
    showGains();
    m_bar->refresh();
}

void TourPage::forget()
{
    waitAt(TourSteps::Windings);
    m_steps.clear();
    check();
    showGains();
    m_bar->refresh();
}

std::chrono::milliseconds TourPage::length() const
{
    return std::chrono::seconds(m_length->value());
}

lab::Goal TourPage::goal() const
{
    return lab::kGoals[static_cast<std::size_t>(std::max(0, m_goal->currentIndex()))];
}

std::optional<LoopTuning::Gains> TourPage::chosen() const
{
    const auto one = m_parts.tuning.candidate(goal());
    return one ? std::optional(LoopTuning::Gains{one->proportional, one->integral}) : std::nullopt;
}

/// Whether the motor can be measured at all, and which stations this board cannot have.
void TourPage::check()
{
    if (m_bar->busy())
        return;
    const auto subject = m_parts.lab.experiments.subject();
    const QString why = subject ? m_parts.lab.experiments.obstacle() : subject.error();
    if (!why.isEmpty())
        return m_steps.set(TourSteps::Check, State::Waits, why);
    m_steps.set(TourSteps::Check, State::Done,
        subject->seesRotor() ? tr("The board sees its rotor and is armed.")
                             : tr("The board observes its rotor without a sensor, and is armed."));
}

Result<ExperimentBar::Run, QString> TourPage::runOf(Step step)
{
    auto run = step == TourSteps::Windings ? m_parts.identification.electricalRun()
        : step == TourSteps::Mechanics     ? m_parts.identification.mechanicalRun()
                                           : m_parts.tuning.speedRun(length());
    if (!run)
        return run;
    for (const lab::Experiment &experiment : run->experiments)
        if (const std::string why = lab::objectionTo(experiment); !why.empty())
            return fail(labSentence(why));
    return run;
}

/// The next station, and all that follows: it is asked about once. Stations that this board cannot have are passed
/// over.
Result<ExperimentBar::Run, QString> TourPage::wholeTour()
{
    if (auto response = runOf(TourSteps::Response); !response) // the tour is for it
        return response;
    std::optional<ExperimentBar::Run> tour;
    for (int step = m_next; step <= TourSteps::Response; ++step) {
        auto run = runOf(Step(step));
        if (!run)
            continue;
        if (!tour)
            tour = std::move(*run);
        else
            tour->later.insert(tour->later.end(), run->experiments.begin(), run->experiments.end());
    }
    const auto subject = m_parts.lab.experiments.subject();
    if (subject)
        tour->later.push_back(
            {lab::proofStepsFor(*subject, m_parts.lab.device.userLimits()), *subject});
    return std::move(*tour);
}

Result<ExperimentBar::Run, QString> TourPage::proof()
{
    if (withoutResponse())
        return fail(noGainsText());
    const auto gains = chosen();
    const auto &measured = m_parts.tuning.measured();
    if (!gains && !measured)
        return fail(tr("Make the tour first: it proposes the gains."));
    if (!gains)
        return fail(measured->whyNone.empty() ? tr("No gains keep the distance of this goal.")
                                              : labSentence(measured->whyNone));
    return m_parts.tuning.proofRun(length(), *gains);
}

bool TourPage::withoutResponse() const
{
    return m_steps.state(TourSteps::Response) == State::Unclear
        && m_parts.tuning.measurements() == m_measurements;
}

QString TourPage::noGainsText()
{
    return tr("The response was not conclusive: no gains follow from it.");
}

void TourPage::began(int which)
{
    if (which == m_prove)
        return m_steps.set(TourSteps::Proof, State::Runs);
    m_measurements = m_parts.tuning.measurements();
    if (m_next == TourSteps::Windings)
        for (const Step step : {TourSteps::Windings, TourSteps::Mechanics, TourSteps::Response,
                 TourSteps::Gains, TourSteps::Proof})
            m_steps.set(step, State::Waits);
    while (m_next < TourSteps::Response) { // as wholeTour() passes over
        const auto run = runOf(m_next);
        if (run)
            break;
        m_steps.set(m_next, State::Impossible, run.error());
        m_next = Step(m_next + 1);
    }
    m_steps.set(m_next, State::Runs);
}

/// From the first station, or from a response: with gentler gains, which are still to be agreed to, if those stand with
/// which the speed swung.
void TourPage::waitAt(Step next)
{
    m_next = next;
    if (next == TourSteps::Response)
        m_bar->rename(m_tour, tr("Go on with the tou&r"),
            tr("Measures the response, and proposes gains from it. Instead of the gains with which "
               "the speed swung it takes gentler ones meanwhile, and asks about them; others are "
               "taken as they are."));
    else
        m_bar->rename(m_tour, tr("Sta&rt the tour"),
            tr("Measures windings, mechanics and the response of the speed, one after the other, "
               "and proposes gains; nothing is written."));
}

/// The next station begins by itself: it was asked about with the first. So it does behind windings whose speed swings:
/// it needs none at rest.
void TourPage::ended(int which, bool complete)
{
    const Step step = which == m_prove ? TourSteps::Proof : m_next;
    const bool swung = which == m_tour && !complete && m_bar->swung();
    const bool calmed = swung && step == TourSteps::Response && !m_bar->more().isEmpty();
    if (complete)
        showStation(step);
    else
        m_steps.set(step, State::Ended,
            calmed ? m_bar->told() + QLatin1Char(' ') + tr("Go on with the tour: it begins there.")
                   : m_bar->told());
    if (which == m_prove || step == TourSteps::Response || !(complete || swung)) {
        waitAt(calmed ? TourSteps::Response : TourSteps::Windings);
        showGains();
        return m_bar->refresh();
    }
    m_next = Step(m_next + 1);
    if (!m_bar->goOn(m_tour)) {
        m_steps.set(m_next, State::Ended, m_bar->told());
        m_next = TourSteps::Windings;
    }
}

void TourPage::showStation(Step step)
{
    const MotorFindings &findings = m_parts.identification.findings();
    const motor::MotorSheet measured = findings.measured();
    const auto list = [&](std::initializer_list<MotorFindings::Row> rows) {
        QStringList texts;
        for (const MotorFindings::Row row : rows)
            texts.append(figureText(findings, row));
        return texts.join(QStringLiteral(", "));
    };
    if (step == TourSteps::Windings) {
        const bool all = measured.rs_ohm && measured.ld_h && measured.lq_h && measured.flux_wb;
        const QString figures = list(
            {MotorFindings::Resistance, MotorFindings::Ld, MotorFindings::Lq, MotorFindings::Flux});
        m_steps.set(step, all ? State::Done : State::Unclear,
            all ? figures : figures + QStringLiteral(". ") + m_bar->more());
    } else if (step == TourSteps::Mechanics) {
        const bool any = measured.inertia_kgm2.has_value();
        m_steps.set(step, any ? State::Done : State::Unclear,
            any ? list({MotorFindings::Inertia, MotorFindings::Viscous, MotorFindings::Dry})
                : m_bar->more());
    } else if (step == TourSteps::Response) {
        const auto &found = m_parts.tuning.measured();
        const bool margins = m_parts.tuning.measurements() != m_measurements && found
            && found->response.crossover_hz && found->response.ms;
        m_steps.set(step, margins ? State::Done : State::Unclear,
            margins ? tr("Crossover %1 Hz, Ms %2")
                          .arg(numberText(found->response.crossover_hz->value, 1),
                              numberText(found->response.ms->value, 2))
                    : m_bar->more());
    } else {
        const auto &proof = m_parts.tuning.proof();
        m_steps.set(step, proof && proof->kept == lab::Kept::Yes ? State::Done : State::Unclear,
            proof ? m_parts.tuning.verdict() : m_bar->more());
    }
}

/// What is proposed for the goal, and whether the board holds it.
void TourPage::showGains()
{
    const LoopTuning &tuning = m_parts.tuning;
    const QString why = tuning.backHint();
    m_back->setEnabled(why.isEmpty());
    m_back->setToolTip(plainToolTip(
        why.isEmpty() ? tr("Writes the gains from before the first Apply, as one step") : why));
    const auto &measured = tuning.measured();
    const auto one = tuning.candidate(goal());
    const bool none = withoutResponse();
    const State proof = m_steps.state(TourSteps::Proof);
    if (proof == State::Waits && (none || (measured && !one)))
        m_steps.set(TourSteps::Proof, State::PassedOver, tr("There are no gains to prove."));
    else if (proof == State::PassedOver && !none && (!measured || one))
        m_steps.set(TourSteps::Proof, State::Waits);
    if (none)
        return m_steps.set(TourSteps::Gains, State::PassedOver, noGainsText());
    if (!measured)
        return m_steps.set(TourSteps::Gains, State::Waits);
    if (!one)
        return m_steps.set(TourSteps::Gains, State::Unclear,
            measured->whyNone.empty() ? tr("No gains keep the distance of this goal.")
                                      : labSentence(measured->whyNone));
    const bool held = tuning.present() == chosen();
    const QString text = tr("Kp %1, Ki %2: crossover %3 Hz, phase margin %4\u00b0, Ms %5 predicted")
                             .arg(QString::number(one->proportional),
                                 QString::number(one->integral), numberText(one->crossover_hz, 1),
                                 numberText(one->phaseMargin_deg, 0), numberText(one->ms, 2));
    m_steps.set(TourSteps::Gains, held ? State::Done : State::Waits,
        held ? tr("%1; the board holds them.").arg(text) : tr("%1; not written yet.").arg(text));
}

} // namespace widgets

#include "widgets/lab/step_page.h"

#include "drive/motion_limits.h"
#include "lab/evaluation/finding.h"
#include "lab/happenings.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/lab/step_fields.h"
#include "widgets/lab/step_overlay.h"
#include "widgets/lab/step_runs.h"
#include "widgets/lab/text.h"
#include "widgets/lab/told_figures.h"

#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

/// Of the table. More would cut the picture in a small window where the sentence of an end stands below the buttons.
constexpr int kLeastRows = 1;

/// What has to be known of a series that came to its end.
QStringList wordsOf(const lab::StepSeries &series)
{
    QStringList words = labSentences(series.notes);
    if (const std::string lack = lab::lackOf(series); !lack.empty())
        words.prepend(labSentence(lack));
    return words;
}

/// How many steps have been asked for.
int stepsIn(const lab::Happenings &happenings)
{
    int steps = 0;
    for (const auto &[at, what] : lab::carriedOut(happenings))
        steps += lab::setsSpeedAtOnce(what) ? 1 : 0;
    return steps;
}

ExperimentBar::Progress progress(const lab::Happenings &happenings)
{
    const recorded::Happening &begun = happenings.front().second;
    if (lab::recordedPlan<lab::LoadPlan>(begun) && stepsIn(happenings) >= 1)
        return {1, 2, StepPage::tr("The speed is held: put the load on, and take it off.")};
    const auto plan = lab::recordedPlan<lab::StepPlan>(begun);
    if (!plan)
        return {}; // a current is stepped by milliseconds: the time tells it
    const int all = 2 * plan->plan.repeat;
    const int steps = std::min(stepsIn(happenings), all);
    return {steps, all,
        steps == 0 ? StepPage::tr("On the way to the first speed\u2026")
                   : StepPage::tr("Step %1 of %2", "numbers")
                         .arg(QString::number(steps), QString::number(all))};
}

} // namespace

StepPage::StepPage(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_parts(parts)
    , m_fields(new StepFields(this))
    , m_direction(named(new QComboBox(this), "stepDirection", tr("Steps in the picture")))
    , m_overlay(new StepOverlay(this))
    , m_runs(new StepRuns(this))
    , m_table(new RowList("stepRuns", tr("Series of steps"), m_runs, this))
    , m_bar(new ExperimentBar(parts.lab, "step", this))
{
    setObjectName(QStringLiteral("stepPage"));
    for (std::size_t kind = 0; kind < kStepKinds; ++kind)
        m_gains[kind] = new SpeedGains(
            parts.device, parts.registers, parts.edits, static_cast<StepKind>(kind), this);
    // Side by side: one above the other, both would have half of a height that is little in a small window.
    auto *both = new QSplitter(Qt::Horizontal, this);
    both->setChildrenCollapsible(false);
    both->addWidget(m_overlay);
    both->addWidget(makeSide());
    both->setStretchFactor(0, 2);
    both->setStretchFactor(1, 3);
    both->setSizes({1000, 1500}); // shares of what there is
    makeTable();
    auto *layout = edged(new QVBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0});
    layout->addWidget(both);
    makeBar();
    connectParts();
    boardChanged();
    showResults();
}

/// The table, below what is changed from step to step. A gain whose text gets longer moves nothing: it is at the end.
QWidget *StepPage::makeSide()
{
    m_direction->addItems({tr("steps up"), tr("steps down")});
    new WheelGuard(m_direction);
    auto *side = new QWidget(this);
    auto *gains = new QWidget(side);
    auto *grid = bare(new QGridLayout(gains), kGrid, kFineGrid);
    auto *label = new QLabel(tr("In the picture"), gains);
    label->setBuddy(m_direction);
    for (SpeedGains *of : m_gains) // one of them is seen
        grid->addWidget(of, 0, 0, 1, 2);
    grid->addWidget(label, 1, 0);
    grid->addWidget(m_direction, 1, 1);
    auto *choices = new QWidget(side);
    auto *flow = new FlowLayout(kGrid, choices);
    flow->addWidget(m_fields);
    flow->addWidget(gains);
    auto *column = bare(new QVBoxLayout(side), kHalfGrid);
    column->addWidget(choices);
    column->addWidget(m_table, 1);
    return side;
}

void StepPage::makeTable()
{
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setIconSize(QSize(2 * fontMetrics().height(), fontMetrics().height()));
    m_table->installEventFilter(this);
}

void StepPage::makeBar()
{
    ExperimentBar::Button run{tr("Run steps"), "stepRun",
        tr("Steps up and down; then the motor is as it was (Ctrl+Shift+T)."),
        [this] { return wanted(); }, Qt::CTRL | Qt::SHIFT | Qt::Key_T};
    run.settled = [this] { return gains().settled(); };
    m_bar->add(std::move(run));
    m_bar->add({tr("Load"), "stepLoad",
        tr("Holds the speed that the motor has for 10 s, in which you put a load on it and take it "
           "off: says how far the speed gives way, and when it is back."),
        [this] { return loadWanted(); }});
    m_bar->setLook(progress);
    m_bar->setPollable(true);
    m_reference = named(new QPushButton(tr("Reference"), m_bar), "stepReference");
    m_reference->setToolTip(tr("The others show their difference to the chosen series (Enter)"));
    m_remove = named(new QPushButton(tr("Remove"), m_bar), "stepRemove");
    m_remove->setToolTip(tr("Takes the chosen series out of the table and the picture (Delete)"));
    m_bar->addAside(m_reference);
    m_bar->addAside(m_remove);
}

void StepPage::connectParts()
{
    Device &device = m_parts.device;
    connect(m_fields, &StepFields::changed, m_bar, &ExperimentBar::refresh);
    connect(m_fields, &StepFields::kindChanged, this, &StepPage::kindChanged);
    for (const SpeedGains *of : m_gains)
        connect(of, &SpeedGains::changed, m_bar, &ExperimentBar::refresh);
    connect(&device, &Device::boundsChanged, this, &StepPage::boardChanged);
    connect(&m_parts.registers, &RegisterModel::catalogSet, this, &StepPage::boardChanged);
    connect(&m_parts.edits, &RegisterEdits::told, this, [this](const QString &told, bool good) {
        if (!good && isVisible())
            m_bar->tell(told);
    });
    connect(m_direction, &QComboBox::currentIndexChanged, this, &StepPage::showResults);
    connect(m_runs, &StepRuns::changed, this, &StepPage::showResults);
    connect(m_reference, &QPushButton::clicked, this, &StepPage::takeAsReference);
    connect(m_remove, &QPushButton::clicked, this, &StepPage::removeChosen);
    connect(m_table, &QTreeView::doubleClicked, this, &StepPage::takeAsReference);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &StepPage::enableButtons);
}

std::vector<catalog::RegisterId> StepPage::watchedRegisters() const
{
    return gains().watchedRegisters();
}

void StepPage::refresh(Milliseconds)
{
    if (gains().refresh())
        Q_EMIT watchedRegistersChanged();
    m_bar->refresh();
}

void StepPage::focusFirst() { m_fields->focusFirst(); }

void StepPage::boardChanged()
{
    const Device &device = m_parts.device;
    const auto subject = m_parts.lab.experiments.subject(true);
    const auto recorded = m_parts.lab.experiments.subject();
    const drive::UserLimits own = device.userLimits();
    const drive::MotionBounds most = drive::realBoundsOf(device.limits(device.motor()), own);
    m_fields->setLimits({.greatestRpm = most.rpm,
        .greatestAmps = most.amps,
        .leastRpm = subject ? subject->leastObservedRpm(own.maxSpeedRpm) : 0.0,
        .turningRpm = recorded ? lab::currentStepPlanFor(*recorded, false, 0.0, 1.0, own).rpm : 0});
    for (const StepKind kind : {StepKind::Torque, StepKind::Flux, StepKind::Position})
        m_fields->grey(kind, subject && !recorded ? recorded.error() : QString());
    if (recorded && recorded->registers.position == 0)
        m_fields->grey(
            StepKind::Position, tr("This board does not control the position of its shaft."));
    else if (recorded && own.maxSpeedRpm > 0.0)
        m_fields->grey(StepKind::Position,
            tr("Nothing holds your own limit of the speed in position control: take it away "
               "first."));
    Q_EMIT watchedRegistersChanged();
    m_bar->refresh();
}

SpeedGains &StepPage::gains() const { return *m_gains[std::size_t(m_fields->kind())]; }

void StepPage::kindChanged()
{
    for (SpeedGains *of : m_gains)
        of->setWanted(of == &gains());
    m_bar->setPollable(m_fields->kind() == StepKind::Speed);
    Q_EMIT watchedRegistersChanged();
    showResults();
    m_bar->refresh();
}

void StepPage::changeEvent(QEvent *event)
{
    Form::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_runs->setDark(isDark(palette()));
}

Result<ExperimentBar::Run, QString> StepPage::wanted()
{
    if (const QString why = m_fields->problem(); !why.isEmpty())
        return fail(why);
    if (gains().there() && !gains().known())
        return fail(tr("The gains are being read."));
    const auto subject = m_parts.lab.experiments.subject(m_fields->kind() == StepKind::Speed);
    if (!subject)
        return fail(subject.error());
    const auto plan = m_fields->plan(m_parts.device.userLimits());
    if (!plan)
        return fail(QString());
    return ExperimentBar::Run{
        {{*plan, *subject}}, evaluation(*subject), {.proportional = gains().jumpPerRpm(*subject)}};
}

Result<ExperimentBar::Run, QString> StepPage::loadWanted()
{
    const auto subject = m_parts.lab.experiments.subject();
    if (!subject)
        return fail(subject.error());
    lab::LoadPlan plan = lab::loadPlanFor(*subject, m_parts.device.userLimits());
    const drive::MotorStatus status = m_parts.device.status(subject->motor);
    if (status.state == drive::MotorState::Running)
        plan.fromRpm = plan.toRpm = qRound(status.speedRpm.value_or(plan.fromRpm));
    return ExperimentBar::Run{{{plan, *subject}}, tellsFigures()};
}

/// Also of a series that ended early, as far as it went.
ExperimentBar::Evaluate StepPage::evaluation(const lab::Subject &subject)
{
    return [this, bus = subject.nameOf(subject.registers.bus), &of = gains(),
               with = gains().values()](const Experiments::Run &run) -> ExperimentBar::Show {
        auto result = stepResult(run, bus);
        if (!result)
            return {};
        const bool complete = run.outcome.end == lab::End::Complete;
        if (!result->told())
            return [words = complete ? wordsOf(result->series) : QStringList()] { return words; };
        return [this, &of, with, complete, result = std::move(*result)] {
            return addResult(result, of, with, complete);
        };
    };
}

QStringList StepPage::addResult(
    StepResult result, const SpeedGains &gains, const SpeedGains::Values &begunWith, bool complete)
{
    result.kp = gains.kpText(begunWith.kp);
    result.ki = gains.kiText(begunWith.ki);
    QStringList more;
    if (begunWith != gains.values())
        more.append(tr("The gains were changed meanwhile: the row has the first."));
    if (complete) // else why it ended is what counts
        more += wordsOf(result.series);
    m_runs->add(std::move(result));
    m_table->scrollToBottom();
    return more;
}

void StepPage::enableButtons()
{
    const auto chosen = m_table->selectionModel()->selectedRows();
    m_reference->setEnabled(chosen.size() == 1 && chosen.first().row() != m_runs->reference());
    m_remove->setEnabled(!chosen.isEmpty());
}

void StepPage::showResults()
{
    m_overlay->showSteps(m_runs->results(), m_direction->currentIndex() == 0, m_fields->kind());
    for (int column = 0; column < StepRuns::kColumns; ++column)
        m_table->resizeColumnToContents(column);
    const int row = std::max(m_table->sizeHintForRow(0), fontMetrics().height());
    m_table->setMinimumHeight(m_table->header()->sizeHint().height() + kLeastRows * row
        + m_table->horizontalScrollBar()->sizeHint().height() + 2 * m_table->frameWidth());
    enableButtons();
}

void StepPage::takeAsReference()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.isValid())
        m_runs->setReference(current.row());
}

void StepPage::removeChosen()
{
    QList<int> rows;
    for (const QModelIndex &index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    std::sort(rows.rbegin(), rows.rend());
    for (const int row : rows)
        m_runs->remove(row);
}

bool StepPage::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_table || event->type() != QEvent::KeyPress)
        return Form::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
        takeAsReference();
    else if (key == Qt::Key_Delete)
        removeChosen();
    else
        return false;
    return true;
}

} // namespace widgets

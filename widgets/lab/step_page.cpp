#include "widgets/lab/step_page.h"

#include "lab/fields.h"
#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/trace_colors.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motor_button.h"
#include "widgets/lab/step_fields.h"
#include "widgets/lab/step_overlay.h"
#include "widgets/lab/step_runs.h"

#include <QComboBox>
#include <QDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr std::chrono::milliseconds kPatience{500};

/// A sentence of core, which begins small and has no full stop.
QString sentence(const std::string &words)
{
    QString text = QString::fromStdString(words);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text + QLatin1Char('.');
}

QString endText(const lab::Outcome &outcome)
{
    const QString reason = QString::fromStdString(outcome.reason);
    switch (outcome.end) {
    case lab::End::Complete:
        return reason.isEmpty() ? StepPage::tr("Done; the motor is as it was.")
                                : StepPage::tr("Done; afterwards: %1.").arg(reason);
    case lab::End::Refused:
        return StepPage::tr("Not carried out: %1.").arg(reason);
    case lab::End::Aborted:
        return StepPage::tr("Ended with a Stop: %1.").arg(reason);
    case lab::End::Interrupted:
    case lab::End::Lost:
        break;
    }
    return StepPage::tr("Interrupted: %1.").arg(reason);
}

/// How many steps have been asked for.
int stepsIn(const lab::Happenings &happenings)
{
    int steps = 0;
    for (const auto &[at, what] : lab::carriedOut(happenings))
        steps += what.name == "speed ramp" && lab::numberOf(what, "ms") == 0.0 ? 1 : 0;
    return steps;
}

} // namespace

StepPage::StepPage(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_parts(parts)
    , m_fields(new StepFields(this))
    , m_gains(new SpeedGains(parts.device, parts.registers, parts.edits, this))
    , m_direction(new QComboBox(this))
    , m_overlay(new StepOverlay(this))
    , m_runs(new StepRuns(this))
    , m_table(new QTreeView(this))
    , m_footer(makeFooter())
{
    setObjectName(QStringLiteral("stepPage"));
    auto *above = new QWidget(this);
    auto *row = new QHBoxLayout(above);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(makeSide());
    row->addWidget(m_overlay, 1);
    auto *both = new QSplitter(Qt::Vertical, this);
    both->setChildrenCollapsible(false);
    both->addWidget(above);
    both->addWidget(m_table);
    both->setStretchFactor(0, 3);
    both->setStretchFactor(1, 2);
    makeTable();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(kGrid, kHalfGrid, kGrid, 0);
    layout->addWidget(both);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connectParts();
    boardChanged();
    showResults();
}

QWidget *StepPage::makeSide()
{
    m_direction->setObjectName(QStringLiteral("stepDirection"));
    m_direction->setAccessibleName(tr("Steps in the picture"));
    m_direction->addItems({tr("steps up"), tr("steps down")});
    new WheelGuard(m_direction);
    auto *side = new QWidget(this);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kGrid);
    layout->addWidget(m_fields);
    layout->addWidget(m_gains);
    auto *shown = new QHBoxLayout;
    auto *label = new QLabel(tr("In the picture"), side);
    label->setBuddy(m_direction);
    shown->addWidget(label);
    shown->addWidget(m_direction, 1);
    layout->addLayout(shown);
    layout->addStretch(1);
    side->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    return side;
}

void StepPage::makeTable()
{
    m_table->setObjectName(QStringLiteral("stepRuns"));
    m_table->setAccessibleName(tr("Series of steps"));
    m_table->setModel(m_runs);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setAlternatingRowColors(true);
    m_table->setAllColumnsShowFocus(true);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setIconSize(QSize(2 * fontMetrics().height(), fontMetrics().height()));
    m_table->installEventFilter(this);
}

QWidget *StepPage::makeFooter()
{
    auto *footer = new QWidget(this);
    m_run = new MotorButton(tr("Run steps"), footer);
    m_run->setObjectName(QStringLiteral("stepRun"));
    m_run->setEnabled(false);
    m_run->setFocusPolicy(Qt::TabFocus); // a click leaves the focus in the gain that is tuned
    m_cancel = new MotorButton(tr("Cancel"), footer);
    m_cancel->setObjectName(QStringLiteral("stepCancel"));
    m_cancel->setFocusPolicy(Qt::TabFocus);
    m_cancel->setToolTip(tr("Stops every motor and disarms, as Esc does."));
    m_progress = new QProgressBar(footer);
    m_progress->setObjectName(QStringLiteral("stepProgress"));
    m_progress->setAccessibleName(tr("Progress of the series"));
    m_progress->setTextVisible(false);
    QSizePolicy place = m_progress->sizePolicy();
    place.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(place);
    m_progress->hide();
    m_progress->setFixedWidth(100);
    m_progress->setMaximumHeight(10);
    m_sentence = new SteadyLabel(footer, 2);
    m_sentence->setObjectName(QStringLiteral("stepSentence"));
    m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_reference = new QPushButton(tr("Reference"), footer);
    m_reference->setObjectName(QStringLiteral("stepReference"));
    m_reference->setToolTip(tr("The others show their difference to the chosen series (Enter)"));
    m_remove = new QPushButton(tr("Remove"), footer);
    m_remove->setObjectName(QStringLiteral("stepRemove"));
    m_remove->setToolTip(tr("Takes the chosen series out of the table and the picture (Delete)"));
    auto *layout = new QHBoxLayout(footer);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_run);
    layout->addWidget(m_cancel);
    layout->addWidget(m_progress);
    layout->addWidget(m_sentence, 1);
    layout->addWidget(m_reference);
    layout->addWidget(m_remove);
    return footer;
}

void StepPage::connectParts()
{
    Device &device = m_parts.device;
    connect(m_run, &QPushButton::clicked, this, &StepPage::run);
    auto *keys = new QShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_T, this);
    keys->setAutoRepeat(false); // one that is held is no wish for another series
    connect(keys, &QShortcut::activated, this, &StepPage::run);
    connect(m_cancel, &QPushButton::pressed, &device, &Device::stop); // as a Stop does
    connect(m_fields, &StepFields::changed, this, &StepPage::updateAll);
    connect(m_gains, &SpeedGains::changed, this, [this] {
        if (m_patience.isActive() && m_gains->settled()) {
            m_patience.stop();
            runNow();
        }
        updateAll();
    });
    connect(&m_patience, &QTimer::timeout, this,
        [this] { tell(tr("Not begun: the gain was not written in time.")); });
    connect(&device, &Device::armedStateChanged, this, &StepPage::updateAll);
    connect(&device, &Device::linkStateChanged, this, &StepPage::updateAll);
    connect(&device, &Device::statusChanged, this, &StepPage::updateAll);
    connect(&device, &Device::boundsChanged, this, &StepPage::boardChanged);
    connect(&m_parts.registers, &QAbstractItemModel::modelReset, this, &StepPage::boardChanged);
    connect(&m_parts.edits, &RegisterEdits::told, this, [this](const QString &told, bool good) {
        if (!good && isVisible())
            tell(told);
    });
    const Experiments &experiments = m_parts.experiments;
    connect(&experiments, &Experiments::progressed, this, &StepPage::progressed);
    connect(&experiments, &Experiments::began, this, &StepPage::updateAll);
    connect(&experiments, &Experiments::ended, this, &StepPage::ended);
    connect(&experiments, &Experiments::agreementEnded, this, [this] {
        if (m_question)
            m_question->reject();
    });
    connect(m_direction, &QComboBox::currentIndexChanged, this, &StepPage::showResults);
    connect(m_runs, &StepRuns::changed, this, &StepPage::showResults);
    connect(m_reference, &QPushButton::clicked, this, &StepPage::takeAsReference);
    connect(m_remove, &QPushButton::clicked, this, &StepPage::removeChosen);
    connect(m_table, &QTreeView::doubleClicked, this, &StepPage::takeAsReference);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &StepPage::updateAll);
}

std::vector<catalog::RegisterId> StepPage::watchedRegisters() const
{
    return m_gains->watchedRegisters();
}

void StepPage::refresh(Milliseconds)
{
    if (m_gains->refresh())
        Q_EMIT watchedRegistersChanged();
    updateAll();
}

void StepPage::focusFirst() { m_fields->focusFirst(); }

void StepPage::boardChanged()
{
    const Device &device = m_parts.device;
    m_fields->setLimit(device.bounds(device.motor()).rpm);
    Q_EMIT watchedRegistersChanged();
    updateAll();
}

void StepPage::changeEvent(QEvent *event)
{
    Form::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_runs->setDark(isDark(palette()));
}

void StepPage::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    updateAll();
}

/// Why Run does nothing now; empty if it does.
QString StepPage::hint() const
{
    if (const QString why = m_parts.experiments.obstacle(); !why.isEmpty())
        return why;
    if (const QString why = m_fields->problem(); !why.isEmpty())
        return why;
    if (m_gains->there() && !m_gains->known())
        return tr("The gains are being read.");
    const auto wanted = experiment();
    const std::string why = wanted ? lab::objectionTo(*wanted) : std::string();
    return why.empty() ? QString() : sentence(why);
}

std::optional<lab::Experiment> StepPage::experiment() const
{
    const auto subject = m_parts.experiments.subject();
    auto plan = m_fields->plan();
    if (!subject || !plan)
        return std::nullopt;
    plan->caps = m_parts.device.userLimits();
    return lab::Experiment{*plan, *subject};
}

MotorBefore StepPage::before() const
{
    const Device &device = m_parts.device;
    const drive::MotorStatus status = device.status(device.motor());
    if (status.state != drive::MotorState::Running)
        return {};
    const auto rpm = m_parts.motion.startTarget(device.motor()).rpm;
    return {true, rpm.value_or(status.speedRpm.value_or(0.0))};
}

/// A gain that is on its way to the board is waited for.
void StepPage::run()
{
    // A page behind another one is out of sight: its key moves nothing.
    if (!m_run->isEnabled() || m_patience.isActive() || m_run->visibleRegion().isEmpty())
        return;
    if (m_gains->settled())
        runNow();
    else
        m_patience.start();
}

void StepPage::runNow()
{
    const auto wanted = experiment();
    if (m_question || !wanted || !hint().isEmpty())
        return;
    const MotorBefore motor = before();
    if (m_parts.experiments.agreed(*wanted, motor.rpm))
        return begin(*wanted);
    m_question = askToConfirm(window(), stepQuestion(*wanted, motor),
        [this, page = QPointer(this), wanted = *wanted, motor](bool yes) {
            if (!page || !yes)
                return;
            if (const QString why = hint(); !why.isEmpty())
                return tell(tr("Not begun: %1").arg(why));
            m_parts.experiments.agree(wanted, motor.rpm);
            begin(wanted);
        });
}

void StepPage::begin(const lab::Experiment &experiment)
{
    const auto &plan = std::get<lab::StepPlan>(experiment.plan);
    const lab::Subject &subject = experiment.subject;
    m_own = true;
    m_runHadFocus = m_run->hasFocus();
    m_steps = 2 * plan.repeat;
    m_bus = subject.nameOf(subject.registers.bus);
    m_begunWith = m_gains->values();
    m_told.clear();
    m_parts.experiments.begin(
        experiment, lab::entryOf(plan, subject, m_gains->jumpPerRpm(subject)));
    updateAll();
}

void StepPage::progressed()
{
    if (!m_own || !m_parts.experiments.running())
        return;
    const int steps = std::min(stepsIn(m_parts.experiments.happenings()), m_steps);
    m_progress->setRange(0, m_steps);
    m_progress->setValue(steps);
    m_sentence->setText(steps == 0
            ? tr("On the way to the first speed\u2026")
            : tr("Step %1 of %2", "numbers").arg(QString::number(steps), QString::number(m_steps)));
}

void StepPage::ended(const Experiments::Record &record)
{
    if (!std::exchange(m_own, false))
        return;
    m_progress->setValue(0);
    m_told = endText(record.outcome);
    addResult(record);
    updateAll();
    if (std::exchange(m_runHadFocus, false) && m_run->isEnabled() && isVisible())
        m_run->setFocus(Qt::OtherFocusReason);
}

/// Also of a series that ended early, as far as it went.
void StepPage::addResult(const Experiments::Record &record)
{
    auto result = stepResult(record, m_bus);
    if (!result || !result->told())
        return;
    result->kp = m_gains->kpText(m_begunWith.kp);
    result->ki = m_gains->kiText(m_begunWith.ki);
    QStringList more;
    if (m_begunWith != m_gains->values())
        more.append(tr("The gains were changed meanwhile: the row has the first."));
    if (record.outcome.end == lab::End::Complete) // else why it ended is what counts
        for (const std::string &note : result->series.notes)
            more.append(sentence(note));
    if (!more.isEmpty())
        m_told += QLatin1Char('\n') + more.join(QLatin1Char(' '));
    m_runs->add(std::move(*result));
    m_table->scrollToBottom();
}

void StepPage::tell(const QString &sentence)
{
    m_told = sentence;
    updateAll();
}

void StepPage::updateAll()
{
    if (!isVisible())
        return;
    const bool running = m_parts.experiments.running();
    const QString why = hint();
    m_run->setEnabled(why.isEmpty());
    m_run->setToolTip(plainToolTip(why.isEmpty()
            ? tr("Steps the speed up and down; then the motor is as it was (Ctrl+Shift+T).")
            : why));
    m_cancel->setEnabled(running && m_own);
    m_progress->setVisible(running && m_own);
    if (!(running
            && m_own)) // how it ended, and below it what is to be known, or what the next one lacks
        m_sentence->setText(
            m_told.isEmpty() || why.isEmpty() ? m_told + why : m_told + QLatin1Char('\n') + why);
    const auto chosen = m_table->selectionModel()->selectedRows();
    m_reference->setEnabled(chosen.size() == 1 && chosen.first().row() != m_runs->reference());
    m_remove->setEnabled(!chosen.isEmpty());
}

void StepPage::showResults()
{
    m_overlay->showSteps(m_runs->results(), m_direction->currentIndex() == 0);
    for (int column = 0; column < StepRuns::kColumns; ++column)
        m_table->resizeColumnToContents(column);
    updateAll();
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

#include "widgets/lab/experiment_bar.h"

#include "widgets/base/device_text.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motor_button.h"
#include "widgets/lab/text.h"

#include <QAction>
#include <QBoxLayout>
#include <QDialog>
#include <QProgressBar>
#include <QResizeEvent>

#include <algorithm>

namespace widgets {
namespace {

std::vector<lab::Experiment> allOf(const ExperimentBar::Run &run)
{
    std::vector<lab::Experiment> all = run.experiments;
    all.insert(all.end(), run.later.begin(), run.later.end());
    return all;
}

constexpr int kLines = 3; ///< of the sentence
constexpr int kLongestLines = 8; ///< of one that names what is to be typed back

/// Without the ends of its paragraphs, which take room.
QString flowing(QString text) { return text.replace(QLatin1Char('\n'), QLatin1Char(' ')); }

} // namespace

ExperimentBar::ExperimentBar(const Parts &parts, const char *prefix, QWidget *page)
    : QWidget(page)
    , m_parts(parts)
{
    m_pool.setMaxThreadCount(1);
    makeRow(prefix);
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this,
        [this] { tell(tr("Not begun: the gains were not written in time.")); });
    Device &device = parts.device;
    connect(m_cancel, &QPushButton::pressed, &device, &Device::stop); // as a Stop does
    connect(&device, &Device::identityChanged, this, [this, &device] {
        if (!std::exchange(m_known, device.identified().has_value()) && m_known)
            m_told.clear(); // which was of the board before, or of the link to it
    });
    connect(&device, &Device::armedStateChanged, this, &ExperimentBar::refresh);
    connect(&device, &Device::linkStateChanged, this, &ExperimentBar::refresh);
    connect(&device, &Device::statusChanged, this, &ExperimentBar::refresh);
    const Experiments &experiments = parts.experiments;
    connect(&experiments, &Experiments::progressed, this, &ExperimentBar::progressed);
    connect(&experiments, &Experiments::began, this, &ExperimentBar::refresh);
    connect(&experiments, &Experiments::ended, this, &ExperimentBar::accept);
    connect(&experiments, &Experiments::agreementEnded, this, [this] {
        if (m_question)
            m_question->reject();
    });
}

void ExperimentBar::makeRow(const char *prefix)
{
    const auto named = [prefix](const char *what) {
        return QLatin1String(prefix) + QLatin1String(what);
    };
    m_cancel = new MotorButton(tr("Cancel"), this);
    m_cancel->setObjectName(named("Cancel"));
    m_cancel->setFocusPolicy(Qt::TabFocus);
    m_cancel->setToolTip(tr("Stops every motor and disarms, as Esc does."));
    m_progress = new QProgressBar(this);
    m_progress->setObjectName(named("Progress"));
    m_progress->setAccessibleName(tr("Progress of the experiment"));
    m_progress->setTextVisible(false);
    m_progress->hide();
    m_progress->setMaximumHeight(10);
    m_place = new QWidget(this); // nothing moves when the progress comes
    m_place->setFixedSize(100, m_cancel->sizeHint().height());
    auto *place = bare(new QVBoxLayout(m_place));
    place->addWidget(m_progress, 0, Qt::AlignVCenter);
    m_sentence = new SteadyLabel(this, kLines);
    m_sentence->setObjectName(named("Sentence"));
    m_sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto *buttons = new QWidget(this);
    m_flow = new FlowLayout(kHalfGrid, buttons);
    m_flow->addWidget(m_cancel);
    m_flow->addWidget(m_place);
    m_row = bare(new QBoxLayout(QBoxLayout::LeftToRight, this));
    m_row->addWidget(buttons);
    m_row->addWidget(m_sentence, 1);
}

int ExperimentBar::add(Button button)
{
    const int which = static_cast<int>(m_buttons.size());
    auto *run = new MotorButton(button.text, this);
    run->setObjectName(QLatin1String(button.name));
    run->setEnabled(false);
    run->setFocusPolicy(Qt::TabFocus); // a click leaves the focus in the gain that is tuned
    connect(run, &QPushButton::clicked, this, [this, which] { this->run(which); });
    if (!button.keys.isEmpty()) {
        // No QShortcut: the Keys page lists actions.
        auto *keys = new QAction(button.text, parentWidget());
        keys->setShortcut(button.keys);
        keys->setAutoRepeat(false); // one that is held is no wish for another run
        parentWidget()->addAction(keys);
        connect(keys, &QAction::triggered, this, [this, which] { this->run(which); });
    }
    for (QWidget *behind : {static_cast<QWidget *>(m_cancel), m_place})
        m_flow->removeWidget(behind);
    for (QWidget *next : {static_cast<QWidget *>(run), static_cast<QWidget *>(m_cancel), m_place})
        m_flow->addWidget(next);
    QWidget *before = which == 0 ? nullptr : m_runs.back();
    if (before)
        setTabOrder(before, run);
    setTabOrder(run, m_cancel);
    m_runs.push_back(run);
    m_buttons.push_back(std::move(button));
    return which;
}

void ExperimentBar::addAside(QWidget *widget) { m_flow->addWidget(widget); }

void ExperimentBar::rename(int which, const QString &text, const QString &help)
{
    Button &button = m_buttons[static_cast<std::size_t>(which)];
    button.text = text;
    button.help = help;
    m_runs[static_cast<std::size_t>(which)]->setText(text);
    refresh();
}

/// Whether the sentence has room for a text, in so many pixels.
bool ExperimentBar::fits(const QString &text, int width) const
{
    constexpr int kTall = 10'000;
    const QFontMetrics metrics = m_sentence->fontMetrics();
    return metrics.boundingRect(QRect(0, 0, width, kTall), Qt::TextWordWrap, text).height()
        <= kLines * metrics.lineSpacing();
}

/// The sentence beside the buttons where there is room for some words, and for how it ended; else below them.
void ExperimentBar::fold()
{
    constexpr int kLetters = 24;
    int line = 0;
    for (int i = 0; i < m_flow->count(); ++i)
        line += m_flow->itemAt(i)->sizeHint().width() + kHalfGrid;
    const int room = width() - line;
    m_crowded = m_crowded || !fits(flowing(m_told), room); // the next run moves no button
    const bool beside = !m_crowded && room >= kLetters * fontMetrics().averageCharWidth();
    m_flow->parentWidget()->setMinimumWidth(beside ? line : 0);
    m_row->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

QSize ExperimentBar::minimumSizeHint() const
{
    return {m_flow->minimumSize().width(), QWidget::minimumSizeHint().height()};
}

void ExperimentBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->oldSize().width() != width())
        m_crowded = false;
    fold();
}

void ExperimentBar::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    fold();
    refresh();
}

MotorBefore ExperimentBar::before() const
{
    const Device &device = m_parts.device;
    const drive::MotorStatus status = device.status(device.motor());
    if (status.state != drive::MotorState::Running)
        return {};
    const auto rpm = m_parts.motion.startTarget(device.motor()).rpm;
    return {true, rpm.value_or(status.speedRpm.value_or(0.0))};
}

Result<ExperimentBar::Run, QString> ExperimentBar::wanted(int which) const
{
    auto run = m_buttons[static_cast<std::size_t>(which)].wanted();
    if (!run)
        return run;
    const bool runs = before().runs;
    if (runs && lab::inBothDirections(run->experiments))
        return fail(tr("Both directions begin at rest: stop the motor first."));
    for (const lab::Experiment &experiment : allOf(*run)) {
        if (const std::string why = lab::objectionTo(experiment); !why.empty())
            return fail(labSentence(why));
        if (runs && lab::conditionsOf(experiment).beginning != lab::Beginning::AtSpeed)
            return fail(tr("%1 is measured at rest: stop the motor first.", "Resistance")
                            .arg(experimentName(experiment)));
        if (const std::string why = lab::objectionWhileTurning(experiment, before().rpm);
            runs && !why.empty())
            return fail(labSentence(why));
    }
    const drive::StartTarget target = m_parts.motion.startTarget(m_parts.device.motor());
    if (target.control == catalog::ControlMode::Torque) // Other may be one that is not known
        return fail(tr("The motor is in torque control: ask for a speed first, with Go or a speed "
                       "ramp."));
    return run;
}

QString ExperimentBar::hint(int which) const
{
    if (const QString why = obstacle(); !why.isEmpty())
        return why;
    if (m_evaluating)
        return tr("What was measured is being evaluated.");
    const auto run = wanted(which);
    return run ? QString() : run.error();
}

bool ExperimentBar::settled(int which) const
{
    const auto &settled = m_buttons[static_cast<std::size_t>(which)].settled;
    return !settled || settled();
}

/// What is on its way to the board is waited for.
void ExperimentBar::run(int which)
{
    const MotorButton *button = m_runs[static_cast<std::size_t>(which)];
    // A page behind another one is out of sight: its key moves nothing.
    if (!button->isEnabled() || m_patience.isActive() || button->visibleRegion().isEmpty())
        return;
    const Button &what = m_buttons[static_cast<std::size_t>(which)];
    if (what.prepare)
        what.prepare();
    if (settled(which))
        return runNow(which);
    m_which = which;
    m_patience.start(what.patience);
}

bool ExperimentBar::agreed(const std::vector<lab::Experiment> &all) const
{
    const double before_rpm = before().rpm;
    return std::all_of(all.begin(), all.end(), [&](const lab::Experiment &experiment) {
        return m_parts.experiments.agreed(experiment, before_rpm);
    });
}

bool ExperimentBar::goOn(int which)
{
    const QString why = m_left.isEmpty() ? hint(which) : m_left;
    const auto run = wanted(which);
    const bool may = why.isEmpty() && run && agreed(run->experiments);
    if (may)
        begin(which, *run);
    else
        tell(tr("Not continued: %1")
                 .arg(why.isEmpty() ? tr("What comes next is not agreed to any more.") : why));
    return may;
}

void ExperimentBar::runNow(int which)
{
    if (m_question || !hint(which).isEmpty())
        return;
    const auto run = wanted(which);
    const MotorBefore motor = before();
    const std::vector<lab::Experiment> all = allOf(*run);
    if (agreed(all))
        return begin(which, *run);
    m_question = askToConfirm(window(), planQuestion(all, motor),
        [this, bar = QPointer(this), which, run = *run, all, motor](bool yes) {
            if (!bar || !yes)
                return;
            if (const QString why = hint(which); !why.isEmpty())
                return tell(tr("Not begun: %1").arg(why));
            for (const lab::Experiment &experiment : all)
                m_parts.experiments.agree(experiment, motor.rpm);
            begin(which, run);
        });
}

void ExperimentBar::begin(int which, const Run &run)
{
    m_own = true;
    m_which = which;
    m_hadFocus = m_runs[static_cast<std::size_t>(which)]->hasFocus();
    m_experiments = run.experiments;
    m_evaluate = run.evaluate;
    m_before = before();
    m_part = 0;
    m_since.start();
    m_told.clear();
    m_more.clear();
    std::vector<Experiments::Part> parts;
    for (const lab::Experiment &experiment : run.experiments)
        parts.push_back({experiment, lab::entryOf(experiment, run.regulator)});
    Q_EMIT began(which);
    m_parts.experiments.begin(std::move(parts), m_before.rpm);
    refresh();
}

/// How fast, behind what it is measured by, where that is to turn.
QString ExperimentBar::turning() const
{
    const Device &device = m_parts.device;
    const drive::MotorStatus status = device.status(device.motor());
    const bool turns = status.state == drive::MotorState::Running
        && lab::conditionsOf(m_experiments[m_part]).beginning == lab::Beginning::AtSpeed;
    return turns && device.statusIsNow(device.motor()) && status.speedRpm
        ? QStringLiteral(", ") + rpmText(*status.speedRpm)
        : QString();
}

void ExperimentBar::progressed()
{
    if (!m_own || !m_parts.experiments.running())
        return;
    if (m_parts.experiments.part() != m_part) {
        m_part = m_parts.experiments.part();
        m_since.start();
    }
    Progress progress;
    if (m_look)
        progress = m_look(m_parts.experiments.happenings());
    if (progress.words.isEmpty()) {
        const auto msOf = [this](std::size_t part) {
            return static_cast<int>(usualLength(m_experiments[part], m_before).count());
        };
        progress = {};
        progress.all = 0;
        for (std::size_t part = 0; part < m_experiments.size(); ++part) {
            progress.all += msOf(part);
            progress.done += part < m_part ? msOf(part) : 0;
        }
        const int elapsed = static_cast<int>(m_since.elapsed());
        progress.done += std::min(elapsed, msOf(m_part));
        constexpr int kMsPerSecond = 1000;
        progress.words =
            tr("%1: %2 s of about %3 s", "what is measured, times")
                .arg(experimentName(m_experiments[m_part]), QString::number(elapsed / kMsPerSecond),
                    QString::number((msOf(m_part) + kMsPerSecond - 1) / kMsPerSecond))
            + turning();
    }
    m_progress->setRange(0, progress.all);
    m_progress->setValue(progress.done);
    m_sentence->setText(progress.words);
}

void ExperimentBar::accept(const Experiments::RunPtr &run)
{
    if (!std::exchange(m_own, false))
        return refresh();
    m_progress->setValue(0);
    m_told = endText(run->outcome);
    m_swung = run->outcome.swings;
    m_left = run->outcome.leaves ? labSentence(run->outcome.reason) : QString();
    m_evaluating = true;
    refresh();
    m_pool.start([this, run, evaluate = std::exchange(m_evaluate, {})] {
        Show show = evaluate(*run);
        const bool complete = run->outcome.end == lab::End::Complete;
        QMetaObject::invokeMethod(
            this,
            [this, complete, show = std::move(show)] {
                shown(complete, show ? show() : QStringList());
            },
            Qt::QueuedConnection);
    });
}

void ExperimentBar::shown(bool complete, const QStringList &more)
{
    m_evaluating = false;
    m_more = more.join(QLatin1Char(' '));
    if (!more.isEmpty())
        m_told += QLatin1Char('\n') + m_more;
    refresh();
    MotorButton *button = m_runs[static_cast<std::size_t>(m_which)];
    if (std::exchange(m_hadFocus, false) && button->isEnabled() && isVisible())
        button->setFocus(Qt::OtherFocusReason);
    Q_EMIT ended(m_which, complete);
}

void ExperimentBar::tell(const QString &sentence)
{
    m_told = sentence;
    refresh();
}

/// What all buttons lack, or each of them.
QString ExperimentBar::hints() const
{
    if (!m_saysObstacle && !obstacle().isEmpty())
        return {};
    QStringList all, each;
    for (std::size_t which = 0; which < m_runs.size(); ++which) {
        const QString why = hint(static_cast<int>(which));
        if (why.isEmpty())
            continue;
        if (!all.contains(why))
            all.append(why);
        each.append(tr("%1: %2", "text of a button, why it is greyed")
                        .arg(QString(m_buttons[which].text).remove(QLatin1Char('&')), why));
    }
    return each.size() == qsizetype(m_runs.size()) && all.size() == 1 ? all.first()
                                                                      : each.join(QLatin1Char(' '));
}

void ExperimentBar::refresh()
{
    if (m_patience.isActive() && settled(m_which)) {
        m_patience.stop();
        runNow(m_which);
    }
    if (!isVisible())
        return;
    const bool running = m_own && m_parts.experiments.running();
    for (std::size_t which = 0; which < m_runs.size(); ++which) {
        const QString why = hint(static_cast<int>(which));
        m_runs[which]->setEnabled(why.isEmpty());
        m_runs[which]->setToolTip(plainToolTip(why.isEmpty() ? m_buttons[which].help : why));
    }
    m_cancel->setEnabled(running);
    m_progress->setVisible(running);
    if (running)
        return;
    fold();
    m_row->activate();
    const QString says = sentence();
    m_sentence->setLines(std::clamp(m_sentence->linesFor(says), kLines, kLongestLines));
    m_sentence->setSelectable(!m_told.isEmpty());
    m_sentence->setText(says);
}

/// How it ended, and below it what is to be known, and what the next one lacks. That gives way: the buttons have it,
/// too.
QString ExperimentBar::sentence() const
{
    const QString why = hints(), flows = flowing(m_told);
    if (m_told.isEmpty())
        return why;
    const QString below = why.isEmpty() ? why : QLatin1Char('\n') + why;
    for (const QString &text : {m_told + below, flows + below, m_told, flows})
        if (fits(text, m_sentence->width()))
            return text;
    return m_sentence->linesFor(m_told) <= kLongestLines ? m_told : flows;
}

} // namespace widgets

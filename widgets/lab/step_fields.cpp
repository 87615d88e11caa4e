#include "widgets/lab/step_fields.h"

#include "widgets/base/device_text.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/fields/whole_spin.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/lab/step_runs.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kAnyRpm = 1e6; ///< where no board has told its limit
constexpr double kUsualRpm = 4000.0;
constexpr double kNotch_rpm = 50.0;
/// Of the limit, offered at first: the step down of a heavy rotor on a supply that takes nothing back raises its bus,
/// and a step of 550 rpm trips the simulated blower. Twenty digits of the set-point say enough.
constexpr double kFromShare = 0.25, kToShare = 0.3, kLeastStep_rpm = 120.0;
/// Above what an observer needs, and a smaller step: the faster a motor turns the more a brake gives back.
constexpr double kFromObserved = 1.25, kObservedShare = 0.075;
constexpr int kNotch_ms = 50, kUsual_ms = 500, kLeastHold_ms = 50, kMost_ms = 10'000,
              kMostRepeats = 100;
/// Of a current: nothing holds the speed meanwhile.
constexpr int kCurrentNotch_ms = 5, kCurrentUsual_ms = 20, kCurrentLeast_ms = 10,
              kCurrentMost_ms = 500;
/// Of the greatest current, offered at first. A torque pushes all the time; a current along the magnets weakens them.
constexpr double kFromTorque = 0.1, kToTorque = 0.3, kToFlux = -0.3;
constexpr double kAnyAmps = 1e5; ///< where no board has told its limit
constexpr double kUsualAmps = 1.0;
constexpr double kUsual_deg = 90.0, kMost_deg = 3600.0;

/// Of the numbers of a kind, and of the time that each is held.
struct Fields {
    double digit, notch;
    int leastHold_ms, usualHold_ms, mostHold_ms, notchHold_ms;
    int usualApproach_ms; ///< of a position the time of a move
};
constexpr Fields kOfSpeed{
    1.0, kNotch_rpm, kLeastHold_ms, kUsual_ms, kMost_ms, kNotch_ms, kUsual_ms};
constexpr Fields kOfCurrent{
    0.01, 0.05, kCurrentLeast_ms, kCurrentUsual_ms, kCurrentMost_ms, kCurrentNotch_ms, kUsual_ms};
constexpr Fields kOfPosition{0.1, 5.0, 100, kUsual_ms, kMost_ms, kNotch_ms, 300};

const Fields &fieldsOf(StepKind kind)
{
    return kind == StepKind::Speed   ? kOfSpeed
        : kind == StepKind::Position ? kOfPosition
                                     : kOfCurrent;
}

} // namespace

StepFields::StepFields(QWidget *parent)
    : QWidget(parent)
    , m_grid(bare(new QGridLayout(this), kGrid, kFineGrid))
{
    setObjectName(QStringLiteral("stepFields"));
    m_from = addNumber(0, 0, tr("Fr&om"), "stepFrom", m_offered);
    m_to = addNumber(0, 2, tr("to", "a speed"), "stepTo", m_offered);
    m_hold = addSpin(1, 0, tr("Hold"), "stepHold");
    m_approach = addSpin(1, 2, tr("ramp"), "stepApproach");
    m_rampLabel = qobject_cast<QLabel *>(m_grid->itemAtPosition(1, 2)->widget());
    m_turning = addNumber(1, 2, tr("at", "a speed"), "stepSpeed", m_turningOffered);
    m_turning.edit->setToolTip(
        tr("How fast the motor turns meanwhile, negative for torques that push it backwards"));
    m_repeat = addSpin(2, 0, tr("Repeat"), "stepRepeat");
    m_repeat->setToolTip(tr("So many steps up, and as many down"));
    m_which = named(new QComboBox(this), "stepKind", tr("What is stepped"));
    for (const StepKind kind :
        {StepKind::Speed, StepKind::Torque, StepKind::Flux, StepKind::Position})
        m_which->addItem(StepRuns::kindText(kind));
    new WheelGuard(m_which);
    auto *label = new QLabel(tr("Kind"), this);
    label->setBuddy(m_which);
    m_grid->addWidget(label, 2, 2);
    m_grid->addWidget(m_which, 2, 3);
    connect(m_which, &QComboBox::currentIndexChanged, this, &StepFields::changeKind);
    m_approach->setRange(1, kMost_ms);
    m_approach->setSingleStep(kNotch_ms);
    for (QSpinBox *time : {m_hold, m_approach})
        time->setSuffix(QStringLiteral("\u202fms"));
    m_repeat->setRange(1, kMostRepeats);
    m_repeat->setSuffix(QStringLiteral("\u202f\u00d7"));
    showKind();
}

StepFields::Number StepFields::addNumber(
    int row, int column, const QString &text, const char *name, bool &offered)
{
    auto *edit = named(new NumberEdit(this), name);
    edit->setFixedWidth(edit->fontMetrics().horizontalAdvance(QStringLiteral("-0000000")));
    edit->setWheelAllowed(true); // moves nothing by itself
    edit->setNotch(kNotch_rpm);
    auto *label = new QLabel(text, this);
    label->setBuddy(edit);
    edit->setAccessibleName(tr("%1, rpm", "a field").arg(QString(text).remove(QLatin1Char('&'))));
    auto *unit = new QLabel(tr("rpm"), this);
    auto *both = bare(new QHBoxLayout, kHalfGrid);
    both->addWidget(edit);
    both->addWidget(unit);
    m_grid->addWidget(label, row, column);
    m_grid->addLayout(both, row, column + 1);
    connect(edit, &NumberEdit::echoChanged, this, [this, &offered] {
        offered = offered && m_offering;
        Q_EMIT changed();
    });
    return {edit, label, unit};
}

QSpinBox *StepFields::addSpin(int row, int column, const QString &text, const char *name)
{
    auto *spin = named(new WholeSpin(this), name);
    new WheelGuard(spin);
    auto *label = new QLabel(text, this);
    label->setBuddy(spin);
    spin->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    m_grid->addWidget(label, row, column);
    m_grid->addWidget(spin, row, column + 1);
    connect(spin, &QSpinBox::valueChanged, this, &StepFields::changed);
    return spin;
}

void StepFields::changeKind()
{
    m_typed[std::size_t(m_kind)] = {
        m_from.edit->text(), m_to.edit->text(), m_hold->value(), m_approach->value(), m_offered};
    m_kind = static_cast<StepKind>(m_which->currentIndex());
    showKind();
    Q_EMIT changed();
    Q_EMIT kindChanged();
}

void StepFields::show(const Number &number, bool shown)
{
    for (QWidget *part : {static_cast<QWidget *>(number.edit), static_cast<QWidget *>(number.label),
             static_cast<QWidget *>(number.unit)})
        part->setVisible(shown);
}

/// With what was typed for it, or what is offered.
void StepFields::showKind()
{
    const Typed typed = m_typed[std::size_t(m_kind)];
    const Fields &fields = fieldsOf(m_kind);
    m_hold->setRange(fields.leastHold_ms, fields.mostHold_ms);
    m_hold->setSingleStep(fields.notchHold_ms);
    m_hold->setValue(typed.hold_ms > 0 ? typed.hold_ms : fields.usualHold_ms);
    m_hold->setToolTip(ofSpeed()
            ? tr("How long each speed is held: longer than the loop takes to settle")
            : ofPosition()
            ? tr("How long each position is held: longer than the loop takes to settle")
            : tr("How long each current is held: nothing holds the speed meanwhile"));
    m_approach->setValue(typed.approach_ms > 0 ? typed.approach_ms : fields.usualApproach_ms);
    m_rampLabel->setVisible(!ofCurrent());
    m_rampLabel->setText(ofPosition() ? tr("in", "a time") : tr("ramp"));
    m_approach->setAccessibleName(m_rampLabel->text());
    m_approach->setVisible(!ofCurrent());
    m_approach->setToolTip(ofPosition()
            ? tr("The time of each move, there and back")
            : tr("Of the ramp to the first speed, and of the way back"));
    show(m_turning, ofCurrent());
    show(m_from, !ofPosition());
    m_to.label->setText(ofPosition() ? tr("B&y", "an angle") : tr("to", "a speed"));
    m_to.edit->setToolTip(ofPosition() ? tr("How far the shaft is moved from where it rests, and "
                                            "back")
                                       : QString());
    const QString unit = ofSpeed() ? tr("rpm")
        : ofPosition()             ? QString(QChar(0xb0))
                                   : QStringLiteral("A");
    for (const Number &end : {m_from, m_to}) {
        const QString name = QString(end.label->text()).remove(QLatin1Char('&'));
        end.edit->setAccessibleName(tr("%1, %2", "a field, its unit").arg(name, unit));
        end.edit->setNotch(fields.notch);
        end.unit->setText(unit);
    }
    m_offered = typed.offered;
    setLimits(m_limits);
    if (!typed.offered) {
        m_from.edit->setText(typed.from);
        m_to.edit->setText(typed.to);
    }
}

void StepFields::setLimits(const Limits &limits)
{
    m_limits = limits;
    m_offering = true;
    const double rpm = limits.greatestRpm > 0.0 ? limits.greatestRpm : kAnyRpm;
    const double amps = limits.greatestAmps > 0.0 ? limits.greatestAmps : kAnyAmps;
    const double most = ofSpeed() ? rpm : ofPosition() ? kMost_deg : amps;
    for (const Number &end : {m_from, m_to}) // the board rounds to its own steps
        end.edit->setLimits(most, fieldsOf(m_kind).digit, end.unit->text());
    m_turning.edit->setLimits(rpm, 1.0, tr("rpm"));
    if (m_turningOffered)
        m_turning.edit->setValue(limits.turningRpm);
    if (m_offered && ofSpeed())
        offerSpeeds();
    else if (m_offered && ofCurrent())
        offerCurrents();
    else if (m_offered)
        m_to.edit->setValue(kUsual_deg);
    m_offering = false;
}

void StepFields::offerSpeeds()
{
    const double leastRpm = m_limits.leastRpm;
    const double greatest = m_limits.greatestRpm > 0.0 ? m_limits.greatestRpm : kUsualRpm;
    const double notch = greatest > 20.0 * kNotch_rpm ? kNotch_rpm : 1.0;
    const auto round = [notch](double rpm) { return notch * std::round(rpm / notch); };
    double from = kFromShare * greatest, to = kToShare * greatest;
    if (from < leastRpm) {
        from = std::min(kFromObserved * leastRpm, (leastRpm + greatest) / 2.0);
        to = std::min(from + kObservedShare * greatest, greatest);
    }
    from = round(from);
    to = round(to);
    if (to - from < kLeastStep_rpm)
        to = std::min(from + notch * std::ceil(kLeastStep_rpm / notch), greatest);
    m_from.edit->setValue(from);
    m_to.edit->setValue(to);
}

void StepFields::offerCurrents()
{
    const double greatest = m_limits.greatestAmps > 0.0 ? m_limits.greatestAmps : kUsualAmps;
    const bool flux = m_kind == StepKind::Flux;
    m_from.edit->setValue(flux ? 0.0 : kFromTorque * greatest);
    m_to.edit->setValue((flux ? kToFlux : kToTorque) * greatest);
}

void StepFields::grey(StepKind kind, const QString &why)
{
    auto *item = qobject_cast<QStandardItemModel *>(m_which->model())->item(int(kind));
    item->setEnabled(why.isEmpty());
    item->setToolTip(plainToolTip(why));
}

std::vector<StepFields::Number> StepFields::numbers() const
{
    if (ofPosition())
        return {m_to};
    return ofSpeed() ? std::vector{m_from, m_to} : std::vector{m_from, m_to, m_turning};
}

std::optional<lab::Plan> StepFields::plan(const drive::UserLimits &caps) const
{
    if (!problem().isEmpty())
        return std::nullopt;
    const auto whole = [](const Number &rpm) {
        return static_cast<int>(std::lround(rpm.edit->value().value_or(0.0)));
    };
    const std::chrono::milliseconds hold(m_hold->value()), approach(m_approach->value());
    if (ofPosition())
        return lab::PositionPlan{.byDegrees = *m_to.edit->value(),
            .ramp = approach,
            .repeat = m_repeat->value(),
            .hold = hold,
            .caps = caps};
    if (!ofSpeed())
        return lab::CurrentStepPlan{.flux = m_kind == StepKind::Flux ? 1 : 0,
            .fromAmps = *m_from.edit->value(),
            .toAmps = *m_to.edit->value(),
            .repeat = m_repeat->value(),
            .hold = hold,
            .rpm = whole(m_turning),
            .caps = caps};
    return lab::StepPlan{.fromRpm = whole(m_from),
        .toRpm = whole(m_to),
        .repeat = m_repeat->value(),
        .hold = hold,
        .approach = approach,
        .caps = caps};
}

QString StepFields::problem() const
{
    for (const Number &number : numbers())
        if (!number.edit->value())
            return number.edit->echo();
    return {};
}

void StepFields::focusFirst()
{
    NumberEdit *first = numbers().front().edit;
    first->setFocus(Qt::ShortcutFocusReason);
    first->selectAll();
}

} // namespace widgets

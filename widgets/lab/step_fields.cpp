#include "widgets/lab/step_fields.h"

#include "widgets/base/fields/number_edit.h"
#include "widgets/base/fields/whole_spin.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/wheel_guard.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

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

} // namespace

StepFields::StepFields(QWidget *parent)
    : QWidget(parent)
    , m_grid(bare(new QGridLayout(this), kGrid, kFineGrid))
{
    setObjectName(QStringLiteral("stepFields"));
    m_from = addSpeed(0, tr("Fr&om"), "stepFrom");
    m_to = addSpeed(2, tr("to", "a speed"), "stepTo");
    m_hold = addSpin(1, 0, tr("Hold"), "stepHold");
    m_hold->setToolTip(tr("How long each speed is held: longer than the loop takes to settle"));
    m_approach = addSpin(1, 2, tr("ramp"), "stepApproach");
    m_approach->setToolTip(tr("Of the ramp to the first speed, and of the way back"));
    m_repeat = addSpin(2, 0, tr("Repeat"), "stepRepeat");
    m_repeat->setToolTip(tr("So many steps up, and as many down"));
    m_hold->setRange(kLeastHold_ms, kMost_ms);
    m_approach->setRange(1, kMost_ms);
    for (QSpinBox *time : {m_hold, m_approach}) {
        time->setSuffix(QStringLiteral("\u202fms"));
        time->setSingleStep(kNotch_ms);
        time->setValue(kUsual_ms);
    }
    m_repeat->setRange(1, kMostRepeats);
    m_repeat->setSuffix(QStringLiteral("\u202f\u00d7"));
    setLimits(0.0, 0.0);
}

NumberEdit *StepFields::addSpeed(int column, const QString &text, const char *name)
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
    m_grid->addWidget(label, 0, column);
    m_grid->addLayout(both, 0, column + 1);
    connect(edit, &NumberEdit::echoChanged, this, [this] {
        m_offered = m_offered && m_offering;
        Q_EMIT changed();
    });
    return edit;
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

void StepFields::setLimits(double greatestRpm, double leastRpm)
{
    m_offering = true;
    const double limit = greatestRpm > 0.0 ? greatestRpm : kAnyRpm;
    for (NumberEdit *edit : {m_from, m_to})
        edit->setLimits(limit, 1.0, tr("rpm")); // the board rounds to its own steps
    if (m_offered) {
        const double greatest = greatestRpm > 0.0 ? greatestRpm : kUsualRpm;
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
        m_from->setValue(from);
        m_to->setValue(to);
    }
    m_offering = false;
}

std::optional<lab::StepPlan> StepFields::plan() const
{
    const auto from = m_from->value(), to = m_to->value();
    if (!from || !to)
        return std::nullopt;
    lab::StepPlan plan;
    plan.fromRpm = static_cast<int>(std::lround(*from));
    plan.toRpm = static_cast<int>(std::lround(*to));
    plan.hold = std::chrono::milliseconds(m_hold->value());
    plan.approach = std::chrono::milliseconds(m_approach->value());
    plan.repeat = m_repeat->value();
    return plan;
}

QString StepFields::problem() const
{
    for (const NumberEdit *edit : {m_from, m_to})
        if (!edit->value())
            return edit->echo();
    return {};
}

void StepFields::focusFirst()
{
    m_from->setFocus(Qt::ShortcutFocusReason);
    m_from->selectAll();
}

} // namespace widgets

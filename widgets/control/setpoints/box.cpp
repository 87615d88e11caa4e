#include "widgets/control/setpoints/box.h"

#include "drive/set_point_check.h"
#include "widgets/base/device_text.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/control/command_box.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/setpoints/shaft_move.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QStandardItemModel>

namespace widgets {
namespace {

constexpr double kAmpStep = 0.01;
constexpr double kRampTimeMs = 500.0, kRampTimeNotchMs = 100.0;

QLabel *plainLabel(QWidget *parent, const char *objectName)
{
    auto *label = named(new QLabel(parent), objectName);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

SetpointBox::SetpointBox(
    Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_registers(registers)
    , m_motion(motion)
    , m_mode(named(new QComboBox(this), "setpointMode", tr("Kind of set-point")))
    , m_control(named(new SteadyLabel(this), "controlMode"))
    , m_firstLabel(plainLabel(this, "firstLabel"))
    , m_secondLabel(plainLabel(this, "secondLabel"))
    , m_shaftLabel(plainLabel(this, "shaftLabel"))
    , m_timeLabel(plainLabel(this, "timeLabel"))
    , m_speed(makeEdit("speed", tr("Speed set-point in rpm")))
    , m_torque(makeEdit("torque", tr("Torque set-point in ampere")))
    , m_iq(makeEdit("iqReference", tr("Reference of the current Iq in ampere")))
    , m_id(makeEdit("idReference", tr("Reference of the current Id in ampere")))
    , m_position(makeEdit("position", tr("Angle of the shaft to go to, in degrees")))
    , m_shaft(named(new SteadyLabel(this), "shaftNow"))
    , m_echo(named(new SteadyLabel(this), "speedEcho"))
    , m_rampTime(makeEdit("rampTime", tr("Ramp time in milliseconds")))
    , m_go(named(new MotorButton(tr("Go", "send the set-point"), this), "go"))
    , m_stopRamp(named(new MotorButton(tr("Stop ramp"), this), "stopRamp"))
    , m_cyclic(named(
          new QCheckBox(tr("Send with every exchange", "set-points"), this), "cyclicSetPoints"))
{
    m_mode->addItems({tr("Speed", "kind of set-point"), tr("Torque (Iq)", "kind of set-point"),
        tr("Currents (Iq, Id)", "kind of set-point"), tr("Position", "kind of set-point")});
    new WheelGuard(m_mode);
    m_echo->setEnabled(false);
    m_echo->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // whatever was typed
    m_control->setEnabled(false);
    m_control->setRoomFor({controlText(catalog::kSpeedModeNumber),
        controlText(catalog::kTorqueModeNumber), controlText(catalog::kPositionModeNumber)});
    m_rampTime->setRange(
        0.0, static_cast<double>(drive::kLongestRamp.count()), 1.0, QStringLiteral("ms"));
    m_rampTime->setNotch(kRampTimeNotchMs);
    m_rampTime->setValue(kRampTimeMs);
    m_timeLabel->setText(tr("Ramp time [ms]"));
    m_timeLabel->setBuddy(m_rampTime);
    makeAngleField(*m_position);
    m_shaftLabel->setText(tr("Shaft is at"));
    m_shaft->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_shaft->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_secondLabel->setText(tr("Id [A]"));
    m_secondLabel->setBuddy(m_id);
    makeLayout();

    connect(m_cyclic, &QCheckBox::clicked, this, &SetpointBox::wantCyclic);
    connect(&device, &Device::cyclicSetPointsChanged, this, &SetpointBox::followCyclic);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &SetpointBox::showMode);
    connect(m_go, &QPushButton::clicked, this, &SetpointBox::go);
    connect(m_stopRamp, &QPushButton::clicked, this, &SetpointBox::stopRamp);
    connect(&device, &Device::boundsChanged, this, &SetpointBox::updateLimits);
    connect(&device, &Device::motorChanged, this, &SetpointBox::updateLimits);
    connect(&device, &Device::identityChanged, this, &SetpointBox::updateLimits);
    updateLimits();
    showMode();
}

NumberEdit *SetpointBox::makeEdit(const char *name, const QString &accessible)
{
    auto *edit = named(new NumberEdit(this), name, accessible);
    connect(edit, &NumberEdit::echoChanged, this, &SetpointBox::follow);
    connect(edit, &NumberEdit::committed, this, &SetpointBox::go);
    return edit;
}

void SetpointBox::makeLayout()
{
    // With the words of a stop all fits on 720 lines.
    auto *grid = bare(new QGridLayout(this), kGrid, kFineGrid);
    grid->addWidget(m_mode, 0, 0);
    grid->addWidget(m_control, 0, 1, Qt::AlignRight);
    grid->addWidget(m_firstLabel, 1, 0);
    for (NumberEdit *edit : {m_speed, m_torque, m_iq, m_position})
        grid->addWidget(edit, 1, 1);
    grid->addWidget(m_secondLabel, 2, 0);
    grid->addWidget(m_id, 2, 1);
    grid->addWidget(m_shaftLabel, 2, 0);
    grid->addWidget(m_shaft, 2, 1);
    grid->addWidget(m_echo, 3, 0, 1, 2);
    grid->addWidget(m_timeLabel, 4, 0);
    grid->addWidget(m_rampTime, 4, 1);
    grid->addWidget(m_go, 5, 0);
    grid->addWidget(m_stopRamp, 5, 1);
    grid->addWidget(m_cyclic, 6, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
}

SetpointBox::Mode SetpointBox::mode() const { return static_cast<Mode>(m_mode->currentIndex()); }

void SetpointBox::setMode(Mode mode) { m_mode->setCurrentIndex(static_cast<int>(mode)); }

void SetpointBox::showMode()
{
    const Mode shown = mode();
    m_speed->setVisible(shown == Mode::Speed);
    m_torque->setVisible(shown == Mode::Torque);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_iq, m_id, m_secondLabel})
        widget->setVisible(shown == Mode::Currents);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_timeLabel, m_rampTime, m_stopRamp})
        widget->setVisible(shown != Mode::Currents);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_position, m_shaftLabel, m_shaft})
        widget->setVisible(shown == Mode::Position);
    m_firstLabel->setText(shown == Mode::Speed ? tr("Speed [rpm]")
            : shown == Mode::Position          ? tr("Position [\u00b0]")
                                               : tr("Iq [A]"));
    m_firstLabel->setBuddy(shownEdits().first());
    // Each of the currents may have something to say, and a move tells of its way.
    m_echo->setLines(shown == Mode::Currents || shown == Mode::Position ? 2 : 1);
    follow();
}

QList<NumberEdit *> SetpointBox::shownEdits() const
{
    switch (mode()) {
    case Mode::Torque:
        return {m_torque, m_rampTime};
    case Mode::Currents:
        return {m_iq, m_id};
    case Mode::Position:
        return {m_position, m_rampTime};
    case Mode::Speed:
        break;
    }
    return {m_speed, m_rampTime};
}

drive::Feature SetpointBox::featureOf(Mode mode)
{
    return mode == Mode::Torque  ? drive::Feature::TorqueRamp
        : mode == Mode::Currents ? drive::Feature::CurrentReference
        : mode == Mode::Position ? drive::Feature::PositionRamp
                                 : drive::Feature::SpeedRamp;
}

/// What the board cannot do is grey in the list, with the reason; before a board is met nothing is.
void SetpointBox::greyModes()
{
    auto *items = qobject_cast<QStandardItemModel *>(m_mode->model());
    for (int i = 0; i < m_mode->count(); ++i) {
        drive::Capability can{featureOf(static_cast<Mode>(i)), true, {}};
        if (m_device.identified())
            can = m_device.capability(can.feature);
        items->item(i)->setEnabled(can.available);
        items->item(i)->setToolTip(plainToolTip(deviceText(can.reason)));
    }
}

std::optional<ShaftMove> SetpointBox::move() const
{
    const auto to = m_position->sentValue(), time = m_rampTime->sentValue();
    return to && time ? std::optional(ShaftMove(m_device, m_registers, *to, *time)) : std::nullopt;
}

void SetpointBox::updateLimits()
{
    // What the board does not tell is refused below, with the reason: the field need not know it.
    const drive::MotionBounds bounds = m_device.bounds(m_device.motor());
    const drive::MotorLimits told = m_device.limits(m_device.motor());
    m_speed->setLimits(std::min(bounds.rpm > 0.0 ? bounds.rpm : drive::kHighestRpm, told.wireRpm),
        told.speedStepRpm, tr("rpm"));
    for (NumberEdit *edit : {m_torque, m_iq, m_id})
        edit->setLimits(
            bounds.amps > 0.0 ? bounds.amps : drive::kHighestAmps, kAmpStep, QStringLiteral("A"));
    greyModes();
    follow();
}

/// Of another field than the first, which is the one above, with its name.
QString SetpointBox::saidOf(const NumberEdit *edit) const
{
    if (edit == shownEdits().first())
        return edit->echo();
    const QLabel *label = edit == m_rampTime ? m_timeLabel : m_secondLabel;
    const QString name = label->text().section(QStringLiteral(" ["), 0, 0);
    return tr("%1: %2", "name of a field, what is wrong with its text").arg(name, edit->echo());
}

QString SetpointBox::echo() const
{
    // What is wrong, else whatever does not become what was typed.
    QStringList rounded;
    for (const NumberEdit *edit : shownEdits()) {
        if (!edit->sentValue())
            return saidOf(edit);
        if (edit->sentValue() != edit->value())
            rounded.append(saidOf(edit));
    }
    if (mode() == Mode::Position) {
        const QString refused = move()->refusal();
        QStringList said{shownEdits().first()->echo(), move()->outlook()};
        said.removeAll(QString());
        return refused.isEmpty() ? said.join(QLatin1Char('\n')) : refused;
    }
    return rounded.isEmpty() ? shownEdits().first()->echo() : rounded.join(QLatin1Char('\n'));
}

bool SetpointBox::readable() const
{
    const auto edits = shownEdits();
    return std::all_of(edits.begin(), edits.end(), [](const NumberEdit *edit) {
        return edit->sentValue().has_value();
    }) && (mode() != Mode::Position || move()->refusal().isEmpty());
}

/// What the board controls now, if it says so.
QString SetpointBox::controlText() const
{
    const auto catalog = m_device.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find("CONTROL_MODE") : nullptr;
    if (info == nullptr)
        return {};
    const auto value = m_registers.shownValue(catalog->withMotor(*info, m_device.motor()));
    if (!value)
        return {};
    return controlText(static_cast<std::int64_t>(*value));
}

QString SetpointBox::controlText(std::int64_t mode)
{
    switch (mode) {
    case catalog::kSpeedModeNumber:
        return tr("drive mode: speed", "the board does now");
    case catalog::kTorqueModeNumber:
        return tr("drive mode: torque", "the board does now");
    case catalog::kPositionModeNumber:
        return tr("drive mode: position", "the board does now");
    default:
        return {};
    }
}

void SetpointBox::follow()
{
    MotionAllowed can = motionAllowed(m_device, feature());
    for (NumberEdit *edit : {m_speed, m_torque, m_iq, m_id, m_position, m_rampTime})
        edit->setWheelAllowed(can.yes);
    // What is wrong is no hint: it has a mark, and is not grey.
    const bool wrong = !readable();
    m_echo->setText(wrong ? QStringLiteral("\u2716 ") + echo() : echo());
    m_echo->setEnabled(wrong);
    m_control->setText(controlText());
    const auto shaft = ShaftMove::degreesNow(m_device, m_registers);
    m_shaft->setText(shaft ? ShaftMove::angleText(*shaft) : QStringLiteral("\u2013"));
    MotionAllowed ends = motionAllowed(m_device, drive::Feature::SpeedRamp);
    if (mode() == Mode::Position)
        ends = {false, tr("A move to an angle has no end on its way: Stop ends it.")};
    applyAllowed(m_stopRamp, ends, tr("Ends a ramp where it is; the motor goes on turning."));
    followCyclic();
    if (can.yes && wrong)
        can = {false, echo()};
    applyAllowed(m_go, can,
        mode() == Mode::Currents
            ? tr("Sets both currents at once (Enter in a field does the same).")
            : mode() == Mode::Position
            ? tr("Turns the shaft to that angle (Enter in the field does the same).")
            : tr("Sends the set-point as a ramp (Enter in the field does the same)."));
}

/// Off is always possible; it changes nothing at the motor.
void SetpointBox::followCyclic()
{
    const bool on = m_device.cyclicSetPoints();
    m_cyclic->setChecked(on);
    MotionAllowed can = motionAllowed(m_device, drive::Feature::CyclicSetPoints);
    if (on && m_device.answering())
        can = {true, {}};
    else if (can.yes && m_device.status(m_device.motor()).state != drive::MotorState::Idle)
        can = {false, tr("The motor has to be idle.")};
    applyAllowed(m_cyclic, can,
        tr("Speeds and currents travel in every frame that is exchanged with the drive, instead of "
           "as a write of their own. Stop and a fault set them to zero; a reset or a lost link "
           "ends it. Positions are always written."));
}

void SetpointBox::wantCyclic(bool on)
{
    followCyclic(); // what the drive does, not what is wanted of it
    if (m_cyclic->isEnabled())
        m_motion.want(tr("Set-points with every exchange"), drive::CyclicSetPoints{on});
}

void SetpointBox::go()
{
    if (!readable() || !motionAllowed(m_device, feature()).yes)
        return;
    const int motor = m_device.motor();
    const std::chrono::milliseconds time(
        static_cast<std::int64_t>(m_rampTime->sentValue().value_or(0.0))); // currents have none
    switch (mode()) {
    case Mode::Speed:
        m_motion.want(tr("Speed ramp"),
            drive::SpeedRamp{motor, static_cast<std::int32_t>(*m_speed->sentValue()), time});
        break;
    case Mode::Torque:
        m_motion.want(tr("Torque ramp"), drive::TorqueRamp{motor, *m_torque->sentValue(), time});
        break;
    case Mode::Currents:
        m_motion.want(tr("Current reference"),
            drive::CurrentReference{motor, *m_iq->sentValue(), *m_id->sentValue()});
        break;
    case Mode::Position:
        m_motion.want(tr("Move to an angle"), move()->wish());
        break;
    }
}

void SetpointBox::stopRamp()
{
    if (mode() != Mode::Position && motionAllowed(m_device, drive::Feature::SpeedRamp).yes)
        m_motion.want(
            tr("Stop ramp"), drive::Command{drive::MotorAction::StopRamp, m_device.motor()});
}

void SetpointBox::forget()
{
    m_expectsReference = false;
    for (NumberEdit *edit : {m_speed, m_torque, m_iq, m_id})
        edit->beginAnew();
    m_position->setText({}); // zero would be a place to go to, and Undo takes clear() back
}

void SetpointBox::expectReference()
{
    m_expectsReference = true;
    m_offered = m_speed->text();
}

void SetpointBox::offerReference(std::optional<double> rpm)
{
    m_expectsReference =
        m_expectsReference && !m_speed->isModified() && m_speed->text() == m_offered;
    if (!m_expectsReference || !rpm)
        return;
    m_speed->setValue(*rpm);
    m_offered = m_speed->text();
}

} // namespace widgets

#include "widgets/control_panel.h"

#include "widgets/device_text.h"
#include "widgets/lamp.h"
#include "widgets/messages.h"
#include "widgets/motion_gate.h"
#include "widgets/motor_button.h"
#include "widgets/setpoint_edit.h"
#include "widgets/stop_words.h"
#include "widgets/wheel_guard.h"

#include <QCheckBox>
#include <QEvent>
#include <QFormLayout>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr double kRpmStep = 6.0; // one digit of speed is 0.1 Hz
constexpr double kFallbackLimitRpm = 32766.0; // speeds beyond 16 bits are cut by the board
constexpr int kLongestRampMs = 65535;

QLabel *plainLabel(QWidget *parent, const char *objectName)
{
    auto *label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setObjectName(QLatin1String(objectName));
    return label;
}

QFrame *line(QWidget *parent)
{
    auto *frame = new QFrame(parent);
    frame->setFrameShape(QFrame::HLine);
    frame->setFrameShadow(QFrame::Sunken);
    return frame;
}

QString joined(const std::vector<std::string> &names)
{
    QStringList texts;
    for (const std::string &name : names)
        texts.append(deviceText(name));
    return texts.join(QStringLiteral(", "));
}

} // namespace

ControlPanel::ControlPanel(
    Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_registers(registers)
    , m_motion(motion)
{
    setObjectName(QStringLiteral("controlPanel"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setSpacing(8);
    layout->addWidget(makeState());
    layout->addWidget(line(this));
    layout->addWidget(makeCommands());
    layout->addWidget(line(this));
    layout->addWidget(makeSpeed());
    layout->addWidget(line(this));
    layout->addWidget(makeReadouts());
    layout->addStretch(1);
    layout->addWidget(m_words = new StopWords(this));
    m_words->hide();

    connect(&device, &Device::linkStateChanged, this, &ControlPanel::updateState);
    connect(&device, &Device::statusChanged, this, &ControlPanel::updateState);
    connect(&device, &Device::motorChanged, this, [this] {
        resolveReadouts();
        updateLimits();
        updateState();
    });
    connect(&device, &Device::identityChanged, this, [this] {
        m_takeReference = true;
        resolveReadouts();
        updateLimits();
        updateState();
    });
    connect(&device, &Device::boundsChanged, this, &ControlPanel::updateLimits);
    connect(&device, &Device::armedStateChanged, this, &ControlPanel::updateButtons);
    connect(&device, &Device::stopAdvanced, this, &ControlPanel::stopAdvanced);
    connect(&registers, &QAbstractItemModel::dataChanged, this, &ControlPanel::updateReadouts);
    connect(&registers, &QAbstractItemModel::modelReset, this, &ControlPanel::resolveReadouts);
    updateLimits();
    updateReadouts();
    updateState();
}

QWidget *ControlPanel::makeState()
{
    auto *box = new QWidget(this);
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    m_state = plainLabel(box, "motorState");
    QFont large = m_state->font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    large.setBold(true);
    m_state->setFont(large);
    m_faultsNow = plainLabel(box, "faultsNow");
    m_faultsNow->setWordWrap(true);
    m_faultsPast = plainLabel(box, "faultsPast");
    m_faultsPast->setWordWrap(true);
    layout->addWidget(m_state);
    layout->addWidget(m_faultsNow);
    layout->addWidget(m_faultsPast);
    return box;
}

QWidget *ControlPanel::makeCommands()
{
    auto *box = new QWidget(this);
    m_arm = new QCheckBox(tr("Arm: allow commands"), box);
    m_arm->setObjectName(QStringLiteral("arm"));
    // A click leaves the focus where it is: the Space that follows is meant for the picture.
    m_arm->setFocusPolicy(Qt::TabFocus);
    m_start = new MotorButton(tr("Start"), box);
    m_start->setObjectName(QStringLiteral("start"));
    m_start->setAccessibleName(tr("Start motor"));
    m_start->setMinimumHeight(48);
    m_stop = new StopButton(box);
    m_stop->setObjectName(QStringLiteral("stop"));
    m_stop->setText(tr("Stop (Esc)"));
    m_acknowledge = new MotorButton(tr("Acknowledge faults"), box);
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));

    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    grid->addWidget(m_arm, 0, 0, 1, 2);
    grid->addWidget(m_start, 1, 0);
    grid->addWidget(m_stop, 1, 1);
    grid->addWidget(m_acknowledge, 2, 0, 1, 2);
    grid->setColumnStretch(0, 1);

    connect(m_arm, &QCheckBox::clicked, this, [this](bool wanted) {
        m_device.setArmed(wanted);
        updateButtons(); // the box shows what the session has confirmed, not what was clicked
    });
    connect(m_start, &QPushButton::clicked, this, &ControlPanel::start);
    connect(m_stop, &StopButton::stopPressed, &m_device, &Device::stop);
    connect(m_acknowledge, &QPushButton::clicked, this, &ControlPanel::acknowledge);
    return box;
}

QWidget *ControlPanel::makeSpeed()
{
    auto *box = new QWidget(this);
    m_speed = new SetpointEdit(box);
    m_speed->setObjectName(QStringLiteral("speed"));
    m_speed->setAccessibleName(tr("Speed set-point in rpm"));
    m_echo = plainLabel(box, "speedEcho");
    m_echo->setWordWrap(true);
    m_echo->setEnabled(false);
    m_rampTime = new QSpinBox(box);
    m_rampTime->setObjectName(QStringLiteral("rampTime"));
    m_rampTime->setAccessibleName(tr("Ramp time in milliseconds"));
    m_rampTime->setRange(0, kLongestRampMs);
    m_rampTime->setSingleStep(100);
    m_rampTime->setValue(500);
    m_rampTime->setKeyboardTracking(false);
    m_rampTime->setAlignment(Qt::AlignRight);
    m_rampTime->setSuffix(QStringLiteral(" ms"));
    new WheelGuard(m_rampTime);
    m_go = new MotorButton(tr("Go", "send the speed ramp"), box);
    m_go->setObjectName(QStringLiteral("go"));
    m_stopRamp = new MotorButton(tr("Stop ramp"), box);
    m_stopRamp->setObjectName(QStringLiteral("stopRamp"));

    auto *speedLabel = new QLabel(tr("Speed [rpm]"), box);
    speedLabel->setBuddy(m_speed);
    auto *timeLabel = new QLabel(tr("Ramp time"), box);
    timeLabel->setBuddy(m_rampTime);
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(6);
    grid->addWidget(speedLabel, 0, 0);
    grid->addWidget(m_speed, 0, 1);
    grid->addWidget(m_echo, 1, 0, 1, 2);
    grid->addWidget(timeLabel, 2, 0);
    grid->addWidget(m_rampTime, 2, 1);
    grid->addWidget(m_go, 3, 0);
    grid->addWidget(m_stopRamp, 3, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    connect(m_speed, &SetpointEdit::echoChanged, this, &ControlPanel::updateButtons);
    connect(m_speed, &SetpointEdit::committed, this, &ControlPanel::go);
    connect(m_go, &QPushButton::clicked, this, &ControlPanel::go);
    connect(m_stopRamp, &QPushButton::clicked, this, &ControlPanel::stopRamp);
    return box;
}

QWidget *ControlPanel::makeReadouts()
{
    auto *box = new QWidget(this);
    auto *grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    const std::pair<const char *, QString> rows[] = {
        {"SPEED_MEAS", tr("Measured speed")},
        {"SPEED_REF", tr("Speed reference")},
        {"I_Q_MEAS", tr("Current Iq")},
        {"BUS_VOLTAGE", tr("Bus voltage")},
        {"HEATS_TEMP", tr("Power stage")},
    };
    for (const auto &[name, text] : rows) {
        auto *label = new QLabel(text, box);
        auto *value = plainLabel(box, name);
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        const int row = static_cast<int>(m_readouts.size());
        grid->addWidget(label, row, 0);
        grid->addWidget(value, row, 1);
        m_readouts.push_back({name, label, value, {}});
    }
    grid->setColumnStretch(1, 1);
    return box;
}

std::vector<catalog::RegisterId> ControlPanel::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    for (const Readout &readout : m_readouts)
        if (readout.id)
            ids.push_back(*readout.id);
    return ids;
}

void ControlPanel::resolveReadouts()
{
    const auto catalog = m_device.catalog();
    for (Readout &readout : m_readouts) {
        readout.id.reset();
        const catalog::RegisterInfo *info = catalog ? catalog->find(readout.name) : nullptr;
        if (info && info->readable() && !info->stub)
            readout.id = info->perMotor ? catalog->withMotor(*info, m_device.motor()) : info->id;
        const bool there = readout.id.has_value() || !catalog;
        readout.label->setVisible(there);
        readout.value->setVisible(there);
    }
    updateReadouts();
    Q_EMIT watchedRegistersChanged();
}

void ControlPanel::updateReadouts()
{
    for (const Readout &readout : m_readouts)
        readout.value->setText(
            readout.id ? m_registers.text(*readout.id) : QStringLiteral("\u2013"));
    takeReference();
}

void ControlPanel::takeReference()
{
    // Once, and not over what a person has typed: the field begins with what the board would do anyway.
    if (!m_takeReference || m_speed->isModified())
        return;
    for (const Readout &readout : m_readouts) {
        const bool isReference = readout.name == std::string_view("SPEED_REF");
        const auto value =
            isReference && readout.id ? m_registers.shownValue(*readout.id) : std::nullopt;
        if (!value)
            continue;
        m_speed->setValue(*value);
        m_takeReference = false;
    }
}

void ControlPanel::refresh(Milliseconds now)
{
    m_now = now;
    m_words->refresh(now);
}

void ControlPanel::stopAdvanced(const drive::StopProgress &progress)
{
    m_words->show();
    m_words->take(progress, m_now);
    if (progress.word == drive::StopWord::Requested) {
        m_takeReference = false;
        m_speed->setValue(0.0); // nothing of the old set-point is left to be sent again by accident
    }
}

void ControlPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_words)
        updateState(); // the colours of states follow the theme
}

void ControlPanel::updateLimits()
{
    // What the board does not tell is refused below, with the reason: the field need not know it.
    const double bound = m_device.bounds(m_device.motor()).rpm;
    const double limit = bound > 0.0 ? std::min(bound, kFallbackLimitRpm) : kFallbackLimitRpm;
    m_speed->setLimits(limit, kRpmStep, tr("rpm"));
}

void ControlPanel::updateState()
{
    const drive::MotorStatus status = m_device.status(m_device.motor());
    const bool believed = m_device.answering();
    QString text = believed ? motorStateText(status.state) : linkStateText(m_device.link().state);
    // The firmware's own word where several of its states are one of ours.
    const bool several =
        status.state == drive::MotorState::Starting || status.state == drive::MotorState::Unknown;
    const QString name = deviceText(status.stateName);
    if (believed && several && !name.isEmpty())
        text += QStringLiteral(" (%1)").arg(name);
    m_state->setText(text);
    m_state->setEnabled(believed);
    QPalette colors = palette();
    // The link's words must not wear the colour of a state that is no longer known.
    const auto light = !believed
        ? (m_device.link().state == drive::LinkState::Lost ? Lamp::Light::Bad : Lamp::Light::Off)
        : status.state == drive::MotorState::Running  ? Lamp::Light::On
        : status.state == drive::MotorState::FaultNow ? Lamp::Light::Bad
        : status.state == drive::MotorState::FaultOver
            || status.state == drive::MotorState::Starting
            || status.state == drive::MotorState::Stopping
        ? Lamp::Light::Waiting
        : Lamp::Light::Off;
    if (light != Lamp::Light::Off)
        colors.setColor(QPalette::WindowText, Lamp::colorOf(light, palette()));
    m_state->setPalette(colors);

    QPalette red = palette();
    red.setColor(QPalette::WindowText, Lamp::colorOf(Lamp::Light::Bad, palette()));
    m_faultsNow->setPalette(status.faultsNow.empty() ? palette() : red);
    m_faultsNow->setText(!believed ? tr("Faults are not known")
            : status.faultsNow.empty()
            ? tr("No fault present")
            : QStringLiteral("\u2716 ") + tr("Present: %1").arg(joined(status.faultsNow)));
    m_faultsNow->setEnabled(believed);
    m_faultsPast->setVisible(believed && !status.faultsPast.empty());
    m_faultsPast->setText(tr("To acknowledge: %1").arg(joined(status.faultsPast)));
    updateButtons();
}

ControlPanel::Allowed ControlPanel::allowed(drive::Feature feature) const
{
    return motionAllowed(m_device, feature);
}

ControlPanel::Allowed ControlPanel::startAllowed() const
{
    const Allowed base = allowed(drive::Feature::Start);
    if (!base.yes)
        return base;
    const auto state = m_device.status(m_device.motor()).state;
    if (state == drive::MotorState::FaultNow || state == drive::MotorState::FaultOver)
        return {false, tr("Acknowledge the faults first.")};
    if (state != drive::MotorState::Idle)
        return {false, tr("The motor has to be idle.")};
    return base;
}

ControlPanel::Allowed ControlPanel::acknowledgeAllowed() const
{
    const Allowed base = allowed(drive::Feature::AcknowledgeFaults);
    if (!base.yes)
        return base;
    const drive::MotorStatus status = m_device.status(m_device.motor());
    if (!status.faultsNow.empty() || status.state == drive::MotorState::FaultNow)
        return {false, tr("The fault is still present: remove its cause first.")};
    if (status.faultsPast.empty() && status.state != drive::MotorState::FaultOver)
        return {false, tr("There is no fault to acknowledge.")};
    return base;
}

QString ControlPanel::startHint() const
{
    const Allowed can = startAllowed();
    return can.yes ? tr("Starts the motor (Ctrl+Enter).") : can.why;
}

QString ControlPanel::acknowledgeHint() const
{
    const Allowed can = acknowledgeAllowed();
    return can.yes ? tr("Acknowledges the faults that are over (Ctrl+Backspace).") : can.why;
}

void ControlPanel::updateButtons()
{
    const auto apply = [](QWidget *widget, const Allowed &can, const QString &help) {
        if (!can.yes && widget->hasFocus())
            widget->clearFocus(); // or it would move on by itself, to the next button
        widget->setEnabled(can.yes);
        widget->setToolTip(plainToolTip(can.yes ? help : can.why));
    };
    m_arm->setChecked(m_device.armed());
    m_arm->setEnabled(m_device.answering());
    m_arm->setToolTip(m_device.answering()
            ? tr("Until it is armed, nothing that writes or moves leaves Rotorscope. A stop, a "
                 "lost link and a new connection disarm.")
            : tr("Connect to a board first."));
    apply(m_start, startAllowed(), startHint());
    apply(m_acknowledge, acknowledgeAllowed(), acknowledgeHint());
    Allowed ramp = allowed(drive::Feature::SpeedRamp);
    m_speed->setWheelAllowed(ramp.yes);
    m_echo->setText(m_speed->echo());
    apply(m_stopRamp, ramp, tr("Ends a ramp where it is; the motor goes on turning."));
    if (ramp.yes && !m_speed->sentValue())
        ramp = {false, m_speed->echo()};
    apply(m_go, ramp, tr("Sends the set-point as a ramp (Enter in the field does the same)."));
}

void ControlPanel::start()
{
    if (startAllowed().yes)
        m_motion.want(tr("Start"), drive::Command{drive::MotorAction::Start, m_device.motor()});
}

void ControlPanel::acknowledge()
{
    if (acknowledgeAllowed().yes)
        m_motion.want(tr("Acknowledge"),
            drive::Command{drive::MotorAction::AcknowledgeFaults, m_device.motor()});
}

void ControlPanel::go()
{
    const auto rpm = m_speed->sentValue();
    if (!rpm || !allowed(drive::Feature::SpeedRamp).yes)
        return;
    m_rampTime->interpretText();
    m_motion.want(tr("Speed ramp"),
        drive::SpeedRamp{m_device.motor(), static_cast<std::int32_t>(*rpm),
            std::chrono::milliseconds(m_rampTime->value())});
}

void ControlPanel::stopRamp()
{
    if (allowed(drive::Feature::SpeedRamp).yes)
        m_motion.want(
            tr("Stop ramp"), drive::Command{drive::MotorAction::StopRamp, m_device.motor()});
}

void ControlPanel::toggleArmed() { m_device.setArmed(!m_device.armed()); }

} // namespace widgets

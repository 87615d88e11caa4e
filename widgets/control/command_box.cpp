#include "widgets/control/command_box.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motor_button.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QToolTip>

namespace widgets {

void applyAllowed(QWidget *widget, const MotionAllowed &can, const QString &help)
{
    if (!can.yes && widget->hasFocus())
        widget->clearFocus(); // or it would move on by itself, to the next button
    widget->setEnabled(can.yes);
    const QString tip = plainToolTip(can.yes ? help : can.why);
    if (tip != widget->toolTip() && widget->underMouse())
        QToolTip::hideText(); // which told of before
    widget->setToolTip(tip);
}

CommandBox::CommandBox(Device &device, MotionGate &motion, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_motion(motion)
    , m_arm(named(new QCheckBox(tr("Arm: allow commands"), this), "arm"))
    , m_start(named(new MotorButton(tr("Start"), this), "start", tr("Start motor")))
    , m_acknowledge(named(new MotorButton(tr("Acknowledge faults"), this), "acknowledge"))
{
    // A click leaves the focus where it is: the Space that follows is meant for the picture.
    m_arm->setFocusPolicy(Qt::TabFocus);
    m_start->setMinimumHeight(48);
    m_start->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // wherever it goes to
    auto *stop = named(new StopButton(this), "stop");
    stop->setText(tr("Stop (Esc)"));
    setLineIcon(*m_start, "start");
    setLineIcon(*m_acknowledge, "acknowledge");

    auto *grid = bare(new QGridLayout(this), kGrid, kFineGrid);
    grid->addWidget(m_arm, 0, 0, 1, 2);
    grid->addWidget(m_start, 1, 0);
    grid->addWidget(stop, 1, 1);
    grid->addWidget(m_acknowledge, 2, 0, 1, 2);
    grid->setColumnStretch(0, 1);

    connect(m_arm, &QCheckBox::clicked, this, [this](bool wanted) {
        m_device.setArmed(wanted);
        follow(); // the box shows what the session has confirmed, not what was clicked
    });
    connect(m_start, &QPushButton::clicked, this, &CommandBox::start);
    connect(stop, &StopButton::stopPressed, &m_device, &Device::stop);
    connect(m_acknowledge, &QPushButton::clicked, this, &CommandBox::acknowledge);
    follow();
}

QString CommandBox::startHint() const
{
    const MotionAllowed can = startAllowed(m_device);
    return can.yes ? tr("Starts the motor (Ctrl+Enter).") : can.why;
}

QString CommandBox::acknowledgeHint() const
{
    const MotionAllowed can = acknowledgeAllowed(m_device);
    return can.yes ? tr("Acknowledges the faults that are over (Ctrl+Backspace).") : can.why;
}

void CommandBox::follow()
{
    const QString target = m_motion.startText(m_device.motor());
    const bool starts = startAllowed(m_device).yes && !target.isEmpty();
    m_start->setText(starts ? tr("Start \u2192 %1", "speed or current").arg(target) : tr("Start"));
    m_arm->setChecked(m_device.armed());
    const MotionAllowed arm = armAllowed(m_device);
    m_arm->setEnabled(arm.yes);
    m_arm->setToolTip(arm.yes
            ? tr("Until it is armed, nothing that writes or moves leaves Rotorscope. A stop, a "
                 "lost link and a new connection disarm.")
            : plainToolTip(arm.why));
    applyAllowed(m_start, startAllowed(m_device), startHint());
    applyAllowed(m_acknowledge, acknowledgeAllowed(m_device), acknowledgeHint());
}

void CommandBox::start()
{
    if (startAllowed(m_device).yes)
        m_motion.want(tr("Start"), drive::Command{drive::MotorAction::Start, m_device.motor()});
}

void CommandBox::acknowledge()
{
    if (acknowledgeAllowed(m_device).yes)
        m_motion.want(tr("Acknowledge"),
            drive::Command{drive::MotorAction::AcknowledgeFaults, m_device.motor()});
}

} // namespace widgets

// CommandBox: arming, start, stop and acknowledging of one motor. What cannot be pressed says why in its tool tip.
#pragma once

#include "widgets/control/motion_allowed.h"

#include <QWidget>

class QCheckBox;

namespace widgets {

class MotionGate;
class MotorButton;

class CommandBox : public QWidget {
    Q_OBJECT
public:
    CommandBox(Device &device, MotionGate &motion, QWidget *parent = nullptr);

    QString startHint() const; ///< what Start does, or why it cannot be pressed
    QString acknowledgeHint() const;

public Q_SLOTS:
    void start();
    void acknowledge();
    void follow(); ///< the device may allow something else now

private:
    Device &m_device;
    MotionGate &m_motion;
    QCheckBox *m_arm;
    MotorButton *m_start;
    MotorButton *m_acknowledge;
};

/// Enables a widget as far as it is allowed; the tool tip says what it does, or why it cannot.
void applyAllowed(QWidget *widget, const MotionAllowed &can, const QString &help);

} // namespace widgets

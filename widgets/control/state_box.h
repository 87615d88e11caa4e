// StateBox: the state of the motor that is shown, in words and as a lit strip, and its faults by name.
#pragma once

#include "widgets/base/device.h"

#include <QWidget>

class QToolButton;

namespace widgets {

class StateStrip;
class SteadyLabel;

class StateBox : public QWidget {
    Q_OBJECT
public:
    explicit StateBox(Device &device, QWidget *parent = nullptr);

    QString stateText() const;

Q_SIGNALS:
    void causesWanted(); ///< of the faults, to be explained

protected:
    void changeEvent(QEvent *event) override;

private:
    void follow();
    void showState(const drive::MotorStatus &status, bool believed);
    void showFaults(const drive::MotorStatus &status, bool believed);

    Device &m_device;
    SteadyLabel *m_state;
    StateStrip *m_strip;
    SteadyLabel *m_faultsNow;
    SteadyLabel *m_faultsPast;
    QToolButton *m_causes;
};

} // namespace widgets

// ControlPanel: state, faults and commands of one motor. What can be pressed follows from what the device has said;
// what cannot says why in its tool tip. Nothing here sends without a person's act.
#pragma once

#include "widgets/device.h"
#include "widgets/motion_allowed.h"
#include "widgets/register_model.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QSpinBox;
class QFormLayout;

namespace widgets {

class MotionGate;
class MotorButton;
class SetpointEdit;
class StopButton;
class StopWords;

class ControlPanel : public QWidget {
    Q_OBJECT
public:
    ControlPanel(
        Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent = nullptr);

    /// Registers whose values the panel shows: they are to be polled as long as it is there.
    std::vector<catalog::RegisterId> watchedRegisters() const;
    void refresh(Milliseconds now); ///< ages

    SetpointEdit *speed() const { return m_speed; }
    QString startHint() const; ///< what Start does, or why it cannot be pressed
    QString acknowledgeHint() const;

public Q_SLOTS:
    void start(); ///< Ctrl+Enter; only if the button could be pressed
    void acknowledge(); ///< Ctrl+Backspace
    void go();
    void stopRamp();
    void toggleArmed();

Q_SIGNALS:
    void watchedRegistersChanged();

protected:
    void changeEvent(QEvent *event) override;

private:
    using Allowed = MotionAllowed;
    Allowed allowed(drive::Feature feature) const;
    Allowed startAllowed() const;
    Allowed acknowledgeAllowed() const;

    QWidget *makeState();
    QWidget *makeCommands();
    QWidget *makeSpeed();
    QWidget *makeReadouts();
    void updateButtons();
    void updateState();
    void updateLimits();
    void updateReadouts();
    void resolveReadouts();
    void takeReference();
    void stopAdvanced(const drive::StopProgress &progress);

    Device &m_device;
    RegisterModel &m_registers;
    MotionGate &m_motion;

    QLabel *m_state = nullptr;
    QLabel *m_faultsNow = nullptr;
    QLabel *m_faultsPast = nullptr;
    QCheckBox *m_arm = nullptr;
    MotorButton *m_start = nullptr;
    StopButton *m_stop = nullptr;
    MotorButton *m_acknowledge = nullptr;
    SetpointEdit *m_speed = nullptr;
    QLabel *m_echo = nullptr;
    QSpinBox *m_rampTime = nullptr;
    MotorButton *m_go = nullptr;
    MotorButton *m_stopRamp = nullptr;
    StopWords *m_words = nullptr;
    struct Readout {
        const char *name = nullptr;
        QLabel *label = nullptr;
        QLabel *value = nullptr;
        std::optional<catalog::RegisterId> id;
    };
    std::vector<Readout> m_readouts;
    Milliseconds m_now{};
    bool m_takeReference =
        false; ///< the speed field still has to be given the board's own set-point
};

} // namespace widgets

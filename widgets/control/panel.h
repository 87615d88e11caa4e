// ControlPanel: state, faults and commands of one motor. State, faults, arming, start and stop stay in view; what is
// below them scrolls. What can be pressed follows from what the device has said; what cannot says why in its tool tip.
// Nothing here sends without the user's act, and what moves goes through the MotionGate.
#pragma once

#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QWidget>

class QToolButton;

namespace widgets {

class CommandBox;
class JogBox;
class MotionGate;
class NumberEdit;
class ReadoutBox;
class SetpointBox;
class StateBox;
class SteadyLabel;
class StopWords;

class ControlPanel : public QWidget {
    Q_OBJECT
public:
    ControlPanel(
        Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent = nullptr);

    /// Registers whose values the panel shows: they are to be polled as long as it is there.
    std::vector<catalog::RegisterId> watchedRegisters() const;
    void refresh(Milliseconds now); ///< ages

    NumberEdit *speed() const;
    QString startHint() const; ///< what Start does, or why it cannot be pressed
    QString acknowledgeHint() const;

public Q_SLOTS:
    void start(); ///< Ctrl+Enter; only if the button could be pressed
    void acknowledge(); ///< Ctrl+Backspace
    void go();
    void stopRamp();
    void toggleArmed();
    void fileShown(); ///< in the place of what a board tells

Q_SIGNALS:
    void watchedRegistersChanged();
    void currentScaleWanted(); ///< the user knows the scale of the currents
    void causesWanted(); ///< of the faults, to be explained
    void limitsWanted(); ///< the user wants to change their own limits

private:
    QWidget *makeBody();
    void follow();
    void showLimits();
    QString scaleText() const;
    void stopAdvanced(const drive::StopProgress &progress);

    Device &m_device;
    MotionGate &m_motion;
    StateBox *m_state;
    CommandBox *m_commands;
    SetpointBox *m_setpoints;
    JogBox *m_jog;
    ReadoutBox *m_readouts;
    SteadyLabel *m_limits;
    QToolButton *m_changeLimits;
    QToolButton *m_changeScale;
    StopWords *m_words;
    Milliseconds m_now{};
    /// The motor that was shown last, and its state.
    std::pair<int, drive::MotorState> m_followed{};
};

} // namespace widgets

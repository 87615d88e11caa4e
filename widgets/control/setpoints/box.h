// SetpointBox: the quick set-points of one motor: a speed, a torque current or an angle of the shaft within a time, or
// both currents at once. Which one is shown is the user's choice and sends nothing; the board changes its control with
// the first set-point.
#pragma once

#include "catalog/control_mode.h"
#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace widgets {

class MotionGate;
class MotorButton;
class NumberEdit;
class ShaftMove;
class SteadyLabel;

class SetpointBox : public QWidget {
    Q_OBJECT
public:
    enum class Mode : std::uint8_t { Speed, Torque, Currents, Position };

    SetpointBox(
        Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent = nullptr);

    NumberEdit *speed() const { return m_speed; }
    Mode mode() const;
    void setMode(Mode mode);

public Q_SLOTS:
    void go();
    void stopRamp();
    void follow(); ///< the device may allow something else now
    void forget(); ///< nothing of a set-point is left to be sent by accident
    /// The speed begins with what the board would do anyway, once and not over what the user has typed.
    void offerReference(std::optional<double> rpm);
    void expectReference(); ///< a board was met: offerReference() counts again

private:
    NumberEdit *makeEdit(const char *name, const QString &accessible);
    void makeLayout();
    void showMode();
    void followCyclic();
    void wantCyclic(bool on);
    void updateLimits();
    void greyModes();
    static drive::Feature featureOf(Mode mode);
    drive::Feature feature() const { return featureOf(mode()); }
    std::optional<ShaftMove> move() const; ///< of Position; empty while a field is not understood
    QList<NumberEdit *> shownEdits() const;
    QString echo() const;
    QString saidOf(const NumberEdit *edit) const;
    bool readable() const; ///< all shown fields hold a number that may be sent
    QString controlText() const;
    static QString controlText(std::int64_t mode);

    Device &m_device;
    RegisterModel &m_registers;
    MotionGate &m_motion;
    QComboBox *m_mode;
    SteadyLabel *m_control; ///< what the board says it controls
    QLabel *m_firstLabel;
    QLabel *m_secondLabel;
    QLabel *m_shaftLabel;
    QLabel *m_timeLabel;
    NumberEdit *m_speed;
    NumberEdit *m_torque;
    NumberEdit *m_iq;
    NumberEdit *m_id;
    NumberEdit *m_position;
    SteadyLabel *m_shaft; ///< where it is now
    SteadyLabel *m_echo;
    NumberEdit *m_rampTime;
    MotorButton *m_go;
    MotorButton *m_stopRamp;
    QCheckBox *m_cyclic;
    bool m_expectsReference = false;
    QString m_offered; ///< of the board: any other text is the user's
};

} // namespace widgets

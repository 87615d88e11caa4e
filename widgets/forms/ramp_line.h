// RampLine: the fields of one kind of ramp: what is typed, what the board will make of it, and whether it can be sent.
// It sends nothing itself.
#pragma once

#include "widgets/control/motion_allowed.h"
#include "widgets/forms/ramp_preset.h"
#include "widgets/forms/ramp_preview.h"

#include "drive/motion_caution.h"

#include <QObject>

#include <optional>

class QGridLayout;
class QLabel;

namespace widgets {

class MotorButton;
class NumberEdit;
class RegisterModel;

/// The step in which the drive counts speeds [rpm]; 0: a set-point is as fine as it is typed.
double speedStair_rpm(const Device &device);

class RampLine : public QObject {
    Q_OBJECT
public:
    /// Puts its widgets into two rows of `grid`, from `row` on.
    RampLine(RampKind kind, const Device &device, const RegisterModel &registers, QGridLayout &grid,
        int row, QWidget *parent);

    RampKind kind() const { return m_kind; }
    QString title() const; ///< for messages: "Speed ramp"
    NumberEdit *first() const { return m_first; }
    NumberEdit *second() const { return m_second; }
    MotorButton *button() const { return m_send; }

    /// What would be sent to the device's motor; empty if a field is not understood or out of its limits.
    std::optional<drive::WishContent> content() const;
    RampPicture picture() const; ///< from where it begins; empty without content()
    RampPreset preset(const QString &name) const; ///< only with content()
    void accept(const RampPreset &preset);

    void updateLimits();
    void update(); ///< note and button
    void reset(); ///< to zero: nothing of the old set-points is left to be sent by accident

Q_SIGNALS:
    void wanted(); ///< the button, or Enter in a field
    void touched(); ///< has the focus: this is what the user looks at
    void changed(); ///< something else stands in a field

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    drive::Feature feature() const;
    QString note() const;
    QString speedNote() const;
    QString torqueNote() const;
    QString currentNote() const;
    QString positionNote() const;
    std::optional<double> reference() const; ///< where a ramp begins: the board's own set-point
    double ampsPerDigit() const; ///< 0: not known

    RampKind m_kind;
    const Device &m_device;
    const RegisterModel &m_registers;
    NumberEdit *m_first, *m_second;
    QLabel *m_note;
    MotorButton *m_send;
    std::vector<QWidget *> m_widgets;
};

} // namespace widgets

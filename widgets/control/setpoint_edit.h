// SetpointEdit: a field for one set-point. Nothing leaves it while the user types; Enter commits, and only a number
// that was understood and is within the limits. The wheel and the arrow keys step, the wheel only in a focused and
// enabled-for-motion field.
#pragma once

#include "widgets/base/stepped_edit.h"

#include <optional>

namespace widgets {

class SetpointEdit : public SteppedEdit {
    Q_OBJECT
public:
    explicit SetpointEdit(QWidget *parent = nullptr);

    /// @param limit  greatest magnitude, > 0 and finite
    /// @param step   what the device can resolve; also what one notch of the wheel adds
    void setLimits(double limit, double step, const QString &unit);
    /// What one notch of the wheel or an arrow key adds, where that is more than the step.
    void setNotch(double notch) { m_notch = notch; }
    void setNegativeAllowed(bool allowed); ///< true if not told
    double limit() const { return m_limit; }
    double step() const { return m_step; }
    void setWheelAllowed(bool allowed) { m_wheelAllowed = allowed; }

    /// What the text means now; empty if it is not understood or too large.
    std::optional<double> value() const;
    /// value() as the device will take it: the nearest multiple of the step, never beyond the limit.
    std::optional<double> sentValue() const;
    void setValue(double value); ///< cursor and selection stay
    /// Zero, all of it selected in a field with focus: what is typed, and what follows, takes its place.
    void beginAnew();
    /// The understood value, or what is wrong with the text; one short sentence.
    QString echo() const;
    QString problem() const override; ///< of what was typed

Q_SIGNALS:
    void committed(double value); ///< sentValue(), on Enter
    void echoChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void stepBy(int steps) override;
    bool wheelWanted() const override { return hasFocus() && m_wheelAllowed; }

private:
    double least() const; ///< that can be sent

    double m_limit = 1.0;
    double m_step = 1.0;
    double m_notch = 0.0;
    QString m_unit;
    bool m_wheelAllowed = false;
    bool m_negativeAllowed = true;
};

} // namespace widgets

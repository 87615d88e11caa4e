// NumberEdit: a line for one plain number: a set-point, or what a computation starts from. Nothing is sent while the
// user types; Enter commits, and only a number that was understood and is within the limits. With a step, which is what
// a device resolves, the text counts, rounded to the step; without one any number does, and a notch is a share of it.
//
// The other fields for numbers are of other kinds: a register has names, flags and digits (EntryEdit); a value of the
// scope stands with its unit, holds until it is left, and leaves the arrow keys to the scope (ValueEdit); a count is
// clicked as often as typed, with Qt's buttons (WholeSpin).
#pragma once

#include "widgets/base/fields/stepped_edit.h"

#include <optional>

namespace widgets {

class NumberEdit : public SteppedEdit {
    Q_OBJECT
public:
    /// Begins with 0 in steps of 1, between -1 and 1.
    explicit NumberEdit(QWidget *parent = nullptr);
    /// Without a step; begins empty. The wheel is allowed.
    /// @param name  the object's; @param label  for people, without a unit
    NumberEdit(const char *name, const QString &label, const QString &unit, double least,
        double greatest, QWidget *parent = nullptr);

    /// @param limit  greatest magnitude, > 0 and finite
    /// @param step   what the device can resolve; also what one notch of the wheel adds
    void setLimits(double limit, double step, const QString &unit)
    {
        setRange(-limit, limit, step, unit);
    }
    void setRange(double least, double greatest, double step, const QString &unit);
    /// What one notch of the wheel or an arrow key adds, where that is more than the step.
    void setNotch(double notch) { m_notch = notch; }
    double limit() const { return m_greatest; }
    double step() const { return m_step; }
    QString unit() const { return m_unit; }
    void setWheelAllowed(bool allowed) { m_wheelAllowed = allowed; }

    /// What the text means now; empty if it is not understood or beyond the limits. Without a step what setValue() gave
    /// comes back exactly.
    std::optional<double> value() const;
    /// value() as the device will take it: the nearest multiple of the step, never beyond the limits.
    std::optional<double> sentValue() const;
    /// Not as the user types it; cursor and selection stay. What is no number empties a field without a step, and
    /// changes nothing in another.
    void setValue(std::optional<double> value);
    /// Zero, all of it selected in a field with focus: what is typed, and what follows, takes its place.
    void beginAnew();
    /// The understood value, or what is wrong with the text; one short sentence.
    QString echo() const;
    QString problem() const override; ///< none if there is no text

Q_SIGNALS:
    void committed(double value); ///< sentValue(), on Enter in a field with a step
    void valueEdited(); ///< by the user; value() may be empty
    void echoChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void stepBy(int steps) override;
    bool wheelWanted() const override { return hasFocus() && m_wheelAllowed; }

private:
    bool stepless() const { return !(m_step > 0.0); }
    bool holds(double value) const { return value >= m_least && value <= m_greatest; }
    QString wrong() const; ///< with the text, a missing one included
    double inside(double value) const; ///< the nearest one that can be sent
    QString textOf(double value) const;

    double m_least = -1.0, m_greatest = 1.0;
    double m_step = 1.0;
    double m_notch = 0.0;
    QString m_unit;
    bool m_wheelAllowed = false;
    std::optional<double> m_set; ///< without a step, while the text is m_setText
    QString m_setText;
};

} // namespace widgets

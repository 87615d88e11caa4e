// GainNumber: a text field for one number that a computation starts from (a resistance, a bandwidth). Reads as strictly
// as the fields whose numbers reach a board; nothing leaves it but signals. A step is a share of its size.
#pragma once

#include "widgets/base/stepped_edit.h"

#include <optional>

namespace widgets {

/// Significant digits, neither an exponent nor group marks: "0.35", "1732", "0,0012" in German.
QString significantText(double value, int digits = 4);

class GainNumber : public SteppedEdit {
    Q_OBJECT
public:
    /// @param name  the object's; @param label  for people, without a unit
    GainNumber(const char *name, const QString &label, const QString &unit, double least,
        double greatest, QWidget *parent = nullptr);

    QString unit() const { return m_unit; }
    /// Empty if there is no number that is understood and within the bounds. What setValue() gave comes back exactly.
    std::optional<double> value() const;
    bool isEmpty() const { return text().trimmed().isEmpty(); }
    /// Not as the user types it: no signal. Empty, or not a number: the field is emptied.
    void setValue(std::optional<double> value);
    /// What is wrong with the text; empty if nothing is, or if there is none.
    QString problem() const override;

Q_SIGNALS:
    void valueEdited(); ///< by the user; value() may be empty

protected:
    void stepBy(int steps) override;

private:
    QString m_unit;
    double m_least, m_greatest;
    std::optional<double> m_set;
    QString m_setText; ///< while it is the text, m_set is the value
};

} // namespace widgets

// A field for one number of the scope with its unit: a level, a time, a percentage. Read as strictly as a set-point; a
// time may be typed in s, ms or us. Only Enter or leaving the field commits, and what is not understood changes
// nothing.
#pragma once

#include <QLineEdit>

#include <optional>

namespace widgets {

class ValueEdit : public QLineEdit {
    Q_OBJECT
public:
    explicit ValueEdit(QWidget *parent = nullptr);

    /// A plain number in this unit, which may be typed behind it, shown in steps of `step`.
    void setPlain(const QString &unit, double step);
    void setTime(); ///< value() in seconds
    void setBounds(double least, double most);
    void setValue(double value); ///< does not change what is being typed
    double value() const { return m_value; }
    /// What the text means; empty if it is not understood or out of bounds.
    std::optional<double> understood() const;

Q_SIGNALS:
    void committed(double value);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void commit();
    void show();
    QString textOf(double value) const;

    QString m_unit;
    double m_step = 1.0;
    double m_value = 0.0;
    double m_least = -1e12;
    double m_most = 1e12;
    bool m_time = false;
};

} // namespace widgets

// MotorConverter: the four ways people give the strength of a motor's magnets, and phase and terminal values of its
// winding, each computed from the one that was typed last. It reads and writes nothing.
#pragma once

#include "motor/sheet.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QLineEdit;

namespace widgets {

class MotorConverter : public QWidget {
    Q_OBJECT
public:
    explicit MotorConverter(QWidget *parent = nullptr);

    /// Begins with a motor's values; what the user has typed stays.
    void suggest(const motor::MotorSheet &sheet);
    void accept(const motor::MotorSheet &sheet); ///< whatever was typed

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    enum Field {
        PolePairs,
        Ke,
        Kv,
        Flux,
        Kt,
        MeasuredVolts,
        MeasuredRpm,
        PhaseOhm,
        TerminalOhm,
        PhaseHenry,
        TerminalHenry,
        FieldCount
    };

    QWidget *makeField(Field field, const char *name, const QString &label, const QString &unit,
        const QString &help);
    void commit(Field field);
    void convert(Field from);
    std::optional<double> number(Field field) const;
    void put(Field field, double value);
    void showNumbers(); ///< that were put
    void tell();

    std::array<QLineEdit *, FieldCount> m_edits{};
    std::array<QLabel *, FieldCount> m_labels{};
    std::array<QString, FieldCount> m_shown;
    std::array<double, FieldCount> m_values{}; ///< in the unit of the field; 0: none
    QLabel *m_told = nullptr;
    Field m_strength = Ke; ///< typed last of the four
    bool m_typed = false;
};

} // namespace widgets

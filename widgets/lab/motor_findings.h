// What was measured of a motor, one figure a row: its value, the interval that holds the true one, and what board and
// motor file say. It computes none of it.
#pragma once

#include "lab/evaluation/electrical_evaluation.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/pole_pairs.h"
#include "motor/sheet.h"
#include "widgets/base/row_table.h"

#include <QString>

#include <vector>

namespace widgets {

class MotorFindings : public RowTable {
    Q_OBJECT
public:
    enum Column {
        QuantityColumn,
        MeasuredColumn,
        IntervalColumn,
        BoardColumn,
        FileColumn,
        NoteColumn
    };
    enum Row { PolePairs, Resistance, DeadTime, Ld, Lq, Flux, Inertia, Viscous, Dry, Fan, kRows };

    explicit MotorFindings(QObject *parent = nullptr);

    /// Why it does not tell a figure stands in that row; what else it has to say is for the page.
    /// @param complete  the run came to its end; else what it does not tell stays as it was measured before
    void accept(const lab::Electrics &found, bool complete = true);
    void accept(const lab::Mechanics &found, bool complete = true); ///< tells all of it
    /// What could not be measured is told in the rows of its kind. @param mechanical  else electrical
    void fail(bool mechanical, const QString &why);
    void setPolePairs(const lab::PolePairs &counted);
    void clear();
    void setKnown(const motor::MotorSheet &board, const std::optional<motor::MotorSheet> &file);
    double measured(Row row) const { return m_rows[row].value.value_or(lab::Estimate{}).value; }
    motor::MotorSheet measured() const; ///< only that
    /// N m for an ampere of Iq, by pole pairs and flux of the motor file; 0: it does not tell both.
    double torqueConstant_nm() const;
    const std::optional<lab::Estimate> &estimate(Row row) const { return m_rows[row].value; }
    bool any() const; ///< something was measured that a motor file holds

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    struct Finding {
        std::optional<lab::Estimate> value;
        QString note;
    };
    std::size_t rowsHeld() const override { return kRows; }
    QString text(Row row, int column) const;
    /// With as many digits as the interval of what was measured lets count.
    QString measuredFigure(Row row, const std::optional<double> &value) const;
    void set(Row row, const std::optional<lab::Estimate> &value, const QString &note);

    std::vector<Finding> m_rows;
    motor::MotorSheet m_board, m_file;
};

} // namespace widgets

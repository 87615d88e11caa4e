// GainTable: every regulator of the board with its gains as numerator over divisor, to be edited, and beside each what
// it comes to in SI units, or why that cannot be said. Follows the RegisterModel live; edits stay pending.
#pragma once

#include "catalog/gain_rows.h"
#include "drive/motor_view.h"
#include "widgets/registers/field.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace widgets {

class GainTable : public QWidget {
    Q_OBJECT
public:
    explicit GainTable(RegisterModel &model, QWidget *parent = nullptr);

    /// What the numbers are worth on this board.
    void setFacts(const drive::MotorFacts &facts);
    /// Those of the board's registers that are shown.
    std::vector<catalog::RegisterId> registers() const;
    void focusFirst();

Q_SIGNALS:
    void entryRefused(const QString &sentence);

private:
    struct Gain {
        catalog::GainKind kind = catalog::GainKind::PerUnit;
        int row = 0, place = 0;
        RegisterField *numerator = nullptr;
        RegisterField *divisor = nullptr; ///< nullptr: there is none in any firmware
        QLabel *slash = nullptr;
        QLabel *physical = nullptr;
    };
    void addRow(QGridLayout *grid, int row);
    void addGain(QGridLayout *grid, int row, int place, catalog::GainKind kind, const char *name,
        bool divided);
    void updateRows();
    void updatePhysical();
    static std::optional<double> digitsOf(const Gain &gain); ///< as wanted; empty: not known

    RegisterModel &m_model;
    drive::MotorFacts m_facts;
    std::vector<Gain> m_gains;
    std::vector<QLabel *> m_titles; ///< one a row
    std::vector<QLabel *> m_heads; ///< one a place in a row
    QLabel *m_none;
    QTimer m_soon;
};

} // namespace widgets

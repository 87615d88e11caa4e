// The series of steps that were made, one a row: the gains they were made with, what came of them, and the difference
// to the one that was chosen as reference. It computes none of the numbers.
#pragma once

#include "widgets/base/row_table.h"
#include "widgets/lab/step_result.h"

namespace widgets {

class StepRuns : public RowTable {
    Q_OBJECT
public:
    enum Column {
        RunColumn, ///< its number and its mark
        KpColumn,
        KiColumn,
        RiseColumn,
        OvershootColumn,
        SettlingColumn,
        PeakColumn,
        BusColumn,
        StepColumn, ///< behind what is compared, because it is mostly the same
        kColumns
    };
    static constexpr int kMost = 50; ///< the oldest that is no reference goes for the next one

    explicit StepRuns(QObject *parent = nullptr);
    static QString kindText(StepKind kind); ///< a word

    void add(StepResult result); ///< it gets the next number
    void remove(int row);
    void setReference(int row);
    int reference() const; ///< row; -1: there is none
    const std::vector<StepResult> &results() const { return m_results; }
    /// Marks are drawn for this ground.
    void setDark(bool dark);

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void changed(); ///< which there are, or the reference

private:
    std::size_t rowsHeld() const override { return m_results.size(); }
    QString text(const StepResult &result, int column) const;
    QString number(const StepResult &result, int column) const;
    QString tip(const StepResult &result) const;

    std::vector<StepResult> m_results;
    int m_reference = 0; ///< number of the result; 0: none
    int m_last = 0; ///< number given
    bool m_dark = false;
};

} // namespace widgets

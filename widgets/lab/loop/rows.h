// The loops that stand beside one another: as measured, with gains that are only thought of, as proposed, as proved.
// One a row, with what is told of it. It computes nothing.
#pragma once

#include "lab/maths/statistics.h"
#include "widgets/base/row_table.h"

#include <QString>

#include <optional>
#include <vector>

namespace widgets {

struct LoopRow {
    /// Not translated: "measured", "what-if", "stiff", ..., "proof", "current".
    const char *key = "";
    QString name = {}, help = {};
    int slot = 0; ///< colour of its curve
    bool drawn = false; ///< it has a curve
    std::optional<int> kp = {}, ki = {}; ///< digits
    std::optional<lab::Estimate> crossover_hz = {}, phaseMargin_deg = {}, ms = {}, rise_s = {},
                                 overshoot_pct = {};
};

class LoopRows : public RowTable {
    Q_OBJECT
public:
    enum Column {
        NameColumn,
        KpColumn,
        KiColumn,
        CrossoverColumn,
        MarginColumn,
        MsColumn,
        RiseColumn,
        OvershootColumn
    };
    explicit LoopRows(QObject *parent = nullptr);

    /// Rows with the same key stay the same row.
    void show(std::vector<LoopRow> rows);
    const std::vector<LoopRow> &rows() const { return m_rows; }
    int rowOf(const char *key) const; ///< -1: none
    void setDark(bool dark); ///< marks are drawn for this ground

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;

private:
    std::size_t rowsHeld() const override { return m_rows.size(); }
    QString text(const LoopRow &row, int column) const;

    std::vector<LoopRow> m_rows;
    bool m_dark = false;
};

} // namespace widgets

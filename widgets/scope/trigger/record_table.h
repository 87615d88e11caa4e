// The history of records as a table, newest first: time, age, what caused it, label. The tick in the first column pins
// a record. Read anew when asked, because records come by the dozen in a second.
#pragma once

#include "widgets/base/row_table.h"
#include "widgets/scope/trigger/control.h"

namespace widgets {

class RecordTable : public RowTable {
    Q_OBJECT
public:
    enum Column { TimeColumn, AgeColumn, CauseColumn, LabelColumn };
    enum Role { IdRole = Qt::UserRole };

    explicit RecordTable(TriggerControl &control, QObject *parent = nullptr);

    void refresh(); ///< rows that came and went, and all ages
    int rowOf(scope::RecordId id) const; ///< -1: not there

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    std::size_t rowsHeld() const override { return m_records.size(); }

    TriggerControl &m_control;
    std::vector<scope::Record> m_records; ///< newest first
};

} // namespace widgets

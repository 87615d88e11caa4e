// The history of records as a table, newest first: time, age, what caused it, label. The tick in the first column pins a
// record. Read anew when asked, because records come by the dozen in a second.
#pragma once

#include "widgets/scope/trigger/trigger_control.h"

#include <QAbstractTableModel>

namespace widgets {

class RecordTable : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { TimeColumn, AgeColumn, CauseColumn, LabelColumn, kColumns };
    enum Role { IdRole = Qt::UserRole };

    explicit RecordTable(TriggerControl &control, QObject *parent = nullptr);

    void refresh(); ///< rows that came and went, and all ages
    int rowOf(scope::RecordId id) const; ///< -1: not there

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    TriggerControl &m_control;
    std::vector<scope::Record> m_records; ///< newest first
};

} // namespace widgets

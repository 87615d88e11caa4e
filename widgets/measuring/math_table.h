// The math channels as a table: name, formula, last value. The tick in the first column draws a channel or not.
#pragma once

#include "widgets/base/row_table.h"
#include "widgets/measuring/math_channels.h"

namespace widgets {

class ScopeView;

class MathTable : public RowTable {
    Q_OBJECT
public:
    enum Column { NameColumn, FormulaColumn, ValueColumn };

    /// All outlive it.
    MathTable(MathChannels &channels, const capture::Capture &capture, const ScopeView &scope,
        QObject *parent = nullptr);

    void refresh(); ///< the last values
    int rowOf(const QString &name) const; ///< -1: not there
    const MathChannels::Entry &entry(int row) const { return m_entries[std::size_t(row)]; }

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

private:
    std::size_t rowsHeld() const override { return m_entries.size(); }
    void follow();
    QString valueText(const MathChannels::Entry &entry) const;

    MathChannels &m_channels;
    const capture::Capture &m_capture;
    const ScopeView &m_scope;
    std::vector<MathChannels::Entry> m_entries;
};

} // namespace widgets

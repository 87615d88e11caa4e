// SnapshotModel: the registers in which two snapshots differ, as a table, and which of them the user wants back on the
// board. It compares and remembers; reading and writing are others' business.
#pragma once

#include "snapshots/restore.h"
#include "widgets/base/row_table.h"

#include <functional>
#include <memory>
#include <set>

namespace widgets {

class SnapshotModel : public RowTable {
    Q_OBJECT
public:
    enum Column { NameColumn, MotorColumn, AColumn, BColumn, UnitColumn, ARawColumn, BRawColumn };
    enum Role {
        SearchRole = Qt::UserRole, ///< name and group in one text
        SortRole, ///< numbers as numbers
        RestorableRole, ///< bool
    };
    using Side = std::shared_ptr<const snapshots::Snapshot>;

    explicit SnapshotModel(QObject *parent = nullptr);

    /// Either may be empty: then nothing is shown.
    void compare(Side a, Side b, snapshots::Scope scope);
    /// What of it can be written to the board that B was read from; those have a check box, all checked at first. What
    /// was unchecked before stays so. An empty plan: none.
    void offer(const snapshots::RestorePlan &plan);
    /// The writes that are wanted, in the plan's order, of the rows that `seen` says yes to.
    std::vector<drive::RegisterWrite> chosen(const std::function<bool(int row)> &seen) const;

    int differing() const { return static_cast<int>(m_rows.size()); }
    QString copyText(const QList<int> &rows) const; ///< with a line of headers, tabs between
    void choose(const QList<int> &rows, bool wanted);

    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;

Q_SIGNALS:
    void chosenChanged();

private:
    using Key = std::pair<std::string, int>; ///< name and motor
    struct Row {
        snapshots::Difference difference;
        std::size_t write = SIZE_MAX; ///< in m_plan; SIZE_MAX: cannot be restored
        QString why; ///< it cannot
        bool wanted = true;
    };

    std::size_t rowsHeld() const override { return m_rows.size(); }
    QString text(const Row &row, int column) const;
    QVariant sortKey(const Row &row, int column) const;
    QString toolTip(const Row &row) const;

    Side m_a, m_b;
    std::vector<Row> m_rows;
    snapshots::RestorePlan m_plan;
    std::set<Key> m_unwanted;
};

} // namespace widgets

// RowTable: the base of flat tables, whose columns have fixed titles. It says how large they are and what stands above,
// and how their views are told that rows changed; what the rows are is the business of those that derive from it.
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

#include <algorithm>
#include <utility>
#include <vector>

namespace widgets {

class RowTable : public QAbstractTableModel {
public:
    int rowCount(const QModelIndex &parent = {}) const final
    {
        return parent.isValid() ? 0 : static_cast<int>(rowsHeld());
    }
    int columnCount(const QModelIndex &parent = {}) const final
    {
        return parent.isValid() ? 0 : static_cast<int>(m_titles.size());
    }
    QVariant headerData(
        int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override
    {
        const bool title = orientation == Qt::Horizontal && role == Qt::DisplayRole;
        return title ? QVariant(m_titles.value(section)) : QVariant();
    }

    /// The titles with tabs between, to stand above what rowText() says.
    QString titlesText() const { return m_titles.join(QLatin1Char('\t')); }

protected:
    /// @param titles  one a column, from the left
    RowTable(QObject *parent, QStringList titles)
        : QAbstractTableModel(parent)
        , m_titles(std::move(titles))
    {
    }
    virtual std::size_t rowsHeld() const = 0;

    /// Views read all rows anew, in these columns. @param last  -1: that farthest right
    void cellsChanged(int first = 0, int last = -1)
    {
        if (rowCount() > 0)
            Q_EMIT dataChanged(
                index(0, first), index(rowCount() - 1, last < 0 ? columnCount() - 1 : last));
    }
    /// Puts others in the place of the rows. While they are `same` ones, in the same order, the chosen row stays.
    template <class Row, class Same>
    void replace(std::vector<Row> &rows, std::vector<Row> fresh, Same same)
    {
        if (std::equal(fresh.begin(), fresh.end(), rows.begin(), rows.end(), same)) {
            rows = std::move(fresh);
            return cellsChanged();
        }
        beginResetModel();
        rows = std::move(fresh);
        endResetModel();
    }

private:
    QStringList m_titles;
};

/// The row of that index, in any table or tree, as it is shown, with tabs between columns: for the clipboard.
/// Empty for an index of no table.
inline QString rowText(const QModelIndex &row)
{
    QStringList cells;
    const int columns = row.isValid() ? row.model()->columnCount(row.parent()) : 0;
    for (int column = 0; column < columns; ++column)
        cells.append(row.siblingAtColumn(column).data().toString());
    return cells.join(QLatin1Char('\t'));
}

} // namespace widgets

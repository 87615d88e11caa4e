// What the traces are at the cursors, as a table: rows A, B and their difference, a column for the time and one for
// each trace. Values are those of the sample before a cursor; a gap is said, never counted as zero.
#pragma once

#include "capture/capture.h"
#include "widgets/scope/cursors.h"

#include <QAbstractTableModel>

namespace widgets {

class ScopeView;

class CursorTable : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Row { RowA, RowB, RowDelta, kRows };

    /// Both outlive it. Follows the cursors and the traces shown by itself.
    CursorTable(const ScopeView &scope, const capture::Capture &capture, QObject *parent = nullptr);

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    /// Everything with headings, tabs between columns: for the clipboard.
    QString asText() const;

public Q_SLOTS:
    void refresh(); ///< reads everything anew; tells only of what changed

private:
    struct Column {
        capture::ChannelId channel = 0;
        QString name;
        QString text[kRows];
        bool operator==(const Column &) const = default;
    };
    Column timeColumn() const;
    Column columnOf(capture::ChannelId channel) const;

    const ScopeView &m_scope;
    const capture::Capture &m_capture;
    std::vector<Column> m_columns;
};

} // namespace widgets

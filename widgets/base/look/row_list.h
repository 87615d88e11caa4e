// RowList: a list of rows in columns, as all of them look and move: no branches, rows of one height, the focus around
// whole rows.
#pragma once

#include <QHeaderView>
#include <QTreeView>

namespace widgets {

class RowList : public QTreeView {
public:
    /// @param says  its accessible name
    RowList(const char *name, const QString &says, QAbstractItemModel *model, QWidget *parent)
        : QTreeView(parent)
    {
        setObjectName(QLatin1String(name));
        setAccessibleName(says);
        setModel(model);
        setRootIsDecorated(false);
        setUniformRowHeights(true);
        setAlternatingRowColors(true);
        setAllColumnsShowFocus(true);
    }
};

} // namespace widgets

#include "widgets/base/table_text.h"

#include <QAbstractItemModel>
#include <QStringList>

namespace widgets {

QString tableText(const QAbstractItemModel &table)
{
    constexpr int kHeadings = -1;
    QString text;
    for (int row = kHeadings; row < table.rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < table.columnCount(); ++column)
            cells.append((row == kHeadings ? table.headerData(column, Qt::Horizontal)
                                           : table.index(row, column).data())
                             .toString());
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return text;
}

} // namespace widgets

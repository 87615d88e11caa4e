// A table as text for the clipboard.
#pragma once

#include <QString>

class QAbstractItemModel;

namespace widgets {

/// The headings and every row as shown, tabs between columns, each line ended.
QString tableText(const QAbstractItemModel &table);

} // namespace widgets

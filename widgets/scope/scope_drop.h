// Registers on their way from the tree to the scope, as a drag carries them.
#pragma once

#include <QList>

class QMimeData;

namespace widgets {

/// Ids in a drag of kRegisterMimeType; empty if it holds none or is damaged. At most 64.
QList<quint32> registersIn(const QMimeData &data);

} // namespace widgets

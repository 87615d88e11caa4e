// Inertias: what was typed of motors whose boards do not know it, for every form that needs it.
#pragma once

#include <QMap>
#include <QString>

namespace widgets {

/// By the name that the board gives its motor, fit to be shown, in kg m2.
using Inertias = QMap<QString, double>;

} // namespace widgets

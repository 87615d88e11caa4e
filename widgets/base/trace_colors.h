// Colours of the traces: the Okabe-Ito set, which stays apart for people who see fewer colours, once for light and
// once for dark ground. A slot is the same hue in both, so a signal keeps its colour when the theme changes.
#pragma once

#include <QColor>
#include <QString>

class QPalette;

namespace widgets {

constexpr int kTraceColors = 8;

bool isDark(const QPalette &palette);
QColor traceColor(int slot, bool dark); ///< slots repeat after kTraceColors

QColor faded(QColor color, int alpha); ///< of 255

/// Where a family of signals (currents, voltages, speeds, angles, the rest) starts to look for a free slot.
int preferredSlot(const QString &unit);

} // namespace widgets

#include "widgets/base/trace_colors.h"

#include <QPalette>

#include <array>

namespace widgets {

namespace {
struct Pair {
    QRgb light; ///< on light ground
    QRgb dark; ///< on dark ground
};
// Blue, vermillion, bluish green, reddish purple, orange, sky blue, yellow, ink. The yellow and the pale ones are
// darkened for white paper, the deep ones lightened for black.
constexpr std::array<Pair, kTraceColors> kSlots{{
    {0xFF0072B2, 0xFF4FA8E8},
    {0xFFD55E00, 0xFFF2783A},
    {0xFF008A63, 0xFF1FC79A},
    {0xFFB3558A, 0xFFDB8FBA},
    {0xFFC98500, 0xFFE69F00},
    {0xFF2C8FC9, 0xFF8CCBF2},
    {0xFF8F8400, 0xFFF0E442},
    {0xFF303030, 0xFFE8E8E8},
}};
} // namespace

bool isDark(const QPalette &palette)
{
    return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

QColor traceColor(int slot, bool dark)
{
    const Pair &pair = kSlots[std::size_t(slot < 0 ? 0 : slot % kTraceColors)];
    return QColor(dark ? pair.dark : pair.light);
}

int preferredSlot(const QString &unit)
{
    if (unit == QLatin1String("A"))
        return 0;
    if (unit == QLatin1String("rpm") || unit == QLatin1String("Hz"))
        return 2;
    if (unit == QLatin1String("V"))
        return 4;
    if (unit == QLatin1String("deg") || unit == QString::fromUtf8("\u00b0"))
        return 3;
    return 7;
}

QColor faded(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

} // namespace widgets

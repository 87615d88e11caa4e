#include "widgets/scope/drawing/axis_ticker.h"

#include "widgets/base/axis_ticks.h"

namespace widgets {

namespace {
constexpr int kLeastPixels = 4; ///< from one small tick to the next
}

void AxisTicker::generate(const QCPRange &range, const QLocale &locale, QChar, int,
    QVector<double> &ticks, QVector<double> *subTicks, QVector<QString> *labels)
{
    const double from = range.lower - m_origin;
    const double to = range.upper - m_origin;
    const double step = valueStep(from, to, m_most, m_room);
    const QVector<double> shown = ticksIn(from, to, step);
    const double largest = std::max(std::abs(from), std::abs(to));
    ticks.clear();
    if (labels)
        labels->clear();
    if (subTicks)
        *subTicks = smallTicks(from, to, step);
    for (const double tick : shown) {
        ticks.append(tick + m_origin);
        if (labels)
            labels->append(m_labels == Labels::Times ? timeLabel(tick, step, largest, locale)
                                                     : valueLabel(tick, step, locale));
    }
}

QVector<double> AxisTicker::smallTicks(double from, double to, double step) const
{
    const double pieces = (to - from) / step * piecesOf(step);
    if (!(pieces * kLeastPixels <= m_pixels)) // true of a range without a number, too
        return {};
    QVector<double> ticks = smallTicksIn(from, to, step);
    for (double &tick : ticks)
        tick += m_origin;
    return ticks;
}

} // namespace widgets

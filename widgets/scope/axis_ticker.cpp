#include "widgets/scope/axis_ticker.h"

#include "widgets/scope/axis_ticks.h"

namespace widgets {

void AxisTicker::generate(const QCPRange &range, const QLocale &locale, QChar, int,
    QVector<double> &ticks, QVector<double> *subTicks, QVector<QString> *labels)
{
    const double step = tickStep(range.size(), m_most);
    ticks = ticksIn(range.lower, range.upper, step);
    if (subTicks)
        subTicks->clear();
    if (!labels)
        return;
    labels->clear();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    for (const double tick : std::as_const(ticks)) {
        labels->append(m_labels == Labels::Times ? timeLabel(tick, step, largest, locale)
                                                 : valueLabel(tick, step, locale));
    }
}

} // namespace widgets

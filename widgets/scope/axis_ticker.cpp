#include "widgets/scope/axis_ticker.h"

#include "widgets/scope/axis_ticks.h"

namespace widgets {

void AxisTicker::generate(const QCPRange &range, const QLocale &locale, QChar, int,
    QVector<double> &ticks, QVector<double> *subTicks, QVector<QString> *labels)
{
    const double step = tickStep(range.size(), m_most);
    const double from = range.lower - m_origin;
    const double to = range.upper - m_origin;
    const QVector<double> shown = ticksIn(from, to, step);
    const double largest = std::max(std::abs(from), std::abs(to));
    ticks.clear();
    if (labels)
        labels->clear();
    if (subTicks)
        subTicks->clear();
    for (const double tick : shown) {
        ticks.append(tick + m_origin);
        if (labels)
            labels->append(m_labels == Labels::Times ? timeLabel(tick, step, largest, locale)
                                                     : valueLabel(tick, step, locale));
    }
}

} // namespace widgets

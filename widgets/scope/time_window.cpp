#include "widgets/scope/time_window.h"

#include "widgets/scope/plot_stack.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kLeastShare = 1e-12; ///< of what is counted from; a double tells 1e-16 apart
constexpr double kMostSpan = 1e7; ///< seconds
/// From zero; files may count from 1970.
constexpr double kFarthest = 4e9;

} // namespace

TimeWindow::TimeWindow(PlotStack &stack, QObject *parent)
    : QObject(parent)
    , m_stack(stack)
{
    apply(m_range);
}

double TimeWindow::step() const { return m_stack.timeStep(); }

double TimeWindow::timeAt(double x) const
{
    const QRect area = m_stack.plot(0).rect->rect();
    const double share = (x - area.left()) / std::max(1, area.width());
    return m_range.from + share * m_range.span();
}

double TimeWindow::xOf(double seconds) const
{
    const QRect area = m_stack.plot(0).rect->rect();
    return area.left() + (seconds - m_range.from) / m_range.span() * area.width();
}

void TimeWindow::apply(Range range)
{
    if (!std::isfinite(range.from) || !std::isfinite(range.to) || !(range.to > range.from))
        return;
    const double center = std::clamp(range.from + range.span() / 2, -kFarthest, kFarthest);
    const double least = std::max(kLeastSpan, std::abs(center) * kLeastShare);
    const double span = std::clamp(range.span(), least, kMostSpan);
    const bool resized = span != range.span() || std::abs(center) == kFarthest;
    if (resized)
        range = {center - span / 2, center + span / 2};
    const bool moved = range.from != m_range.from || range.to != m_range.to;
    m_range = range;
    m_stack.setTimeRange(range.from, range.to);
    if (moved)
        Q_EMIT changed(range.from, range.to);
}

void TimeWindow::set(double from, double to)
{
    if (m_following) {
        m_following = false;
        Q_EMIT followingChanged(false);
    }
    apply({from, to});
    Q_EMIT redrawWanted();
}

void TimeWindow::setFollowing(bool following)
{
    if (following)
        follow();
    if (m_following != following) {
        m_following = following;
        Q_EMIT followingChanged(following);
    }
    Q_EMIT redrawWanted();
}

void TimeWindow::follow()
{
    const auto newest = m_stack.newestSample();
    if (!newest)
        return;
    // A young session fills the picture from the left: nothing was ever recorded before zero.
    const double to = std::max(*newest, m_range.span());
    apply({to - m_range.span(), to});
}

void TimeWindow::zoom(double factor)
{
    if (!(factor > 0) || !std::isfinite(factor))
        return;
    const double span = std::max(m_range.span() / factor, kLeastSpan);
    const bool around = m_anchor && m_range.has(*m_anchor);
    const double center = around ? *m_anchor : m_range.from + m_range.span() / 2;
    const double share = (center - m_range.from) / m_range.span();
    if (m_following)
        apply({m_range.to - span, m_range.to});
    else
        apply({center - share * span, center + (1.0 - share) * span});
    Q_EMIT redrawWanted();
}

void TimeWindow::pan(double fraction)
{
    const double shift = fraction * m_range.span();
    set(m_range.from + shift, m_range.to + shift);
}

void TimeWindow::centerOn(double seconds)
{
    const double half = m_range.span() / 2;
    set(seconds - half, seconds + half);
}

void TimeWindow::show(double seconds)
{
    if (m_range.has(seconds))
        return;
    const double span = m_range.span();
    const double from = seconds < m_range.from ? seconds - span * 0.1 : seconds - span * 0.9;
    set(from, from + span);
}

void TimeWindow::setOrigin(double seconds)
{
    if (seconds == m_origin || !std::isfinite(seconds))
        return;
    m_origin = seconds;
    m_stack.setTimeOrigin(seconds);
    Q_EMIT originChanged(seconds);
    Q_EMIT redrawWanted();
}

} // namespace widgets

#include "widgets/measuring/xy_job.h"

#include "scope/unit.h"

#include <algorithm>
#include <numbers>

namespace widgets {

namespace {

/// Where the newest kMostXySamples of it begin.
capture::Nanos newest(const capture::Channel &channel, const XyWanted &wanted)
{
    const capture::Index first = channel.atOrAfter(wanted.from);
    const capture::Index end = channel.atOrAfter(wanted.to);
    return end - first > kMostXySamples ? channel.timeOf(end - kMostXySamples) : wanted.from;
}

} // namespace

XyAnswer computeXy(const capture::Snapshot &copy, const XyWanted &wanted)
{
    XyAnswer answer{wanted, {}, false};
    if (!copy || copy->size() != 2)
        return answer;
    const capture::Channel &x = (*copy)[0];
    const capture::Channel &y = (*copy)[1];
    const capture::Nanos from = std::max(newest(x, wanted), newest(y, wanted));
    answer.cut = from > wanted.from;
    scope::XySettings settings;
    settings.turnX = scope::turnOf(x.info().unit);
    settings.turnY = scope::turnOf(y.info().unit);
    settings.most = wanted.most;
    answer.trace = scope::xyTrace(x, y, from, wanted.to, settings);
    if (wanted.clarke) {
        for (scope::XyPoint &point : answer.trace.points)
            point.y = -(point.x + 2.0 * point.y) / std::numbers::sqrt3;
    }
    return answer;
}

} // namespace widgets

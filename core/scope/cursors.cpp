#include "scope/cursors.h"

#include <algorithm>

namespace scope {

CursorValues valuesAt(const capture::Channel &channel, const CursorPair &cursors)
{
    CursorValues result;
    if (channel.empty())
        return result;
    result.a = channel.valueAt(cursors.a);
    result.b = channel.valueAt(cursors.b);
    if (result.a && result.b) {
        result.delta = *result.b - *result.a;
        if (cursors.a != cursors.b)
            result.slope = *result.delta / cursors.seconds();
    }
    return result;
}

Nanos nudged(const capture::Channel &channel, Nanos cursor, std::int64_t steps)
{
    if (channel.empty() || steps == 0)
        return cursor;
    const auto first = static_cast<std::int64_t>(channel.begin());
    const auto last = static_cast<std::int64_t>(channel.end()) - 1;
    steps = std::clamp(steps, -last - 1, last + 1);
    const auto after = static_cast<std::int64_t>(channel.atOrAfter(cursor));
    const bool onSample =
        after <= last && channel.timeOf(static_cast<capture::Index>(after)) == cursor;
    // From between two samples, the first step forwards is to the one after.
    const std::int64_t wanted = steps > 0 && !onSample ? after + steps - 1 : after + steps;
    return channel.timeOf(static_cast<capture::Index>(std::clamp(wanted, first, last)));
}

Nanos snapped(const capture::Channel &channel, Nanos cursor)
{
    if (channel.empty())
        return cursor;
    const capture::Index after = channel.atOrAfter(cursor);
    if (after == channel.end())
        return channel.timeOf(after - 1);
    const Nanos later = channel.timeOf(after);
    if (after == channel.begin())
        return later;
    const Nanos earlier = channel.timeOf(after - 1);
    return cursor - earlier <= later - cursor ? earlier : later;
}

} // namespace scope

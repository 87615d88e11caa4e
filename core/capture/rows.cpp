#include "capture/rows.h"

#include <algorithm>

namespace capture {

namespace {

struct Cursor {
    const Channel *channel = nullptr;
    Index next = 0;
    Index stop = 0;
};

} // namespace

Rows rowsOf(const Snapshot &channels, const std::optional<TimeSpan> &range)
{
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    Rows rows;
    std::vector<Cursor> cursors;
    for (const Channel &channel : *channels) {
        cursors.push_back({&channel, channel.begin(), channel.end()});
        if (range) {
            cursors.back().next = channel.atOrAfter(toNanos(range->from));
            cursors.back().stop = channel.atOrAfter(toNanos(range->to));
        }
    }
    rows.columns.resize(cursors.size());
    while (true) {
        std::optional<Nanos> time;
        for (const Cursor &cursor : cursors) {
            if (cursor.next < cursor.stop)
                time = std::min(time.value_or(std::numeric_limits<Nanos>::max()),
                    cursor.channel->timeOf(cursor.next));
        }
        if (!time)
            return rows;
        rows.time.push_back(toSeconds(*time));
        for (std::size_t i = 0; i < cursors.size(); ++i) {
            Cursor &cursor = cursors[i];
            const bool there =
                cursor.next < cursor.stop && cursor.channel->timeOf(cursor.next) == *time;
            rows.columns[i].push_back(there ? cursor.channel->at(cursor.next) : kUnknown);
            cursor.next += there ? 1 : 0;
        }
    }
}

} // namespace capture

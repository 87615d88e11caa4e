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

Rows rowsOf(const Snapshot &channels, const std::optional<TimeSpan> &range,
    const std::function<bool(std::size_t rows, std::size_t least)> &proceed)
{
    constexpr std::size_t kTold = 1 << 16; ///< rows
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
    std::size_t least = 0;
    for (const Cursor &cursor : cursors)
        least = std::max(least, cursor.stop - std::min(cursor.next, cursor.stop));
    if (proceed && !proceed(0, least))
        return rows;
    rows.time.reserve(least); // most often all there are: growing would take as much again
    for (std::vector<double> &column : rows.columns)
        column.reserve(least);
    while (true) {
        if (proceed && rows.time.size() % kTold == kTold - 1 && !proceed(rows.time.size(), least))
            return rows;
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

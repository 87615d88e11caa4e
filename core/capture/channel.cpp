#include "capture/channel.h"

namespace capture {

Channel::Channel(ChannelInfo info, std::shared_ptr<SampleMemory> memory)
    : m_info(std::move(info))
    , m_column(m_info.kind == ChannelInfo::Kind::Fast ? Column(FastColumn(std::move(memory)))
                                                      : Column(ValueColumn()))
{
}

Index Channel::begin() const
{
    return std::visit([](const auto &column) { return column.begin(); }, m_column);
}

Index Channel::end() const
{
    return std::visit([](const auto &column) { return column.end(); }, m_column);
}

Nanos Channel::timeOf(Index index) const
{
    return std::visit([index](const auto &column) { return column.timeOf(index); }, m_column);
}

double Channel::at(Index index) const
{
    return toShown(
        std::visit([index](const auto &column) { return double(column.at(index)); }, m_column));
}

Index Channel::atOrAfter(Nanos time) const
{
    return std::visit([time](const auto &column) { return column.atOrAfter(time); }, m_column);
}

std::size_t Channel::pieceOf(Index index) const
{
    return std::visit([index](const auto &column) { return column.pieceOf(index); }, m_column);
}

Nanos Channel::holdUntil(Index index) const
{
    if (const FastColumn *column = fast())
        return column->segments()[column->pieceOf(index)].timeOf(index + 1);
    const ValueColumn *column = values();
    const Run &run = column->runs()[column->pieceOf(index)];
    return index + 1 < run.end() ? column->timeOf(index + 1) : run.holdUntil;
}

std::optional<TimeSpan> Channel::timeSpan() const
{
    if (empty())
        return std::nullopt;
    const Nanos last = timeOf(end() - 1);
    // That a polled value may still be true says nothing about how long was recorded.
    const Nanos until = m_info.kind == ChannelInfo::Kind::Polled ? last + 1 : holdUntil(end() - 1);
    return TimeSpan{toSeconds(timeOf(begin())), toSeconds(until)};
}

template <class Range>
MinMax Channel::shown(const Range &range) const
{
    if (range.empty())
        return {};
    // Rounding keeps the order: the extremes of rounded values are the rounded extremes.
    const auto a = static_cast<float>(toShown(range.min));
    const auto b = static_cast<float>(toShown(range.max));
    return {std::min(a, b), std::max(a, b)};
}

MinMax Channel::extremes(double from, double to) const
{
    const Index low = atOrAfter(toNanos(from));
    const Index high = atOrAfter(toNanos(to));
    const auto ask = [&](const auto &column) { return shown(column.extremes(low, high)); };
    return std::visit(ask, m_column);
}

std::vector<MinMax> Channel::columns(const Slices &slices) const
{
    std::vector<MinMax> result(slices.count);
    const auto set = [&](std::size_t i, auto range) { result[i] = shown(range); };
    std::visit([&](const auto &column) { column.slices(slices, set); }, m_column);
    return result;
}

std::optional<double> Channel::valueAt(Nanos time) const
{
    const Index after = atOrAfter(time + 1);
    if (after == begin() || time >= holdUntil(after - 1))
        return std::nullopt;
    return at(after - 1);
}

std::uint64_t Channel::countIn(double from, double to) const
{
    const Index low = atOrAfter(toNanos(from));
    const Index high = atOrAfter(toNanos(to));
    return high > low ? high - low : 0;
}

std::vector<Sample> Channel::samples(double from, double to, std::size_t limit) const
{
    std::vector<Sample> result;
    Index index = atOrAfter(toNanos(from));
    const Index stop = atOrAfter(toNanos(to));
    if (index > begin() && holdUntil(index - 1) > toNanos(from))
        --index;
    Nanos known = index > begin() ? holdUntil(index - 1) : 0;
    result.reserve(static_cast<std::size_t>(std::min<Index>(limit, stop - std::min(index, stop))));
    const auto put = [&](Nanos time, Nanos until) {
        const bool first = index == begin() || known < time;
        known = until;
        result.push_back({toSeconds(time), at(index), toSeconds(until), first});
    };
    const auto goesOn = [&] { return index < stop && result.size() < limit; };
    if (const FastColumn *column = fast()) {
        for (std::size_t piece = column->pieceOf(index); goesOn(); ++piece) {
            const Segment &segment = column->segments()[piece];
            for (; index < segment.end() && goesOn(); ++index)
                put(segment.timeOf(index), segment.timeOf(index + 1));
        }
        return result;
    }
    const ValueColumn *column = values();
    for (std::size_t piece = column->pieceOf(index); goesOn(); ++piece) {
        const Run &run = column->runs()[piece];
        for (Nanos time = column->timeOf(index); index < run.end() && goesOn(); ++index) {
            const Nanos next = index + 1 < run.end() ? column->timeOf(index + 1) : run.holdUntil;
            put(time, next);
            time = next;
        }
    }
    return result;
}

std::vector<TimeSpan> Channel::gaps(double from, double to, double least) const
{
    std::vector<TimeSpan> result;
    const auto add = [&](Nanos start, Nanos stop) {
        const TimeSpan gap{toSeconds(start), toSeconds(stop)};
        if (gap.to > from && gap.from < to && gap.to - gap.from > least)
            result.push_back(gap);
    };
    const Nanos stop = toNanos(to);
    const Index near = atOrAfter(toNanos(from));
    if (empty())
        return result;
    if (m_released && near == begin())
        add(*m_released, timeOf(begin()));
    const Index start = near > begin() ? near - 1 : near;
    const auto leastNanos = static_cast<Nanos>(least * kNanosPerSecond);
    // A gap that is wide enough ends so long behind the one before it: those between are passed over, however many.
    const auto walk = [&](const auto &column) {
        std::size_t piece = column.pieceOf(start);
        std::size_t stride = 1;
        while (piece + 1 < column.pieces() && column.startOf(piece) < stop) {
            const Nanos next = column.startOf(++piece);
            add(column.stopOf(piece - 1), next);
            const std::size_t last = lastThatBegins(piece, stride, column.pieces(),
                [&](std::size_t one) { return column.startOf(one) <= next + leastNanos; });
            stride = std::max<std::size_t>(1, last - piece);
            piece = last;
        }
    };
    std::visit(walk, m_column);
    return result;
}

bool Channel::sharesGapsWith(const Channel &other) const
{
    const FastColumn *own = fast();
    const FastColumn *its = other.fast();
    if (!own || !its || own->segments().size() != its->segments().size() || empty()
        || m_released != other.m_released)
        return false;
    const auto same = [](const Segment &a, const Segment &b) {
        return a.start() == b.start() && a.stop() == b.stop() && a.first == b.first;
    };
    return same(own->segments().front(), its->segments().front())
        && same(own->segments().back(), its->segments().back());
}

std::size_t Channel::bytes() const
{
    return std::visit([](const auto &column) { return column.bytes(); }, m_column);
}

std::uint64_t Channel::archivedBytes() const
{
    return std::visit([](const auto &column) { return column.archivedBytes(); }, m_column);
}

std::uint64_t Channel::archivableBytes() const
{
    return std::visit([](const auto &column) { return column.archivableBytes(); }, m_column);
}

std::size_t Channel::chunkBytes() const
{
    return std::visit([](const auto &column) { return column.chunkBytes(); }, m_column);
}

Index Channel::toArchive() const
{
    return std::visit([](const auto &column) { return column.toArchive(); }, m_column);
}

std::size_t Channel::handOver(std::vector<Stretch> &to)
{
    const std::size_t before = to.size();
    std::visit([&to](auto &column) { column.handOver(to); }, m_column);
    return to.size() - before;
}

void Channel::place(Index first, std::span<const Stretch> where)
{
    std::visit([=](auto &column) { column.place(first, where); }, m_column);
}

void Channel::takeBack()
{
    std::visit([](auto &column) { column.takeBack(); }, m_column);
}

bool Channel::canRelease() const
{
    return std::visit([](const auto &column) { return column.canRelease(); }, m_column);
}

void Channel::releaseOldest()
{
    if (!m_released && canRelease())
        m_released = oldest();
    std::visit([](auto &column) { column.releaseOldest(); }, m_column);
}

} // namespace capture

#include "scope/sample_range.h"

#include <algorithm>
#include <cmath>

namespace scope {

using capture::FastColumn;

namespace {
/// The first sample in [from, to) that equals `wanted`; it is there.
template <class Column, class Value>
Index findSample(const Column &column, Index from, Index to, Value wanted)
{
    constexpr Index kBlock = Column::kBlockSamples;
    while (from < to) {
        const Index stop = std::min(to, (from / kBlock + 1) * kBlock);
        if (stop - from == kBlock) {
            const auto range = column.blockExtremes(from);
            if (wanted < range.min || wanted > range.max) {
                from = stop;
                continue;
            }
        }
        for (; from < stop; ++from) {
            if (column.at(from) == wanted)
                return from;
        }
    }
    return to;
}
} // namespace

SampleRange::SampleRange(const capture::Channel &channel, Nanos from, Nanos to)
    : m_channel(channel)
    , m_from(from)
    , m_to(std::max(from, to))
    , m_begin(channel.atOrAfter(from))
    , m_end(channel.atOrAfter(m_to))
{
}

bool SampleRange::gapInside() const
{
    return !empty() && m_channel.pieceOf(m_begin) != m_channel.pieceOf(m_end - 1);
}

SampleRange::Extremes SampleRange::extremes() const
{
    const auto shown = [&](const auto &column) -> Extremes {
        const auto range = column.extremes(m_begin, m_end);
        const Index lowAt = findSample(column, m_begin, m_end, range.min);
        const Index highAt = findSample(column, m_begin, m_end, range.max);
        const double low = m_channel.toShown(range.min);
        const double high = m_channel.toShown(range.max);
        if (low <= high)
            return {low, high, lowAt, highAt};
        return {high, low, highAt, lowAt}; // a scale that turns the sign
    };
    return std::visit(shown, m_channel.column());
}

std::optional<SampleRange::Moments> SampleRange::moments() const
{
    return m_channel.fast() ? fastMoments() : heldMoments();
}

std::optional<SampleRange::Moments> SampleRange::fastMoments() const
{
    if (empty())
        return std::nullopt;
    const FastColumn &column = *m_channel.fast();
    std::int64_t sum = 0;
    std::int64_t squares = 0; // at most 2^30 each: room for 2^33 samples
    for (Index at = m_begin; at < m_end;) {
        const auto codes = column.codes(at, static_cast<std::size_t>(m_end - at));
        for (const std::int16_t code : codes) {
            sum += code;
            squares += std::int64_t(code) * code;
        }
        at += codes.size();
    }
    const auto count = static_cast<double>(m_end - m_begin);
    const double mean = static_cast<double>(sum) / count;
    const double variance = std::max(0.0, static_cast<double>(squares) / count - mean * mean);
    const double factor = std::abs(m_channel.info().factor);
    const double shown = m_channel.toShown(mean);
    const double deviation = std::sqrt(variance) * factor;
    return Moments{shown, std::hypot(shown, deviation), deviation};
}

std::optional<SampleRange::Moments> SampleRange::heldMoments() const
{
    // The mean first, then the squares around it: nothing cancels. A value from before the range may hold into it.
    const Index first = m_begin > m_channel.begin() ? m_begin - 1 : m_begin;
    const auto weigh = [&](auto use) {
        for (Index at = first; at < m_end; ++at) {
            const Nanos begin = std::max(m_from, m_channel.timeOf(at));
            const Nanos end = std::min(m_to, m_channel.holdUntil(at));
            if (end > begin)
                use(capture::toSeconds(end - begin), m_channel.at(at));
        }
    };
    double time = 0.0;
    double sum = 0.0;
    weigh([&](double weight, double value) {
        time += weight;
        sum += weight * value;
    });
    if (time <= 0.0)
        return std::nullopt;
    const double mean = sum / time;
    double squares = 0.0;
    weigh(
        [&](double weight, double value) { squares += weight * (value - mean) * (value - mean); });
    const double deviation = std::sqrt(squares / time);
    return Moments{mean, std::hypot(mean, deviation), deviation};
}

} // namespace scope

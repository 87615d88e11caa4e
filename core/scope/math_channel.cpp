#include "scope/math_channel.h"

#include "scope/acquisition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scope {

using capture::Channel;
using capture::ChannelInfo;

namespace {
ChannelInfo infoOf(ChannelInfo info, const Formula &formula)
{
    info.unit = formula.unit();
    info.factor = 1.0;
    info.offset = 0.0;
    info.kind = ChannelInfo::Kind::Slow; // values that hold
    return info;
}

/// Nothing is known right before this sample.
bool beginsPiece(const Channel &channel, Index index)
{
    if (const capture::FastColumn *column = channel.fast())
        return column->segments()[column->segmentOf(index)].first == index;
    const capture::ValueColumn &column = *channel.values();
    return column.runs()[column.runOf(index)].first == index;
}

/// Seconds since the sample before; of a fast channel not rounded to nanoseconds, which a derivative would show.
double distance(const Channel &channel, Index index, Nanos otherwise)
{
    if (const capture::FastColumn *column = channel.fast())
        return column->segments()[column->segmentOf(index)].stepNanos() / capture::kNanosPerSecond;
    return capture::toSeconds(otherwise);
}

/// Between its first samples, as most of them are.
Nanos usualDistance(const Channel &channel)
{
    constexpr Index kFirst = 32;
    std::vector<Nanos> distances;
    const Index end = std::min(channel.end(), channel.begin() + kFirst);
    for (Index i = channel.begin() + 1; i < end; ++i)
        distances.push_back(channel.timeOf(i) - channel.timeOf(i - 1));
    if (distances.empty())
        return std::numeric_limits<Nanos>::max();
    const auto middle = distances.begin() + std::ssize(distances) / 2;
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

/// Fast is before Slow is before Polled; what was computed or came from a file is Slow at any rate.
bool isFaster(const Channel &channel, const Channel &other)
{
    const ChannelInfo::Kind kind = channel.info().kind;
    if (kind != other.info().kind)
        return kind < other.info().kind;
    return kind == ChannelInfo::Kind::Slow && usualDistance(channel) < usualDistance(other);
}
} // namespace

MathChannel::MathChannel(Formula formula, ChannelInfo info, std::uint64_t mostSamples)
    : m_formula(std::move(formula))
    , m_channel(infoOf(std::move(info), m_formula))
    , m_mostSamples(mostSamples)
    , m_inputs(m_formula.used().size())
    , m_values(m_formula.used().size())
{
}

void MathChannel::chooseClock(std::span<const Channel *const> inputs)
{
    m_clock = 0;
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        if (isFaster(*inputs[i], *inputs[*m_clock]))
            m_clock = i;
    }
}

/// The values of the inputs at an instant of the clock; false if one of them is not known.
bool MathChannel::readInputs(std::span<const Channel *const> inputs, Nanos time)
{
    bool known = true;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Channel &channel = *inputs[i];
        Input &input = m_inputs[i];
        Index next = input.next;
        if (next == 0 || next < channel.begin())
            next = channel.atOrAfter(time + 1);
        while (next < channel.end() && channel.timeOf(next) <= time)
            ++next;
        const bool any = next > channel.begin();
        // How long the last sample of a channel holds is only known once another has followed.
        if (any && (next != input.next || input.wasLast)) {
            input.value = channel.at(next - 1);
            input.holdUntil = channel.holdUntil(next - 1);
        }
        input.next = next;
        input.wasLast = next == channel.end();
        known = known && any && time < input.holdUntil;
        m_values[i] = input.value;
    }
    return known;
}

bool MathChannel::update(std::span<const Channel *const> inputs, Nanos until, std::size_t most)
{
    if (inputs.empty() || inputs.size() != m_inputs.size())
        return false;
    if (!m_clock) {
        // Until all have begun there is nothing to compute, and which is the fastest may not be known.
        if (std::ranges::any_of(inputs, [](const auto *in) { return in->empty(); }))
            return false;
        chooseClock(inputs);
    }
    const Channel &clock = *inputs[*m_clock];
    if (m_next < clock.begin()) {
        m_next = clock.begin();
        m_joined = false;
    }
    const Index end = std::max(m_next, clock.atOrAfter(until));
    const bool rest = end - m_next > most;
    for (auto left = static_cast<std::size_t>(std::min<Index>(end - m_next, most)); left > 0;) {
        std::size_t count = together(inputs, clock, left);
        if (count > 0) {
            const capture::FastColumn &column = *clock.fast();
            computeTogether(inputs, column.segments()[column.segmentOf(m_next)], count);
        } else {
            constexpr std::size_t kSome = 256; // until they may come together
            count = std::min(left, kSome);
            for (std::size_t i = 0; i < count; ++i, ++m_next)
                compute(inputs, clock);
        }
        left -= count;
    }
    while (m_channel.size() > m_mostSamples && m_channel.canRelease())
        m_channel.releaseOldest();
    return rest;
}

/// At so many instants from the next one on, `most` at most, all inputs have a sample of their own, side by side in a chunk:
/// signals of one stream. Places them there.
std::size_t MathChannel::together(
    std::span<const Channel *const> inputs, const Channel &clock, std::size_t most)
{
    const capture::FastColumn *column = clock.fast();
    if (!column)
        return 0;
    const capture::Segment &segment = column->segments()[column->segmentOf(m_next)];
    const capture::Tick tick = segment.tickOf(m_next);
    std::size_t count = std::min(most, static_cast<std::size_t>(segment.end() - m_next));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const capture::FastColumn *other = inputs[i]->fast();
        const Index at = other ? other->atOrAfter(segment.base.timeOf(tick)) : 0;
        if (!other || at >= other->end())
            return 0;
        const capture::Segment &its = other->segments()[other->segmentOf(at)];
        if (its.base != segment.base || its.step != segment.step || its.tickOf(at) != tick)
            return 0;
        count = std::min(count, static_cast<std::size_t>(its.end() - at));
        count = other->codes(at, count).size();
        m_inputs[i].next = at;
    }
    return count;
}

void MathChannel::computeTogether(
    std::span<const Channel *const> inputs, const capture::Segment &clock, std::size_t count)
{
    capture::ValueColumn &result = *m_channel.values();
    std::vector<std::span<const std::int16_t>> codes;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        codes.push_back(inputs[i]->fast()->codes(m_inputs[i].next, count));
    const double step = clock.stepNanos() / capture::kNanosPerSecond;
    const auto store = [&] {
        if (!m_pieceTimes.empty())
            result.append(m_pieceTimes, m_pieceValues,
                std::max(m_pieceTimes.back() + 1, clock.timeOf(m_next)));
        m_pieceTimes.clear();
        m_pieceValues.clear();
    };
    for (std::size_t k = 0; k < count; ++k, ++m_next) {
        for (std::size_t i = 0; i < inputs.size(); ++i)
            m_values[i] = inputs[i]->toShown(codes[i][k]);
        const bool joined = m_joined && m_next != clock.first;
        const double value = m_formula.step(m_values, step, joined);
        m_joined = true;
        m_before = clock.timeOf(m_next);
        if (!joined || !std::isfinite(value)) {
            store();
            result.breakHere();
        }
        if (std::isfinite(value)) {
            m_pieceTimes.push_back(m_before);
            m_pieceValues.push_back(value);
        }
    }
    store();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Input &input = m_inputs[i];
        input.next += count;
        input.value = m_values[i];
        input.holdUntil = inputs[i]->holdUntil(input.next - 1);
        input.wasLast = input.next == inputs[i]->end();
    }
}

/// One instant: the value of the formula, or a gap.
void MathChannel::compute(std::span<const Channel *const> inputs, const Channel &clock)
{
    capture::ValueColumn &result = *m_channel.values();
    const Nanos time = clock.timeOf(m_next);
    if (!readInputs(inputs, time)) {
        m_joined = false;
        result.breakHere();
        return;
    }
    const bool joined = m_joined && !beginsPiece(clock, m_next);
    const double value = m_formula.step(m_values, distance(clock, m_next, time - m_before), joined);
    m_joined = true;
    m_before = time;
    if (!joined || !std::isfinite(value))
        result.breakHere();
    if (std::isfinite(value))
        result.append(time, value, std::max(time + 1, clock.holdUntil(m_next)));
}

std::optional<Nanos> settledUntil(std::span<const Channel *const> channels)
{
    std::optional<Nanos> result;
    for (const Channel *const channel : channels) {
        if (channel->empty())
            return std::nullopt;
        const Nanos held = heldUntil(*channel);
        result = result ? std::min(*result, held) : held;
    }
    return result;
}

} // namespace scope

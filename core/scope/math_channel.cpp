#include "scope/math_channel.h"

#include "scope/acquisition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scope {

using capture::Channel;
using Kind = capture::ChannelInfo::Kind;

namespace {
/// Seconds since the sample before; of a fast channel not rounded to nanoseconds, which a derivative would show.
double distance(const Channel &channel, Index index, Nanos otherwise)
{
    if (const capture::FastColumn *column = channel.fast())
        return column->segments()[column->pieceOf(index)].stepNanos() / capture::kNanosPerSecond;
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
    const Kind kind = channel.info().kind;
    if (kind != other.info().kind)
        return kind < other.info().kind;
    return kind == Kind::Slow && usualDistance(channel) < usualDistance(other);
}
} // namespace

MathChannel::MathChannel(Formula formula)
    : m_formula(std::move(formula))
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
    m_results.times.clear();
    m_results.values.clear();
    m_results.pieces.clear();
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
            computeTogether(inputs, column.segments()[column.pieceOf(m_next)], count);
        } else {
            constexpr std::size_t kSome = 256; // until they may come together
            count = std::min(left, kSome);
            for (std::size_t i = 0; i < count; ++i, ++m_next)
                compute(inputs, clock);
        }
        left -= count;
    }
    return rest;
}

/// At so many instants from the next one on, `most` at most, all inputs have a sample of their own, side by side in a
/// chunk: signals of one stream. Places them there.
std::size_t MathChannel::together(
    std::span<const Channel *const> inputs, const Channel &clock, std::size_t most)
{
    const capture::FastColumn *column = clock.fast();
    if (!column)
        return 0;
    const capture::Segment &segment = column->segments()[column->pieceOf(m_next)];
    const capture::Tick tick = segment.tickOf(m_next);
    std::size_t count = std::min(most, static_cast<std::size_t>(segment.end() - m_next));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const capture::FastColumn *other = inputs[i]->fast();
        const Index at = other ? other->atOrAfter(segment.base.timeOf(tick)) : 0;
        if (!other || at >= other->end())
            return 0;
        const capture::Segment &its = other->segments()[other->pieceOf(at)];
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
    std::vector<std::span<const std::int16_t>> codes;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        codes.push_back(inputs[i]->fast()->codes(m_inputs[i].next, count));
    const double step = clock.stepNanos() / capture::kNanosPerSecond;
    Nanos time = clock.timeOf(m_next);
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < inputs.size(); ++i)
            m_values[i] = inputs[i]->toShown(codes[i][k]);
        const bool joined = m_joined && m_next != clock.first;
        const Nanos next = clock.timeOf(++m_next);
        put(time, m_formula.step(m_values, step, joined), next, joined);
        time = next;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        Input &input = m_inputs[i];
        input.next += count;
        input.value = m_values[i];
        input.holdUntil = inputs[i]->holdUntil(input.next - 1);
        input.wasLast = input.next == inputs[i]->end();
    }
}

/// One instant.
void MathChannel::compute(std::span<const Channel *const> inputs, const Channel &clock)
{
    const Nanos time = clock.timeOf(m_next);
    if (!readInputs(inputs, time)) {
        m_joined = false;
        m_begins = true;
        return;
    }
    const bool joined = m_joined && clock.pieceOf(m_next) == clock.pieceOf(m_next - 1);
    const double value = m_formula.step(m_values, distance(clock, m_next, time - m_before), joined);
    put(time, value, clock.holdUntil(m_next), joined);
}

/// The value of the formula, or a gap.
/// @param joined  it follows the one before
void MathChannel::put(Nanos time, double value, Nanos holdUntil, bool joined)
{
    m_joined = true;
    m_before = time;
    const bool gap = !std::isfinite(value);
    m_begins = m_begins || !joined || gap;
    if (gap)
        return;
    if (m_begins || m_results.pieces.empty())
        m_results.pieces.push_back({0, 0, m_begins});
    m_begins = false;
    m_results.times.push_back(time);
    m_results.values.push_back(value);
    MathResults::Piece &piece = m_results.pieces.back();
    ++piece.count;
    piece.holdUntil = std::max(time + 1, holdUntil);
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

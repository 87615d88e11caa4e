#include "scope/trigger_search.h"

#include "scope/code_masks.h"
#include "scope/trigger_machines.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace scope {

using capture::Channel;
using capture::FastColumn;

namespace {

/// Times and neighbours of samples of one unbroken piece of a channel.
class Reader {
public:
    Reader(const Channel &channel, Between between)
        : m_channel(channel)
        , m_between(between)
    {
    }

    /// A piece of a fast channel: its samples are timed without a search for each.
    void enter(const capture::Segment &segment, Nanos notBefore)
    {
        m_segment = segment;
        m_segment.count = Index(1) << 40; // as far as it may ever grow
        m_dueTime.reset();
        m_countsFrom = m_segment.atOrAfter(notBefore);
    }

    /// False if a hit of this sample is certainly too early: then its time is not needed.
    bool counts(Index index) const { return index >= m_countsFrom; }

    Nanos timeOf(Index index) const
    {
        return m_channel.fast() ? m_segment.timeOf(index) : m_channel.timeOf(index);
    }

    bool reached(Index index, Nanos when)
    {
        if (!m_channel.fast())
            return timeOf(index) >= when;
        if (m_dueTime != when) {
            m_dueTime = when;
            m_dueIndex = m_segment.atOrAfter(when);
        }
        return index >= m_dueIndex;
    }

    /// The same of sixteen samples, a bit each.
    std::uint32_t reachedOf16(Index index, const std::optional<Nanos> &when)
    {
        if (!when || !reached(index + kMaskedCodes - 1, *when))
            return 0;
        return (kEachMasked << (std::max(m_dueIndex, index) - index)) & kEachMasked;
    }

    TriggerHit crossing(Index index, double level) const
    {
        const Nanos there = timeOf(index);
        if (m_between == Between::Hold)
            return {there, index, 1.0};
        const double before = m_channel.at(index - 1);
        const double step = m_channel.at(index) - before;
        const double share = step != 0.0 ? (level - before) / step : 1.0;
        const double fraction = std::clamp(share, 0.0, 1.0);
        const Nanos here = timeOf(index - 1);
        return {here + std::llround(fraction * static_cast<double>(there - here)), index, fraction};
    }

    TriggerHit between(Index index, Nanos when) const
    {
        const auto step = static_cast<double>(timeOf(index) - timeOf(index - 1));
        const auto part = static_cast<double>(when - timeOf(index - 1));
        return {when, index, std::clamp(part / step, 0.0, 1.0)};
    }

private:
    const Channel &m_channel;
    Between m_between;
    capture::Segment m_segment;
    Index m_countsFrom = 0;
    std::optional<Nanos> m_dueTime;
    Index m_dueIndex = 0;
};

/// A stretch of neighbouring samples, and how to read them.
struct Codes {
    using Value = std::int32_t;
    std::span<const std::int16_t> codes;
    Index first;
    Value operator[](Index index) const { return codes[static_cast<std::size_t>(index - first)]; }
};
struct Shown {
    using Value = double;
    const Channel &channel;
    Value operator[](Index index) const { return channel.at(index); }
};

constexpr double kNoTurn = std::numeric_limits<double>::infinity();

/// Steps `machine` through [from, to) until it hits. A step of more than half a turn is the angle's
/// end and no edge.
template <class Values, class AnyMachine>
MaybeHit scanEach(const Values &values, AnyMachine &machine, Reader &reader, Index &from, Index to,
    double halfTurn, double &before)
{
    while (from < to) {
        const auto value = values[from];
        if (std::abs(static_cast<double>(value) - before) > halfTurn)
            machine.wrapped();
        before = static_cast<double>(value);
        const At<Reader> at{reader, from};
        const MaybeHit hit = machine.step(at, value);
        ++from;
        if (hit)
            return hit;
    }
    return std::nullopt;
}

/// The same for codes of no angle: of sixteen at a time those alone are stepped through that would
/// move the machine as it is.
template <class AnyMachine>
MaybeHit scan(const Codes &values, AnyMachine &machine, Reader &reader, Index &from, Index to)
{
    for (; from + kMaskedCodes <= to; from += kMaskedCodes) {
        const std::int16_t *const codes =
            &values.codes[static_cast<std::size_t>(from - values.first)];
        const auto in = [codes](const Half<Codes::Value> &half) { return maskOf(half, codes); };
        std::uint32_t ahead = kEachMasked;
        while (const std::uint32_t moving =
                   (machine.moves(in) | reader.reachedOf16(from, machine.due())) & ahead) {
            const int at = std::countr_zero(moving);
            ahead = ~std::uint32_t{1} << at;
            const MaybeHit hit = machine.step(
                At<Reader>{reader, from + static_cast<Index>(at)}, Codes::Value{codes[at]});
            if (hit) {
                from += static_cast<Index>(at) + 1;
                return hit;
            }
        }
    }
    double before = 0.0;
    return scanEach(values, machine, reader, from, to, kNoTurn, before);
}

/// The same for a single edge of codes, which is what most searches are: sixteen codes at a time.
MaybeHit scan(
    const Codes &values, EdgeMachine<std::int32_t> &machine, Reader &reader, Index &from, Index to)
{
    Edges<std::int32_t> &edges = machine.edges;
    if (edges.slope == Slope::Either)
        return scan<EdgeMachine<std::int32_t>>(values, machine, reader, from, to);
    Crossing<std::int32_t> &crossing = edges.slope == Slope::Rising ? edges.rising : edges.falling;
    const Half<std::int32_t> arms = crossing.arm;
    const Half<std::int32_t> fires = crossing.fire;
    for (; from + kMaskedCodes <= to; from += kMaskedCodes) {
        const std::int16_t *const codes =
            &values.codes[static_cast<std::size_t>(from - values.first)];
        std::uint32_t arm = maskOf(arms, codes);
        std::uint32_t fire = maskOf(fires, codes);
        // Bits that lie behind are cleared; arming and firing take turns.
        while ((crossing.armed ? fire : arm) != 0) {
            if (!crossing.armed) {
                fire &= ~std::uint32_t{0} << std::countr_zero(arm);
                crossing.armed = true;
                continue;
            }
            const int at = std::countr_zero(fire);
            arm &= ~std::uint32_t{1} << at;
            crossing.armed = false;
            if (const Index index = from + static_cast<Index>(at); reader.counts(index)) {
                from = index + 1;
                return reader.crossing(index, edges.level());
            }
        }
    }
    return scan<EdgeMachine<std::int32_t>>(values, machine, reader, from, to);
}

/// Where a search is in a channel, with its machine.
struct Work {
    const TriggerCondition condition;
    const double halfTurn = condition.turn > 0 ? condition.turn / 2 : kNoTurn;
    Index next;
    /// The machine saw the samples before this one.
    Index known = std::numeric_limits<Index>::max();
    double before = 0.0; ///< value of the last sample; for angles only

    Work(const TriggerCondition &what, Index from)
        : condition(what)
        , next(from)
    {
    }
    Work(const Work &) = delete;
    Work &operator=(const Work &) = delete;
    virtual ~Work() = default;
    virtual MaybeHit search(const Channel &channel, Nanos notBefore, Index until) = 0;
};

/// In the codes of a fast channel, block by block.
template <class AnyMachine>
struct CodeWork final : Work {
    AnyMachine machine;

    CodeWork(const TriggerCondition &what, Index from, const AnyMachine &made)
        : Work(what, from)
        , machine(made)
    {
    }

    MaybeHit search(const Channel &channel, Nanos notBefore, Index until) override
    {
        const FastColumn &column = *channel.fast();
        Reader reader(channel, condition.between);
        next = std::max(next, column.begin());
        while (next < std::min(column.end(), until)) {
            const capture::Segment &segment = column.segments()[column.pieceOf(next)];
            reader.enter(segment, notBefore);
            if (next != known || next == segment.first) {
                machine.begin(reader.timeOf(next));
                before = column.at(next);
            }
            if (const MaybeHit hit = searchSegment(
                    channel, segment, std::min(segment.end(), until), reader, notBefore))
                return hit;
        }
        return std::nullopt;
    }

    MaybeHit searchSegment(const Channel &channel, const capture::Segment &segment, Index end,
        Reader &reader, Nanos notBefore)
    {
        constexpr Index kBlock = FastColumn::kBlockSamples;
        constexpr Index kMostBlocks = 16;
        const FastColumn &column = *channel.fast();
        const double halfCodes = halfTurn / std::abs(channel.info().factor);
        Index atOnce = 1; ///< blocks
        while (next < end) {
            if constexpr (AnyMachine::kForgetful) {
                next = known = std::max(next, segment.atOrAfter(notBefore));
                if (next >= end)
                    return std::nullopt;
            }
            const Index blockEnd = (next / kBlock + 1) * kBlock;
            if (next % kBlock == 0 && blockEnd <= end
                && passesOver(column, reader, blockEnd, halfCodes)) {
                next = known = blockEnd;
                atOnce = 1;
                if (condition.turn > 0)
                    before = column.at(next - 1);
                continue;
            }
            // Where one block could not be passed over, the next ones rarely can: asked less and less often.
            const Index wanted = std::min(end, blockEnd + (atOnce - 1) * kBlock) - next;
            atOnce = std::min(2 * atOnce, kMostBlocks);
            const Codes codes{column.codes(next, static_cast<std::size_t>(wanted)), next};
            const Index stop = next + codes.codes.size();
            const MaybeHit hit = condition.turn > 0
                ? scanEach(codes, machine, reader, next, stop, halfCodes, before)
                : scan(codes, machine, reader, next, stop);
            known = next;
            if (hit && hit->time >= notBefore)
                return hit;
        }
        return std::nullopt;
    }

    /// Nothing can happen in the block from `next` to `stop`.
    bool passesOver(const FastColumn &column, Reader &reader, Index stop, double halfCodes) const
    {
        const capture::CodeRange range = column.blockExtremes(next);
        const auto touches = [range](const Half<std::int32_t> &half) {
            return std::uint32_t{!half.misses(range.min, range.max)};
        };
        if (machine.moves(touches) != 0)
            return false;
        if (std::max<double>(range.max, before) - std::min<double>(range.min, before) > halfCodes)
            return false;
        const auto due = machine.due();
        return !due || !reader.reached(stop - 1, *due);
    }
};

/// In the values of a slow, polled or computed channel.
template <class AnyMachine>
struct ValueWork final : Work {
    AnyMachine machine;

    ValueWork(const TriggerCondition &what, Index from, const AnyMachine &made)
        : Work(what, from)
        , machine(made)
    {
    }

    MaybeHit search(const Channel &channel, Nanos notBefore, Index until) override
    {
        const capture::ValueColumn &column = *channel.values();
        Reader reader(channel, condition.between);
        const Shown shown{channel};
        next = std::max(next, column.begin());
        while (next < std::min(column.end(), until)) {
            const capture::Run &run = column.runs()[column.pieceOf(next)];
            const Index end = std::min(run.end(), until);
            if (next != known || next == run.first) {
                machine.begin(reader.timeOf(next));
                before = channel.at(next);
            }
            const MaybeHit hit = scanEach(shown, machine, reader, next, end, halfTurn, before);
            known = next;
            if (hit && hit->time >= notBefore)
                return hit;
        }
        return std::nullopt;
    }
};

/// The work that fits the trigger and the channel; nullptr for what is no matter of samples.
struct MakeWork {
    const TriggerCondition &condition;
    Index from;
    const Channel &channel;

    template <template <class> class AnyMachine, class Trigger>
    std::unique_ptr<Work> make(const Trigger &trigger) const
    {
        using OfCodes = AnyMachine<std::int32_t>;
        using OfValues = AnyMachine<double>;
        if (channel.fast())
            return std::make_unique<CodeWork<OfCodes>>(
                condition, from, OfCodes({channel}, trigger));
        return std::make_unique<ValueWork<OfValues>>(condition, from, OfValues({channel}, trigger));
    }
    using Made = std::unique_ptr<Work>;
    Made operator()(const EdgeTrigger &t) const { return make<EdgeMachine>(t); }
    Made operator()(const LevelTrigger &t) const { return make<LevelMachine>(t); }
    Made operator()(const WindowTrigger &t) const
    {
        return t.when == WindowTrigger::When::Leaves ? make<LeavingMachine>(t)
                                                     : make<EnteringMachine>(t);
    }
    Made operator()(const PulseTrigger &t) const { return make<PulseMachine>(t); }
    Made operator()(const SlewTrigger &t) const { return make<SlewMachine>(t); }
    Made operator()(const DropoutTrigger &t) const { return make<DropoutMachine>(t); }
    Made operator()(const NthEdgeTrigger &t) const { return make<NthEdgeMachine>(t); }
    Made operator()(const EventTrigger & /*event*/) const { return nullptr; }
};

} // namespace

struct TriggerSearch::State {
    TriggerCondition condition;
    Index from;
    std::unique_ptr<Work> work; ///< made when the channel is first seen
};

TriggerSearch::TriggerSearch(TriggerCondition condition, Index from)
    : m_state(std::make_unique<State>(State{condition, from, nullptr}))
{
}
TriggerSearch::TriggerSearch(TriggerSearch &&) noexcept = default;
TriggerSearch &TriggerSearch::operator=(TriggerSearch &&) noexcept = default;
TriggerSearch::~TriggerSearch() = default;

std::optional<TriggerHit> TriggerSearch::next(const Channel &channel, Nanos notBefore, Index until)
{
    if (!m_state->work)
        m_state->work = std::visit(
            MakeWork{m_state->condition, m_state->from, channel}, m_state->condition.what);
    return m_state->work ? m_state->work->search(channel, notBefore, until) : std::nullopt;
}

std::optional<TriggerHit> findTrigger(const Channel &channel, const TriggerCondition &condition,
    Nanos from, const std::function<bool(double)> &proceed, Index atOnce)
{
    constexpr Index kBefore = 1'000'000; ///< samples: whether it is armed, since when it is high
    const Index first = channel.atOrAfter(from);
    const Index begin = first - std::min(first - channel.begin(), kBefore);
    TriggerSearch search(condition, begin);
    const auto all = static_cast<double>(std::max<Index>(channel.end() - begin, 1));
    for (Index at = begin; at < channel.end(); at += atOnce) {
        if (proceed && !proceed(static_cast<double>(at - begin) / all))
            break;
        if (const auto hit = search.next(channel, from, at + atOnce))
            return hit;
    }
    return std::nullopt;
}

} // namespace scope

#include "capture/capture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

namespace capture {

namespace {
using Kind = ChannelInfo::Kind;

/// How many samples may come between two looks at the memory used: a look costs a walk over the
/// channels.
constexpr std::uint64_t kSamplesBetweenChecks = 65536;

/// Registers of imported channels without a name are numbered from here on.
constexpr catalog::RegisterId kImportedRegister = kFirstOwnRegister + 0x10000000;

/// How far new streams may be moved in all: far from where 64 bits end.
constexpr Nanos kMostShift = Nanos{4'000'000'000} * 1'000'000'000;

bool fits(const SampleBlock &block, const StreamLayout &layout)
{
    if (block.fast.size() != std::size_t(block.count) * layout.fast.size())
        return false;
    return std::ranges::all_of(block.slow,
        [&](const SlowGroup &group) { return group.values.size() == layout.slow.size(); });
}
} // namespace

Capture::Capture()
    : Capture(Config{})
{
}

Capture::Capture(Config config)
    : m_config(std::move(config))
{
    if (!m_config.memory)
        m_config.memory = std::make_shared<SampleMemory>();
}

void Capture::begin(const StreamLayout &layout)
{
    breakStream();
    m_layout = layout;
    m_layoutBase = TickBase::of(layout.tickHz, layout.originSeconds);
    m_fresh = true;
    makeStreamChannels();
    ++m_revision;
}

void Capture::makeStreamChannels()
{
    m_fast.clear();
    m_slow.clear();
    for (const StreamSignal &signal : m_layout.fast)
        m_fast.push_back(channelFor(signal, Kind::Fast, m_fast));
    for (const StreamSignal &signal : m_layout.slow)
        m_slow.push_back(channelFor(signal, Kind::Slow, m_slow));
}

Channel *Capture::channelFor(const StreamSignal &signal, Kind kind, std::span<Channel *const> taken)
{
    for (auto entry = m_entries.rbegin(); entry != m_entries.rend(); ++entry) {
        const ChannelInfo &info = entry->channel->info();
        if (info.registerId == signal.id && info.kind == kind && info.unit == signal.unit
            && info.factor == signal.factor && info.offset == signal.offset
            && info.real == signal.real
            && std::ranges::find(taken, entry->channel.get()) == taken.end()) {
            entry->touched = ++m_revision;
            return entry->channel.get();
        }
    }
    return mutableChannel(add(
        {0, signal.id, signal.name, signal.unit, signal.factor, signal.offset, kind, signal.real}));
}

ChannelId Capture::add(ChannelInfo info)
{
    info.id = m_nextId++;
    m_entries.push_back(
        {std::make_unique<Channel>(std::move(info), m_config.memory), ++m_revision});
    return m_entries.back().channel->info().id;
}

/// True if the block's ticks continue where the last block of the stream ended; sets the time base
/// on the first one.
bool Capture::follows(const SampleBlock &block)
{
    TickBase base = m_layoutBase;
    base.origin += m_shift;
    const Nanos start = base.timeOf(block.firstTick);
    if (start < m_streamEnd) {
        if (!m_fresh)
            return false;
        // A new stream that would overlap what is recorded: its clock restarted, its origin is only
        // known roughly.
        const Nanos behind = m_streamEnd - start;
        if (m_shift > kMostShift - behind)
            return false; // only a file that was made to do so gets there
        m_shift += behind;
        base.origin += behind;
    } else if (start > m_streamEnd && !m_layout.fast.empty()) {
        breakStream(); // also if the block does not own up to a loss
    }
    m_base = base;
    m_fresh = false;
    return true;
}

void Capture::append(const SampleBlock &block)
{
    if (block.stream != m_layout.id || m_layout.empty()) {
        ++m_refused.otherStream;
        return;
    }
    if (!fits(block, m_layout)) {
        ++m_refused.malformed;
        return;
    }
    if (!follows(block)) {
        ++m_refused.backwards;
        return;
    }
    if (block.lostTicks != 0)
        breakStream();
    ++m_revision;
    try {
        appendFast(block);
        appendSlow(block);
        m_sinceCheck += block.fast.size() + block.slow.size() * m_slow.size();
        if (m_sinceCheck >= kSamplesBetweenChecks)
            keepWithinLimit();
    } catch (const std::bad_alloc &) {
        // What is drawn gets a gap and loses its oldest; what is recorded goes another way and misses nothing.
        m_released += block.count;
        breakStream();
        forgetDeposits();
        releaseOldest();
    }
}

void Capture::appendFast(const SampleBlock &block)
{
    const std::span<const std::int16_t> all(block.fast);
    for (std::size_t i = 0; i < m_fast.size(); ++i) {
        FastColumn *column = m_fast[i]->fast();
        column->append(
            m_base, block.firstTick, m_layout.fastStep, all.subspan(i * block.count, block.count));
    }
    const Tick end =
        block.firstTick + static_cast<Tick>(block.count) * static_cast<Tick>(m_layout.fastStep);
    m_streamEnd = std::max(m_streamEnd, m_base.timeOf(end));
}

void Capture::appendSlow(const SampleBlock &block)
{
    if (m_slow.empty())
        return;
    m_slowTimes.clear();
    for (const SlowGroup &group : block.slow)
        m_slowTimes.push_back(m_base.timeOf(group.tick));
    m_slowValues.resize(block.slow.size());
    for (std::size_t i = 0; i < m_slow.size(); ++i) {
        ValueColumn *column = m_slow[i]->values();
        const bool real = m_layout.slow[i].real;
        Nanos last = column->empty() ? std::numeric_limits<Nanos>::min() : column->lastTime();
        std::size_t first = 0;
        const auto storeUpTo = [&](std::size_t end) {
            const std::size_t count = end - first;
            column->append(std::span(m_slowTimes).subspan(first, count),
                std::span(m_slowValues).subspan(first, count), std::max(last + 1, m_streamEnd));
            first = end + 1;
        };
        for (std::size_t g = 0; g < block.slow.size(); ++g) {
            const std::int32_t code = block.slow[g].values[i];
            const double value =
                real ? double{std::bit_cast<float>(code)} : static_cast<double>(code);
            m_slowValues[g] = value;
            if (!std::isfinite(value)) {
                ++m_refused.notFinite;
                storeUpTo(g);
                column->breakHere();
            } else if (m_slowTimes[g] <= last) {
                ++m_refused.backwards;
                storeUpTo(g);
            } else {
                last = m_slowTimes[g];
            }
        }
        storeUpTo(block.slow.size());
        column->extendHold(m_streamEnd);
    }
}

void Capture::breakStream()
{
    for (Channel *channel : m_fast)
        channel->fast()->breakHere();
    for (Channel *channel : m_slow)
        channel->values()->breakHere();
}

void Capture::appendPolled(catalog::RegisterId id, std::string_view name, std::string_view unit,
    double seconds, double value, Asked why)
{
    if (!std::isfinite(value) || !std::isfinite(seconds)) {
        ++m_refused.notFinite;
        return;
    }
    std::optional<ChannelId> found = find(id, Kind::Polled);
    const bool anew = m_polledAnew.erase(id) > 0;
    if (found && (anew || info(*found)->unit != unit))
        found.reset();
    if (!found) {
        found = add({0, id, std::string(name), std::string(unit), 1.0, 0.0, Kind::Polled});
        entryOf(*found).touched = 0;
    }
    ValueColumn &column = *mutableChannel(*found)->values();
    const Nanos time = toNanos(seconds);
    if (!column.empty()) {
        if (time <= column.lastTime()) {
            ++m_refused.backwards;
            return;
        }
        if (time > column.runs().back().holdUntil)
            column.breakHere();
    }
    column.append(time, value, time + toNanos(m_config.polledHold));
    ++m_revision;
    if (why == Asked::AsSignal)
        entryOf(*found).touched = m_revision;
    if (++m_sinceCheck >= kSamplesBetweenChecks)
        keepWithinLimit();
}

void Capture::endPolled(catalog::RegisterId id)
{
    if (const auto found = find(id, Kind::Polled))
        mutableChannel(*found)->values()->endHere();
}

void Capture::endPolledForGood(catalog::RegisterId id)
{
    endPolled(id);
    m_polledAnew.insert(id);
}

ChannelId Capture::addImported(std::string name, std::string unit, catalog::RegisterId id)
{
    id = id != 0 ? std::max(id, kFirstOwnRegister) : kImportedRegister + m_nextId;
    return add({0, id, std::move(name), std::move(unit), 1.0, 0.0, Kind::Slow});
}

void Capture::appendImported(
    ChannelId id, std::span<const Nanos> times, std::span<const double> values, Nanos holdUntil)
{
    Channel *channel = mutableChannel(id);
    ValueColumn *column = channel ? channel->values() : nullptr;
    if (!column || times.empty() || (!column->empty() && times.front() <= column->lastTime())) {
        m_refused.backwards += times.size();
        return;
    }
    column->append(times, values, holdUntil);
    ++m_revision;
    m_sinceCheck += times.size();
    if (m_sinceCheck >= kSamplesBetweenChecks)
        keepWithinLimit();
}

void Capture::breakImported(ChannelId id)
{
    Channel *channel = mutableChannel(id);
    if (ValueColumn *column = channel ? channel->values() : nullptr)
        column->breakHere();
}

void Capture::keepNewest(ChannelId id, std::uint64_t most)
{
    Channel *channel = mutableChannel(id);
    while (channel && channel->size() > most && channel->canRelease())
        channel->releaseOldest();
}

void Capture::removeImported(ChannelId id)
{
    const Channel *found = channel(id);
    if (!found || found->info().isBoards())
        return;
    std::erase_if(m_entries, [id](const Entry &entry) { return entry.channel->info().id == id; });
    ++m_revision;
}

void Capture::clear()
{
    m_entries.clear();
    m_streamEnd = std::numeric_limits<Nanos>::min();
    makeStreamChannels();
    m_sinceCheck = 0;
    m_released = 0;
    forgetDeposits();
    m_archiveMost = kNoLimit;
    ++m_revision;
}

void Capture::adopt(Capture other)
{
    m_layout = {};
    clear();
    other.adoptArchived();
    other.forgetDeposits();
    const std::vector<Entry> entries = std::move(other.m_entries);
    for (const Entry &entry : entries) {
        const std::uint64_t touched = entry.touched != 0 ? m_revision + entry.touched : 0;
        m_entries.push_back({std::make_unique<Channel>(*entry.channel, m_nextId++), touched});
    }
    m_revision += other.m_revision + 1;
    m_streamEnd = other.m_streamEnd;
    m_released = other.m_released;
    m_shift = 0;
}

std::vector<ChannelInfo> Capture::channels() const
{
    std::vector<ChannelInfo> result;
    result.reserve(m_entries.size());
    for (const Entry &entry : m_entries)
        result.push_back(entry.channel->info());
    return result;
}

const Channel *Capture::channel(ChannelId id) const
{
    // Ids rise with the position.
    const auto entry = std::ranges::lower_bound(
        m_entries, id, {}, [](const Entry &e) { return e.channel->info().id; });
    const bool there = entry != m_entries.end() && entry->channel->info().id == id;
    return there ? entry->channel.get() : nullptr;
}

Capture::Entry &Capture::entryOf(ChannelId id)
{
    return *std::ranges::find_if(
        m_entries, [id](const Entry &entry) { return entry.channel->info().id == id; });
}

std::optional<ChannelInfo> Capture::info(ChannelId id) const
{
    const Channel *found = channel(id);
    return found ? std::optional(found->info()) : std::nullopt;
}

std::optional<ChannelId> Capture::find(catalog::RegisterId id) const
{
    const Entry *best = nullptr;
    const auto rank = [](const Entry &entry) {
        return std::pair(!entry.channel->empty(), entry.touched);
    };
    for (const Entry &entry : m_entries) {
        if (entry.channel->info().registerId == id && (!best || rank(entry) > rank(*best)))
            best = &entry;
    }
    return best ? std::optional(best->channel->info().id) : std::nullopt;
}

std::optional<ChannelId> Capture::find(catalog::RegisterId id, Kind kind) const
{
    const Entry *best = nullptr;
    for (const Entry &entry : m_entries) {
        const ChannelInfo &info = entry.channel->info();
        // Values that are read aside touch no channel: they go into the last one that was made.
        if (info.registerId == id && info.kind == kind
            && (!best || kind == Kind::Polled || entry.touched >= best->touched))
            best = &entry;
    }
    return best ? std::optional(best->channel->info().id) : std::nullopt;
}

std::vector<ChannelId> Capture::streaming() const
{
    std::vector<ChannelId> result;
    for (const auto *channels : {&m_fast, &m_slow}) {
        for (const Channel *channel : *channels)
            result.push_back(channel->info().id);
    }
    return result;
}

std::uint64_t Capture::size(ChannelId id) const
{
    const Channel *found = channel(id);
    return found ? found->size() : 0;
}

std::optional<TimeSpan> Capture::timeSpan() const
{
    std::optional<TimeSpan> all;
    for (const Entry &entry : m_entries) {
        const auto one = entry.channel->timeSpan();
        if (one && all)
            all = TimeSpan{std::min(all->from, one->from), std::max(all->to, one->to)};
        else if (one)
            all = one;
    }
    return all;
}

std::optional<TimeSpan> Capture::timeSpan(ChannelId id) const
{
    const Channel *found = channel(id);
    return found ? found->timeSpan() : std::nullopt;
}

std::vector<MinMax> Capture::columns(ChannelId id, double from, double to, std::size_t count) const
{
    const Channel *found = channel(id);
    return found ? found->columns(from, to, count) : std::vector<MinMax>(count);
}

MinMax Capture::extremes(ChannelId id, double from, double to) const
{
    const Channel *found = channel(id);
    return found ? found->extremes(from, to) : MinMax{};
}

std::optional<double> Capture::valueAt(ChannelId id, double time) const
{
    const Channel *found = channel(id);
    return found ? found->valueAt(time) : std::nullopt;
}

std::optional<double> Capture::lastValue(ChannelId id) const
{
    const Channel *found = channel(id);
    return found && !found->empty() ? std::optional(found->at(found->end() - 1)) : std::nullopt;
}

Snapshot Capture::snapshot(std::span<const ChannelId> ids) const
{
    auto copy = std::make_shared<std::vector<Channel>>();
    for (const ChannelId id : ids) {
        if (const Channel *found = channel(id))
            copy->push_back(*found);
    }
    return copy;
}

Capture excerptOf(const Capture &capture, Nanos from, Nanos to)
{
    Capture excerpt;
    for (const ChannelInfo &info : capture.channels()) {
        const Channel &channel = *capture.channel(info.id);
        const Index first = channel.atOrAfter(from), end = channel.atOrAfter(to);
        if (first >= end)
            continue;
        const ChannelId copy = excerpt.addImported(info.name, info.unit);
        for (Index at = first; at < end; ++at) {
            if (at > first && channel.holdUntil(at - 1) < channel.timeOf(at))
                excerpt.breakImported(copy);
            excerpt.appendImported(
                copy, channel.timeOf(at), channel.at(at), std::min(channel.holdUntil(at), to));
        }
    }
    return excerpt;
}

} // namespace capture

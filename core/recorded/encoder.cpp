#include "recorded/encoder.h"

#include "recorded/block.h"
#include "recorded/entry_codec.h"

#include <algorithm>

namespace recorded {

namespace {

using capture::SampleBlock;
using capture::StreamLayout;
using capture::Tick;

constexpr std::size_t kAround = 256; ///< bytes of a block of samples beside the fast ones
constexpr std::size_t kReserve = 256; ///< bytes of data in the place kept for the end
constexpr std::size_t kMostSampleBytes = kMostPayload / 2; ///< of one block that is added
constexpr std::size_t kMostDescribed = 4096; ///< registers that are described again
const Bytes kPadding{'R', 'S', 1, 0};

std::size_t slowWidth(const SampleBlock &block)
{
    return block.slow.empty() ? 0 : block.slow.front().values.size();
}

/// Bytes of the block in the file.
std::size_t bytesOf(const SampleBlock &block)
{
    return block.fast.size() * 2 + block.slow.size() * (8 + 4 * slowWidth(block));
}

} // namespace

Encoder::Encoder(Begin begin, Config config)
    : m_begin(std::move(begin))
    , m_config(config)
{
}

Block Encoder::head()
{
    Bytes head = fileHead(m_begin.startSeconds, m_begin.program);
    m_reserveAt = head.size();
    Bytes padding = kPadding;
    padding.resize(kReserve);
    emitPayload(0, padding, 0);
    emitEntry(0, m_begin);
    for (const Block &block : takeBlocks())
        head.insert(head.end(), block.bytes.begin(), block.bytes.end());
    m_sinceRepeat = 0;
    return {std::move(head), 0};
}

bool Encoder::add(Nanos at, const Entry &entry)
{
    if (const auto *block = std::get_if<SampleBlock>(&entry)) {
        if (bytesOf(*block) > kMostSampleBytes || !isWhole(*block))
            return false;
        m_overview.add(*block);
        addSamples(at, *block);
        return true;
    }
    if (const auto *link = std::get_if<LinkBytes>(&entry)) {
        addLink(at, *link);
        return true;
    }
    if (std::holds_alternative<StreamLayout>(entry))
        flushSamples(); // they belong to the layout before
    if (!emitEntry(at, entry))
        return false;
    remember(entry);
    return true;
}

void Encoder::remember(const Entry &entry)
{
    if (const auto *layout = std::get_if<StreamLayout>(&entry)) {
        m_layout = *layout;
        m_overview.begin(*layout);
    }
    const auto *polled = std::get_if<PolledRegister>(&entry);
    if (polled && m_polled.size() < kMostDescribed)
        m_polled[polled->id] = *polled;
}

/// Without a gap behind what was gathered, so that both are one column.
bool Encoder::continues(const SampleBlock &block) const
{
    if (!m_gathered || !m_layout || block.stream != m_gathered->stream || block.lostTicks != 0
        || block.count == 0 || block.fast.size() / block.count != m_columns.size()
        || (!block.slow.empty() && !m_gathered->slow.empty()
            && slowWidth(block) != slowWidth(*m_gathered)))
        return false;
    const Tick step = m_layout->fastStep;
    return block.firstTick == m_gathered->firstTick + Tick{m_gathered->count} * step;
}

void Encoder::addSamples(Nanos at, const SampleBlock &block)
{
    if (!continues(block))
        flushSamples();
    if (!m_gathered) {
        m_gathered = SampleBlock{};
        m_gathered->stream = block.stream;
        m_gathered->firstTick = block.firstTick;
        m_gathered->lostTicks = block.lostTicks;
        m_columns.resize(block.count > 0 ? block.fast.size() / block.count : 0);
        m_gatheredSince = at;
    }
    m_gatheredBytes += bytesOf(block);
    for (std::size_t s = 0; s < m_columns.size(); ++s) {
        const auto begin = block.fast.begin() + static_cast<std::ptrdiff_t>(s * block.count);
        m_columns[s].insert(m_columns[s].end(), begin, begin + block.count);
    }
    m_gathered->count += block.count;
    m_gathered->slow.insert(m_gathered->slow.end(), block.slow.begin(), block.slow.end());
    if (m_gatheredBytes >= m_config.blockBytes || block.count == 0)
        flushSamples();
}

void Encoder::flushSamples()
{
    if (!m_gathered)
        return;
    const std::uint64_t samples =
        samplesOf(*m_gathered) + std::uint64_t{m_gathered->count} * m_columns.size();
    repeatWhereDue(m_gatheredSince);
    emitPayload(m_gatheredSince, encodeSamples(*m_gathered, m_columns, kAround), samples);
    for (std::vector<std::int16_t> &column : m_columns)
        column.clear();
    m_gathered.reset();
    m_gatheredBytes = 0;
}

void Encoder::addLink(Nanos at, const LinkBytes &link)
{
    if (m_link && m_link->what.direction != link.direction)
        flushLink();
    for (ByteView rest(link.bytes); !rest.empty();) {
        if (!m_link)
            m_link = GatheredLink{at, {link.direction, {}}};
        Bytes &bytes = m_link->what.bytes;
        const std::size_t count = std::min(m_config.linkBytes - bytes.size(), rest.size());
        bytes.insert(bytes.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count));
        rest = rest.subspan(count);
        if (bytes.size() >= m_config.linkBytes)
            flushLink();
    }
}

void Encoder::flushLink()
{
    if (!m_link)
        return;
    GatheredLink link = std::move(*m_link);
    m_link.reset();
    const BlockHead head{
        Interface::Link, link.since, static_cast<std::uint32_t>(link.what.direction), m_number, 0};
    push(packetBlock(head, std::move(link.what.bytes)), 0);
}

void Encoder::flush(Nanos now)
{
    if (m_gathered && now - m_gatheredSince >= m_config.gatherSamples)
        flushSamples();
    if (m_link && now - m_link->since >= m_config.gatherLink)
        flushLink();
}

void Encoder::flushAll()
{
    flushSamples();
    flushLink();
}

std::optional<Nanos> Encoder::due() const
{
    std::optional<Nanos> due;
    if (m_gathered)
        due = m_gatheredSince + m_config.gatherSamples;
    if (m_link)
        due = std::min(
            due.value_or(m_link->since + m_config.gatherLink), m_link->since + m_config.gatherLink);
    return due;
}

void Encoder::addOverview(Nanos at)
{
    constexpr std::size_t kShare = 100;
    flushAll();
    for (const Overview &overview : m_overview.take(m_bytes / kShare))
        if (const auto payload = encodeOverview(overview))
            emitPayload(at, *payload, 0);
}

void Encoder::end(Nanos at, End end)
{
    flushAll();
    end.blocks = m_number;
    end.samples = m_samples;
    emitEntry(at, end);
}

Encoder::Overwrite Encoder::endInReserve(Nanos at, End end) const
{
    end.blocks = m_number;
    end.samples = m_samples;
    constexpr std::size_t kLongestText = 200;
    end.text.resize(std::min(end.text.size(), kLongestText));
    Bytes payload = encodeEntry(end).value_or(kPadding);
    payload.resize(kReserve);
    return {m_reserveAt, packetBlock({Interface::Entries, at, 0, 0, 0}, payload)};
}

bool Encoder::emitEntry(Nanos at, const Entry &entry)
{
    auto payload = encodeEntry(entry);
    if (!payload)
        return false;
    if (std::holds_alternative<PolledValues>(entry))
        repeatWhereDue(at);
    emitPayload(at, std::move(*payload), 0);
    return true;
}

/// What samples and values are, for readers that come in behind damage.
void Encoder::repeatWhereDue(Nanos at)
{
    if (m_sinceRepeat < m_config.repeatBytes)
        return;
    m_sinceRepeat = 0;
    const auto repeat = [&](const Entry &entry) {
        if (auto payload = encodeEntry(entry, Repeat::Yes))
            emitPayload(at, std::move(*payload), 0);
    };
    if (m_layout)
        repeat(*m_layout);
    for (const auto &[id, polled] : m_polled)
        repeat(polled);
}

void Encoder::emitPayload(Nanos at, Bytes payload, std::uint64_t samples)
{
    push(packetBlock({Interface::Entries, at, 0, m_number, 0}, std::move(payload)), samples);
}

void Encoder::push(Bytes bytes, std::uint64_t samples)
{
    ++m_number;
    m_samples += samples;
    m_sinceRepeat += bytes.size();
    m_bytes += bytes.size();
    m_blocks.push_back({std::move(bytes), samples});
}

} // namespace recorded

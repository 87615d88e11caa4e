#include "mcp/datalog_decoder.h"

#include <algorithm>

namespace mcp {
namespace {

constexpr std::size_t kMaxKnown = 8; ///< configurations that can be in flight at once
constexpr double kBelievedJump = 10.0; ///< seconds

bool isUnsigned(const std::vector<bool> &list, std::size_t index)
{
    return index < list.size() && list[index];
}

std::int32_t slowValue(RegisterId id, bool unsignedValue, ByteReader &reader)
{
    switch (scalarWidth(id.type())) {
    case 1:
        return unsignedValue ? std::int32_t{reader.u8()} : reader.s8();
    case 2:
        return unsignedValue ? std::int32_t{reader.u16()} : reader.s16();
    case 4:
        return reader.s32();
    default:
        return 0; // texts and raw values take no room in a packet
    }
}

void readGroup(capture::SlowGroup &group, const DatalogConfig &config, const Signedness &signedness,
    ByteView bytes)
{
    group.values.resize(config.slow.size());
    ByteReader reader(bytes);
    for (std::size_t i = 0; i < config.slow.size(); ++i)
        group.values[i] = slowValue(config.slow[i], isUnsigned(signedness.slowUnsigned, i), reader);
}

/// Samples as packets interleave them, block after block, to columns, signal after signal.
/// @param to  the first sample of signal 0; that of signal s is at to + s * pitch
void toColumns(
    ByteView from, std::size_t signals, std::size_t blocks, std::int16_t *to, std::size_t pitch)
{
    for (std::size_t s = 0; s < signals; ++s) {
        const std::uint8_t *in = from.data() + 2 * s;
        for (std::size_t i = 0; i < blocks; ++i, in += 2 * signals)
            to[s * pitch + i] = static_cast<std::int16_t>(in[0] | in[1] << 8);
    }
}

std::uint32_t timestampOf(ByteView payload) { return ByteReader(payload).u32(); }

/// Where the blocks of a packet are, between its timestamp and its mark.
struct Walk {
    const DatalogConfig &config;
    const DatalogLayout &layout;
    const Signedness &signedness;
    ByteView payload;
    std::size_t blocks;
    bool endGroup;

    void into(capture::SampleBlock &block) const
    {
        const std::size_t signals = config.fast.size();
        const bool groups = layout.blocksAGroup() > 0;
        const std::size_t period = groups ? layout.blocksAGroup() : blocks;
        block.slow.resize((groups ? blocks / period : 0) + (endGroup ? 1 : 0));
        auto group = block.slow.begin();
        std::size_t at = sizeof(std::uint32_t);
        for (std::size_t done = 0; done < blocks;) {
            const std::size_t run = std::min(period, blocks - done);
            if (signals > 0)
                toColumns(payload.subspan(at), signals, run, block.fast.data() + done, blocks);
            at += run * layout.fastBytes();
            done += run;
            if (groups && run == period)
                at += accept(block, *group++, at, done);
        }
        if (endGroup)
            accept(block, *group, at, blocks);
    }

    /// The MF group at `at`, which follows block `done` - 1.
    std::size_t accept(const capture::SampleBlock &block, capture::SlowGroup &group, std::size_t at,
        std::size_t done) const
    {
        const auto after = static_cast<capture::Tick>(done > 0 ? done - 1 : 0);
        group.tick = block.firstTick + after * layout.step();
        readGroup(group, config, signedness, payload.subspan(at, layout.slowBytes()));
        return layout.slowBytes();
    }
};

} // namespace

bool decodeBlocks(const DatalogConfig &config, const DatalogLayout &layout,
    const Signedness &signedness, ByteView payload, capture::SampleBlock &block)
{
    const std::optional<std::size_t> blocks = layout.blocksIn(payload.size());
    if (!blocks)
        return false;
    block.lostTicks = 0;
    block.firstTick = timestampOf(payload);
    block.count = config.fast.empty() ? 0 : static_cast<std::uint32_t>(*blocks);
    block.fast.resize(config.fast.size() * *blocks);
    const bool endGroup = layout.endsInGroup(payload.size()) && layout.slowBytes() > 0;
    Walk{config, layout, signedness, payload, *blocks, endGroup}.into(block);
    for (std::size_t s = 0; s < config.fast.size(); ++s) {
        if (isUnsigned(signedness.fastUnsigned, s))
            std::for_each_n(block.fast.begin() + static_cast<std::ptrdiff_t>(s * *blocks), *blocks,
                [](std::int16_t &sample) {
                    sample = static_cast<std::int16_t>(sample ^ INT16_MIN);
                });
    }
    return true;
}

DatalogDecoder::DatalogDecoder(double tickHz)
    : m_tickHz(tickHz)
{
}

void DatalogDecoder::expect(
    capture::StreamId stream, const DatalogConfig &config, Signedness signedness)
{
    std::erase_if(
        m_known, [&config](const Known &known) { return known.config.mark == config.mark; });
    if (m_known.size() == kMaxKnown)
        m_known.erase(m_known.begin());
    m_known.push_back({stream, config, DatalogLayout(config), std::move(signedness)});
}

DatalogDecoder::Known *DatalogDecoder::find(std::uint8_t mark)
{
    const auto it = std::ranges::find_if(
        m_known, [mark](const Known &known) { return known.config.mark == mark; });
    return it == m_known.end() ? nullptr : &*it;
}

std::optional<capture::SampleBlock> DatalogDecoder::decode(ByteView payload)
{
    capture::SampleBlock block;
    return decode(payload, block) ? std::optional(std::move(block)) : std::nullopt;
}

bool DatalogDecoder::decode(ByteView payload, capture::SampleBlock &block)
{
    if (payload.size() < kDatalogOverhead) {
        ++m_stats.badLength;
        return false;
    }
    if (payload.back() != 0) {
        ++m_stats.otherId;
        return false;
    }
    Known *known = find(payload[payload.size() - 2]);
    if (!known) {
        ++m_stats.unknownMark;
        return false;
    }
    const auto full = known->layout.fullLength();
    if (!full || payload.size() > *full
        || !decodeBlocks(known->config, known->layout, known->signedness, payload, block)) {
        ++m_stats.badLength;
        return false;
    }
    const auto ticks = known->layout.blocksIn(payload.size()).value_or(block.count);
    if (!place(block, timestampOf(payload), *known, block.count > 0 ? block.count : ticks)) {
        ++m_stats.badTime;
        return false;
    }
    block.stream = known->stream;
    m_stats.lostTicks += static_cast<std::uint64_t>(block.lostTicks);
    ++m_stats.packets;
    forgetOlderThan(*known);
    return true;
}

bool DatalogDecoder::place(
    capture::SampleBlock &block, std::uint32_t timestamp, const Known &known, std::size_t blocks)
{
    const std::uint32_t after =
        timestamp + static_cast<std::uint32_t>(blocks * known.layout.step());
    const auto farJump = static_cast<std::int64_t>(kBelievedJump * m_tickHz);
    const bool sameStream = m_lastStream == known.stream;
    const bool first = !m_clock.has_value();
    if (first)
        m_clock = Clock{timestamp, timestamp};
    const std::int64_t jump = static_cast<std::int32_t>(timestamp - m_clock->expected);
    // A new stream may begin any time after the last one; within a stream time goes on, by whole steps.
    const bool strange =
        jump < 0 || (sameStream && (jump > farJump || jump % known.layout.step() != 0));
    if (strange) {
        const std::int64_t fromDoubt =
            m_doubtful ? static_cast<std::int32_t>(timestamp - *m_doubtful) : -1;
        if (fromDoubt < 0 || fromDoubt > farJump) {
            m_doubtful = after;
            return false;
        }
        if (jump < 0) { // it did begin anew
            m_clock = Clock{timestamp, timestamp};
            ++m_stats.timeRestarts;
            ++m_epoch;
        }
    }
    m_doubtful.reset();
    const std::int64_t gap = strange && jump < 0 ? 0 : jump;
    const capture::Tick tick = m_clock->tick + gap;
    for (capture::SlowGroup &group : block.slow)
        group.tick += tick - block.firstTick;
    block.firstTick = tick;
    block.lostTicks = sameStream && !first ? gap : 0;
    m_clock = Clock{after, tick + static_cast<std::int64_t>(blocks * known.layout.step())};
    m_lastStream = known.stream;
    return true;
}

void DatalogDecoder::forgetOlderThan(const Known &known)
{
    const auto index = &known - m_known.data();
    m_known.erase(m_known.begin(), m_known.begin() + index);
}

} // namespace mcp

// P8: bytes of the line to samples in the store (framing, CRC, de-interleaving, envelope), against a copy of the same
// bytes and against a decoder of another program's style.
#include "aspep/framer.h"
#include "base/crc.h"
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "mcp/datalog_decoder.h"

#include <array>
#include <cstring>
#include <deque>

namespace {

using namespace bench;

constexpr std::size_t kPackets = 24000; ///< 49 MB: more than a cache holds, as a recording is
constexpr std::size_t kPayload = 2048;

/// Eight fast signals and two slow ones every 20th block, as on the line.
struct Line {
    mcp::DatalogConfig config;
    Bytes bytes;
    std::size_t samples = 0;

    Line()
    {
        using mcp::RegisterType;
        config.bufferSize = kPayload;
        config.mark = 1;
        for (unsigned s = 0; s < kSignals; ++s)
            config.fast.push_back(mcp::registerId(20 + s, RegisterType::Bits16, 1));
        config.slowRate = 19;
        config.slow = {mcp::registerId(1, RegisterType::Bits32, 1),
            mcp::registerId(2, RegisterType::Bits16, 1)};
        const mcp::DatalogLayout layout(config);
        std::int64_t tick = 0;
        for (std::size_t p = 0; p < kPackets; ++p)
            tick = appendPacket(layout, tick);
    }

    std::int64_t appendPacket(const mcp::DatalogLayout &layout, std::int64_t tick)
    {
        const std::size_t length = *layout.fullLength();
        const auto header =
            aspep::encodeHeader(aspep::Data{false, static_cast<std::uint16_t>(length)});
        bytes.insert(bytes.end(), header.begin(), header.end());
        const std::size_t start = bytes.size();
        put(static_cast<std::uint64_t>(tick), 4);
        for (std::size_t block = 0; block < layout.fullBlocks(); ++block, ++tick) {
            for (int s = 0; s < kSignals; ++s)
                put(static_cast<std::uint16_t>(motorSample(s, tick)), 2);
            if ((block + 1) % layout.blocksAGroup() == 0)
                put(0x0102030405060708ULL, layout.slowBytes());
            samples += kSignals;
        }
        put(1, 1);
        put(0, 1);
        require(bytes.size() - start == length, "the packet is not as long as its layout says");
        const std::uint16_t crc = crc16Xmodem(ByteView(bytes).subspan(start));
        put(crc, 2);
        return tick;
    }
    void put(std::uint64_t value, std::size_t width)
    {
        for (std::size_t i = 0; i < width; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
};

/// Arenas that nobody holds any more are handed out again: pages that are there, as those of the copy are.
class WarmMemory : public capture::SampleMemory {
protected:
    std::shared_ptr<std::byte> makeArena() override
    {
        for (const auto &arena : m_arenas) {
            if (arena.use_count() == 1)
                return arena;
        }
        m_arenas.push_back(capture::SampleMemory::makeArena());
        return m_arenas.back();
    }

private:
    std::vector<std::shared_ptr<std::byte>> m_arenas;
};

/// All of the bytes into the store; returns how many samples arrived.
/// @param memory  of the samples; none: fresh
std::uint64_t decode(const Line &line, const std::shared_ptr<capture::SampleMemory> &memory = {})
{
    aspep::Framer framer;
    aspep::Framer::Limits limits;
    limits.dataCrc = true;
    framer.setLimits(limits);
    mcp::DatalogDecoder decoder(kTickHz);
    decoder.expect(1, line.config);
    capture::Capture store({.memory = memory});
    capture::StreamLayout layout = motorLayout();
    layout.slow.resize(2);
    store.begin(layout);
    constexpr std::size_t kRead = 4096; // as a port hands them over
    aspep::Packet packet;
    capture::SampleBlock block; // used again: nothing is allocated for a packet
    for (std::size_t at = 0; at < line.bytes.size(); at += kRead) {
        ByteView bytes(line.bytes.data() + at, std::min(kRead, line.bytes.size() - at));
        while (framer.next(bytes, packet) == aspep::Framer::Step::Packet) {
            if (decoder.decode(packet.payload, block))
                store.append(block);
        }
    }
    std::uint64_t samples = 0;
    for (const capture::ChannelId id : store.streaming()) {
        if (store.info(id)->kind == capture::ChannelInfo::Kind::Fast)
            samples += store.size(id);
    }
    return samples;
}

/// One byte at a time through a state machine, a table CRC, and each value popped off the front of a queue into a
/// vector of doubles: how tools do it that were written for a few hundred values a second.
std::size_t decodeByteWise(const Line &line, const mcp::DatalogLayout &layout)
{
    std::vector<std::vector<double>> signals(kSignals);
    std::deque<std::uint8_t> queue;
    const std::size_t length = *layout.fullLength();
    std::size_t state = 0;
    std::array<std::uint16_t, 256> table{};
    for (unsigned i = 0; i < 256; ++i) {
        unsigned bits = i << 8;
        for (int k = 0; k < 8; ++k)
            bits = bits << 1 ^ ((bits & 0x8000U) != 0 ? 0x1021U : 0U);
        table[i] = static_cast<std::uint16_t>(bits);
    }
    std::uint16_t crc = 0;
    for (const std::uint8_t byte : line.bytes) {
        if (state >= 4 && state < 4 + length) {
            queue.push_back(byte);
            crc = static_cast<std::uint16_t>(crc << 8 ^ table[(crc >> 8) ^ byte]);
        }
        if (++state < 4 + length + 2)
            continue;
        state = 0;
        benchmark::DoNotOptimize(crc);
        crc = 0;
        const auto pop16 = [&queue] {
            const int low = queue.front();
            queue.pop_front();
            const int high = queue.front();
            queue.pop_front();
            return double(static_cast<std::int16_t>(low | high << 8));
        };
        pop16();
        pop16();
        for (std::size_t block = 0; block < layout.fullBlocks(); ++block) {
            for (auto &signal : signals)
                signal.push_back(pop16());
            for (std::size_t i = 0;
                 (block + 1) % layout.blocksAGroup() == 0 && i < layout.slowBytes(); ++i)
                queue.pop_front();
        }
        queue.clear();
    }
    std::size_t samples = 0;
    for (const auto &signal : signals)
        samples += signal.size();
    return samples;
}

const Line &line()
{
    static const Line made;
    return made;
}

void decodeAgainstMemcpy(benchmark::State &state)
{
    const Line &l = line();
    Bytes copy(l.bytes.size());
    const auto warm = std::make_shared<WarmMemory>();
    require(decode(l, warm) == l.samples, "samples were lost on the way");
    const Pair pair = pairedRatio(
        state,
        [&] {
            std::memcpy(copy.data(), l.bytes.data(), l.bytes.size());
            benchmark::DoNotOptimize(copy.data());
            benchmark::ClobberMemory();
        },
        [&] { benchmark::DoNotOptimize(decode(l, warm)); });
    state.counters["ns_per_sample"] = pair.bSeconds * 1e9 / double(l.samples);
    report({"P8", "bytes to samples with CRC and envelope: times the cost", pair.ratio, "<= 7",
        "memcpy of the same bytes, both into warm pages"});
}

void decodeAgainstByteWise(benchmark::State &state)
{
    const Line &l = line();
    const mcp::DatalogLayout layout(l.config);
    require(decodeByteWise(l, layout) == l.samples, "the stand-in loses samples");
    const Pair pair = pairedRatio(
        state, [&] { benchmark::DoNotOptimize(decode(l)); },
        [&] { benchmark::DoNotOptimize(decodeByteWise(l, layout)); });
    report({"P8", "bytes to samples: times faster", pair.ratio, ">= 15",
        "byte-wise state machine and queue, style of vesc_tool"});
}

} // namespace

BENCHMARK(decodeAgainstMemcpy)->Iterations(15)->UseManualTime();
BENCHMARK(decodeAgainstByteWise)->Iterations(5)->UseManualTime();

// P8: bytes of the line to samples in the store (framing, de-interleaving, envelope), against a copy of the same
// bytes and against a decoder of another program's style.
#include "aspep/framer.h"
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "mcp/datalog_decoder.h"

#include <QByteArray>
#include <QList>

#include <array>
#include <cstring>
#include <memory>

namespace {

using namespace bench;

constexpr std::size_t kPackets = 24000; ///< 49 MB: more than a cache holds, as a recording is
constexpr std::size_t kPayload = 2048;
constexpr std::size_t kRead = 4096; ///< bytes, as a port hands them over

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
        return tick;
    }
    void put(std::uint64_t value, std::size_t width)
    {
        for (std::size_t i = 0; i < width; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
};

/// Arenas that are not held any more are given out again: pages that are there, as those of the copy are.
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
/// @param piece   bytes at a time
/// @param memory  of the samples; none: fresh
std::uint64_t decode(
    const Line &line, std::size_t piece, const std::shared_ptr<capture::SampleMemory> &memory = {})
{
    aspep::Framer framer;
    mcp::DatalogDecoder decoder(kTickHz);
    decoder.expect(1, line.config);
    capture::Capture store({.memory = memory});
    capture::StreamLayout layout = motorLayout();
    layout.slow.resize(2);
    store.begin(layout);
    aspep::Packet packet;
    capture::SampleBlock block; // used again: nothing is allocated for a packet
    for (std::size_t at = 0; at < line.bytes.size(); at += piece) {
        ByteView bytes(line.bytes.data() + at, std::min(piece, line.bytes.size() - at));
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

/// How vesc_tool takes a stream apart (what its Packet and VByteArray do), on our packets: byte by byte into a buffer,
/// with a count of what is still missing; a whole packet is copied; each value is taken off the front of the copy and
/// divided by its scale. The sum that vesc_tool's packets carry is left out, as ours carry none.
class ByteWiseDecoder {
public:
    explicit ByteWiseDecoder(const mcp::DatalogLayout &layout)
        : m_layout(layout)
        , m_signals(kSignals)
    {
    }

    void accept(ByteView bytes)
    {
        QList<QByteArray> packets;
        for (const std::uint8_t byte : bytes) {
            makeRoom();
            m_buffer[m_end++] = byte;
            if (m_missing > 1)
                --m_missing;
            else
                look(packets);
        }
        for (const QByteArray &packet : packets)
            takeApart(packet);
    }

    std::size_t samples() const
    {
        std::size_t count = 0;
        for (const auto &signal : m_signals)
            count += static_cast<std::size_t>(signal.size());
        return count;
    }

private:
    static constexpr std::size_t kHeader = 4;

    std::size_t held() const { return m_end - m_begin; }

    /// Before every byte; what waits moves to the front when the buffer's end is reached.
    void makeRoom()
    {
        if (held() == m_buffer.size()) {
            m_begin = m_end = 0;
        } else if (m_end == m_buffer.size()) {
            std::memmove(m_buffer.data(), m_buffer.data() + m_begin, held());
            m_end = held();
            m_begin = 0;
        }
    }

    /// What is there may be a header, or a packet.
    void look(QList<QByteArray> &packets)
    {
        const std::uint8_t *const packet = m_buffer.data() + m_begin;
        const std::size_t length =
            held() < kHeader ? 0 : packet[0] >> 4 | packet[1] << 4 | (packet[2] & 1) << 12;
        const std::size_t wanted = held() < kHeader ? kHeader : kHeader + length;
        m_missing = wanted - held();
        if (m_missing > 0)
            return;
        const std::uint8_t *const payload = packet + kHeader;
        packets.append(QByteArray(reinterpret_cast<const char *>(payload), qsizetype(length)));
        m_begin = m_end = 0;
    }

    static double pop16(QByteArray &bytes, double scale)
    {
        if (bytes.size() < 2)
            return 0;
        const int value = quint8(bytes.at(0)) | quint8(bytes.at(1)) << 8;
        bytes.remove(0, 2);
        return static_cast<std::int16_t>(value) / scale;
    }

    void takeApart(QByteArray bytes)
    {
        bytes.remove(0, 4);
        for (std::size_t block = 0; block < m_layout.fullBlocks(); ++block) {
            for (auto &signal : m_signals)
                signal.append(pop16(bytes, 10.0));
            if ((block + 1) % m_layout.blocksAGroup() == 0)
                bytes.remove(0, qsizetype(m_layout.slowBytes()));
        }
    }

    const mcp::DatalogLayout &m_layout;
    QList<QList<double>> m_signals;
    std::array<std::uint8_t, 16384> m_buffer{}; ///< more than the longest packet
    std::size_t m_begin = 0, m_end = 0, m_missing = 0;
};

std::size_t decodeByteWise(const Line &line, const mcp::DatalogLayout &layout)
{
    const auto decoder = std::make_unique<ByteWiseDecoder>(layout);
    for (std::size_t at = 0; at < line.bytes.size(); at += kRead)
        decoder->accept(ByteView(line.bytes).subspan(at, std::min(kRead, line.bytes.size() - at)));
    return decoder->samples();
}

const Line &line()
{
    static const Line made;
    return made;
}

/// The same for the heap, where the chunks of slow signals are: pages below a block in use stay with the process.
class WarmHeap {
public:
    WarmHeap()
    {
        std::vector<Bytes> chunks;
        for (int i = 0; i < 128; ++i)
            chunks.emplace_back(std::size_t(1) << 16, std::uint8_t(1));
        m_last.assign(64, 1);
    }

private:
    Bytes m_last;
};

void decodeAgainstMemcpy(benchmark::State &state)
{
    const WarmHeap heap;
    const Line &l = line();
    Bytes copy(l.bytes.size());
    const auto warm = std::make_shared<WarmMemory>();
    const auto piece = static_cast<std::size_t>(state.range(0));
    require(decode(l, piece, warm) == l.samples, "samples were lost on the way");
    const Pair pair = pairedRatio(
        state,
        [&] {
            std::memcpy(copy.data(), l.bytes.data(), l.bytes.size());
            benchmark::DoNotOptimize(copy.data());
            benchmark::ClobberMemory();
        },
        [&] { benchmark::DoNotOptimize(decode(l, piece, warm)); });
    state.counters["ns_per_sample"] = pair.bSeconds * 1e9 / double(l.samples);
    const bool asAFile = piece > kRead; // as the goal was taken
    report({asAFile ? "P8 decode" : "P8",
        std::string("bytes to samples with envelope, ") + (asAFile ? "a mebibyte" : "4096 bytes")
            + " at a time",
        Measured::cost(pair), "memcpy of the same bytes, both into warm pages"});
}

/// Before each of the two: as much memory as the larger of them takes, so that a virtual machine's host has it to give.
void warmPages() { benchmark::DoNotOptimize(Bytes(std::size_t(256) << 20).data()); }

void decodeAgainstByteWise(benchmark::State &state)
{
    const Line &l = line();
    const mcp::DatalogLayout layout(l.config);
    require(decodeByteWise(l, layout) == l.samples, "the stand-in loses samples");
    const Pair pair = pairedRatio(
        state, [&] { benchmark::DoNotOptimize(decode(l, kRead)); },
        [&] { benchmark::DoNotOptimize(decodeByteWise(l, layout)); }, warmPages);
    report({"P8", "bytes to samples", Measured::faster(pair),
        "vesc_tool's way: byte by byte, values off the front of a QByteArray"});
}

} // namespace

BENCHMARK(decodeAgainstMemcpy)->Arg(1 << 20)->Arg(kRead)->Iterations(15)->UseManualTime();
BENCHMARK(decodeAgainstByteWise)->Iterations(5)->UseManualTime();

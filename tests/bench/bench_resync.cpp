// P9: noise on the line instead of packets: how fast it is got rid of, against the line's own speed and against another
// decoder's way, and whether the stream comes back behind it.
#include "aspep/framer.h"
#include "bench/paired.h"
#include "support/link_pair.h"

#include <array>
#include <deque>

namespace {

using namespace bench;
using namespace std::chrono_literals;

constexpr double kLine = 184'320.0; ///< bytes a second at 1.8432 Mbaud
constexpr std::size_t kNoise = std::size_t{4} << 20;
constexpr std::size_t kRead = 4096; ///< as a port hands them over

Bytes noise()
{
    support::Random random(9);
    Bytes bytes(kNoise);
    for (std::uint8_t &byte : bytes)
        byte = static_cast<std::uint8_t>(random.next());
    return bytes;
}

/// Out of step from the first header on, as on a line that fell out of step: every byte may begin a header.
std::size_t throughFramer(const Bytes &bytes)
{
    aspep::Framer framer;
    aspep::Packet packet;
    std::size_t packets = 0;
    for (std::size_t at = 0; at < bytes.size(); at += kRead) {
        ByteView piece = ByteView(bytes).subspan(at, std::min(kRead, bytes.size() - at));
        while (!piece.empty())
            packets += framer.next(piece, packet) == aspep::Framer::Step::Packet ? 1 : 0;
    }
    return packets;
}

/// Start byte, length, payload, CRC, stop byte; at the first that does not fit one byte is dropped and all that waits
/// is looked at again.
std::size_t throughByteWise(const Bytes &bytes)
{
    std::array<std::uint16_t, 256> table{};
    for (unsigned i = 0; i < 256; ++i) {
        unsigned bits = i << 8;
        for (int k = 0; k < 8; ++k)
            bits = bits << 1 ^ ((bits & 0x8000U) != 0 ? 0x1021U : 0U);
        table[i] = static_cast<std::uint16_t>(bits);
    }
    std::deque<std::uint8_t> queue;
    std::size_t packets = 0;
    const auto attempt = [&]() -> int { // bytes used; 0: more are needed; -1: none begins here
        if (queue[0] != 2 && queue[0] != 3)
            return -1;
        const std::size_t head = queue[0];
        if (queue.size() < head)
            return 0;
        const std::size_t length =
            head == 2 ? queue[1] : static_cast<std::size_t>(queue[1] << 8 | queue[2]);
        if (length == 0 || length > 512)
            return -1;
        if (queue.size() < head + length + 3)
            return 0;
        if (queue[head + length + 2] != 3)
            return -1;
        std::uint16_t crc = 0;
        for (std::size_t i = head; i < head + length; ++i)
            crc = static_cast<std::uint16_t>(crc << 8 ^ table[(crc >> 8) ^ queue[i]]);
        if (crc != (queue[head + length] << 8 | queue[head + length + 1]))
            return -1;
        return static_cast<int>(head + length + 3);
    };
    for (const std::uint8_t byte : bytes) {
        queue.push_back(byte);
        while (!queue.empty()) {
            const int used = attempt();
            if (used == 0)
                break;
            packets += used > 0 ? 1 : 0;
            queue.erase(queue.begin(), queue.begin() + std::max(used, 1));
        }
    }
    return packets;
}

void noiseThroughFramer(benchmark::State &state)
{
    const Bytes bytes = noise();
    require(throughFramer(bytes) == 0, "a packet was found where there is none");
    std::size_t found = 0;
    const Pair pair = pairedRatio(
        state, [&] { found += throughFramer(bytes); }, [&] { found += throughByteWise(bytes); });
    benchmark::DoNotOptimize(found);
    state.counters["MB_per_s"] = double(kNoise) / pair.aSeconds / 1e6;
    report({"P9 framer", "searching noise for headers", double(kNoise) / pair.aSeconds / kLine,
        "1.8432 Mbaud, 8N1"});
    report({"P9", "searching noise for headers: times faster", Measured::faster(pair),
        "byte-wise state machine that drops a byte and looks again, style of vesc_tool"});
}

/// A drive that streams, then noise in place of its board, then the board again.
void noiseThroughDrive(benchmark::State &state)
{
    support::Session session;
    require(session.ready, "the simulated board did not connect");
    std::uint64_t samples = 0;
    auto link = drive::LinkState::Connected;
    session.onEvent = [&](const drive::Event &event) {
        if (const auto *changed = std::get_if<drive::LinkChanged>(&event))
            link = changed->state;
        if (const auto *block = std::get_if<capture::SampleBlock>(&event))
            samples += block->count;
    };
    session.submit(
        drive::Stream{{session.id("I_A"), session.id("I_B"), session.id("I_Q_MEAS")}, 1, {}, 1});
    require(session.runUntil([&] { return samples > 1000; }, 2s), "nothing is streamed");
    const Bytes bytes = noise();
    const Duration pieceTime =
        std::chrono::duration_cast<Duration>(std::chrono::duration<double>(double(kRead) / kLine));
    // A link that is lost does not look at its bytes: what counts is what comes before.
    double used = 0.0, bytesThen = 0.0;
    double worstReturn = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        session.toDrive.cut = true;
        samples = 0;
        double round = 0.0;
        for (std::size_t at = 0; at < bytes.size(); at += kRead) {
            session.runFor(pieceTime);
            const double start = cpuSeconds();
            session.drive->receive(ByteView(bytes).subspan(at, kRead), session.now);
            const double took = cpuSeconds() - start;
            round += took;
            if (link != drive::LinkState::Lost) {
                used += took;
                bytesThen += double(std::min(kRead, bytes.size() - at));
            }
            session.exchange();
        }
        require(samples == 0, "samples were read out of noise");
        session.toDrive.cut = false;
        const TimePoint quiet = session.now;
        require(session.runUntil([&] { return samples > 1000; }, 5s),
            "the stream did not come back behind the noise");
        worstReturn = std::max(worstReturn, toSeconds(session.now - quiet));
        state.SetIterationTime(round);
    }
    state.counters["MB_per_s"] = bytesThen / used / 1e6;
    report({"P9 recovering", "noise through the drive while it recovers", bytesThen / used / kLine,
        "1.8432 Mbaud, 8N1"});
    report({"P9", "seconds from the end of the noise until samples come again, at worst",
        worstReturn, "virtual time"});
}

} // namespace

BENCHMARK(noiseThroughFramer)->Iterations(15)->UseManualTime();
BENCHMARK(noiseThroughDrive)->Iterations(3)->UseManualTime();

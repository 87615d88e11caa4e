// P13: how much faster than real time the simulated board is, with a running motor and four signals logged at the
// control rate.
#include "bench/paired.h"
#include "support/link_pair.h"

namespace {

using namespace bench;
using namespace std::chrono_literals;

constexpr Duration kPiece = 2s;
constexpr double kTicks = 16000.0 * toSeconds(kPiece);

/// A session whose motor runs and whose stream has begun.
struct Running : support::Session {
    Running()
    {
        require(ready, "the simulated board did not connect");
        require(runAt(1500), "the simulated motor did not run");
        submit(drive::Stream{
            {id("I_A"), id("I_B"), id("I_Q_MEAS"), id("STOPLL_ROT_SPEED")}, 1, {}, 1});
        onEvent = [this](const drive::Event &event) {
            if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
                samples += block->count;
                lost += static_cast<double>(block->lostTicks);
            }
        };
        runFor(200ms);
        samples = lost = 0.0;
    }
    double samples = 0.0, lost = 0.0;
};

void tell(
    benchmark::State &state, double virtualSeconds, double cpu, const char *goal, const char *what)
{
    const double ratio = virtualSeconds / cpu;
    state.counters["virtual_s_per_core_s"] = ratio;
    report({goal, what, ratio, "real time"});
}

/// The board alone: motor, firmware, datalog, line.
void simulatedBoard(benchmark::State &state)
{
    Running running;
    std::size_t bytes = 0;
    double cpu = 0.0, virtualSeconds = 0.0;
    TimePoint now = running.now;
    for ([[maybe_unused]] auto _ : state) {
        const double start = cpuSeconds();
        for (const TimePoint end = now + kPiece; now < end; now += 1ms) {
            running.board->advance(now);
            bytes += running.board->takeOutput().size();
        }
        const double used = cpuSeconds() - start;
        state.SetIterationTime(used);
        cpu += used;
        virtualSeconds += toSeconds(kPiece);
    }
    constexpr double kBytesASample = 8.0;
    require(static_cast<double>(bytes) > 0.9 * kBytesASample * 16000.0 * virtualSeconds,
        "the simulated board did not log");
    tell(state, virtualSeconds, cpu, "P13 board", "a running motor, 4 signals at 16 kHz");
}

/// The same with our drive at the other end of the line.
void simulatedBoardAndDrive(benchmark::State &state)
{
    Running running;
    double cpu = 0.0, virtualSeconds = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        running.samples = 0.0;
        const double start = cpuSeconds();
        running.runFor(kPiece);
        const double used = cpuSeconds() - start;
        state.SetIterationTime(used);
        cpu += used;
        virtualSeconds += toSeconds(kPiece);
        require(running.samples > 0.95 * kTicks && running.lost == 0.0, "samples were lost");
    }
    tell(state, virtualSeconds, cpu, "P13 drive", "the same with our drive connected");
}

} // namespace

BENCHMARK(simulatedBoard)->Iterations(5)->UseManualTime();
BENCHMARK(simulatedBoardAndDrive)->Iterations(5)->UseManualTime();

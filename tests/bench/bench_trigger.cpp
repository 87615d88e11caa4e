// N17: the search for an edge with hysteresis through a whole recording, against a plain scan of the same codes.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "scope/trigger_search.h"

#include <random>

namespace {

using namespace bench;
using capture::Index;
using capture::Nanos;

constexpr std::size_t kSamples = 100'000'000;
constexpr Nanos kHoldOff = 100'000'000; // a record of 100 ms
constexpr Index kHoldOffSamples = 2000; // at 20 kHz

enum Signal : int { Rare, Current, Noise };

/// One fast channel: a bus voltage with a dip every million samples, a phase current, or noise around the level.
capture::Channel record(int signal)
{
    capture::Channel channel({1, 7, "F", "A", 1.0, 0.0, capture::ChannelInfo::Kind::Fast});
    std::vector<std::int16_t> codes = motorSignal(0, 1'000'000);
    std::mt19937 random(1);
    for (std::size_t i = 0; i < codes.size() && signal != Current; ++i) {
        codes[i] = static_cast<std::int16_t>(random() % 2001 - 1000);
        if (signal == Rare)
            codes[i] = static_cast<std::int16_t>(i % 1'000'000 == 500'000 ? 6000 : codes[i] / 4);
    }
    for (std::size_t done = 0; done < kSamples; done += codes.size())
        channel.fast()->append(
            capture::TickBase::of(kTickHz, 0), static_cast<capture::Tick>(done), 1, codes);
    return channel;
}

/// Sample by sample, with the thresholds known: what every search without an envelope does at least.
std::size_t scan(const capture::Channel &channel, int level, int arm)
{
    std::size_t hits = 0;
    bool armed = false;
    Index from = 0;
    for (Index next = 0; next < channel.end();) {
        const auto codes = channel.fast()->codes(next, kSamples);
        for (std::size_t i = 0; i < codes.size(); ++i) {
            if (!armed) {
                armed = codes[i] < arm;
            } else if (codes[i] >= level) {
                armed = false;
                if (next + i >= from) {
                    ++hits;
                    from = next + i + kHoldOffSamples;
                }
            }
        }
        next += codes.size();
    }
    return hits;
}

std::size_t search(const capture::Channel &channel, int level, int arm)
{
    scope::TriggerCondition condition;
    condition.what = scope::EdgeTrigger{scope::Slope::Rising, double(level), double(level - arm)};
    scope::TriggerSearch search(condition);
    std::size_t hits = 0;
    Nanos from = 0;
    while (const auto hit = search.next(channel, from)) {
        ++hits;
        from = hit->time + kHoldOff;
    }
    return hits;
}

void triggerAgainstScan(benchmark::State &state)
{
    const auto signal = static_cast<Signal>(state.range(0));
    const int level = signal == Rare ? 5000 : 100;
    const int arm = signal == Rare ? 4000 : signal == Noise ? 50 : 0;
    const capture::Channel channel = record(signal);
    const std::size_t wanted = scan(channel, level, arm);
    const std::size_t found = search(channel, level, arm);
    // The time of a hit is finer than a sample, so the hold-off may end one sample earlier or later.
    require(found > 50 && found * 100 >= wanted * 99 && found * 99 <= wanted * 100,
        "the search finds other edges than the scan");
    std::size_t hits = 0;
    const Pair pair = pairedRatio(
        state, [&] { hits += scan(channel, level, arm); },
        [&] { hits += search(channel, level, arm); });
    benchmark::DoNotOptimize(hits);
    state.counters["hits"] = static_cast<double>(found);
    const char *const what[] = {"a level crossed once in a million samples",
        "a phase current's zero, every period", "noise around the level, no block to pass over"};
    report({"N17 edges", "trigger search in 1e8 samples, " + std::string(what[signal]),
        Measured::cost(pair), "a plain scan of the same codes"});
}

} // namespace

BENCHMARK(triggerAgainstScan)->Arg(Rare)->Arg(Current)->Arg(Noise)->Iterations(9)->UseManualTime();

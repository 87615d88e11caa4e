// N17: the search for what a trigger waits for through a whole recording, against a plain scan of the same codes.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "scope/trigger_search.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

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

/// The same as scan() for any kind. @param step  with its thresholds known as codes: true is a hit
template <class Step>
std::size_t scanOf(const capture::Channel &channel, Step step)
{
    std::size_t hits = 0;
    Index from = 0;
    for (Index next = 0; next < channel.end();) {
        const auto codes = channel.fast()->codes(next, kSamples);
        for (std::size_t i = 0; i < codes.size(); ++i) {
            if (step(codes[i], next + i) && next + i >= from) {
                ++hits;
                from = next + i + kHoldOffSamples;
            }
        }
        next += codes.size();
    }
    return hits;
}

constexpr int kLevel = 2000;
constexpr int kApart = 1000; ///< hysteresis
constexpr int kHigh = 6000;
constexpr Index kLong = 60; ///< samples: of a period of 200

struct Rises {
    bool armed = false;
    bool operator()(int code)
    {
        const bool hit = armed && code >= kLevel;
        armed = code < kLevel - kApart || (armed && !hit);
        return hit;
    }
};
struct Falls {
    bool armed = false;
    bool operator()(int code)
    {
        const bool hit = armed && code <= kLevel;
        armed = code > kLevel + kApart || (armed && !hit);
        return hit;
    }
};

constexpr Nanos inTime(Index samples) { return static_cast<Nanos>(samples) * 50'000; }

/// A kind: its condition, and the plain scan of it.
struct Kind {
    const char *name;
    decltype(scope::TriggerCondition::what) what;
    std::size_t (*plain)(const capture::Channel &channel);
};

const std::vector<Kind> &kinds()
{
    static const std::vector<Kind> all{
        {"either edge", scope::EdgeTrigger{scope::Slope::Either, kLevel, kApart},
            [](const capture::Channel &channel) {
                return scanOf(channel, [up = Rises(), down = Falls()](int code, Index) mutable {
                    const bool rose = up(code);
                    return down(code) || rose;
                });
            }},
        {"level", scope::LevelTrigger{scope::LevelTrigger::Side::AtOrAbove, kHigh},
            [](const capture::Channel &channel) {
                return scanOf(channel, [](int code, Index) { return code >= kHigh; });
            }},
        {"window", scope::WindowTrigger{scope::WindowTrigger::When::Leaves, -kHigh, kHigh, kApart},
            [](const capture::Channel &channel) {
                return scanOf(channel, [under = false, over = false](int code, Index) mutable {
                    const bool hit = (under && code > kHigh) || (over && code < -kHigh);
                    under = code < kHigh - kApart || (under && code <= kHigh);
                    over = code > -kHigh + kApart || (over && code >= -kHigh);
                    return hit;
                });
            }},
        {"pulse",
            scope::PulseTrigger{scope::PulseTrigger::Polarity::Positive, kLevel, kApart,
                {inTime(kLong), std::numeric_limits<Nanos>::max(), {}}},
            [](const capture::Channel &channel) {
                return scanOf(channel,
                    [up = Rises(), down = Falls(), since = Index{0}](int code, Index at) mutable {
                        if (up(code))
                            since = at;
                        return down(code) && at - since >= kLong;
                    });
            }},
        {"slew",
            scope::SlewTrigger{scope::Slope::Rising, -kHigh, kHigh, kApart, {0, inTime(kLong), {}}},
            [](const capture::Channel &channel) {
                return scanOf(channel,
                    [armed = false, rising = false, since = Index{0}](int code, Index at) mutable {
                        if (armed && code >= -kHigh) {
                            armed = false;
                            rising = true;
                            since = at;
                        }
                        if (code < -kHigh - kApart) {
                            armed = true;
                            rising = false;
                        }
                        if (!rising || code < kHigh)
                            return false;
                        rising = false;
                        return at - since <= kLong;
                    });
            }},
        {"dropout",
            scope::DropoutTrigger{{scope::Slope::Rising, kLevel, kApart}, inTime(3 * kLong)},
            [](const capture::Channel &channel) {
                return scanOf(channel,
                    [up = Rises(), due = std::numeric_limits<Index>::max()](
                        int code, Index at) mutable {
                        const bool hit = at >= due;
                        if (up(code))
                            due = at + 3 * kLong;
                        else if (hit)
                            due = std::numeric_limits<Index>::max();
                        return hit;
                    });
            }},
        {"every fifth edge", scope::NthEdgeTrigger{{scope::Slope::Rising, kLevel, kApart}, 5, 0},
            [](const capture::Channel &channel) {
                return scanOf(channel, [up = Rises(), count = 0](int code, Index) mutable {
                    count += up(code) ? 1 : 0;
                    const bool hit = count == 5;
                    count = hit ? 0 : count;
                    return hit;
                });
            }},
    };
    return all;
}

std::size_t searchFor(const capture::Channel &channel, const Kind &kind)
{
    scope::TriggerCondition condition;
    condition.what = kind.what;
    scope::TriggerSearch search(condition);
    std::size_t hits = 0;
    Nanos from = 0;
    while (const auto hit = search.next(channel, from)) {
        ++hits;
        from = hit->time + kHoldOff;
    }
    return hits;
}

void kindAgainstScan(benchmark::State &state)
{
    const Kind &kind = kinds()[static_cast<std::size_t>(state.range(0))];
    const capture::Channel channel = record(Current);
    const auto wanted = double(kind.plain(channel));
    const auto found = double(searchFor(channel, kind));
    // What is counted from a hit, or lies between two samples, may shift by one: not by whole periods.
    require(wanted > 50.0 && std::abs(found - wanted) < 0.05 * wanted,
        "the search finds something else than the scan");
    std::size_t hits = 0;
    const Pair pair = pairedRatio(
        state, [&] { hits += kind.plain(channel); }, [&] { hits += searchFor(channel, kind); });
    benchmark::DoNotOptimize(hits);
    report({"N17 kinds", "search in 1e8 samples of a phase current: " + std::string(kind.name),
        Measured::cost(pair), "a plain scan for the same"});
}

} // namespace

BENCHMARK(kindAgainstScan)->DenseRange(0, 6)->Iterations(3)->UseManualTime();
BENCHMARK(triggerAgainstScan)->Arg(Rare)->Arg(Current)->Arg(Noise)->Iterations(9)->UseManualTime();

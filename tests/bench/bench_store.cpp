// P6, P7: what a sample costs in the store, in memory and in time.
#include "bench/motor_data.h"
#include "bench/paired.h"

#include <qcustomplot.h>

#include <cstring>
#include <memory>

namespace {

using namespace bench;

/// Blocks made beforehand, so that only the appending is measured.
std::vector<capture::SampleBlock> blocksOf(std::size_t samples, std::size_t batch)
{
    std::vector<capture::SampleBlock> blocks;
    for (std::size_t done = 0; done < samples; done += batch) {
        capture::SampleBlock block{1, static_cast<capture::Tick>(done),
            static_cast<std::uint32_t>(batch), std::vector<std::int16_t>(batch * kSignals), {}, 0};
        for (std::size_t i = 0; i < block.fast.size(); ++i)
            block.fast[i] =
                motorSample(static_cast<int>(i / batch), std::int64_t(done + i % batch));
        blocks.push_back(std::move(block));
    }
    return blocks;
}

void memory(benchmark::State &state)
{
    constexpr std::size_t kSamples = 5'000'000;
    double bytes = 0;
    while (state.KeepRunning()) {
        const double before = residentBytes();
        const auto store = std::make_unique<capture::Capture>();
        recordMotor(*store, kSamples);
        const double resident = residentBytes() - before;
        const double own = double(store->bytes());
        bytes = std::max(resident, own) / double(kSamples * kSignals);
    }
    state.counters["bytes"] = bytes;
    report({"P6 memory", "a fast sample, envelope included", bytes,
        "nothing (larger of resident growth and allocated)"});
    report({"P6", "times less memory a sample", double(sizeof(QCPGraphData)) / bytes,
        "QCPGraph, 16 bytes"});
}

void appendAgainstMemcpy(benchmark::State &state)
{
    const auto batch = static_cast<std::size_t>(state.range(0));
    const auto blocks = blocksOf(999'000 / batch * batch, batch);
    // Into memory that is in use: what is left is new pages, the envelope and the order.
    std::vector<std::int16_t> there(std::size_t{999'000} * kSignals, 1);
    const auto copy = [&] {
        std::int16_t *at = there.data();
        for (const capture::SampleBlock &block : blocks) {
            std::memcpy(at, block.fast.data(), block.fast.size() * sizeof(std::int16_t));
            at += block.fast.size();
        }
        benchmark::DoNotOptimize(there.data());
        benchmark::ClobberMemory();
    };
    const auto append = [&] {
        capture::Capture store;
        store.begin(motorLayout());
        for (const capture::SampleBlock &block : blocks)
            store.append(block);
        benchmark::DoNotOptimize(store.revision());
    };
    const Pair pair = pairedRatio(state, copy, append);
    state.counters["ns_per_sample"] = pair.bSeconds * 1e9 / (999'000.0 * kSignals);
    report({batch == 333 ? "P7 append" : "P7",
        "append with envelope, batches of " + std::to_string(batch), Measured::cost(pair),
        "memcpy into memory in use"});
}

void appendAgainstGraphs(benchmark::State &state)
{
    const auto blocks = blocksOf(999'000, 333);
    // As its documentation adds points; the vectors are made of the same blocks, which is part of the work.
    const auto add = [&] {
        QCustomPlot plot;
        QVector<double> keys(333), values(333);
        for (int s = 0; s < kSignals; ++s)
            plot.addGraph();
        for (const capture::SampleBlock &block : blocks) {
            for (qsizetype i = 0; i < 333; ++i)
                keys[i] = double(block.firstTick + i) / kTickHz;
            for (std::size_t s = 0; s < kSignals; ++s) {
                for (qsizetype i = 0; i < 333; ++i)
                    values[i] = double(block.fast[s * 333 + std::size_t(i)]);
                plot.graph(static_cast<int>(s))->addData(keys, values, true);
            }
        }
    };
    const auto append = [&] {
        capture::Capture store;
        store.begin(motorLayout());
        for (const capture::SampleBlock &block : blocks)
            store.append(block);
    };
    const Pair pair = pairedRatio(state, append, add);
    report({"P7", "append with envelope, batches of 333: times cheaper", Measured::faster(pair),
        "QCPGraph::addData of two vectors"});
}

} // namespace

BENCHMARK(memory)->Iterations(1);
BENCHMARK(appendAgainstMemcpy)->Arg(333)->Arg(20)->Iterations(31)->UseManualTime();
BENCHMARK(appendAgainstGraphs)->Iterations(15)->UseManualTime();

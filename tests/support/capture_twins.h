// Two captures of the same stream, one with room for everything in memory: whatever the other is asked, it must answer
// the same. The stream has gaps, codes that wrap, slow signals that are floats, and polled values, some that
// repeat and some that do not.
#pragma once

#include "capture/capture.h"
#include "capture/csv_export.h"

#include <QtTest>

#include <bit>
#include <random>

struct CaptureTwins {
    static constexpr std::size_t kFast = 3;
    static constexpr std::size_t kSlow = 2;
    static constexpr std::size_t kUnlimited = std::size_t{4} << 30;

    /// By how much memory may be passed between two looks at it, which are 65536 samples apart.
    static constexpr std::size_t kSlack = 300'000;

    capture::Capture whole{{.maxBytes = kUnlimited}};
    capture::Capture small;
    std::mt19937 random;
    capture::Tick tick = 5;

    explicit CaptureTwins(capture::Capture::Config config, std::uint32_t seed = 1)
        : small(std::move(config))
        , random(seed)
    {
        begin(1);
    }

    void begin(capture::StreamId stream)
    {
        capture::StreamLayout layout{stream, 16000.0, 0.0, 1, {}, {}};
        for (std::size_t i = 0; i < kFast; ++i)
            layout.fast.push_back({catalog::RegisterId(i + 1), "F", "A", 0.5, 0.0});
        for (std::size_t i = 0; i < kSlow; ++i)
            layout.slow.push_back({catalog::RegisterId(i + 10), "S", "V", 0.25, 0.0, i == 1});
        m_stream = stream;
        whole.begin(layout);
        small.begin(layout);
    }

    /// @param samples  of each fast signal, about
    void record(capture::Tick samples)
    {
        const capture::Tick end = tick + samples;
        while (tick < end) {
            const capture::SampleBlock next = block();
            whole.append(next);
            small.append(next);
            const double now = static_cast<double>(tick) / 16000.0;
            const auto polled = static_cast<double>(random() % 1000);
            whole.appendPolled(40, "P", "K", now, polled);
            small.appendPolled(40, "P", "K", now, polled);
        }
    }

    /// Everything the small one keeps, sample by sample, and random questions about it.
    void verifyTheSame(int questions = 200)
    {
        QCOMPARE(small.channels().size(), whole.channels().size());
        for (const capture::ChannelInfo &info : small.channels())
            verifyColumn(*small.channel(info.id), *whole.channel(info.id));
        const auto span = small.timeSpan();
        QVERIFY(span);
        for (int i = 0; i < questions && !QTest::currentTestFailed(); ++i)
            verifyQuestion(*span);
    }

    static void verifyColumn(const capture::Channel &has, const capture::Channel &should)
    {
        QCOMPARE(has.end(), should.end());
        std::uint64_t wrong = 0;
        for (capture::Index i = has.begin(); i < has.end(); ++i)
            wrong += has.at(i) != should.at(i);
        QCOMPARE(wrong, std::uint64_t(0));
        for (capture::Index i = has.begin(); i < has.end(); i += 997)
            QCOMPARE(has.timeOf(i), should.timeOf(i));
    }

    static std::string csvOf(const capture::Capture &of, const std::vector<capture::ChannelId> &ids,
        capture::TimeSpan span)
    {
        capture::CsvOptions options;
        options.range = span;
        capture::CsvWriter writer(of.snapshot(ids), options);
        std::string all;
        std::string_view piece;
        while (writer.next(piece))
            all += piece;
        return all;
    }

private:
    capture::SampleBlock block()
    {
        const capture::Tick lost =
            random() % 40 == 0 ? 1 + static_cast<capture::Tick>(random() % 60000) : 0;
        tick += lost;
        capture::SampleBlock next;
        next.stream = m_stream;
        next.firstTick = tick;
        next.lostTicks = lost;
        next.count = 16 * static_cast<std::uint32_t>(1 + random() % 200);
        for (std::size_t s = 0; s < kFast; ++s)
            for (std::uint32_t i = 0; i < next.count; ++i)
                next.fast.push_back(static_cast<std::int16_t>(
                    s == 0 ? static_cast<std::uint64_t>(tick + i) * 411 : random()));
        for (std::uint32_t i = 0; i < next.count; i += 16)
            // Of the first hardly two are equal, of the second many.
            next.slow.push_back({tick + i,
                {static_cast<std::int32_t>(random()),
                    std::bit_cast<std::int32_t>(static_cast<float>(random() % 777) / 7.0F)}});
        tick += next.count;
        return next;
    }

    /// About the same piece of time on all channels: extremes, columns, samples, a value, gaps.
    void verifyQuestion(capture::TimeSpan span)
    {
        // No further back than where every channel has all that the other one has.
        for (const capture::ChannelInfo &info : small.channels())
            if (const auto own = small.timeSpan(info.id))
                span.from = std::max(span.from, own->from);
        std::uniform_real_distribution<double> inside(span.from, span.to);
        const double a = inside(random);
        // From a few samples to everything.
        const double width =
            (span.to - a) * std::pow(10.0, -static_cast<double>(random() % 6)) + 1e-4;
        const double b = std::min(a + width, span.to);
        for (const capture::ChannelInfo &info : small.channels()) {
            const auto id = info.id;
            const auto same = [](capture::MinMax x, capture::MinMax y) {
                return x.min == y.min && x.max == y.max;
            };
            QVERIFY(same(small.extremes(id, a, b), whole.extremes(id, a, b)));
            const auto has = small.columns(id, a, b, 300);
            const auto should = whole.columns(id, a, b, 300);
            QVERIFY(std::equal(has.begin(), has.end(), should.begin(), should.end(), same));
            QCOMPARE(small.valueAt(id, a), whole.valueAt(id, a));
            const auto few = small.channel(id)->samples(a, b, 100);
            const auto theirs = whole.channel(id)->samples(a, b, 100);
            QCOMPARE(few.size(), theirs.size());
            for (std::size_t i = 0; i < few.size(); ++i) {
                QCOMPARE(few[i].time, theirs[i].time);
                QCOMPARE(few[i].value, theirs[i].value);
            }
            QCOMPARE(small.channel(id)->gaps(a, b, 0.0).size(),
                whole.channel(id)->gaps(a, b, 0.0).size());
        }
    }

    capture::StreamId m_stream = 1;
};

// The store against a plain list of samples: whatever it answers must equal what brute force
// answers.
#include "capture/capture.h"
#include "capture/rows.h"

#include <QtTest>

#include <bit>
#include <random>
#include <tuple>

using namespace capture;
using Kind = ChannelInfo::Kind;

class TestCapture : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyExtremeEqualsAScanOfTheSamples();
    void everyColumnEqualsAScanOfItsSamples_data();
    void everyColumnEqualsAScanOfItsSamples();
    void everySampleIsInExactlyOneColumn();
    void columnsShowNothingInAGap();
    void valuesAreFoundAndShownAsAScanFindsThem_data();
    void valuesAreFoundAndShownAsAScanFindsThem();
    void aLossBecomesAGapAndNeverAZero();
    void aStopEndsTheHold();
    void aSignalThatIsStreamedAgainContinuesItsChannel();
    void anotherScaleMakesAnotherChannel();
    void aRealSignalHasNoDigit();
    void timeNeverRunsBackwards();
    void blocksThatDoNotFitAreCountedAndLeftOut();
    void slowValuesHoldUntilTheNextOne();
    void slowValuesThatAreRefusedLeaveTheOthersOfTheirBlock();
    void polledValuesAreTheirOwnChannel();
    void nothingHoldsBeyondTheNextValue();
    void aRegisterIsFoundWhereItWasStreamed();
    void aFastSampleCostsLessThanTwoPointThreeBytes();
    void theOldestSamplesAreReleasedFirst();
    void aSnapshotStaysAsItWas();
    void clearingForgetsEverythingAndTheStreamGoesOn();
    void timesAreExactToTheNanosecond();
    void theTimeOfASampleLeadsBackToIt_data();
    void theTimeOfASampleLeadsBackToIt();
    void whatWasComputedIsFoundCutAndForgotten();
    void anExcerptStaysWhenItsSamplesGo();
};

namespace {

StreamLayout layout(
    StreamId id, std::vector<catalog::RegisterId> fast, std::vector<catalog::RegisterId> slow = {})
{
    StreamLayout result;
    result.id = id;
    result.tickHz = 16000;
    for (const auto reg : fast)
        result.fast.push_back({reg, "F" + std::to_string(reg), "A", 0.5, 0.0});
    for (const auto reg : slow)
        result.slow.push_back({reg, "S" + std::to_string(reg), "V", 0.1, 0.0});
    return result;
}

SampleBlock block(
    StreamId stream, Tick tick, std::vector<std::int16_t> codes, std::size_t signalCount = 1)
{
    SampleBlock result;
    result.stream = stream;
    result.firstTick = tick;
    result.count = static_cast<std::uint32_t>(codes.size() / signalCount);
    result.fast = std::move(codes);
    return result;
}

/// A capture of one channel with gaps of random length, and the same samples as a plain list.
struct Recorded {
    Capture capture;
    ChannelId id = 0;
    std::vector<double> times;
    std::vector<float> values;
    std::vector<std::size_t> starts; ///< of the runs

    /// @param angle  codes that turn and wrap instead of random ones
    /// @param steps  ticks between two samples: the board records at another rate now and then, in this order
    explicit Recorded(std::uint32_t seed, std::size_t blocks = 600, Tick tick = 5,
        bool angle = false, const std::vector<std::uint32_t> &steps = {1})
    {
        std::mt19937 random(seed);
        capture.begin(layout(1, {7}));
        id = *capture.find(7);
        StreamId stream = 1;
        Tick step = steps.front();
        for (std::size_t i = 0; i < blocks; ++i) {
            const std::size_t turn = i * steps.size() / blocks;
            if (i == 0 || turn != (i - 1) * steps.size() / blocks) {
                StreamLayout other = layout(++stream, {7});
                other.fastStep = steps[turn];
                step = steps[turn];
                capture.begin(other);
            }
            const Tick lost = random() % 20 == 0 ? 1 + static_cast<Tick>(random() % 60000) : 0;
            std::vector<std::int16_t> codes(1 + random() % 1000);
            if (lost != 0 || i == 0)
                starts.push_back(times.size());
            tick += lost;
            for (std::size_t k = 0; k < codes.size(); ++k) {
                const Tick at = tick + static_cast<Tick>(k) * step;
                const auto turned = static_cast<std::uint64_t>(at) * 411;
                codes[k] = static_cast<std::int16_t>(angle ? turned : random());
                times.push_back(static_cast<double>(at) / 16000.0);
                values.push_back(static_cast<float>(codes[k] * 0.5));
            }
            SampleBlock next = block(stream, tick, codes);
            next.lostTicks = lost;
            capture.append(next);
            tick += static_cast<Tick>(codes.size()) * step;
        }
    }

    /// In whole nanoseconds, as the store's contract says.
    std::pair<std::size_t, std::size_t> indexes(double from, double to) const
    {
        const auto at = [this](double t) {
            const double edge = std::round(t * 1e9);
            return static_cast<std::size_t>(
                std::lower_bound(times.begin(), times.end(), edge,
                    [](double time, double wanted) { return std::round(time * 1e9) < wanted; })
                - times.begin());
        };
        return {at(from), at(to)};
    }
    MinMax scan(double from, double to) const
    {
        MinMax range;
        const auto [low, high] = indexes(from, to);
        for (std::size_t i = low; i < high; ++i)
            range.include({values[i], values[i]});
        return range;
    }
};

} // namespace

void TestCapture::everyExtremeEqualsAScanOfTheSamples()
{
    const Recorded recorded(1);
    QVERIFY(recorded.capture.size(recorded.id) == recorded.times.size());
    QVERIFY(recorded.starts.size() > 10);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-1.0, recorded.times.back() + 1.0);
    for (int i = 0; i < 25000; ++i) {
        const double from = anywhere(random);
        // All lengths, from less than a sample to everything.
        const double to =
            from + std::pow(10.0, -5.0 + static_cast<double>(random() % 7000) / 1000.0);
        const MinMax expected = recorded.scan(from, to);
        const MinMax found = recorded.capture.extremes(recorded.id, from, to);
        QCOMPARE(found.empty(), expected.empty());
        if (!expected.empty()) {
            QCOMPARE(found.min, expected.min);
            QCOMPARE(found.max, expected.max);
        }
    }
}

void TestCapture::everyColumnEqualsAScanOfItsSamples_data()
{
    QTest::addColumn<bool>("angle");
    QTest::addColumn<qint64>("firstTick");
    QTest::addColumn<std::vector<std::uint32_t>>("steps");
    using Steps = std::vector<std::uint32_t>;
    QTest::addRow("random codes") << false << qint64(5) << Steps{1};
    QTest::addRow("an angle that wraps, across 2^32 ticks")
        << true << qint64(0xFFFF0000) << Steps{1};
    QTest::addRow("several rates, the last one fast")
        << false << qint64(5) << Steps{16, 2, 64, 4, 256, 1};
    QTest::addRow("several rates, the last one slow")
        << false << qint64(5) << Steps{1, 256, 4, 16, 1, 64};
}

/// Where an envelope entry is as long as a column is wide no edge is rounded and the scan must give the same; elsewhere
/// an edge may move by a sixteenth of a column, and the column lies between the scans of a narrower and a wider one.
void TestCapture::everyColumnEqualsAScanOfItsSamples()
{
    QFETCH(const bool, angle);
    QFETCH(const qint64, firstTick);
    QFETCH(const std::vector<std::uint32_t>, steps);
    constexpr int kSpans = 12000;
    constexpr double kRate = 16000.0;
    const Recorded recorded(11, 600, firstTick, angle, steps);
    const double longest = *std::max_element(steps.begin(), steps.end()) / kRate;
    QVERIFY(recorded.starts.size() > 10);
    std::mt19937 random(12);
    std::uniform_real_distribution<double> anywhere(
        recorded.times.front() - 0.1, recorded.times.back() + 0.1);
    int equal = 0;
    for (int i = 0; i < kSpans; ++i) {
        const double most = i % 20 == 0 ? 6.5 : 4.0; // some over everything, most short
        const double length =
            std::pow(10.0, -4.5 + most * static_cast<double>(random() % 1000) / 1000.0);
        const double from = anywhere(random);
        const std::size_t count = 1 + random() % 40;
        const double width = length / static_cast<double>(count);
        const bool exact = width * kRate < 128;
        const double blur = exact ? 2e-9 : width / 16 + longest;
        const auto columns = recorded.capture.columns(recorded.id, from, from + length, count);
        QCOMPARE(columns.size(), count);
        bool all = exact;
        for (std::size_t x = 0; x < count; ++x) {
            const double low = from + width * static_cast<double>(x);
            const MinMax inner = recorded.scan(low + blur, low + width - blur);
            const MinMax outer = recorded.scan(low - blur, low + width + blur);
            const MinMax &column = columns[x];
            QVERIFY(inner.empty() || (column.min <= inner.min && column.max >= inner.max));
            QVERIFY(column.empty() || (outer.min <= column.min && outer.max >= column.max));
            all = all && inner.empty() == outer.empty()
                && (inner.empty() || (inner.min == outer.min && inner.max == outer.max));
        }
        equal += all ? 1 : 0;
    }
    // Two rows at one rate and two at several: of each, more than 20,000 spans of which every column is the scan's own.
    QVERIFY2(equal > 10'500, qPrintable(QString::number(equal)));
}

void TestCapture::everySampleIsInExactlyOneColumn()
{
    const Recorded recorded(3);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> anywhere(0.0, recorded.times.back());
    for (int i = 0; i < 500; ++i) {
        double from = anywhere(random);
        double to = anywhere(random);
        if (from > to)
            std::swap(from, to);
        const std::size_t count = 1 + random() % 400;
        const auto columns = recorded.capture.columns(recorded.id, from, to, count);
        QCOMPARE(columns.size(), count);
        MinMax all;
        for (const MinMax &column : columns)
            all.include(column);
        // The outermost edges are rounded too, by less than a sixteenth of a column.
        const double blur = (to - from) / static_cast<double>(count) / 8.0 + 1e-4;
        const MinMax inner = recorded.scan(from + blur, to - blur);
        const MinMax outer = recorded.scan(from - blur, to + blur);
        if (!inner.empty())
            QVERIFY(all.min <= inner.min && all.max >= inner.max);
        if (!all.empty())
            QVERIFY(outer.min <= all.min && outer.max >= all.max);
    }
}

void TestCapture::valuesAreFoundAndShownAsAScanFindsThem_data()
{
    QTest::addColumn<int>("steps");
    QTest::newRow("equal") << 0;
    QTest::newRow("nearly equal") << 1;
    QTest::newRow("bursts") << 2;
    QTest::newRow("slower and slower") << 3;
}

void TestCapture::valuesAreFoundAndShownAsAScanFindsThem()
{
    QFETCH(const int, steps);
    constexpr int kValues = 3 * int(ValueColumn::kChunkSamples) * 4 + 77;
    Capture capture;
    const ChannelId id = capture.addImported("V", "A");
    std::mt19937 random(21 + steps);
    std::vector<Nanos> times;
    std::vector<float> values;
    Nanos now = 1'000'000;
    for (int i = 0; i < kValues; ++i) {
        const Nanos step[] = {62'500, 60'000 + Nanos(random() % 5'000),
            random() % 500 == 0 ? Nanos(50'000'000) : Nanos(1'000), 10'000 + Nanos(i) * 3};
        now += step[steps];
        times.push_back(now);
        values.push_back(float(int(random() % 2001) - 1000));
        if (random() % 3000 == 0)
            capture.breakImported(id);
        capture.appendImported(id, now, double(values.back()), now + 100);
    }
    const Channel &channel = *capture.channel(id);
    const auto scan = [&](Nanos from, Nanos to) {
        MinMax all;
        const auto first = std::lower_bound(times.begin(), times.end(), from);
        for (auto at = first; at != times.end() && *at < to; ++at) {
            const float value = values[std::size_t(at - times.begin())];
            all.include({value, value});
        }
        return all;
    };
    std::uniform_int_distribution<Nanos> anywhere(0, now + 1'000'000);
    for (int i = 0; i < 20'000; ++i) {
        const Nanos time =
            i % 2 == 0 ? anywhere(random) : times[random() % times.size()] + i % 3 - 1;
        const auto first = std::lower_bound(times.begin(), times.end(), time) - times.begin();
        QCOMPARE(channel.atOrAfter(time), capture::Index(first));
    }
    for (int i = 0; i < 1'000; ++i) {
        Nanos from = anywhere(random), to = anywhere(random);
        if (i % 2 == 0)
            to = from + Nanos(random() % 100'000'000);
        if (from >= to)
            std::swap(from, to);
        const MinMax found = channel.extremes(capture::toSeconds(from), capture::toSeconds(to));
        const MinMax wanted = scan(from, to);
        QVERIFY(found.empty() == wanted.empty()
            && (found.empty() || (found.min == wanted.min && found.max == wanted.max)));
        const std::size_t count = 1 + random() % 300;
        const double width = capture::toSeconds(to - from) / double(count);
        const auto blur = Nanos(width * 1e9 / 16) + 2;
        const auto columns =
            channel.columns(capture::toSeconds(from), capture::toSeconds(to), count);
        for (std::size_t x = 0; x < count; ++x) {
            const Nanos low = from + capture::toNanos(width * double(x));
            const Nanos high = from + capture::toNanos(width * double(x + 1));
            const MinMax inner = scan(low + blur, high - blur);
            const MinMax outer = scan(low - blur, high + blur);
            const MinMax &column = columns[x];
            QVERIFY(inner.empty() || (column.min <= inner.min && column.max >= inner.max));
            QVERIFY(column.empty() || (outer.min <= column.min && outer.max >= column.max));
        }
    }
}

void TestCapture::columnsShowNothingInAGap()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    const ChannelId id = *capture.find(7);
    std::vector<std::int16_t> codes(70001, 100);
    capture.append(block(1, 0, codes));
    SampleBlock later = block(1, 1'070'001, codes);
    later.lostTicks = 1'000'000;
    capture.append(later);
    const double end = 1'140'002 / 16000.0;
    const auto columns = capture.columns(id, 0.0, end, 1000);
    const double width = end / 1000;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double from = static_cast<double>(i) * width;
        const bool inGap = from > 70001 / 16000.0 && from + width < 1'070'001 / 16000.0;
        const bool inData = from + width < 70000 / 16000.0 || from > 1'070'001 / 16000.0;
        if (inGap)
            QVERIFY2(columns[i].empty(), qPrintable(QString::number(i)));
        if (inData)
            QVERIFY2(!columns[i].empty(), qPrintable(QString::number(i)));
    }
}

void TestCapture::aLossBecomesAGapAndNeverAZero()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    const ChannelId id = *capture.find(7);
    capture.append(block(1, 0, {10, 20, 30, 40}));
    SampleBlock later = block(1, 8, {50, 60});
    later.lostTicks = 4;
    capture.append(later);
    const double tick = 1.0 / 16000.0;
    QCOMPARE(capture.valueAt(id, 3.5 * tick), std::optional(20.0));
    QVERIFY(!capture.valueAt(id, 4.5 * tick));
    QVERIFY(!capture.valueAt(id, 7.5 * tick));
    QCOMPARE(capture.valueAt(id, 8.5 * tick), std::optional(25.0));
    QVERIFY(capture.extremes(id, 4 * tick, 8 * tick).empty());
    const auto gaps = capture.channel(id)->gaps(0, 1, 0);
    QCOMPARE(gaps.size(), std::size_t(1));
    QCOMPARE(gaps[0].from, 4 * tick);
    QCOMPARE(gaps[0].to, 8 * tick);
    const auto samples = capture.channel(id)->samples(0, 1, 100);
    QCOMPARE(samples.size(), std::size_t(6));
    QVERIFY(samples[0].first && !samples[3].first && samples[4].first);
    QCOMPARE(samples[3].holdUntil, 4 * tick);
}

void TestCapture::aStopEndsTheHold()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 0, {10, 20}));
    capture.begin({});
    capture.begin(layout(2, {7}));
    capture.append(block(2, 100, {30}));
    const ChannelId id = *capture.find(7);
    QVERIFY(capture.valueAt(id, 1.5 / 16000));
    QVERIFY(!capture.valueAt(id, 2.5 / 16000));
    QCOMPARE(capture.channel(id)->gaps(0, 1, 0).size(), std::size_t(1));
}

void TestCapture::aSignalThatIsStreamedAgainContinuesItsChannel()
{
    Capture capture;
    capture.begin(layout(1, {7, 8}));
    capture.append(block(1, 0, {1, 2, 11, 12}, 2));
    const auto before = capture.channels();
    capture.begin(layout(2, {9, 7})); // another order, another neighbour
    capture.append(block(2, 10, {21, 22, 3, 4}, 2));
    QCOMPARE(capture.channels().size(), std::size_t(3));
    QCOMPARE(*capture.find(7), before[0].id);
    QCOMPARE(capture.size(before[0].id), std::uint64_t(4));
    QCOMPARE(capture.size(before[1].id), std::uint64_t(2));
    QCOMPARE(capture.valueAt(before[0].id, 11.5 / 16000), std::optional(2.0));
    QVERIFY(!capture.valueAt(before[0].id, 5.5 / 16000));
    QCOMPARE(capture.streaming(), (std::vector<ChannelId>{*capture.find(9), before[0].id}));
}

void TestCapture::anotherScaleMakesAnotherChannel()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 0, {100}));
    StreamLayout other = layout(2, {7});
    other.fast[0].factor = 0.25;
    capture.begin(other);
    capture.append(block(2, 10, {100}));
    QCOMPARE(capture.channels().size(), std::size_t(2));
    QCOMPARE(capture.valueAt(capture.channels()[0].id, 0.0), std::optional(50.0));
    QCOMPARE(capture.lastValue(*capture.find(7)), std::optional(25.0));
    // The first board again: its channel goes on, and it is the one that is found.
    capture.begin(layout(3, {7}));
    capture.append(block(3, 20, {300}));
    QCOMPARE(capture.channels().size(), std::size_t(2));
    const auto found = capture.find(7, capture.channels()[0].kind);
    QVERIFY(found);
    QCOMPARE(*found, capture.channels()[0].id);
    QCOMPARE(capture.lastValue(*found), std::optional(150.0));
}

void TestCapture::aRealSignalHasNoDigit()
{
    Capture capture;
    StreamLayout layout;
    layout.id = 1;
    layout.tickHz = 1000.0;
    layout.slow = {{7, "COUNT", "cnt", 2.0, 0.0, false}, {8, "CURRENT", "A", 1.0, 0.0, true}};
    capture.begin(layout);
    QCOMPARE(capture.info(*capture.find(7))->digit(), 2.0);
    QCOMPARE(capture.info(*capture.find(8))->digit(), 0.0); // else 0.4 A would be told as 0 A
    layout.id = 2;
    layout.slow[1].real = false;
    capture.begin(layout);
    QCOMPARE(capture.info(*capture.find(8))->digit(), 1.0);
}

void TestCapture::timeNeverRunsBackwards()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 16000, {1, 2, 3, 4}));
    StreamLayout reset = layout(2, {7}); // the board was reset, its origin is a little too early
    reset.originSeconds = 0.9;
    capture.begin(reset);
    capture.append(block(2, 1600, {5, 6}));
    const ChannelId id = *capture.find(7);
    QCOMPARE(capture.size(id), std::uint64_t(6));
    const auto samples = capture.channel(id)->samples(0, 10, 100);
    for (std::size_t i = 1; i < samples.size(); ++i)
        QVERIFY(samples[i].time > samples[i - 1].time);
    capture.append(block(2, 1500, {7}));
    QCOMPARE(capture.size(id), std::uint64_t(6));
    QCOMPARE(capture.refused().backwards, std::uint64_t(1));
}

void TestCapture::blocksThatDoNotFitAreCountedAndLeftOut()
{
    Capture capture;
    capture.append(block(0, 0, {1}));
    capture.begin(layout(1, {7, 8}, {9}));
    capture.append(block(2, 0, {1, 2}));
    SampleBlock odd = block(1, 0, {1, 2, 3});
    capture.append(odd); // says 3 samples of each of 2 signals
    odd = block(1, 0, {1, 2});
    odd.count = 1;
    odd.slow.push_back({0, {1, 2}});
    capture.append(odd);
    QCOMPARE(capture.refused().otherStream, std::uint64_t(2));
    QCOMPARE(capture.refused().malformed, std::uint64_t(2));
    QVERIFY(!capture.timeSpan());
}

void TestCapture::slowValuesHoldUntilTheNextOne()
{
    Capture capture;
    capture.begin(layout(1, {7}, {9}));
    const ChannelId slow = *capture.find(9);
    SampleBlock first = block(1, 0, {1, 2, 3, 4});
    first.slow.push_back({2, {1000}});
    capture.append(first);
    capture.append(block(1, 4, {5, 6}));
    capture.append(block(1, 100, {7, 8})); // the ticks tell the loss, even if the block does not
    const double tick = 1.0 / 16000.0;
    QVERIFY(!capture.valueAt(slow, 1.5 * tick));
    QCOMPARE(capture.valueAt(slow, 2.5 * tick), std::optional(100.0));
    QCOMPARE(capture.valueAt(slow, 5.5 * tick), std::optional(100.0)); // held by the next packet
    QVERIFY(!capture.valueAt(slow, 7.5 * tick)); // nothing is known here
    QVERIFY(!capture.valueAt(slow, 100.5 * tick)); // nor yet here
    SampleBlock later = block(1, 102, {9});
    later.slow.push_back({102, {-2000}});
    capture.append(later);
    QCOMPARE(capture.valueAt(slow, 102.5 * tick), std::optional(-200.0));
    QCOMPARE(capture.extremes(slow, 0, 1).min, -200.0F);
    QCOMPARE(capture.extremes(slow, 0, 1).max, 100.0F);
}

/// No number, or not later, in the middle and at the end of a block: as if each group had come alone.
void TestCapture::slowValuesThatAreRefusedLeaveTheOthersOfTheirBlock()
{
    StreamLayout slow = layout(1, {}, {8, 9});
    slow.slow[0].real = true;
    using Group = std::pair<Tick, float>;
    const float none = std::nanf("");
    const std::vector<std::vector<Group>> blocks{
        {{0, 1}, {8, 2}, {4, 99}, {16, 4}, {24, none}, {32, 5}, {34, none}, {36, 6}, {36, 99}},
        {{44, 8}, {52, none}}, {{50, 9}, {60, 10}, {30, 99}}, {{70, 12}}};
    Capture together, alone;
    together.begin(slow);
    alone.begin(slow);
    for (const auto &groups : blocks) {
        SampleBlock all = block(1, 100, {}); // no fast sample; the stream has come to tick 100
        for (const auto &[tick, value] : groups) {
            all.slow.push_back({tick, {std::bit_cast<std::int32_t>(value), int(tick)}});
            SampleBlock one = block(1, 100, {});
            one.slow.push_back(all.slow.back());
            alone.append(one);
        }
        together.append(all);
    }
    const auto facts = [](const Capture &capture, catalog::RegisterId id) {
        const ValueColumn &column = *capture.channel(*capture.find(id))->values();
        std::vector<std::tuple<Nanos, double, std::size_t>> result;
        for (Index i = column.begin(); i < column.end(); ++i)
            result.emplace_back(column.timeOf(i), column.at(i), column.pieceOf(i));
        for (const Run &run : column.runs())
            result.emplace_back(run.holdUntil, double(run.first), run.count);
        return result;
    };
    for (const catalog::RegisterId id : {8U, 9U})
        QVERIFY(facts(together, id) == facts(alone, id));
    const Channel &real = *together.channel(*together.find(8));
    std::vector<double> values;
    for (Index i = real.begin(); i < real.end(); ++i)
        values.push_back(std::round(real.at(i) / 0.1));
    QCOMPARE(values, (std::vector<double>{1, 2, 4, 5, 6, 8, 9, 10, 12}));
    QCOMPARE(real.values()->runs().size(), std::size_t(4));
    QCOMPARE(together.size(*together.find(9)), 11U);
    for (const Capture *capture : {&together, &alone}) {
        QCOMPARE(capture->refused().notFinite, 3U);
        QCOMPARE(capture->refused().backwards, 3U + 4U);
    }
}

/// A value that was given up holds as long as the one before it did, unless another one comes: it is drawn the same
/// from wherever the picture begins.
void TestCapture::nothingHoldsBeyondTheNextValue()
{
    Capture capture;
    capture.appendPolled(7, "F7", "rpm", 1.0, 10.0);
    capture.appendPolled(7, "F7", "rpm", 2.0, 20.0);
    capture.endPolled(7);
    const ChannelId id = *capture.find(7, Kind::Polled);
    QCOMPARE(capture.valueAt(id, 2.9), std::optional(20.0));
    capture.appendPolled(7, "F7", "rpm", 2.5, 30.0);
    capture.endPolled(7);
    const Channel &channel = *capture.channel(id);
    QCOMPARE(channel.holdUntil(1), channel.timeOf(2));
    QVERIFY(!channel.valueAt(2.7));
    QVERIFY(channel.samples(2.7, 5.0, 10).empty());
    const auto all = channel.samples(0.0, 5.0, 10);
    QCOMPARE(all.size(), std::size_t(3));
    for (const auto &sample : all)
        QVERIFY(sample.holdUntil < 2.7);
}

void TestCapture::polledValuesAreTheirOwnChannel()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.appendPolled(7, "F7", "rpm", 1.0, 1500.25);
    capture.appendPolled(7, "F7", "rpm", 1.5, 1600.5);
    capture.appendPolled(7, "F7", "rpm", 1.5, 1.0); // not later
    capture.appendPolled(7, "F7", "rpm", 1.6, std::nan(""));
    capture.appendPolled(7, "F7", "rpm", 10.0, 1700.0);
    const ChannelId id = *capture.find(7, Kind::Polled);
    QVERIFY(id != *capture.find(7, Kind::Fast));
    QCOMPARE(capture.size(id), std::uint64_t(3));
    QCOMPARE(capture.valueAt(id, 1.25), std::optional(1500.25));
    QCOMPARE(capture.valueAt(id, 3.0), std::optional(1600.5));
    QVERIFY(capture.timeSpan(id)->to < 10.001);
    QVERIFY(!capture.valueAt(id, 4.0)); // not polled for too long
    QCOMPARE(capture.channel(id)->gaps(0, 20, 0).size(), std::size_t(1));
    QCOMPARE(capture.refused().backwards + capture.refused().notFinite, std::uint64_t(2));

    // Where polling has ended, the last one is known for as long as the one before it was, not for 2 s.
    capture.appendPolled(7, "F7", "rpm", 10.1, 1710.0);
    QCOMPARE(capture.valueAt(id, 11.0), std::optional(1710.0));
    capture.endPolled(7);
    QCOMPARE(capture.valueAt(id, 10.19), std::optional(1710.0));
    QVERIFY(!capture.valueAt(id, 10.21));
    capture.endPolled(7);
    QCOMPARE(capture.size(id), std::uint64_t(4));

    // By another scale the numbers do not follow those before, though their unit is the same.
    capture.endPolledForGood(7);
    capture.appendPolled(7, "F7", "rpm", 10.5, 17.0);
    capture.appendPolled(7, "F7", "rpm", 10.6, 18.0);
    const ChannelId other = *capture.find(7, Kind::Polled);
    QVERIFY(other != id);
    QCOMPARE(capture.size(id), std::uint64_t(4));
    QCOMPARE(capture.size(other), std::uint64_t(2));
    capture.endPolledForGood(7);
    capture.appendPolled(7, "F7", "A", 11.0, 0.5); // another unit, too: one new channel, not two
    capture.appendPolled(7, "F7", "A", 11.1, 0.6);
    QCOMPARE(capture.size(*capture.find(7, Kind::Polled)), std::uint64_t(2));
}

void TestCapture::aRegisterIsFoundWhereItWasStreamed()
{
    Capture file;
    file.appendPolled(7, "F7", "rpm", 0.5, 1.0, Capture::Asked::Aside);
    QCOMPARE(file.info(*file.find(7))->kind, Kind::Polled); // better than nothing
    file.begin(layout(1, {7}));
    QCOMPARE(file.info(*file.find(7))->kind, Kind::Polled); // nothing streamed yet
    file.append(block(1, 0, {{1, 2, 3}}));
    QCOMPARE(file.info(*file.find(7))->kind, Kind::Fast);
    file.appendPolled(7, "F7", "rpm", 1.0, 1.0, Capture::Asked::Aside);
    file.appendPolled(8, "F8", "rpm", 1.0, 1.0, Capture::Asked::Aside);
    file.begin({});
    file.appendPolled(7, "F7", "rpm", 2.0, 1.0, Capture::Asked::Aside);
    QCOMPARE(file.info(*file.find(7))->kind, Kind::Fast);
    QCOMPARE(file.info(*file.find(8))->kind, Kind::Polled);

    Capture window;
    const std::uint64_t before = window.revision();
    window.adopt(std::move(file));
    QVERIFY(window.revision() > before);
    QCOMPARE(window.info(*window.find(7))->kind, Kind::Fast);
    window.appendPolled(7, "F7", "rpm", 3.0, 1.0); // as a signal: what is recorded now
    QCOMPARE(window.info(*window.find(7))->kind, Kind::Polled);
    window.begin(layout(2, {7}));
    QCOMPARE(window.info(*window.find(7))->kind, Kind::Fast);
}

void TestCapture::aFastSampleCostsLessThanTwoPointThreeBytes()
{
    Capture capture;
    capture.begin(layout(1, {7, 8}));
    for (Tick tick = 0; tick < 3'000'000; tick += 500)
        capture.append({1, tick, 500, std::vector<std::int16_t>(1000, 5), {}, 0});
    QCOMPARE(capture.size(*capture.find(7)), std::uint64_t(3'000'000));
    QVERIFY(static_cast<double>(capture.bytes()) / 6e6 <= 2.3);
}

void TestCapture::theOldestSamplesAreReleasedFirst()
{
    Capture capture({.maxBytes = 1'000'000});
    capture.begin(layout(1, {7}));
    const ChannelId id = *capture.find(7);
    for (Tick tick = 0; tick < 2'000'000; tick += 1000) {
        std::vector<std::int16_t> codes(1000, static_cast<std::int16_t>(tick / 1000));
        capture.append(block(1, tick, codes));
    }
    QVERIFY(capture.bytes() <= 1'000'000 + 200'000);
    const auto span = capture.timeSpan(id);
    QVERIFY(span && span->from > 90.0);
    QCOMPARE(span->to, 125.0);
    QVERIFY(!capture.valueAt(id, 1.0));
    QCOMPARE(capture.valueAt(id, 124.99), std::optional(1999 * 0.5));
    const double firstValue = *capture.valueAt(id, span->from);
    QCOMPARE(firstValue, std::floor(span->from * 16) * 0.5);
    QCOMPARE(capture.columns(id, 0.0, 125.0, 100).front().empty(), true);
    // What was let go is counted, and shown as the gap that it is.
    QCOMPARE(capture.released(), 2'000'000 - capture.size(id));
    const auto gaps = capture.channel(id)->gaps(0.0, 125.0, 0.001);
    QCOMPARE(gaps.size(), std::size_t(1));
    QCOMPARE(gaps[0].from, 0.0);
    QCOMPARE(gaps[0].to, span->from);
    QVERIFY(capture.channel(id)->gaps(span->from + 1.0, 125.0, 0.001).empty());
    capture.clear();
    QCOMPARE(capture.released(), 0U);
}

void TestCapture::aSnapshotStaysAsItWas()
{
    Capture capture;
    capture.begin(layout(1, {7}, {9}));
    SampleBlock first = block(1, 0, {1, 2, 3});
    first.slow.push_back({0, {4}});
    capture.append(first);
    const std::vector<ChannelId> ids{*capture.find(9), *capture.find(7), 999};
    const Snapshot snapshot = capture.snapshot(ids);
    for (Tick tick = 3; tick < 200'000; tick += 1000)
        capture.append(block(1, tick, std::vector<std::int16_t>(1000, 9)));
    capture.clear();
    QCOMPARE(snapshot->size(), std::size_t(2));
    QCOMPARE(snapshot->at(1).size(), std::uint64_t(3));
    QCOMPARE(snapshot->at(1).at(2), 1.5);
    QCOMPARE(snapshot->at(0).info().registerId, 9U);
}

void TestCapture::theTimeOfASampleLeadsBackToIt_data()
{
    QTest::addColumn<double>("tickHz");
    QTest::addColumn<double>("origin");
    for (const double rate : {1000.0, 16000.0, 30000.0, 12345.678}) {
        for (const double origin : {0.0, -3.3, 0.1, 3601.7, 86399.123456789})
            QTest::addRow("%g Hz from %g s", rate, origin) << rate << origin;
    }
}

/// In seconds, as a cursor has it: a floating-point number that may lie a hair before the instant it stands for.
void TestCapture::theTimeOfASampleLeadsBackToIt()
{
    QFETCH(double, tickHz);
    QFETCH(double, origin);
    StreamLayout stream = layout(1, {7}, {8});
    stream.tickHz = tickHz;
    stream.originSeconds = origin;
    Capture capture;
    capture.begin(stream);
    constexpr int kCount = 5000;
    std::vector<std::int16_t> codes;
    for (int i = 0; i < kCount; ++i)
        codes.push_back(static_cast<std::int16_t>(i));
    SampleBlock samples = block(1, 0, codes);
    for (Tick tick = 0; tick < kCount; ++tick)
        samples.slow.push_back({tick, {static_cast<std::int32_t>(tick)}});
    capture.append(samples);
    const Snapshot all = capture.snapshot(std::vector{*capture.find(7), *capture.find(8)});
    for (const Channel &channel : *all) {
        const double digit = channel.info().factor;
        const auto timeOf = [&channel](Index i) { return toSeconds(channel.timeOf(i)); };
        QCOMPARE(channel.size(), std::uint64_t(kCount));
        for (Index i = 0; i + 1 < kCount; ++i) {
            QCOMPARE(channel.valueAt(timeOf(i)), std::optional(double(i) * digit));
            QCOMPARE(channel.countIn(timeOf(i), timeOf(i + 1)), 1U);
            const auto found = channel.samples(timeOf(i), timeOf(i + 1), 10);
            QCOMPARE(found.size(), 1U);
            QCOMPARE(found[0].value, double(i) * digit);
            QCOMPARE(channel.extremes(timeOf(i), timeOf(i + 1)).max, float(double(i) * digit));
            QCOMPARE(channel.columns(timeOf(i), timeOf(i + 1), 1)[0].max, float(double(i) * digit));
        }
        const Rows rows = rowsOf(std::make_shared<std::vector<Channel>>(1, channel),
            TimeSpan{timeOf(1001), timeOf(1003)});
        QCOMPARE(rows.time.size(), 2U);
        QCOMPARE(rows.columns[0][0], 1001 * digit);
    }
}

void TestCapture::whatWasComputedIsFoundCutAndForgotten()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 0, {1, 2, 3}));
    const ChannelId id = capture.addImported("M", "A", kFirstOwnRegister + 5);
    QCOMPARE(capture.find(kFirstOwnRegister + 5), std::optional(id));
    QVERIFY(!capture.info(id)->isBoards());
    QCOMPARE(capture.info(id)->digit(), 0.0);
    QCOMPARE(capture.info(*capture.find(7))->digit(), 0.5);
    const Nanos count = 3 * Nanos(ValueColumn::kChunkSamples);
    for (Nanos i = 0; i < count; ++i)
        capture.appendImported(id, i * 1000, double(i), (i + 1) * 1000);
    capture.keepNewest(id, 5000); // a chunk at a time
    QCOMPARE(capture.size(id), std::uint64_t(ValueColumn::kChunkSamples));
    QCOMPARE(capture.lastValue(id), std::optional(double(count - 1)));
    capture.removeImported(*capture.find(7)); // not its business
    QCOMPARE(capture.size(*capture.find(7)), std::uint64_t(3));
    capture.removeImported(id);
    QVERIFY(!capture.info(id) && !capture.find(kFirstOwnRegister + 5));
    // It is gone, and nothing happens.
    capture.appendImported(id, count * 1000, 1.0, count * 1000 + 1);
    capture.append(block(1, 3, {4}));
    QCOMPARE(capture.size(*capture.find(7)), std::uint64_t(4));
    const ChannelId other = capture.addImported("N", "A", 3); // never under a board's register
    QVERIFY(!capture.info(other)->isBoards());
}

void TestCapture::anExcerptStaysWhenItsSamplesGo()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 0, {1, 2, 3}));
    capture.append(block(1, 10, {4, 5, 6})); // behind a gap
    const ChannelId id = *capture.find(7);
    const auto timeOf = [&](Index at) { return capture.channel(id)->timeOf(at); };
    capture.appendPolled(9, "P", "V", toSeconds(timeOf(5)) + 10.0, 1.0); // outside
    const Nanos from = timeOf(1), to = timeOf(5);
    std::vector<Nanos> times;
    for (Index at = 1; at < 5; ++at)
        times.push_back(timeOf(at));
    const ChannelInfo info = *capture.info(id);
    const double digit = info.factor;
    const Capture excerpt = excerptOf(capture, from, to);
    capture.clear();
    const auto channels = excerpt.channels();
    QCOMPARE(channels.size(), std::size_t(1));
    QCOMPARE(channels.front().name, info.name);
    QCOMPARE(channels.front().unit, info.unit);
    const Channel &copy = *excerpt.channel(channels.front().id);
    QCOMPARE(copy.size(), std::uint64_t(4));
    for (Index at = 0; at < 4; ++at) {
        QCOMPARE(copy.timeOf(copy.begin() + at), times[std::size_t(at)]);
        QCOMPARE(copy.at(copy.begin() + at), double(at + 2) * digit);
    }
    QCOMPARE(copy.gaps(toSeconds(from), toSeconds(to), 0.0).size(), std::size_t(1));
}

void TestCapture::clearingForgetsEverythingAndTheStreamGoesOn()
{
    Capture capture;
    capture.begin(layout(1, {7}));
    capture.append(block(1, 0, {1, 2, 3}));
    const ChannelId before = *capture.find(7);
    const auto revision = capture.revision();
    capture.clear();
    QVERIFY(capture.revision() > revision);
    QVERIFY(!capture.channel(before));
    QVERIFY(!capture.timeSpan());
    capture.append(block(1, 3, {4}));
    QCOMPARE(capture.size(*capture.find(7)), std::uint64_t(1));
    QVERIFY(*capture.find(7) != before);
}

void TestCapture::timesAreExactToTheNanosecond()
{
    const TickBase base = TickBase::of(16000, 2.5);
    QCOMPARE(base.timeOf(0), Nanos(2'500'000'000));
    QCOMPARE(base.timeOf(1), Nanos(2'500'062'500));
    QCOMPARE(base.timeOf(-1), Nanos(2'499'937'500));
    QCOMPARE(base.timeOf(16000LL * 86400 * 365), Nanos(2'500'000'000) + 31'536'000'000'000'000);
    const TickBase third = TickBase::of(30000, 0.0);
    QCOMPARE(third.timeOf(1), Nanos(33'333));
    QCOMPARE(third.timeOf(2), Nanos(66'667));
    QCOMPARE(third.timeOf(30000LL * 1000 + 3), Nanos(1'000'000'100'000));
    QCOMPARE(TickBase::of(0.0, 0.0).milliHz, 1000); // nonsense from a board never divides by zero
}

QTEST_APPLESS_MAIN(TestCapture)
#include "tst_capture.moc"

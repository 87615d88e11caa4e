// The trigger search against a naive one, on noisy channels with gaps, however the samples arrive.
#include "scope/code_masks.h"
#include "scope/trigger_search.h"
#include "support/naive_triggers.h"

#include <QtTest>

#include <array>

using namespace scope;
using support::NaiveTriggers;
using support::NoisyChannel;

class TestScopeTrigger : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void hitsEqualANaiveSearch_data();
    void hitsEqualANaiveSearch();
    void aMaskSaysOfEachCodeWhatItsHalfLineSays();
    void theTimeOfAnEdgeIsFinerThanASample();
    void aGapIsNoEdge();
    void anAnglesEndIsNoEdgeUnlessAskedFor();
    void samplesReleasedBeforeTheyWereSearchedAreAGap();
    void aRecordingIsSearchedInPiecesAsAtOnce();
    void aSearchOfARecordingEndsWhenItIsTold();
    void nonsenseIsRefusedWithAReason();
};

namespace {

using Random = std::mt19937;

double pick(Random &random, double low, double high)
{
    return low + (high - low) * static_cast<double>(random() % 10001) / 10000.0;
}

/// A level that such a channel may well cross, sometimes exactly the value of a code.
double level(Random &random)
{
    const double value = pick(random, -120.0, 120.0);
    return random() % 2 == 0 ? value : std::round(value * 100.0) / 100.0;
}
double hysteresis(Random &random) { return random() % 3 == 0 ? 0.0 : pick(random, 0.0, 12.0); }
Slope slope(Random &random) { return Slope(random() % 3); }
Nanos duration(Random &random, double most) { return Nanos(pick(random, 1.0, most)); }

DurationTest durations(Random &random, double most)
{
    DurationTest test;
    test.least = duration(random, most / 2);
    if (random() % 2 == 0)
        test.most = test.least + duration(random, most);
    test.where = random() % 3 == 0 ? DurationTest::Where::Outside : DurationTest::Where::Inside;
    return test;
}
EdgeTrigger edge(Random &random) { return {slope(random), level(random), hysteresis(random)}; }

/// @param span  of the times that are asked for, nanoseconds
TriggerCondition anyCondition(int kind, Random &random, double span)
{
    TriggerCondition result;
    const double a = level(random);
    const double b = a + 0.01 + std::abs(level(random)) / 2;
    switch (kind) {
    case 0:
        result.what = edge(random);
        break;
    case 1:
        result.what = LevelTrigger{LevelTrigger::Side(random() % 2), a};
        break;
    case 2:
        result.what = WindowTrigger{WindowTrigger::When(random() % 2), a, b, hysteresis(random)};
        break;
    case 3:
        result.what = PulseTrigger{
            PulseTrigger::Polarity(random() % 2), a, hysteresis(random), durations(random, span)};
        break;
    case 4:
        result.what = SlewTrigger{slope(random), a, b, hysteresis(random), durations(random, span)};
        break;
    case 5:
        result.what = DropoutTrigger{edge(random), duration(random, span)};
        break;
    default:
        result.what = NthEdgeTrigger{edge(random), 1 + std::uint32_t(random() % 5),
            random() % 2 == 0 ? 0 : duration(random, span)};
        break;
    }
    return result;
}

/// Records the rest, searching whenever `random` says so.
std::vector<Nanos> search(NoisyChannel &channel, const TriggerCondition &condition, Nanos holdOff,
    Random &random, std::size_t mostPerBlock)
{
    TriggerSearch search(condition);
    std::vector<Nanos> hits;
    Nanos notBefore = std::numeric_limits<Nanos>::min();
    while (!channel.done()) {
        channel.record(1 + random() % mostPerBlock);
        if (random() % 3 != 0 && !channel.done())
            continue;
        while (const auto hit = search.next(*channel.channel(), notBefore)) {
            hits.push_back(hit->time);
            notBefore = hit->time + holdOff;
        }
    }
    return hits;
}

/// A fast channel of one segment a list.
struct Recorded {
    capture::Capture store;
    explicit Recorded(const std::vector<std::vector<std::int16_t>> &segments, double tickHz = 1000)
    {
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = tickHz;
        layout.fast.push_back({7, "F", "A", 1.0, 0.0});
        store.begin(layout);
        capture::Tick tick = 0;
        for (const auto &codes : segments) {
            capture::SampleBlock block{
                1, tick, std::uint32_t(codes.size()), codes, {}, tick == 0 ? 0 : 5};
            store.append(block);
            tick += capture::Tick(codes.size()) + 5;
        }
    }
    const capture::Channel &channel() const { return *store.channel(*store.find(7)); }
    std::vector<TriggerHit> hits(const TriggerCondition &condition) const
    {
        TriggerSearch search(condition);
        std::vector<TriggerHit> result;
        while (const auto hit = search.next(channel(), std::numeric_limits<Nanos>::min()))
            result.push_back(*hit);
        return result;
    }
};

} // namespace

void TestScopeTrigger::hitsEqualANaiveSearch_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("polled");
    const char *const names[] = {
        "edge", "level", "window", "pulse width", "slew", "dropout", "N-th edge"};
    for (int kind = 0; kind < 7; ++kind) {
        QTest::addRow("%s, fast", names[kind]) << kind << false;
        QTest::addRow("%s, polled", names[kind]) << kind << true;
    }
}

void TestScopeTrigger::hitsEqualANaiveSearch()
{
    QFETCH(const int, kind);
    QFETCH(const bool, polled);
    std::size_t found = 0;
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        Random random(seed * 100 + std::uint32_t(kind));
        TriggerCondition condition = anyCondition(kind, random, polled ? 9e8 : 1e7);
        const bool angle = seed % 4 == 0;
        if (angle && seed % 8 == 0)
            condition.turn = 655.36;
        if (polled)
            condition.between = Between::Hold;
        const Nanos holdOff = seed % 2 == 0 ? 0 : duration(random, polled ? 5e9 : 3e7);
        const auto make = [&] {
            return NoisyChannel(seed,
                polled ? NoisyChannel::Kind::Polled : NoisyChannel::Kind::Fast,
                angle ? NoisyChannel::Shape::Angle : NoisyChannel::Shape::Wave,
                polled ? 6000 : 12000);
        };
        NoisyChannel inBlocks = make();
        const auto hits = search(inBlocks, condition, holdOff, random, 400);
        NoisyChannel oneByOne = make();
        const auto hitsOneByOne = search(oneByOne, condition, holdOff, random, 3);
        NoisyChannel atOnce = make();
        while (!atOnce.done())
            atOnce.record(1000);
        const auto hitsAtOnce = [&] {
            TriggerSearch whole(condition);
            std::vector<Nanos> all;
            Nanos notBefore = std::numeric_limits<Nanos>::min();
            while (const auto hit = whole.next(*atOnce.channel(), notBefore)) {
                all.push_back(hit->time);
                notBefore = hit->time + holdOff;
            }
            return all;
        }();
        const auto expected = NaiveTriggers(inBlocks.plain(), condition).hits(holdOff);
        QVERIFY2(hits == expected, qPrintable(QString::number(seed)));
        QVERIFY2(hitsOneByOne == expected, qPrintable(QString::number(seed)));
        QVERIFY2(hitsAtOnce == expected, qPrintable(QString::number(seed)));
        found += hits.size();
    }
    QVERIFY2(found > 200, qPrintable(QString::number(found)));
}

void TestScopeTrigger::aMaskSaysOfEachCodeWhatItsHalfLineSays()
{
    const std::array<std::int16_t, kMaskedCodes> codes{
        -32768, -32767, -100, -1, 0, 1, 99, 100, 101, 5000, 32766, 32767, 0, 100, -32768, 32767};
    for (const std::int32_t bound : {-32768, -32767, -1, 0, 100, 32766, 32767}) {
        // The half-lines that there are: nothing lies above all codes, everything below the greatest.
        for (const Half<std::int32_t> half :
            {Half<std::int32_t>{false, bound}, {true, bound + 1}}) {
            const std::uint32_t mask = maskOf(half, codes.data());
            for (std::size_t i = 0; i < codes.size(); ++i)
                QCOMPARE((mask >> i & 1U) != 0, half.holds(codes[i]));
            QCOMPARE(mask & ~kEachMasked, 0U);
        }
    }
}

void TestScopeTrigger::theTimeOfAnEdgeIsFinerThanASample()
{
    const Recorded recorded({{-30, -10, 30, 50}});
    const auto hits = recorded.hits({EdgeTrigger{Slope::Rising, 0.0, 0.0}});
    QCOMPARE(hits.size(), 1U);
    QCOMPARE(hits[0].time, Nanos(1'250'000)); // a quarter of the way from 1 ms to 2 ms
    QCOMPARE(hits[0].sample, Index(2));
    QCOMPARE(hits[0].fraction, 0.25);
}

void TestScopeTrigger::aGapIsNoEdge()
{
    const Recorded recorded({{-30, -20, -10}, {10, 20, 30}, {-10, 10}});
    const auto hits = recorded.hits({EdgeTrigger{Slope::Either, 0.0, 0.0}});
    QCOMPARE(hits.size(), 1U);
    QCOMPARE(hits[0].sample, Index(7));
    QVERIFY(recorded.hits({DropoutTrigger{EdgeTrigger{Slope::Rising, 0.0, 0.0}, Nanos(2'000'000)}})
                .empty());
}

void TestScopeTrigger::anAnglesEndIsNoEdgeUnlessAskedFor()
{
    std::vector<std::int16_t> turns;
    for (int i = 0; i < 300; ++i)
        turns.push_back(std::int16_t((i * 10) % 360 - 180));
    const Recorded recorded({turns});
    TriggerCondition condition{EdgeTrigger{Slope::Falling, 0.0, 0.0}};
    QCOMPARE(recorded.hits(condition).size(), 8U);
    condition.turn = 360.0;
    QVERIFY(recorded.hits(condition).empty());
    condition.what = EdgeTrigger{Slope::Rising, 0.0, 0.0};
    QCOMPARE(recorded.hits(condition).size(), 8U);
}

void TestScopeTrigger::samplesReleasedBeforeTheyWereSearchedAreAGap()
{
    capture::FastColumn column;
    capture::Channel channel({1, 7, "F", "A", 1.0, 0.0, capture::ChannelInfo::Kind::Fast});
    const capture::TickBase base = capture::TickBase::of(1000, 0);
    std::vector<std::int16_t> low(60000, -10);
    std::vector<std::int16_t> high(60000, 10);
    channel.fast()->append(base, 0, 1, low);
    TriggerSearch search({EdgeTrigger{Slope::Rising, 0.0, 0.0}});
    QVERIFY(!search.next(channel, 0));
    channel.fast()->append(base, 60000, 1, high);
    channel.fast()->append(base, 120000, 1, high);
    channel.fast()->releaseOldest(); // with it the edge at 60000
    QVERIFY(!search.next(channel, 0));
    channel.fast()->append(base, 180000, 1, low);
    channel.fast()->append(base, 240000, 1, high);
    const auto hit = search.next(channel, 0);
    QVERIFY(hit);
    QCOMPARE(hit->sample, Index(240000));
}

void TestScopeTrigger::aRecordingIsSearchedInPiecesAsAtOnce()
{
    int found = 0;
    for (std::uint32_t seed = 1; seed <= 700; ++seed) {
        Random random(seed);
        const auto kind = seed % 3 == 0 ? NoisyChannel::Kind::Polled : NoisyChannel::Kind::Fast;
        NoisyChannel noisy(seed, kind, NoisyChannel::Shape::Wave, 3000);
        while (!noisy.done())
            noisy.record(500);
        const capture::Channel &channel = *noisy.channel();
        const Nanos begin = channel.oldest(), end = channel.timeOf(channel.end() - 1);
        const TriggerCondition condition =
            anyCondition(int(seed % 7), random, double(end - begin) / 50);
        for (int i = 0; i < 5; ++i) {
            const Nanos from = begin + Nanos(random()) % (end - begin);
            TriggerSearch search(condition);
            const auto wanted = search.next(channel, from);
            QCOMPARE(findTrigger(channel, condition, from, {}, 1 + random() % 700), wanted);
            found += wanted ? 1 : 0;
        }
    }
    QVERIFY2(found > 700, qPrintable(QString::number(found)));
}

void TestScopeTrigger::aSearchOfARecordingEndsWhenItIsTold()
{
    std::vector<std::int16_t> codes(10'000, 0);
    codes.back() = 100;
    const Recorded recorded({codes});
    TriggerCondition condition;
    condition.what = EdgeTrigger{Slope::Rising, 50.0, 0.0};
    std::vector<double> told;
    const auto proceed = [&told](double done) {
        told.push_back(done);
        return told.size() < 5;
    };
    QVERIFY(!findTrigger(recorded.channel(), condition, 0, proceed, 1000));
    QCOMPARE(told, (std::vector<double>{0.0, 0.1, 0.2, 0.3, 0.4}));
    QVERIFY(findTrigger(recorded.channel(), condition, 0, {}, 1000));
}

void TestScopeTrigger::nonsenseIsRefusedWithAReason()
{
    QVERIFY(!check({EdgeTrigger{}}));
    QCOMPARE(check({EdgeTrigger{Slope::Rising, NAN, 0.0}}), ConditionError::NotFinite);
    QCOMPARE(check({EdgeTrigger{Slope::Rising, 0.0, -1.0}}), ConditionError::NegativeHysteresis);
    QCOMPARE(check({WindowTrigger{WindowTrigger::When::Leaves, 2.0, 1.0, 0.0}}),
        ConditionError::LevelsSwapped);
    QCOMPARE(check({DropoutTrigger{EdgeTrigger{}, 0}}), ConditionError::NoTime);
    QCOMPARE(check({PulseTrigger{PulseTrigger::Polarity::Positive, 0.0, 0.0, {5, 4}}}),
        ConditionError::NoTime);
    QCOMPARE(check({NthEdgeTrigger{EdgeTrigger{}, 0, 0}}), ConditionError::NoCount);
    QVERIFY(!check({EventTrigger{}}));
}

QTEST_APPLESS_MAIN(TestScopeTrigger)
#include "tst_scope_trigger.moc"

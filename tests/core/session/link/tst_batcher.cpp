// Batches on given time: their pace, their number, and what thins while the receiver is behind.
#include "session/link/batcher.h"

#include <QtTest>

using namespace std::chrono_literals;
using session::Batcher;
using session::BatchPtr;

class TestBatcher : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theFirstEventGoesAtOnceAndTheNextBatchAfterItsPeriod();
    void aBatchThatIsALittleLateDoesNotDelayTheNext();
    void noMoreThanTwoBatchesAreUnderWay();
    void everyReadingStaysWhileTheReceiverStandsStill();
    void beyondTheBoundTheNewestReadingOfARegisterWins();
    void everyReadingStaysWhileTheReceiverKeepsUp();
    void readingsAreNotPutBeforeWhatCameFirst();
    void samplesBeyondTheBoundAreLostTicksOfTheNextBlock();
    void endsOfWishesAreNeverThinned();
    void aFloodStaysBounded();
    void theLastWordsDoNotWait();
};

namespace {

const TimePoint kStart{1s};

drive::Event read(drive::RegisterId id, std::int64_t value)
{
    return drive::RegistersRead{
        {{.id = id, .status = drive::ReadStatus::Ok, .value = value, .at = {}}}};
}

/// The values in the only event, which is one of readings.
std::vector<std::int64_t> valuesIn(const BatchPtr &batch)
{
    std::vector<std::int64_t> values;
    if (batch->events.size() == 1)
        for (const drive::Reading &reading :
            std::get<drive::RegistersRead>(batch->events.front()).readings)
            values.push_back(std::get<std::int64_t>(reading.value));
    return values;
}

drive::Event block(capture::Tick tick, std::uint32_t count)
{
    capture::SampleBlock block;
    block.stream = 1;
    block.firstTick = tick;
    block.count = count;
    block.fast.assign(count, 7);
    return block;
}

drive::Event started(std::uint32_t step)
{
    capture::StreamLayout layout{
        .id = 1, .tickHz = 16000, .originSeconds = 0, .fastStep = step, .fast = {{}}, .slow = {}};
    return drive::StreamStarted{layout};
}

/// A batcher whose receiver has taken two batches and acknowledged none.
struct Behind {
    Batcher batcher;
    TimePoint now = kStart;

    explicit Behind(Batcher::Config config = {})
        : batcher(config)
    {
        for (int i = 0; i < config.maxUnacknowledged; ++i) {
            batcher.add(drive::LinkCounters{});
            batcher.take(now);
            now += config.period;
        }
    }
    BatchPtr catchUp()
    {
        batcher.acknowledge();
        return batcher.take(now);
    }
};

} // namespace

void TestBatcher::theFirstEventGoesAtOnceAndTheNextBatchAfterItsPeriod()
{
    Batcher batcher;
    QVERIFY(!batcher.due());
    batcher.add(read(1, 1));
    QVERIFY(*batcher.due() <= kStart);
    QCOMPARE(batcher.take(kStart)->events.size(), 1U);
    batcher.add(read(1, 2));
    QCOMPARE(*batcher.due(), kStart + 16ms);
    QVERIFY(!batcher.take(kStart + 15ms));
    QVERIFY(batcher.take(kStart + 16ms));
    batcher.setCalm(true); // nothing moves
    batcher.acknowledge();
    batcher.add(read(1, 3));
    QVERIFY(batcher.take(kStart + 32ms));
    batcher.acknowledge();
    batcher.add(read(1, 4));
    QCOMPARE(*batcher.due(), kStart + 98ms);
}

void TestBatcher::aBatchThatIsALittleLateDoesNotDelayTheNext()
{
    Batcher batcher({.period = 16ms});
    TimePoint now = kStart;
    batcher.add(read(1, 0));
    QVERIFY(batcher.take(now));
    for (int i = 1; i <= 100; ++i) { // each timer fires a millisecond late
        batcher.acknowledge();
        batcher.add(read(1, i));
        now = *batcher.due() + 1ms;
        QVERIFY(batcher.take(now));
    }
    QCOMPARE(now, kStart + 1601ms);
    // Later than that nothing is made up for: no two batches in quick succession.
    batcher.acknowledge();
    batcher.add(read(1, 101));
    now = *batcher.due() + 15ms;
    QVERIFY(batcher.take(now));
    batcher.acknowledge();
    batcher.add(read(1, 102));
    QCOMPARE(*batcher.due(), now + 16ms);
}

void TestBatcher::noMoreThanTwoBatchesAreUnderWay()
{
    Behind bench;
    bench.batcher.add(read(1, 1));
    QVERIFY(!bench.batcher.due());
    QVERIFY(!bench.batcher.take(bench.now + 10s));
    QVERIFY(bench.catchUp());
}

/// They are drawn: were one left out, the one before would stand in the picture for its time.
void TestBatcher::everyReadingStaysWhileTheReceiverStandsStill()
{
    Behind bench;
    for (int i = 0; i < 500; ++i)
        bench.batcher.add(read(1, i));
    const std::vector<std::int64_t> values = valuesIn(bench.catchUp());
    QCOMPARE(values.size(), 500U);
    for (std::size_t i = 0; i < 500; ++i)
        QCOMPARE(values[i], std::int64_t(i));
}

void TestBatcher::beyondTheBoundTheNewestReadingOfARegisterWins()
{
    Behind bench({.period = 16ms, .maxUnacknowledged = 2, .maxWaitingReadings = 2});
    bench.batcher.add(read(1, 10));
    bench.batcher.add(read(2, 20));
    bench.batcher.add(read(1, 11));
    QCOMPARE(valuesIn(bench.catchUp()), (std::vector<std::int64_t>{20, 11}));
}

void TestBatcher::everyReadingStaysWhileTheReceiverKeepsUp()
{
    Batcher batcher;
    for (int i = 0; i < 5; ++i)
        batcher.add(read(1, i));
    QCOMPARE(valuesIn(batcher.take(kStart)), (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
}

/// What came between them stays there.
void TestBatcher::readingsAreNotPutBeforeWhatCameFirst()
{
    Batcher batcher;
    batcher.add(read(1, 1));
    batcher.add(drive::MotorStatus{});
    batcher.add(read(1, 2));
    const BatchPtr batch = batcher.take(kStart);
    QCOMPARE(batch->events.size(), 3U);
    QVERIFY(std::holds_alternative<drive::MotorStatus>(batch->events[1]));
}

void TestBatcher::samplesBeyondTheBoundAreLostTicksOfTheNextBlock()
{
    Behind bench({.period = 16ms, .maxUnacknowledged = 2, .maxWaitingValues = 250});
    bench.batcher.add(started(2));
    for (int i = 0; i < 5; ++i)
        bench.batcher.add(block(capture::Tick{i} * 200, 100));
    const BatchPtr batch = bench.catchUp();
    QCOMPARE(batch->events.size(), 3U); // the layout and two blocks
    QCOMPARE(batch->droppedForDisplay, 300U);
    bench.batcher.acknowledge();
    bench.batcher.add(block(1000, 100));
    const BatchPtr after = bench.batcher.take(bench.now + 16ms);
    QCOMPARE(std::get<capture::SampleBlock>(after->events.at(0)).lostTicks, 600);
}

void TestBatcher::endsOfWishesAreNeverThinned()
{
    Behind bench;
    for (drive::WishId id = 1; id <= 100; ++id)
        bench.batcher.add(
            drive::Ended{.id = id, .outcome = drive::Outcome::Ok, .reason = {}, .writes = {}});
    QCOMPARE(bench.catchUp()->events.size(), 100U);
}

void TestBatcher::aFloodStaysBounded()
{
    Behind bench({.period = 16ms,
        .maxUnacknowledged = 2,
        .maxWaitingValues = 1000,
        .maxWaitingReadings = 100,
        .maxLinkChanges = 8});
    for (int i = 0; i < 20'000; ++i) {
        bench.batcher.add(read(static_cast<drive::RegisterId>(i % 10), i));
        bench.batcher.add(block(capture::Tick{i} * 100, 100));
        bench.batcher.add(drive::LinkCounters{});
        bench.batcher.add(drive::MotorStatus{});
        bench.batcher.add(drive::LinkChanged{});
    }
    const BatchPtr batch = bench.catchUp();
    QVERIFY2(batch->events.size() <= 100 + 10 + 1 + 1 + 8,
        qPrintable(QString::number(batch->events.size())));
}

void TestBatcher::theLastWordsDoNotWait()
{
    Behind bench;
    QVERIFY(!bench.batcher.takeAll());
    bench.batcher.add(drive::LinkChanged{});
    QCOMPARE(bench.batcher.takeAll()->events.size(), 1U);
}

QTEST_APPLESS_MAIN(TestBatcher)
#include "tst_batcher.moc"

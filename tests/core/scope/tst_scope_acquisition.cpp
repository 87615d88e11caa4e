// Run, Single, Force and Auto of a bench scope, in the time of the samples.
#include "scope/acquisition.h"
#include "support/naive_triggers.h"

#include <QtTest>

using namespace scope;
using State = AcquisitionState;
using Cause = Record::Cause;

class TestScopeAcquisition : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void normalWaitsForTheSamplesAfterTheTrigger();
    void preTriggerPlacesTheRecord();
    void singleStopsAfterOneRecord();
    void autoShowsSomethingWhenNothingComes();
    void aHitPushesAnAutomaticRecordOut();
    void forceMakesARecordWhereTheSamplesEnd();
    void forceWithoutSamplesMakesNoRecord();
    void runForgetsHowFarSamplesReachedBefore();
    void onlyWhatHappensAfterRunCounts();
    void stoppingCutsARecordThatWaits();
    void holdOffKeepsTriggersApart();
    void rollMakesNoRecords();
    void eventsTriggerWhereTheyHappened();
    void anotherChannelIsSearchedFromItsBeginning();
    void recordsDoNotDependOnHowSamplesArrive();
    void recordsOfNormalModeAreThoseOfTheNaiveSearch();
    void historyIsBoundedAndKeepsWhatIsPinned();
    void labelsAreCutBetweenCharacters();
    void releasedRecordsLeaveUnlessPinned();
};

namespace {

constexpr Nanos kMs = 1'000'000;

/// A fast channel at 1 kHz: -10 everywhere, but 10 for `width` samples from each of `pulses` on.
struct Pulses {
    capture::Channel channel{{1, 7, "F", "A", 1.0, 0.0, capture::ChannelInfo::Kind::Fast}};
    std::vector<int> pulses;
    int width = 5;
    int recorded = 0;

    explicit Pulses(std::vector<int> at)
        : pulses(std::move(at))
    {
    }
    /// Records up to that sample, not included.
    const capture::Channel &to(int end)
    {
        for (; recorded < end; ++recorded) {
            std::int16_t code = -10;
            for (const int pulse : pulses) {
                if (recorded >= pulse && recorded < pulse + width)
                    code = 10;
            }
            channel.fast()->append(
                capture::TickBase::of(1000, 0), recorded, 1, std::span(&code, 1));
        }
        return channel;
    }
};

AcquisitionSettings settings(Mode mode)
{
    AcquisitionSettings result;
    result.condition.what = EdgeTrigger{Slope::Rising, 10.0, 0.0}; // where the sample is
    result.mode = mode;
    result.length = 100 * kMs;
    result.preTrigger = 0.25;
    result.autoAfter = 200 * kMs;
    return result;
}

} // namespace

void TestScopeAcquisition::normalWaitsForTheSamplesAfterTheTrigger()
{
    Pulses signal({50, 300});
    Acquisition scope(settings(Mode::Normal));
    QCOMPARE(scope.state(), State::Stop);
    scope.run(nullptr);
    QCOMPARE(scope.state(), State::Armed);
    scope.advance(signal.to(50));
    QCOMPARE(scope.state(), State::Armed);
    scope.advance(signal.to(51));
    QCOMPARE(scope.state(), State::Triggered);
    QCOMPARE(scope.current()->state, Record::State::Waiting);
    QCOMPARE(scope.current()->trigger, 50 * kMs);
    QCOMPARE(scope.current()->held, 51 * kMs);
    scope.advance(signal.to(124));
    QVERIFY(scope.takeRecords().empty());
    scope.advance(signal.to(125));
    QCOMPARE(scope.state(), State::Armed);
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].state, Record::State::Complete);
    QCOMPARE(records[0].from, 25 * kMs);
    QCOMPARE(records[0].to, 125 * kMs);
    QCOMPARE(records[0].age(500 * kMs), 450 * kMs);
    QVERIFY(scope.takeRecords().empty());
}

void TestScopeAcquisition::preTriggerPlacesTheRecord()
{
    for (const double share : {0.0, 0.5, 1.0}) {
        Pulses signal({150});
        AcquisitionSettings wanted = settings(Mode::Normal);
        wanted.preTrigger = share;
        Acquisition scope(wanted);
        scope.run(nullptr);
        scope.advance(signal.to(400));
        const auto records = scope.takeRecords();
        QCOMPARE(records.size(), 1U);
        QCOMPARE(records[0].from, 150 * kMs - Nanos(share * 100 * kMs));
        QCOMPARE(records[0].to - records[0].from, 100 * kMs);
    }
}

void TestScopeAcquisition::singleStopsAfterOneRecord()
{
    Pulses signal({50, 300});
    Acquisition scope(settings(Mode::Single));
    scope.run(nullptr);
    scope.advance(signal.to(1000));
    QCOMPARE(scope.state(), State::Stop);
    QCOMPARE(scope.takeRecords().size(), 1U);
    scope.run(&signal.channel);
    scope.advance(signal.to(1100));
    QCOMPARE(scope.state(), State::Armed);
}

void TestScopeAcquisition::autoShowsSomethingWhenNothingComes()
{
    Pulses signal({1000});
    Acquisition scope(settings(Mode::Auto));
    scope.run(nullptr);
    scope.advance(signal.to(199));
    QCOMPARE(scope.state(), State::Armed);
    scope.advance(signal.to(200));
    QCOMPARE(scope.state(), State::Auto);
    scope.advance(signal.to(900));
    QCOMPARE(scope.state(), State::Auto);
    const auto automatic = scope.takeRecords();
    // At 200 ms, and then 200 ms after the end of each: 275 + 200, 550 + 200.
    QCOMPARE(automatic.size(), 3U);
    QCOMPARE(automatic[1].trigger, 475 * kMs);
    QCOMPARE(automatic[2].trigger, 750 * kMs);
    QCOMPARE(automatic[2].cause, Cause::Automatic);
    scope.advance(signal.to(1010));
    QCOMPARE(scope.state(), State::Triggered);
    scope.advance(signal.to(1100));
    QCOMPARE(scope.takeRecords().back().cause, Cause::Condition);
    QCOMPARE(scope.state(), State::Armed);
}

void TestScopeAcquisition::aHitPushesAnAutomaticRecordOut()
{
    Pulses signal({230});
    Acquisition scope(settings(Mode::Auto));
    scope.run(nullptr);
    scope.advance(signal.to(210)); // automatic at 200 ms, until 275 ms
    QCOMPARE(scope.current()->cause, Cause::Automatic);
    scope.advance(signal.to(400));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].trigger, 230 * kMs);
    QCOMPARE(records[0].cause, Cause::Condition);
}

void TestScopeAcquisition::forceMakesARecordWhereTheSamplesEnd()
{
    Pulses signal({});
    Acquisition scope(settings(Mode::Normal));
    scope.force(5 * kMs);
    QCOMPARE(scope.state(), State::Stop);
    scope.run(nullptr);
    scope.advance(signal.to(500));
    scope.force(2000 * kMs);
    QCOMPARE(scope.state(), State::Triggered);
    scope.advance(signal.to(600));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].trigger, 500 * kMs);
    QCOMPARE(records[0].cause, Cause::Forced);
}

void TestScopeAcquisition::forceWithoutSamplesMakesNoRecord()
{
    for (const Mode mode : {Mode::Normal, Mode::Single, Mode::Auto}) {
        Pulses signal({});
        Acquisition scope(settings(mode));
        scope.run(nullptr);
        scope.force(500 * kMs);
        QCOMPARE(scope.state(), State::Armed);
        QVERIFY(!scope.current());
        scope.advance(signal.to(100));
        QCOMPARE(scope.state(), State::Armed); // nor later
        QVERIFY(scope.takeRecords().empty());
        scope.force(500 * kMs);
        QCOMPARE(scope.current()->trigger, 100 * kMs);
    }
}

void TestScopeAcquisition::runForgetsHowFarSamplesReachedBefore()
{
    Pulses file({});
    Acquisition scope(settings(Mode::Auto));
    scope.run(nullptr);
    scope.advance(file.to(10'000));
    static_cast<void>(scope.takeRecords());
    scope.run(nullptr); // the file is gone, and a board's time begins at zero
    scope.force(20'000 * kMs);
    QVERIFY(!scope.current());
    Pulses live({});
    scope.advance(live.to(10));
    QVERIFY(scope.takeRecords().empty());
    QCOMPARE(scope.state(), State::Armed);
    scope.advance(live.to(300)); // automatic at 200 ms, until 275 ms
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].trigger, 200 * kMs);
}

void TestScopeAcquisition::onlyWhatHappensAfterRunCounts()
{
    Pulses signal({50, 300});
    Acquisition scope(settings(Mode::Normal));
    signal.to(200);
    scope.run(&signal.channel);
    scope.advance(signal.to(500));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].trigger, 300 * kMs);
}

void TestScopeAcquisition::stoppingCutsARecordThatWaits()
{
    Pulses signal({50});
    Acquisition scope(settings(Mode::Normal));
    scope.run(nullptr);
    scope.advance(signal.to(60));
    scope.stop();
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].state, Record::State::Cut);
    QCOMPARE(records[0].held, 60 * kMs);
    QVERIFY(!scope.current());
}

void TestScopeAcquisition::holdOffKeepsTriggersApart()
{
    std::vector<int> pulses;
    for (int at = 50; at < 3000; at += 110)
        pulses.push_back(at);
    Pulses signal(pulses);
    AcquisitionSettings wanted = settings(Mode::Normal);
    wanted.holdOff = 300 * kMs;
    Acquisition scope(wanted);
    scope.run(nullptr);
    scope.advance(signal.to(3000));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 9U);
    for (std::size_t i = 1; i < records.size(); ++i)
        QCOMPARE(records[i].trigger - records[i - 1].trigger, 330 * kMs);
}

void TestScopeAcquisition::rollMakesNoRecords()
{
    Pulses signal({50});
    Acquisition scope(settings(Mode::Roll));
    scope.run(nullptr);
    QCOMPARE(scope.state(), State::Roll);
    scope.advance(signal.to(500));
    scope.force(0);
    QVERIFY(scope.takeRecords().empty());
    QVERIFY(!scope.current());
}

void TestScopeAcquisition::eventsTriggerWhereTheyHappened()
{
    Pulses signal({50});
    AcquisitionSettings wanted = settings(Mode::Normal);
    wanted.condition.what = EventTrigger{EventTrigger::Kind::Fault, 0x6};
    Acquisition scope(wanted);
    scope.run(nullptr);
    scope.advance(signal.to(100));
    scope.event({90 * kMs, EventTrigger::Kind::StateChange, 2});
    scope.event({91 * kMs, EventTrigger::Kind::Fault, 0x1});
    QCOMPARE(scope.state(), State::Armed);
    scope.event({92 * kMs, EventTrigger::Kind::Fault, 0x12});
    QCOMPARE(scope.state(), State::Triggered);
    scope.event({93 * kMs, EventTrigger::Kind::Fault, 0x12}); // inside the record
    scope.advance(signal.to(300));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 1U);
    QCOMPARE(records[0].trigger, 92 * kMs);
    QCOMPARE(records[0].cause, Cause::Event);
}

void TestScopeAcquisition::anotherChannelIsSearchedFromItsBeginning()
{
    Pulses signal({50});
    Pulses other({260});
    other.channel = capture::Channel({2, 7, "F", "A", 1.0, 0.0, capture::ChannelInfo::Kind::Fast});
    Acquisition scope(settings(Mode::Normal));
    scope.run(nullptr);
    scope.advance(signal.to(200));
    scope.advance(other.to(400));
    const auto records = scope.takeRecords();
    QCOMPARE(records.size(), 2U);
    QCOMPARE(records[1].trigger, 260 * kMs);
}

void TestScopeAcquisition::recordsDoNotDependOnHowSamplesArrive()
{
    const auto record = [](std::uint32_t seed, std::size_t most, Mode mode) {
        support::NoisyChannel channel(
            seed, support::NoisyChannel::Kind::Fast, support::NoisyChannel::Shape::Wave, 8000);
        AcquisitionSettings wanted = settings(mode);
        wanted.condition.what = EdgeTrigger{Slope::Rising, 80.0, 5.0};
        wanted.length = 3 * kMs;
        wanted.autoAfter = 5 * kMs;
        Acquisition scope(wanted);
        scope.run(nullptr);
        std::mt19937 random(seed);
        std::vector<Record> records;
        while (!channel.done()) {
            channel.record(1 + random() % most);
            scope.advance(*channel.channel());
            for (Record &one : scope.takeRecords()) {
                one.held = 0;
                records.push_back(one);
            }
        }
        return records;
    };
    std::size_t automatic = 0;
    std::size_t hits = 0;
    for (std::uint32_t seed = 1; seed <= 25; ++seed) {
        for (const Mode mode : {Mode::Normal, Mode::Auto}) {
            const auto small = record(seed, 2, mode);
            const auto large = record(seed, 2000, mode);
            QCOMPARE(small.size(), large.size());
            for (std::size_t i = 0; i < small.size(); ++i) {
                QCOMPARE(small[i].trigger, large[i].trigger);
                QCOMPARE(small[i].cause, large[i].cause);
                (small[i].cause == Cause::Automatic ? automatic : hits) += 1;
            }
        }
    }
    QVERIFY(automatic > 200);
    QVERIFY(hits > 200);
}

void TestScopeAcquisition::recordsOfNormalModeAreThoseOfTheNaiveSearch()
{
    std::size_t found = 0;
    for (std::uint32_t seed = 1; seed <= 25; ++seed) {
        support::NoisyChannel channel(
            seed, support::NoisyChannel::Kind::Fast, support::NoisyChannel::Shape::Wave, 8000);
        AcquisitionSettings wanted = settings(Mode::Normal);
        wanted.condition.what = EdgeTrigger{Slope::Either, 60.0, 2.0};
        wanted.length = 4 * kMs;
        wanted.preTrigger = 0.0;
        Acquisition scope(wanted);
        scope.run(nullptr);
        std::vector<Nanos> triggers;
        while (!channel.done()) {
            channel.record(300);
            scope.advance(*channel.channel());
            for (const Record &one : scope.takeRecords())
                triggers.push_back(one.trigger);
        }
        if (scope.current())
            triggers.push_back(scope.current()->trigger);
        QVERIFY(triggers
            == support::NaiveTriggers(channel.plain(), wanted.condition).hits(wanted.length));
        found += triggers.size();
    }
    QVERIFY(found > 200);
}

void TestScopeAcquisition::historyIsBoundedAndKeepsWhatIsPinned()
{
    RecordHistory history(3);
    for (RecordId id = 1; id <= 5; ++id) {
        Record record;
        record.id = id;
        history.add(record);
        if (id == 2)
            QVERIFY(history.setPinned(2, true));
    }
    QCOMPARE(history.records().size(), 3U);
    QVERIFY(history.find(2) && history.find(4) && history.find(5));
    QVERIFY(history.setPinned(4, true));
    QVERIFY(!history.setPinned(5, true)); // a new record needs a place
    QVERIFY(!history.setPinned(99, true));
    Record again;
    again.id = 5;
    again.label = "x";
    history.add(again);
    QCOMPARE(history.records().size(), 3U);
    QCOMPARE(history.find(5)->label, std::string("x"));
    history.clear();
    QVERIFY(history.records().empty());
}

void TestScopeAcquisition::labelsAreCutBetweenCharacters()
{
    RecordHistory history;
    Record record;
    record.id = 1;
    history.add(record);
    std::string text(199, 'a');
    text += "\xC3\xA4rger"; // a letter of two bytes over the border
    QVERIFY(history.setLabel(1, text));
    QCOMPARE(history.find(1)->label, std::string(199, 'a'));
    QVERIFY(history.setLabel(1, "step 3"));
    QCOMPARE(history.find(1)->label, std::string("step 3"));
}

void TestScopeAcquisition::releasedRecordsLeaveUnlessPinned()
{
    RecordHistory history;
    for (RecordId id = 1; id <= 3; ++id) {
        Record record;
        record.id = id;
        record.to = id * kMs;
        record.state = Record::State::Complete;
        history.add(record);
    }
    QVERIFY(history.setPinned(1, true));
    QVERIFY(history.release(2 * kMs));
    QVERIFY(!history.release(2 * kMs)); // known
    QCOMPARE(history.records().size(), 2U);
    QCOMPARE(history.find(1)->state, Record::State::Released);
    QCOMPARE(history.find(3)->state, Record::State::Complete);
}

QTEST_APPLESS_MAIN(TestScopeAcquisition)
#include "tst_scope_acquisition.moc"

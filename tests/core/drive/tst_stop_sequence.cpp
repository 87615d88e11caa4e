// StopSequence: when a STOP is due to whom, what is claimed on what evidence, and what asking again changes. Numbers
// and times only: no board, no line.
#include "drive/stop_sequence.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using Count = StopSequence::Count;

namespace {

constexpr TimePoint t{10s};

MotorStatus statusOf(MotorState state, double rpm, TimePoint at, int motor = 1)
{
    MotorStatus status;
    status.motor = motor;
    status.state = state;
    status.speedRpm = rpm;
    status.speedMeasured = true;
    status.at = at;
    return status;
}

/// Evidence that the motor is idle and stands.
void seeIdle(StopSequence &stop, TimePoint at, int motor = 1, int readings = 2)
{
    for (int i = 0; i < readings; ++i)
        stop.acceptStatus(statusOf(MotorState::Idle, 0, at, motor), at);
}

std::vector<std::pair<int, StopWord>> words(StopSequence &stop)
{
    std::vector<std::pair<int, StopWord>> all;
    for (const StopProgress &progress : stop.takeProgress())
        all.emplace_back(progress.motor, progress.word);
    return all;
}
using Words = std::vector<std::pair<int, StopWord>>;

} // namespace

class TestStopSequence : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void evidenceFromBeforeTheStopCountsForNothing();
    void aSpeedThatNothingMeasuresIsNeverAStandstill();
    void standstillNeedsThreeSlowReadingsInARow();
    void everyMotorIsStopped();
    void itIsOpenUntilTheBoardHasToldHowManyMotorsItHas();
    void aMotorThatBecomesKnownJoins();
    void aMotorThatTheBoardDoesNotHaveLeaves();
    void askedAgainAnOpenStopKeepsItsHalfSecond();
    void askedAgainAnIdleMotorIsStoppedAnew();
    void eachMotorGetsItsTurnThoughNobodyAnswers();
    void blindTimeCountsFromTheLastPress();
    void followingBeginsNothing();
    void aStopThatIsOverSaysNothingOfTheNext();
    void motorsThatAreOnlyExpectedAreStoppedWithoutALink();
    void aPressIsAStopForEachMotor();
    void aStopThatDidNotLeaveIsDueAtOnce();
    void acceptedIsToldOnce();
    void evidenceCountsFromTheFirstStopAndInARow();
    void ofAMotorThatItDoesNotStopNothingIsTold();
    void noSpeedAtAllIsNoStandstill();
    void itIsOverWhenEveryMotorStands();
    void turnsLeaveALinkTheTime();
    void theNextStopIsTheSoonestOfThoseThatMayLeave();
    void theNextAlarmIsTheSoonestOfThoseToCome();
    void eachWordHasItsRecord();
};

void TestStopSequence::evidenceFromBeforeTheStopCountsForNothing()
{
    StopSequence stop;
    stop.begin(1, t);
    QVERIFY((words(stop) == Words{{1, StopWord::Requested}}));
    stop.acceptStatus(statusOf(MotorState::Idle, 0, t + 2ms), t - 1ms);
    QVERIFY(words(stop).empty());
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(1));
    stop.stopSent(1, t + 3ms);
    stop.acceptStatus(statusOf(MotorState::Idle, 0, t + 4ms), t + 2ms);
    QVERIFY(words(stop).empty());
    stop.acceptStatus(statusOf(MotorState::Running, 1000, t + 6ms), t + 5ms);
    QVERIFY(words(stop).empty());
    stop.acceptStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
    QVERIFY(words(stop).empty());
    stop.acceptStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
    QVERIFY(!stop.exclusive());
    QVERIFY(stop.active());
    stop.handleTimeout(t + 1s);
    QVERIFY(words(stop).empty());
}

void TestStopSequence::aSpeedThatNothingMeasuresIsNeverAStandstill()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.follow(1, Count::Exactly, t);
    stop.stopSent(1, t);
    static_cast<void>(stop.takeProgress());
    const auto tell = [&](std::optional<bool> measured) {
        MotorStatus status = statusOf(MotorState::Idle, 0.0, t + 1ms);
        status.speedMeasured = measured;
        stop.acceptStatus(status, t + 1ms);
    };
    for (int i = 0; i < 5; ++i)
        tell(std::nullopt); // what the board has is not known yet
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
    for (int i = 0; i < StopSequence::kStandstillReadings; ++i)
        tell(false);
    QVERIFY((words(stop) == Words{{1, StopWord::MayCoast}}));
    QVERIFY(!stop.active());
}

void TestStopSequence::standstillNeedsThreeSlowReadingsInARow()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.follow(1, Count::Exactly, t);
    stop.stopSent(1, t);
    static_cast<void>(stop.takeProgress());
    for (const double rpm : {300.0, 300.0, 5.0, -5.0, 10.0, 5.0, 9.0})
        stop.acceptStatus(statusOf(MotorState::Idle, rpm, t + 1ms), t + 1ms);
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
    stop.acceptStatus(statusOf(MotorState::Idle, -9.0, t + 2ms), t + 2ms);
    QVERIFY((words(stop) == Words{{1, StopWord::Standstill}}));
    QVERIFY(!stop.active());
}

void TestStopSequence::everyMotorIsStopped()
{
    StopSequence stop;
    stop.begin(2, t);
    QCOMPARE(words(stop).size(), 2U);
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(1));
    stop.stopSent(1, t);
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(2));
    stop.stopSent(2, t);
    QVERIFY(!stop.stopDue(t + 99ms, true));
    seeIdle(stop, t + 1ms, 1);
    QVERIFY(stop.exclusive());
    QCOMPARE(stop.stopDue(t + 100ms, true), std::optional<int>(2));
    static_cast<void>(stop.takeProgress());
    stop.handleTimeout(t + 499ms);
    QVERIFY(words(stop).empty());
    stop.handleTimeout(t + 500ms);
    QVERIFY((words(stop) == Words{{2, StopWord::NotConfirmed}}));
}

void TestStopSequence::itIsOpenUntilTheBoardHasToldHowManyMotorsItHas()
{
    StopSequence stop;
    QVERIFY(!stop.open());
    stop.begin(1, t);
    stop.follow(1, Count::AtLeast, t);
    stop.stopSent(1, t);
    seeIdle(stop, t + 1ms, 1, 5);
    QVERIFY(stop.open() && stop.active()); // although motor 1 stands
    QVERIFY(!stop.exclusive()); // so that the board can be asked
    stop.follow(1, Count::Exactly, t + 2ms);
    QVERIFY(!stop.open() && !stop.active());
}

void TestStopSequence::aMotorThatBecomesKnownJoins()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    seeIdle(stop, t + 1ms);
    static_cast<void>(stop.takeProgress());
    stop.follow(2, Count::Exactly, t + 300ms);
    QVERIFY((words(stop) == Words{{2, StopWord::Requested}}));
    QVERIFY(stop.open() && stop.exclusive());
    QCOMPARE(stop.stopDue(t + 300ms, true), std::optional<int>(2));
    QCOMPARE(stop.nextAlarm(), std::optional<TimePoint>(t + 800ms)); // its own half second
    stop.handleTimeout(t + 799ms);
    QVERIFY(words(stop).empty());
    stop.handleTimeout(t + 800ms);
    QVERIFY((words(stop) == Words{{2, StopWord::NotConfirmed}}));
    stop.stopSent(2, t + 800ms);
    seeIdle(stop, t + 801ms, 2);
    QVERIFY(!stop.open());
}

void TestStopSequence::aMotorThatTheBoardDoesNotHaveLeaves()
{
    StopSequence stop;
    stop.begin(2, t); // as many as there were before the link was lost
    for (const int motor : {1, 2})
        stop.stopSent(motor, t);
    seeIdle(stop, t + 1ms, 1);
    stop.follow(1, Count::AtLeast, t + 2ms);
    QVERIFY(stop.exclusive()); // it may have them still
    stop.follow(1, Count::Exactly, t + 3ms);
    QVERIFY(!stop.open());
    QVERIFY(!stop.stopDue(t + 1s, true));
}

void TestStopSequence::askedAgainAnOpenStopKeepsItsHalfSecond()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    stop.begin(1, t + 400ms);
    QVERIFY((words(stop) == Words{{1, StopWord::Requested}}));
    QCOMPARE(stop.stopDue(t + 400ms, true), std::optional<int>(1)); // a press is a STOP
    stop.handleTimeout(t + 500ms);
    QVERIFY((words(stop) == Words{{1, StopWord::NotConfirmed}}));
    stop.begin(1, t + 800ms);
    stop.handleTimeout(t + 2s);
    QVERIFY(words(stop).empty()); // it is told once
    QVERIFY(stop.alarmed());
    seeIdle(stop, t + 801ms); // evidence counts from the first STOP
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
}

void TestStopSequence::askedAgainAnIdleMotorIsStoppedAnew()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.follow(1, Count::Exactly, t);
    stop.stopSent(1, t);
    seeIdle(stop, t + 1ms);
    QVERIFY(stop.active() && !stop.open()); // it may run out still
    static_cast<void>(stop.takeProgress());
    stop.begin(1, t + 300ms);
    QVERIFY((words(stop) == Words{{1, StopWord::Requested}}));
    QVERIFY(stop.open());
    seeIdle(stop, t + 200ms); // of before
    QVERIFY(stop.open());
    QCOMPARE(stop.nextAlarm(), std::optional<TimePoint>(t + 800ms));
}

void TestStopSequence::eachMotorGetsItsTurnThoughNobodyAnswers()
{
    for (const bool pressing : {false, true}) {
        StopSequence stop;
        stop.begin(2, t);
        int last = 0;
        QVERIFY(stop.turn() == StopSequence::kRepeat / 2);
        for (TimePoint now = t; now < t + 1s; now += stop.turn()) { // one STOP at a time
            if (pressing)
                stop.begin(2, now);
            const auto motor = stop.stopDue(now, false);
            QVERIFY(motor && *motor != last);
            stop.stopSent(*motor, now);
            last = *motor;
        }
    }
}

void TestStopSequence::blindTimeCountsFromTheLastPress()
{
    StopSequence stop;
    stop.begin(1, t);
    QVERIFY(stop.blind(t + 1999ms));
    QVERIFY(!stop.blind(t + 2s));
    QVERIFY(!stop.stopDue(t + 2s, false));
    QVERIFY(stop.stopDue(t + 2s, true));
    stop.begin(1, t + 1500ms);
    QVERIFY(stop.stopDue(t + 3s, false));
    QVERIFY(!stop.nextStop(false, t + 3500ms));
}

void TestStopSequence::followingBeginsNothing()
{
    StopSequence stop;
    stop.follow(2, Count::Exactly, t);
    QVERIFY(!stop.active() && !stop.open());
    QVERIFY(words(stop).empty());
}

void TestStopSequence::aStopThatIsOverSaysNothingOfTheNext()
{
    StopSequence stop;
    const auto standStill = [&] {
        stop.stopSent(1, t);
        seeIdle(stop, t, 1, 4);
    };
    stop.begin(1, t);
    stop.follow(1, Count::Exactly, t);
    stop.begin(1, t); // the same one
    standStill();
    QVERIFY(!stop.active());
    stop.begin(1, t);
    standStill();
    QVERIFY(stop.open()); // another board may be there by now
}

void TestStopSequence::motorsThatAreOnlyExpectedAreStoppedWithoutALink()
{
    StopSequence stop;
    stop.begin(1, t, 2);
    QVERIFY((words(stop) == Words{{1, StopWord::Requested}, {2, StopWord::Requested}}));
    stop.stopSent(1, t);
    QCOMPARE(stop.stopDue(t, false), std::optional<int>(2));
    QVERIFY(!stop.stopDue(t, true));
    QCOMPARE(stop.nextStop(true, t), std::optional<TimePoint>(t + 100ms));
    stop.follow(2, Count::AtLeast, t);
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(2));
    stop.follow(2, Count::Exactly, t);
    QVERIFY(words(stop).empty()); // it had joined already
    stop.follow(1, Count::Exactly, t);
    QVERIFY(!stop.stopDue(t, true));
    QVERIFY(!stop.stopDue(t, false));
    StopSequence first;
    first.begin(0, t); // a board has one motor at least
    QCOMPARE(first.stopDue(t, false), std::optional<int>(1));
}

void TestStopSequence::aPressIsAStopForEachMotor()
{
    StopSequence stop;
    stop.begin(2, t);
    stop.stopSent(1, t);
    stop.begin(2, t + 50ms);
    for (const int motor : {2, 1}) { // who waits for longer first
        QCOMPARE(stop.stopDue(t + 50ms, true), std::optional<int>(motor));
        stop.stopSent(motor, t + 50ms);
    }
    QVERIFY(!stop.stopDue(t + 149ms, true));
    QVERIFY(stop.stopDue(t + 150ms, true));
}

void TestStopSequence::aStopThatDidNotLeaveIsDueAtOnce()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    QVERIFY(!stop.stopDue(t + 10ms, true));
    stop.stopFailed(1, t + 10ms);
    QCOMPARE(stop.stopDue(t + 10ms, true), std::optional<int>(1));
}

void TestStopSequence::acceptedIsToldOnce()
{
    StopSequence stop;
    stop.begin(2, t);
    static_cast<void>(stop.takeProgress());
    stop.stopAnswered(2, t + 5ms);
    const std::vector<StopProgress> told = stop.takeProgress();
    QCOMPARE(told.size(), 1U);
    QCOMPARE(told[0].motor, 2);
    QVERIFY(told[0].word == StopWord::Accepted && told[0].at == t + 5ms);
    stop.stopAnswered(2, t + 6ms);
    QVERIFY(words(stop).empty());
}

void TestStopSequence::evidenceCountsFromTheFirstStopAndInARow()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    stop.stopSent(1, t + 100ms);
    static_cast<void>(stop.takeProgress());
    const auto tell = [&](MotorState state, int times) {
        for (int i = 0; i < times; ++i)
            stop.acceptStatus(statusOf(state, 0, t), t); // asked for with the first STOP
    };
    tell(MotorState::Idle, 1);
    tell(MotorState::Starting, 1);
    tell(MotorState::Idle, 1);
    QVERIFY(words(stop).empty());
    tell(MotorState::Idle, 1);
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
    tell(MotorState::Idle, 1);
    tell(MotorState::Stopping, 1);
    tell(MotorState::Idle, 3); // the first of them is no second idle one
    QVERIFY(words(stop).empty());
    tell(MotorState::Idle, 1);
    QVERIFY((words(stop) == Words{{1, StopWord::Standstill}}));
    tell(MotorState::Idle, 9);
    QVERIFY(words(stop).empty()); // once
}

void TestStopSequence::ofAMotorThatItDoesNotStopNothingIsTold()
{
    StopSequence stop;
    stop.begin(1, t);
    static_cast<void>(stop.takeProgress());
    stop.stopSent(2, t);
    stop.stopFailed(2, t);
    stop.stopAnswered(2, t);
    seeIdle(stop, t, 2);
    QVERIFY(words(stop).empty());
    QVERIFY(stop.exclusive());
}

void TestStopSequence::noSpeedAtAllIsNoStandstill()
{
    StopSequence stop;
    stop.begin(1, t);
    stop.stopSent(1, t);
    MotorStatus status = statusOf(MotorState::Idle, 0.0, t);
    status.speedRpm.reset();
    static_cast<void>(stop.takeProgress());
    for (int i = 0; i < 9; ++i)
        stop.acceptStatus(status, t);
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
}

void TestStopSequence::itIsOverWhenEveryMotorStands()
{
    StopSequence stop;
    stop.begin(2, t);
    for (const int motor : {1, 2})
        stop.stopSent(motor, t);
    stop.follow(2, Count::Exactly, t);
    seeIdle(stop, t, 1, 4);
    QVERIFY(stop.open() && stop.exclusive());
    seeIdle(stop, t, 2, 3);
    QVERIFY(!stop.open() && stop.active()); // the second one turns still
    seeIdle(stop, t, 2, 1);
    QVERIFY(!stop.active());
}

void TestStopSequence::turnsLeaveALinkTheTime()
{
    constexpr Duration turns[] = {100ms, 100ms, 50ms, 40ms, 40ms};
    for (int motors = 0; motors < 5; ++motors) {
        StopSequence stop;
        stop.begin(motors, t, 0);
        QVERIFY(stop.turn() == turns[motors]);
    }
    StopSequence stop;
    stop.begin(2, t);
    stop.stopSent(1, t);
    seeIdle(stop, t, 1);
    QVERIFY(stop.turn() == 100ms); // who is idle has no turn
}

void TestStopSequence::theNextStopIsTheSoonestOfThoseThatMayLeave()
{
    using Time = std::optional<TimePoint>;
    StopSequence stop;
    QCOMPARE(stop.nextStop(true, t), Time());
    stop.begin(2, t);
    stop.stopSent(1, t + 20ms);
    QCOMPARE(stop.nextStop(true, t), Time(t));
    stop.stopSent(2, t + 10ms);
    QCOMPARE(stop.nextStop(true, t), Time(t + 110ms));
    QCOMPARE(stop.nextStop(false, t), Time(t + 110ms));
    for (const int motor : {1, 2})
        stop.stopSent(motor, t + 1899ms);
    QCOMPARE(stop.nextStop(false, t + 1899ms), Time(t + 1999ms));
    QCOMPARE(stop.nextStop(false, t + 2s), Time()); // too late by now
    QCOMPARE(stop.nextStop(true, t + 2s), Time(t + 1999ms));
    for (const int motor : {1, 2})
        stop.stopSent(motor, t + 1900ms);
    QCOMPARE(stop.nextStop(false, t + 1900ms), Time()); // blind until then, and not longer
    QCOMPARE(stop.nextStop(true, t + 1900ms), Time(t + 2s));
    QVERIFY(stop.blindUntil() == t + 2s);
    stop.end();
    QVERIFY(!stop.blind(t));
}

void TestStopSequence::theNextAlarmIsTheSoonestOfThoseToCome()
{
    using Time = std::optional<TimePoint>;
    StopSequence stop;
    QCOMPARE(stop.nextAlarm(), Time());
    stop.begin(1, t);
    stop.follow(2, Count::Exactly, t + 100ms);
    stop.stopSent(2, t + 100ms);
    QCOMPARE(stop.nextAlarm(), Time(t + 500ms));
    stop.handleTimeout(t + 500ms);
    QCOMPARE(stop.nextAlarm(), Time(t + 600ms));
    QVERIFY(stop.alarmed());
    seeIdle(stop, t + 550ms, 2);
    QCOMPARE(stop.nextAlarm(), Time()); // one was told, the other is idle
    stop.stopSent(1, t + 600ms);
    seeIdle(stop, t + 600ms, 1);
    QVERIFY(!stop.alarmed());
}

void TestStopSequence::eachWordHasItsRecord()
{
    const std::pair<StopWord, Outcome> rows[] = {
        {StopWord::Requested, Outcome::Unknown},
        {StopWord::Accepted, Outcome::Ok},
        {StopWord::DriveIdle, Outcome::Ok},
        {StopWord::Standstill, Outcome::Ok},
        {StopWord::MayCoast, Outcome::Ok},
        {StopWord::NotConfirmed, Outcome::Unknown},
    };
    MotionEntry sent;
    sent.requests = 3;
    for (const auto &[word, outcome] : rows) {
        const MotionEntry entry = entryOf({2, word, t + 30ms}, t, sent);
        QVERIFY(entry.act == MotionAct::Stop && entry.stop == word);
        QVERIFY(entry.outcome == outcome);
        QCOMPARE(entry.motor, 2);
        QCOMPARE(std::size_t{entry.requests}, std::size_t{3});
        QVERIFY(entry.asked == t && entry.ended == t + 30ms);
        QVERIFY(entryOf({2, word, t - 1ms}, t).ended == t); // asked for again meanwhile
    }
}

QTEST_APPLESS_MAIN(TestStopSequence)
#include "tst_stop_sequence.moc"

// StopSequence: when a STOP is due to whom, what is claimed on what evidence, and what asking again changes. Numbers and
// times only: no board, no line.
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
        stop.takeStatus(statusOf(MotorState::Idle, 0, at, motor), at);
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
};

void TestStopSequence::evidenceFromBeforeTheStopCountsForNothing()
{
    StopSequence stop;
    stop.begin(1, t);
    QVERIFY((words(stop) == Words{{1, StopWord::Requested}}));
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 2ms), t - 1ms);
    QVERIFY(words(stop).empty());
    QCOMPARE(stop.stopDue(t, true), std::optional<int>(1));
    stop.stopSent(1, t + 3ms);
    stop.takeStatus(statusOf(MotorState::Idle, 0, t + 4ms), t + 2ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::Running, 1000, t + 6ms), t + 5ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
    QVERIFY(words(stop).empty());
    stop.takeStatus(statusOf(MotorState::FaultOver, 1000, t + 8ms), t + 7ms);
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
        stop.takeStatus(status, t + 1ms);
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
        stop.takeStatus(statusOf(MotorState::Idle, rpm, t + 1ms), t + 1ms);
    QVERIFY((words(stop) == Words{{1, StopWord::DriveIdle}}));
    stop.takeStatus(statusOf(MotorState::Idle, -9.0, t + 2ms), t + 2ms);
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

QTEST_APPLESS_MAIN(TestStopSequence)
#include "tst_stop_sequence.moc"

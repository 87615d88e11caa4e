// Time in which the program did not run: wishes that come too late are never sent, and after a gap the states of the
// motors are read before anything is believed or done.
#include "drive/task.h"
#include "support/link_pair.h"
#include "support/mcb/pair.h"

#include <QTest>

using namespace drive;
using support::McbPair;
using support::Session;
using namespace std::chrono_literals;

namespace {

/// Submits what was made so long ago. @return its id
WishId submitOld(Session &session, decltype(Wish::what) what, Duration age)
{
    static WishId last = 5000;
    session.drive->submit(
        {.id = ++last, .what = std::move(what), .madeAt = session.now - age}, session.now);
    session.exchange();
    return last;
}

const Command kStart{MotorAction::Start, 1};

simulation::BoardOptions boardWithProfile(const QString &profile)
{
    simulation::BoardOptions options;
    options.profile = profile.toStdString();
    if (simulation::isFcpProfile(options.profile))
        options.baud = 115200;
    return options;
}

/// Agrees to move a motor whose board does not tell its limits.
bool becomeExpert(Session &session) { return session.runUntilEnded(session.submit(ExpertMode{1})); }

void profiles()
{
    QTest::addColumn<QString>("profile");
    for (const char *profile : {"mcsdk-6.4", "legacy"})
        QTest::newRow(profile) << QString::fromLatin1(profile);
}

class Probe : public OpenWish {
public:
    explicit Probe(Permission permission)
        : OpenWish(1, permission)
    {
    }
    void leave() { markSent(); }
};

} // namespace

class TestLateWishes : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatWasAskedForLongAgoIsNeverSent_data() { profiles(); }
    void whatWasAskedForLongAgoIsNeverSent();
    void aMotorsEndAndReadingAreNeverTooLate();
    void whatWaitsBehindASilentLineExpires_data() { profiles(); }
    void whatWaitsBehindASilentLineExpires();
    void onlyWhatActsAndHasNotLeftExpires();
    void afterAGapTheStatesAreReadFirst_data() { profiles(); }
    void afterAGapTheStatesAreReadFirst();
    void afterAGapTheDriveOnASpiLineIsDoubtedToo();
    void anAnswerFromBeforeAGapConfirmsNoStop();
    void aGapWithoutALinkChangesNothing();
};

void TestLateWishes::whatWasAskedForLongAgoIsNeverSent()
{
    QFETCH(const QString, profile);
    Session session(true, boardWithProfile(profile));
    QVERIFY(session.ready && becomeExpert(session));
    const WishId late = submitOld(session, kStart, kWishExpiresAfter + 1ms);
    const WishId ramp = submitOld(session, SpeedRamp{1, 1000, 1s}, 8s);
    const WishId write =
        submitOld(session, Write{{{session.id("SPEED_KP"), std::int64_t{1234}}}}, 8s);
    session.runFor(3s);
    for (const WishId id : {late, ramp, write}) {
        QCOMPARE(session.ended.at(id).size(), 1U);
        QVERIFY(session.outcome(id) == Outcome::NotSent);
        QCOMPARE(session.ended.at(id).front().reason, std::string(kTooLate));
    }
    QVERIFY(session.status[1].state == MotorState::Idle);
    QVERIFY(session.drive->armed());

    const WishId inTime = submitOld(session, kStart, kWishExpiresAfter - 50ms);
    QVERIFY(session.runUntilEnded(inTime));
    QVERIFY(session.outcome(inTime) == Outcome::Ok);
}

void TestLateWishes::aMotorsEndAndReadingAreNeverTooLate()
{
    Session session;
    QVERIFY(session.startMotor());
    const WishId read = submitOld(session, Read{{session.id("SPEED_KP")}}, 1h);
    const WishId stop = submitOld(session, Command{MotorAction::StopMotor, 1}, 1h);
    QVERIFY(session.runUntilEnded(read) && session.runUntilEnded(stop));
    QVERIFY(session.outcome(read) == Outcome::Ok);
    QVERIFY(session.outcome(stop) == Outcome::Ok);
    QVERIFY(session.runUntilState(MotorState::Idle));
}

void TestLateWishes::whatWaitsBehindASilentLineExpires()
{
    QFETCH(const QString, profile);
    Session session(true, boardWithProfile(profile));
    QVERIFY(session.ready && becomeExpert(session));
    session.runFor(200ms);
    session.toBoard.cut = true;
    QVERIFY(session.runUntil([&] { return session.link != LinkState::Connected; }, 2s));
    QVERIFY(session.drive->armed()); // a hiccup as yet
    const WishId start = session.submit(kStart);
    session.runFor(600ms);
    session.toBoard.cut = false;
    session.runFor(4s);
    QVERIFY(session.link == LinkState::Connected);
    QVERIFY(session.outcome(start) == Outcome::NotSent);
    QVERIFY(session.status[1].state == MotorState::Idle);
}

void TestLateWishes::onlyWhatActsAndHasNotLeftExpires()
{
    const TimePoint made{10s};
    const auto probe = [&](Permission permission) {
        auto task = std::make_unique<Probe>(permission);
        task->freshen(made);
        return task;
    };
    const auto acting = probe(Permission::Armed), reading = probe(Permission::Always);
    QVERIFY(!acting->expired(made + kWishExpiresAfter));
    QVERIFY(acting->expired(made + kWishExpiresAfter + 1ns));
    QVERIFY(!reading->expired(made + 1h));
    acting->freshen(made + 1s); // the board has answered a question of it
    QVERIFY(!acting->expired(made + 1s + kWishExpiresAfter));
    acting->begin();
    QVERIFY(!acting->expired(made + 1h)); // it moves nothing, and was begun in time
    acting->motion() = MotionEntry{};
    QVERIFY(acting->expired(made + 1h));
    acting->leave();
    QVERIFY(!acting->expired(made + 1h)); // half of a list is worse than a late one
}

void TestLateWishes::afterAGapTheStatesAreReadFirst()
{
    QFETCH(const QString, profile);
    Session session(true, boardWithProfile(profile));
    QVERIFY(session.ready && becomeExpert(session) && session.startMotor());
    session.runFor(300ms);
    // A wish is in flight and two wait while everything stands still.
    session.submit(Read{{session.id("SPEED_KP")}});
    const WishId ramp = session.submit(SpeedRamp{1, 3000, 1s});
    const WishId read = session.submit(Read{{session.id("SPEED_KI")}});
    const TimePoint then = session.now += 8s;
    session.drive->doubt(session.now);
    session.exchange();
    QVERIFY(!session.drive->armed());
    QVERIFY(session.outcome(ramp) == Outcome::NotSent);
    QVERIFY(session.link == LinkState::Suspect);
    session.drive->arm();
    QVERIFY(!session.drive->armed()); // what the motor does now is unknown
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Connected; }, 5s));
    QVERIFY(session.status[1].at > then);
    QVERIFY(!session.ended.contains(read)); // it waited behind the states
    QVERIFY(session.runUntilEnded(read));
    QVERIFY(session.status[1].state == MotorState::Running); // a gap stops no motor by itself
    session.drive->arm();
    QVERIFY(session.drive->armed());
}

void TestLateWishes::afterAGapTheDriveOnASpiLineIsDoubtedToo()
{
    McbPair pair;
    QVERIFY(pair.meet());
    pair.drive->arm();
    pair.exchange();
    QVERIFY(pair.drive->armed());
    const TimePoint then = pair.now += 8s;
    pair.drive->doubt(pair.now);
    const WishId start = pair.submit(kStart);
    QVERIFY(!pair.drive->armed());
    QVERIFY(pair.link == LinkState::Suspect);
    QVERIFY(pair.ended.at(start).front().outcome == Outcome::NotSent);
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Connected; }, 2s));
    QVERIFY(pair.status->at > then);
}

void TestLateWishes::anAnswerFromBeforeAGapConfirmsNoStop()
{
    int confirmedLater = 0;
    for (Duration offset{}; offset < 30ms; offset += 500us) {
        Session session(true, boardWithProfile(QStringLiteral("mcsdk-6.4")));
        QVERIFY(session.ready && session.startMotor());
        session.drive->stop(session.now);
        session.exchange();
        QVERIFY(session.runUntil([&] { return session.board->truth(1).idle; }, 5s));
        session.runFor(offset); // an answer may be on its way
        const TimePoint then = session.now += 1600ms;
        session.drive->doubt(session.now);
        session.exchange();
        session.stops.clear();
        QVERIFY(session.runUntil([&] { return session.link == LinkState::Connected; }, 5s));
        session.runFor(1s);
        for (const StopProgress &said : session.stops)
            confirmedLater += said.word == StopWord::DriveIdle ? 1 : 0;
        QCOMPARE(session.judge.verdict(), std::string());
        QVERIFY(!session.drive->stopOpen());
        QVERIFY(session.status[1].at > then);
    }
    QVERIFY(confirmedLater > 0);
}

void TestLateWishes::aGapWithoutALinkChangesNothing()
{
    Session session(false);
    QVERIFY(session.ready);
    session.drive->disconnect(session.now);
    session.exchange();
    session.runFor(100ms);
    QVERIFY(session.link == LinkState::Closed);
    session.drive->doubt(session.now + 8s);
    session.exchange();
    QVERIFY(session.link == LinkState::Closed);
    session.connect();
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Connected; }, 5s));
    session.runFor(1s);
    session.drive->arm();
    QVERIFY(session.drive->armed());
}

QTEST_APPLESS_MAIN(TestLateWishes)
#include "tst_late_wishes.moc"

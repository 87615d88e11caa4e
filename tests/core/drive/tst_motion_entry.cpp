// The motion log of a drive: every act once, with its outcome and the bytes that left for it. Its words are in
// tst_motion_texts.
#include "drive/motion_entry.h"
#include "support/link_pair.h"

#include <QTest>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

std::vector<MotionEntry> logOf(const Session &session)
{
    std::vector<MotionEntry> log;
    for (const Event &event : session.events)
        if (const auto *entry = std::get_if<MotionEntry>(&event))
            log.push_back(*entry);
    return log;
}

std::vector<MotionAct> actsOf(const Session &session)
{
    std::vector<MotionAct> acts;
    for (const MotionEntry &entry : logOf(session))
        acts.push_back(entry.act);
    return acts;
}

} // namespace

class TestMotionEntry : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSessionIsLoggedActByAct();
    void whatWasNotSentIsLoggedToo();
    void aLostAnswerIsLoggedAsUnknown();
    void theStopsWordsAreLoggedWithTheirBytes();
    void onlyDangerousWritesAreMotion();
    void everyByteThatCanMoveSomethingIsInTheLog();
};

void TestMotionEntry::aSessionIsLoggedActByAct()
{
    Session session;
    const TimePoint asked = session.now;
    QVERIFY(session.runAt(1200));
    QVERIFY(
        actsOf(session) == (std::vector{MotionAct::Arm, MotionAct::Start, MotionAct::SpeedRamp}));
    const MotionEntry start = logOf(session)[1];
    QCOMPARE(start.motor, 1);
    QVERIFY(start.source == Source::Person);
    QVERIFY(start.outcome == Outcome::Ok);
    QVERIFY(start.asked == asked);
    QVERIFY(start.ended > start.asked);
    QCOMPARE(start.requests, 1U);
    QCOMPARE(start.sent, (std::vector<Bytes>{{0x19, 0x00}})); // command 3 of motor 1
    const MotionEntry ramp = logOf(session)[2];
    QCOMPARE(QString::fromStdString(ramp.detail), QStringLiteral("1200 rpm in 500 ms"));
    QVERIFY(ramp.requests >= 1U);
}

void TestMotionEntry::whatWasNotSentIsLoggedToo()
{
    Session session(false);
    const WishId wish = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.outcome(wish) == Outcome::NotSent);
    QCOMPARE(logOf(session).size(), 1U);
    const MotionEntry entry = logOf(session).front();
    QVERIFY(entry.outcome == Outcome::NotSent);
    QCOMPARE(QString::fromStdString(entry.reason), QStringLiteral("not armed"));
    QCOMPARE(entry.requests, 0U);

    session.drive->arm();
    const WishId refused = session.submit(SpeedRamp{1, 1000000, 100ms});
    QVERIFY(session.runUntilEnded(refused));
    QVERIFY(logOf(session).back().outcome == Outcome::Refused);
    QCOMPARE(logOf(session).back().requests, 0U);
}

void TestMotionEntry::aLostAnswerIsLoggedAsUnknown()
{
    Session session;
    const WishId wish = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntil(
        [&] { return support::count(session.requests, mcp::CommandId::StartMotor) == 1; }, 1s));
    session.toDrive.cut = true;
    QVERIFY(session.runUntilEnded(wish, 10s));
    const auto log = logOf(session);
    const auto start = std::find_if(log.begin(), log.end(),
        [](const MotionEntry &entry) { return entry.act == MotionAct::Start; });
    QVERIFY(start != log.end());
    QVERIFY(start->outcome == session.outcome(wish));
    QVERIFY(start->outcome == Outcome::Unknown);
    QCOMPARE(start->requests, 1U);
}

void TestMotionEntry::theStopsWordsAreLoggedWithTheirBytes()
{
    Session session;
    QVERIFY(session.runAt(1200));
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
    std::vector<StopWord> words;
    std::size_t stops = 0;
    for (const MotionEntry &entry : logOf(session))
        if (entry.stop) {
            QVERIFY(entry.act == MotionAct::Stop);
            QCOMPARE(entry.motor, 1);
            words.push_back(*entry.stop);
            stops += entry.requests;
        }
    QVERIFY(words
        == (std::vector{
            StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, StopWord::MayCoast}));
    QCOMPARE(stops, support::count(session.requests, mcp::CommandId::StopMotor));
    const auto acts = actsOf(session);
    QVERIFY(std::find(acts.begin(), acts.end(), MotionAct::Disarm) != acts.end());
}

void TestMotionEntry::onlyDangerousWritesAreMotion()
{
    Session session;
    const WishId gain = session.submit(Write{{{session.id("SPEED_KP"), std::int64_t{1000}}}});
    QVERIFY(session.runUntilEnded(gain));
    QVERIFY(actsOf(session) == std::vector{MotionAct::Arm});
    const WishId both = session.submit(Write{{{session.id("SPEED_KP"), std::int64_t{1001}},
        {session.id("SPEED_REF"), std::int64_t{600}}}});
    QVERIFY(session.runUntilEnded(both));
    const MotionEntry entry = logOf(session).back();
    QVERIFY(entry.act == MotionAct::Write);
    QCOMPARE(QString::fromStdString(entry.detail), QStringLiteral("SPEED_REF = 600 rpm"));
    QCOMPARE(entry.motor, 1);
    QVERIFY(entry.requests >= 1U);
}

void TestMotionEntry::everyByteThatCanMoveSomethingIsInTheLog()
{
    Session session;
    const std::size_t before = session.requests.size();
    QVERIFY(session.runAt(1500));
    QVERIFY(session.runUntilEnded(session.submit(TorqueRamp{1, 0.5, 100ms})));
    QVERIFY(session.runUntilEnded(session.submit(CurrentReference{1, 0.2, 0.0})));
    QVERIFY(session.runUntilEnded(
        session.submit(Write{{{session.id("CONTROL_MODE"), std::int64_t{3}}}})));
    QVERIFY(session.runUntilEnded(session.submit(Command{MotorAction::StopRamp, 1})));
    QVERIFY(session.runUntilEnded(session.submit(Command{MotorAction::StopMotor, 1})));
    session.drive->stop(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
    std::vector<Bytes> left, logged;
    for (std::size_t i = before; i < session.requests.size(); ++i)
        if (support::changesSomething(session.requests[i]))
            left.push_back(session.requests[i]);
    for (const MotionEntry &entry : logOf(session))
        logged.insert(logged.end(), entry.sent.begin(), entry.sent.end());
    QVERIFY(left.size() > 5);
    std::sort(left.begin(), left.end());
    std::sort(logged.begin(), logged.end());
    QCOMPARE(logged, left);
}

QTEST_GUILESS_MAIN(TestMotionEntry)
#include "tst_motion_entry.moc"

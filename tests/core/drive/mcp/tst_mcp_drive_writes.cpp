// Writes of McpDrive: checked before they leave, read back after, and honest about what is unknown.
#include "support/link_pair.h"

#include <QTest>

#include <limits>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

class TestMcpDriveWrites : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aWriteTellsBeforeAndAfter();
    void everyRegisterOfAListHasItsOwnEnd();
    void ofWhatIsWatchedOnlyParametersAreKnownBefore();
    void aListGoesOutInAsFewRequestsAsFit();
    void whatSharesARequestStaysAligned();
    void aListIsReadBackWhereItsAnswerIsNotClear();
    void aListWhoseAnswerWasLostIsSettledByReadingBack();
    void aListThatNeverArrivedIsWrittenAgainOnce();
    void anUnplugTellsWhatWasWrittenAndWhatIsNotKnown();
    void valuesThatDoNotFitNeverLeave();
    void setPointsBeyondTheLimitsAreRefused();
    void rampRegistersReadBackInTheirOwnForm();
    void speedsThatTheBoardRoundsAreWrittenAllTheSame();
    void whatIsKeptForTheNextStartIsNoOtherValue_data();
    void whatIsKeptForTheNextStartIsNoOtherValue();
    void whatTheNextStartMayGoToIsNotRefused_data()
    {
        whatIsKeptForTheNextStartIsNoOtherValue_data();
    }
    void whatTheNextStartMayGoToIsNotRefused();
    void theNewestWaitingWriteWins();
    void aLostAnswerIsSettledByReadingBack();
    void whatWasNotCarriedOutIsWrittenAgainOnce();
    void commandsAreNeverRepeated();
    void aSpeedRampLeavesTorqueControlByItself();
};

void TestMcpDriveWrites::aWriteTellsBeforeAndAfter()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP");
    const WishId read = session.submit(Read{{kp}});
    QVERIFY(session.runUntilEnded(read));
    const Value old = session.values[kp].value;
    const WishId write = session.submit(Write{{{kp, std::int64_t{-1234}}}});
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.outcome == Outcome::Ok);
    QCOMPARE(end.writes.size(), 1U);
    QVERIFY(end.writes[0].before == old);
    QVERIFY(end.writes[0].readBack == Value(std::int64_t{-1234}));
    QVERIFY(session.values[kp].value == Value(std::int64_t{-1234}));
}

void TestMcpDriveWrites::everyRegisterOfAListHasItsOwnEnd()
{
    Session session;
    const WishId write = session.submit(Write{{
        {session.id("SPEED_KP"), std::int64_t{11}},
        {session.id("BUS_VOLTAGE"), std::int64_t{11}},
        {session.id("FLUXWK_KP"), std::int64_t{11}}, // not in this build
        {session.id("ASYNC_UARTA"), Bytes{0, 0}},
        {0xFFF1, std::int64_t{0}},
        {session.id("SPEED_KI"), 12.0},
    }});
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.outcome == Outcome::Refused);
    QCOMPARE(end.writes.size(), 6U);
    QVERIFY(end.writes[0].outcome == Outcome::Ok);
    QCOMPARE(end.writes[1].reason, "cannot be written");
    QCOMPARE(end.writes[2].reason, "UNKNOWN_REG");
    QCOMPARE(end.writes[3].reason, "is set by streaming");
    QCOMPARE(end.writes[4].reason, "no such register");
    QVERIFY(end.writes[5].outcome == Outcome::Ok);
    QVERIFY(end.writes[5].readBack == Value(std::int64_t{12}));
}

namespace {

const std::vector<const char *> kGains{"SPEED_KP_DIV", "SPEED_KI_DIV", "I_Q_KP_DIV", "I_Q_KI_DIV",
    "I_D_KP_DIV", "I_D_KI_DIV", "STOPLL_KP_DIV", "SPEED_KP", "SPEED_KI", "SPEED_KD", "I_Q_KP",
    "I_Q_KI", "I_Q_KD", "I_D_KP", "I_D_KI", "I_D_KD", "STOPLL_C1", "STOPLL_C2", "STOPLL_KI",
    "STOPLL_KP"};

Write gains(const Session &session, std::int64_t first)
{
    Write write;
    for (const char *name : kGains)
        write.writes.push_back({session.id(name), first++});
    return write;
}

std::vector<Bytes> setsIn(const Session &session)
{
    std::vector<Bytes> sets;
    for (const Bytes &request : session.requests)
        if (support::changesSomething(request))
            sets.push_back(request);
    return sets;
}

bool allAre(const Ended &end, Outcome outcome)
{
    return std::all_of(end.writes.begin(), end.writes.end(),
        [outcome](const WriteResult &result) { return result.outcome == outcome; });
}

bool allVerified(const Ended &end)
{
    return std::all_of(end.writes.begin(), end.writes.end(),
        [](const WriteResult &result) { return result.verified == true; });
}

} // namespace

/// A reference is what the motor follows: firmware changes it by itself.
void TestMcpDriveWrites::ofWhatIsWatchedOnlyParametersAreKnownBefore()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP"), ki = session.id("SPEED_KI"),
                     reference = session.id("SPEED_REF");
    session.submit(Watch{{kp, reference}, 50ms});
    session.runFor(130ms);
    const std::size_t before = session.requests.size();
    session.submit(Watch{});
    const WishId write = session.submit(
        Write{{{kp, std::int64_t{123}}, {ki, std::int64_t{45}}, {reference, std::int64_t{600}}}});
    QVERIFY(session.runUntilEnded(write));
    for (const WriteResult &result : session.ended[write].front().writes)
        QVERIFY(result.before && result.outcome == Outcome::Ok);
    const auto first = session.requests.begin() + static_cast<std::ptrdiff_t>(before);
    const auto set = std::find_if(first, session.requests.end(), support::changesSomething);
    std::set<RegisterId> asked;
    for (auto at = first; at != set; ++at)
        for (std::size_t i = 2; i + 1 < at->size(); i += 2)
            asked.insert(RegisterId{(*at)[i]} | RegisterId{(*at)[i + 1]} << 8);
    QVERIFY(!asked.contains(kp));
    QVERIFY(asked.contains(ki) && asked.contains(reference));
}

void TestMcpDriveWrites::aListGoesOutInAsFewRequestsAsFit()
{
    for (const std::size_t rxMax : {256U, 32U}) {
        simulation::BoardOptions options;
        options.rxMax = rxMax;
        Session session(true, options);
        const WishId write = session.submit(gains(session, 3));
        QVERIFY(session.runUntilEnded(write));
        const Ended &end = session.ended[write].front();
        QVERIFY(end.outcome == Outcome::Ok && allAre(end, Outcome::Ok) && allVerified(end));
        QCOMPARE(end.writes.size(), kGains.size());
        // A command word and four bytes a register: 20, or 7 + 7 + 6.
        QCOMPARE(setsIn(session).size(), rxMax == 256U ? 1U : 3U);
        for (const Bytes &set : setsIn(session))
            QVERIFY(set.size() <= rxMax);
    }
}

void TestMcpDriveWrites::whatSharesARequestStaysAligned()
{
    Session session;
    const WishId write = session.submit(Write{{
        {session.id("SPEED_KP"), std::int64_t{11}},
        {session.id("FF_1Q"), std::int64_t{1}}, // 32 bits, at 8
        {session.id("FF_1D"), std::int64_t{1}}, // would be at 14
        {session.id("QUASI_SYNCH"), std::int64_t{1}}, // 8 bits: nothing behind it
        {session.id("SPEED_KI"), std::int64_t{12}},
        {session.id("SPEED_REF"), std::int64_t{600}}, // can move something: alone
        {session.id("SPEED_KD"), std::int64_t{13}},
    }});
    QVERIFY(session.runUntilEnded(write));
    std::vector<std::size_t> sizes;
    for (const Bytes &set : setsIn(session))
        sizes.push_back(set.size());
    QVERIFY((sizes == std::vector<std::size_t>{2 + 4 + 6, 2 + 6 + 3, 2 + 4, 2 + 6, 2 + 4}));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.writes[0].outcome == Outcome::Ok); // its neighbour was refused
    for (const std::size_t absent : {1U, 2U, 3U})
        QCOMPARE(end.writes[absent].reason, "UNKNOWN_REG");
    for (const std::size_t written : {4U, 6U})
        QVERIFY(end.writes[written].verified == true);
}

void TestMcpDriveWrites::aListIsReadBackWhereItsAnswerIsNotClear()
{
    // As printed, the good ones of a list with a failure report CMD_NOK too.
    simulation::BoardOptions options;
    options.profile = "spec";
    Session session(true, options);
    const WishId write = session.submit(Write{{{session.id("SPEED_KP"), std::int64_t{11}},
        {session.id("FLUXWK_KP"), std::int64_t{11}}, {session.id("SPEED_KI"), std::int64_t{12}}}});
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.writes[0].outcome == Outcome::Ok && end.writes[0].verified == true);
    QVERIFY(end.writes[1].outcome == Outcome::Refused && !end.writes[1].verified);
    QVERIFY(end.writes[2].outcome == Outcome::Ok && end.writes[2].verified == true);
}

void TestMcpDriveWrites::aListWhoseAnswerWasLostIsSettledByReadingBack()
{
    Session session;
    const WishId write = session.submit(gains(session, 5));
    QVERIFY(session.runUntil([&] { return setsIn(session).size() == 1; }, 1s));
    session.toDrive.cut = true; // the SET arrives, its answer does not
    session.runFor(30ms);
    session.toDrive.cut = false;
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.outcome == Outcome::Ok && allAre(end, Outcome::Ok) && allVerified(end));
    QCOMPARE(setsIn(session).size(), 1U);
}

void TestMcpDriveWrites::aListThatNeverArrivedIsWrittenAgainOnce()
{
    Session session;
    session.loses = [&](const Bytes &output) {
        return setsIn(session).size() == 1 && output == setsIn(session).front();
    };
    const WishId write = session.submit(gains(session, 5));
    QVERIFY(session.runUntil([&] { return setsIn(session).size() == 2; }, 5s));
    session.loses = nullptr;
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.outcome == Outcome::Ok && allVerified(end));
    QCOMPARE(setsIn(session).size(), 2U);
}

void TestMcpDriveWrites::anUnplugTellsWhatWasWrittenAndWhatIsNotKnown()
{
    simulation::BoardOptions options;
    options.rxMax = 32;
    Session session(true, options);
    const WishId write = session.submit(gains(session, 3));
    QVERIFY(session.runUntil([&] { return setsIn(session).size() == 2; }, 1s));
    session.drive->disconnect(session.now); // as when the port is gone
    session.toDrive.cut = session.toBoard.cut = true;
    QVERIFY(session.runUntilEnded(write));
    const Ended &end = session.ended[write].front();
    QVERIFY(end.outcome == Outcome::Unknown);
    QCOMPARE(end.writes.size(), kGains.size());
    for (std::size_t i = 0; i < end.writes.size(); ++i)
        QVERIFY(end.writes[i].outcome
            == (i < 7        ? Outcome::Ok
                    : i < 14 ? Outcome::Unknown
                             : Outcome::NotSent));
}

void TestMcpDriveWrites::valuesThatDoNotFitNeverLeave()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP"), mode = session.id("CONTROL_MODE");
    const std::size_t before = session.requests.size();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<RegisterWrite> bad{{kp, std::int64_t{32768}}, {kp, std::int64_t{-32769}},
        {kp, nan}, {kp, 1.5}, {kp, 1e300}, {kp, std::string("7")}, {kp, Bytes{7, 0}},
        {mode, std::int64_t{256}}, {mode, std::int64_t{-1}},
        {session.id("SPEED_RAMP"), std::int64_t{5}}, {session.id("SPEED_RAMP"), Bytes{0}},
        {session.id("SPEED_RAMP"), Bytes(7)}, {session.id("TORQUE_RAMP"), Bytes(4)},
        {session.id("CURRENT_REF"), Bytes(3)}, {session.id("REVUP_DATA"), Bytes{}}};
    for (const RegisterWrite &write : bad) {
        const WishId wish = session.submit(Write{{write}});
        QVERIFY(session.runUntilEnded(wish));
        QVERIFY(session.outcome(wish) == Outcome::Refused);
        QVERIFY(!session.ended[wish].front().writes[0].reason.empty());
    }
    for (std::size_t i = before; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
}

void TestMcpDriveWrites::setPointsBeyondTheLimitsAreRefused()
{
    Session session;
    const MotorLimits limits = session.identified->limits.at(0);
    const auto tooFast = static_cast<std::int32_t>(limits.maxSpeedRpm) + 1;
    const double current = std::min(
        limits.nominalCurrentAmps, limits.maxCurrentAmps > 0 ? limits.maxCurrentAmps : 1e9);
    const double amps = session.identified->catalog->readScale(session.id("I_Q")).factor;
    const auto digits = static_cast<std::int64_t>(current / amps) + 2;
    const std::size_t before = session.requests.size();
    std::vector<WishId> wishes;
    wishes.push_back(session.submit(SpeedRamp{1, tooFast, 100ms}));
    wishes.push_back(session.submit(SpeedRamp{1, -tooFast, 100ms}));
    wishes.push_back(session.submit(SpeedRamp{1, 100, 70s}));
    wishes.push_back(session.submit(TorqueRamp{1, -1.01 * current, 100ms}));
    wishes.push_back(session.submit(TorqueRamp{1, std::numeric_limits<double>::infinity(), 0ms}));
    wishes.push_back(session.submit(CurrentReference{1, 0.8 * current, 0.8 * current}));
    const auto put = [&](const char *name, Value value) {
        wishes.push_back(session.submit(Write{{{session.id(name), std::move(value)}}}));
    };
    put("SPEED_REF", std::int64_t{tooFast});
    put("I_Q_REF", -digits);
    put("SPEED_RAMP", ByteWriter().s32(tooFast).u16(100).take());
    put("TORQUE_RAMP", ByteWriter().s32(static_cast<std::int32_t>(digits)).u16(100).take());
    put("CURRENT_REF", ByteWriter().s16(static_cast<std::int32_t>(digits)).s16(0).take());
    session.runFor(1s);
    for (const WishId wish : wishes) {
        QVERIFY(session.outcome(wish) == Outcome::Refused);
        QVERIFY(!session.ended[wish].front().reason.empty());
    }
    for (std::size_t i = before; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
    const WishId within = session.submit(SpeedRamp{1, tooFast - 1, 100ms});
    QVERIFY(session.runUntilEnded(within));
    QVERIFY(session.outcome(within) == Outcome::Ok);
}

void TestMcpDriveWrites::rampRegistersReadBackInTheirOwnForm()
{
    Session session;
    const WishId write =
        session.submit(Write{{{session.id("TORQUE_RAMP"), ByteWriter().s32(-50).u16(200).take()}}});
    QVERIFY(session.runUntilEnded(write));
    QVERIFY(session.outcome(write) == Outcome::Ok);
    QVERIFY(session.ended[write].front().writes[0].readBack
        == Value(ByteWriter().s16(-50).u16(200).take()));
}

/// It keeps whole steps of 0.1 Hz, 6 rpm, cut towards zero.
void TestMcpDriveWrites::speedsThatTheBoardRoundsAreWrittenAllTheSame()
{
    Session session;
    const auto speedRamp = [](std::int32_t rpm) { return ByteWriter().s32(rpm).u16(500).take(); };
    const auto stages = [](std::int32_t rpm) {
        ByteWriter bytes;
        for (std::int32_t i = 0; i < 5; ++i)
            bytes.s32(i % 2 == 0 ? rpm : -rpm).s16(300).u16(200);
        return bytes.take();
    };
    const auto wish = session.submit(Write{{{session.id("SPEED_RAMP"), speedRamp(1000)},
        {session.id("REVUP_DATA"), stages(1000)}, {session.id("SPEED_RAMP"), speedRamp(-1003)},
        {session.id("REVUP_DATA"), stages(5)}, {session.id("REVUP_DATA"), stages(996)}}});
    QVERIFY(session.runUntilEnded(wish));
    QVERIFY(session.ended[wish].front().outcome == Outcome::Ok);
    const WishId one = session.submit(Write{
        {{session.id("SPEED_RAMP"), speedRamp(1000)}, {session.id("REVUP_DATA"), stages(-1001)}}});
    QVERIFY(session.runUntilEnded(one));
    const auto &writes = session.ended[one].front().writes;
    QVERIFY(writes[0].readBack == Value(speedRamp(996)));
    QVERIFY(writes[1].readBack == Value(stages(-996)));
    QVERIFY(allVerified(session.ended[one].front()));
    // A later write of the same list makes another value of the first: that is not the board's rounding.
    const WishId two = session.submit(Write{
        {{session.id("REVUP_DATA"), stages(1000)}, {session.id("REVUP_DATA"), stages(1002)}}});
    QVERIFY(session.runUntilEnded(two));
    QVERIFY(session.ended[two].front().writes[0].verified == false);
    QVERIFY(session.ended[two].front().writes[1].verified == true);
}

namespace {

/// Firmware keeps it for the next start; until then it shows the old one.
Value keptForTheStart(const QByteArray &name)
{
    return name == "SPEED_REF" ? Value(std::int64_t{1002})
        : name == "I_Q_REF"    ? Value(std::int64_t{50})
                               : Value(ByteWriter().s16(50).s16(-20).take());
}

} // namespace

void TestMcpDriveWrites::whatIsKeptForTheNextStartIsNoOtherValue_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("speed") << QByteArray("SPEED_REF");
    QTest::newRow("Iq") << QByteArray("I_Q_REF");
    QTest::newRow("both currents") << QByteArray("CURRENT_REF");
}

void TestMcpDriveWrites::whatIsKeptForTheNextStartIsNoOtherValue()
{
    QFETCH(QByteArray, name);
    Session session;
    const auto wish =
        session.submit(Write{{{session.id(name.constData()), keptForTheStart(name)}}});
    QVERIFY(session.runUntilEnded(wish));
    const Ended &ended = session.ended.at(wish).front();
    QVERIFY2(ended.outcome == Outcome::Ok, ended.reason.c_str());
    const WriteResult &result = ended.writes.front();
    QVERIFY(result.before && result.readBack == result.before);
    QVERIFY(!result.verified);
    QVERIFY2(
        result.reason.starts_with("taken, and shown from the next start"), result.reason.c_str());
}

/// Its answer is lost: the old value is shown, taken or not.
void TestMcpDriveWrites::whatTheNextStartMayGoToIsNotRefused()
{
    QFETCH(QByteArray, name);
    Session session;
    const std::size_t before = support::count(session.requests, mcp::CommandId::SetRegister);
    const auto sets = [&] {
        return support::count(session.requests, mcp::CommandId::SetRegister) - before;
    };
    const WishId wish =
        session.submit(Write{{{session.id(name.constData()), keptForTheStart(name)}}});
    QVERIFY(session.runUntil([&] { return sets() == 1; }, 1s));
    session.toDrive.cut = true; // the SET arrives, its answer does not
    session.runFor(30ms);
    session.toDrive.cut = false;
    QVERIFY(session.runUntilEnded(wish));
    const Ended &ended = session.ended.at(wish).front();
    QVERIFY2(ended.outcome == Outcome::Unknown, ended.reason.c_str());
    QVERIFY(ended.writes.front().readBack == ended.writes.front().before);
    QCOMPARE(sets(), 1U);
}

void TestMcpDriveWrites::theNewestWaitingWriteWins()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP"), ki = session.id("SPEED_KI");
    std::vector<WishId> wishes;
    for (int i = 1; i <= 10; ++i)
        wishes.push_back(session.submit(Write{{{kp, std::int64_t{i}}}}));
    const WishId other = session.submit(Write{{{ki, std::int64_t{77}}}});
    QVERIFY(session.runUntilEnded(other));
    session.runFor(100ms);
    std::size_t notSent = 0;
    for (const WishId wish : wishes) {
        QCOMPARE(session.ended[wish].size(), 1U);
        notSent += session.outcome(wish) == Outcome::NotSent;
    }
    QVERIFY(notSent >= 8);
    QVERIFY(session.outcome(wishes.back()) == Outcome::Ok);
    QVERIFY(session.values[kp].value == Value(std::int64_t{10}));
}

void TestMcpDriveWrites::aLostAnswerIsSettledByReadingBack()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP");
    const std::size_t before = support::count(session.requests, mcp::CommandId::SetRegister);
    const WishId write = session.submit(Write{{{kp, std::int64_t{4321}}}});
    QVERIFY(session.runUntil(
        [&] { return support::count(session.requests, mcp::CommandId::SetRegister) > before; },
        1s));
    session.toDrive.cut = true; // the SET arrives, its answer does not
    session.runFor(30ms);
    session.toDrive.cut = false;
    QVERIFY(session.runUntilEnded(write));
    QVERIFY(session.outcome(write) == Outcome::Ok);
    QVERIFY(session.ended[write].front().writes[0].readBack == Value(std::int64_t{4321}));
    QCOMPARE(support::count(session.requests, mcp::CommandId::SetRegister), before + 1);
}

void TestMcpDriveWrites::whatWasNotCarriedOutIsWrittenAgainOnce()
{
    Session session;
    const RegisterId kp = session.id("SPEED_KP");
    const Bytes set{0x08, 0x00, 0x91, 0x00, 0xE1, 0x10};
    const auto sets = [&] {
        return std::count(session.requests.begin(), session.requests.end(), set);
    };
    session.loses = [&](const Bytes &output) { return output == set && sets() == 1; };
    const WishId write = session.submit(Write{{{kp, std::int64_t{0x10E1}}}});
    QVERIFY(session.runUntilEnded(write));
    QVERIFY(session.outcome(write) == Outcome::Ok);
    QCOMPARE(sets(), 2);
}

void TestMcpDriveWrites::commandsAreNeverRepeated()
{
    for (const bool reachesTheBoard : {true, false}) {
        Session session;
        session.runFor(50ms);
        const WishId start = session.submit(Command{MotorAction::Start, 1});
        if (!reachesTheBoard)
            session.toBoard.cut = true;
        QVERIFY(session.runUntil(
            [&] { return support::count(session.requests, mcp::CommandId::StartMotor) == 1; }, 1s));
        session.toDrive.cut = true;
        session.runFor(30ms);
        session.toDrive.cut = session.toBoard.cut = false;
        QVERIFY(session.runUntilEnded(start));
        QVERIFY(session.outcome(start) == (reachesTheBoard ? Outcome::Unknown : Outcome::NotSent));
        session.runFor(3s);
        QCOMPARE(support::count(session.requests, mcp::CommandId::StartMotor), 1U);
        QCOMPARE(session.status[1].state == MotorState::Running, reachesTheBoard);
    }
}

/// Speed control that is asked for by its number goes to the speed of its last time at once, which may brake hard.
void TestMcpDriveWrites::aSpeedRampLeavesTorqueControlByItself()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    Session session(true, options);
    QVERIFY(session.runAt(1000));
    session.runUntilEnded(session.submit(drive::TorqueRamp{1, 0.8, 0ms}));
    QVERIFY(session.runUntil([&] { return session.board->truth(1).rpm > 2000.0; }, 5s));
    QVERIFY(session.runUntilEnded(session.submit(drive::SpeedRamp{1, 2200, 500ms})));
    const Bytes byNumber{0x08, 0x00, 0x89, 0x00, 0x03};
    QCOMPARE(std::count(session.requests.begin(), session.requests.end(), byNumber), 0);
    session.runFor(1s);
    QVERIFY(std::abs(session.board->truth(1).rpm - 2200.0) < 30.0);
    QVERIFY(session.runUntilEnded(session.submit(Read{{session.id("CONTROL_MODE")}})));
    QVERIFY(session.values[session.id("CONTROL_MODE")].value == Value(std::int64_t{3}));
}

QTEST_APPLESS_MAIN(TestMcpDriveWrites)
#include "tst_mcp_drive_writes.moc"

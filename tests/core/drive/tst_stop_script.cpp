// What stops the motors when the program is gone: a board that runs and from then on hears nothing but the script
// stops, whatever was half-way on the line. Its answers are not read.
#include "aspep/packet.h"
#include "drive/protocol_table.h"
#include "fcp/request.h"
#include "support/fcp_bench.h"
#include "support/link_pair.h"
#include "support/mcb/pair.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using support::FcpBench;
using support::LinkPair;
using support::McbPair;

namespace {

constexpr Duration kEvery = 100ms;
constexpr int kTwoSeconds = 20; ///< repetitions

/// Says the script to the board, by a clock alone: nothing that the board sends is read.
void play(LinkPair &pair, const std::vector<Output> &script, int times)
{
    const auto pass = [&pair](Duration time) {
        for (const TimePoint end = pair.now + time; pair.now < end;) {
            pair.now = std::min(end, pair.now + 250us);
            pair.board->advance(pair.now);
            (void)pair.board->takeOutput();
        }
    };
    for (int i = 0; i < times; ++i) {
        const TimePoint began = pair.now;
        for (const Output &output : script) {
            pass(output.gapBefore);
            pair.board->receive(output.bytes, pair.now);
            pass(wireTime(output.bytes.size(), pair.baud));
        }
        pass(std::max<Duration>(Duration::zero(), began + kEvery - pair.now));
    }
}

/// What the board says of its motor to a program that is started anew. The one before says nothing more.
bool stopped(LinkPair &dead, const simulation::BoardOptions &options = {}, int motor = 1)
{
    LinkPair pair(options);
    pair.now = dead.now;
    std::swap(pair.board, dead.board);
    pair.connect();
    const bool told = pair.runUntil([&] { return pair.status.contains(motor); }, 10s);
    std::swap(pair.board, dead.board);
    dead.now = pair.now;
    return told && pair.status.at(motor).state != MotorState::Running
        && pair.status.at(motor).state != MotorState::Starting;
}

const simulation::BoardOptions kTwoMotors = [] {
    simulation::BoardOptions options;
    options.motors = 2;
    return options;
}();

bool startBoth(support::Session &session)
{
    for (int motor = 1; motor <= 2; ++motor) {
        session.submit(Command{MotorAction::Start, motor});
        if (!session.runUntil(
                [&] { return session.status[motor].state == MotorState::Running; }, 10s))
            return false;
    }
    return true;
}

Bytes asked(std::size_t length)
{
    const auto header = aspep::encodeHeader(aspep::Data{false, static_cast<std::uint16_t>(length)});
    return {header.begin(), header.end()};
}

} // namespace

class TestStopScript : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aConnectedBoardStopsWithTheFirstRound();
    void aConfiguredBoardStopsWithTheFirstRound();
    void aRequestInFlightDoesNotKeepItFromStopping();
    void aBoardThatWaitsForAPayloadStopsAllTheSame();
    void everyMotorStops();
    void ofADriveThatHeardNothingItStopsWhatWasMetBefore_data();
    void ofADriveThatHeardNothingItStopsWhatWasMetBefore();
    void aBoardOfTheOlderProtocolStops_data();
    void aBoardOfTheOlderProtocolStops();
    void aDriveOnSpiStopsInEitherState_data();
    void aDriveOnSpiStopsInEitherState();
    void beforeAutoKnowsItSpeaksEveryLanguage();
    void theScriptStartsNothing();
    void withoutItTheMotorGoesOn();
};

void TestStopScript::aConnectedBoardStopsWithTheFirstRound()
{
    support::Session session;
    QVERIFY(session.startMotor());
    play(session, session.drive->stopScript(), 1);
    QVERIFY(stopped(session));
}

void TestStopScript::aConfiguredBoardStopsWithTheFirstRound()
{
    support::Session session;
    QVERIFY(session.startMotor());
    const auto script = session.drive->stopScript();
    play(session, {script.front()}, 1); // the BEACON alone
    play(session, script, 1);
    QVERIFY(stopped(session));
}

void TestStopScript::aRequestInFlightDoesNotKeepItFromStopping()
{
    for (Duration when = 0us; when < 6ms; when += 250us) {
        support::Session session;
        QVERIFY(session.startMotor());
        session.submit(Read{{session.id("MOTOR_CONFIG")}});
        session.runFor(when);
        play(session, session.drive->stopScript(), 4);
        QVERIFY2(stopped(session), qPrintable(QString::number(when / 1us)));
    }
}

void TestStopScript::aBoardThatWaitsForAPayloadStopsAllTheSame()
{
    const std::size_t step = qEnvironmentVariableIsSet("ROTORSCOPE_LONG") ? 1 : 13;
    for (std::size_t missing = 2; missing <= 256; missing += step) {
        support::Session session;
        QVERIFY(session.startMotor());
        session.runFor(20ms);
        play(session, {{asked(missing), 2ms}}, 1); // and nothing behind it
        play(session, session.drive->stopScript(), missing <= 80 ? 3 : 6);
        QVERIFY2(stopped(session), qPrintable(QString::number(missing)));
    }
}

void TestStopScript::everyMotorStops()
{
    support::Session session(true, kTwoMotors);
    QVERIFY(startBoth(session));
    play(session, session.drive->stopScript(), 2);
    QVERIFY(stopped(session, kTwoMotors, 1));
    QVERIFY(stopped(session, kTwoMotors, 2));
}

void TestStopScript::ofADriveThatHeardNothingItStopsWhatWasMetBefore_data()
{
    QTest::addColumn<Protocol>("protocol");
    QTest::newRow("told what is spoken") << Protocol::Mcp;
    QTest::newRow("finds it out") << Protocol::Auto;
}

void TestStopScript::ofADriveThatHeardNothingItStopsWhatWasMetBefore()
{
    QFETCH(const Protocol, protocol);
    support::Session session(true, kTwoMotors);
    QVERIFY(startBoth(session));
    const auto next = makeDrive({.protocol = protocol, .baud = session.baud, .patience = {}});
    next->remember(session.drive->memory());
    next->connect(session.now);
    play(session, next->takeOutput(), 1); // its BEACON, for which the board leaves the connection
    play(session, next->stopScript(), 2);
    QVERIFY(stopped(session, kTwoMotors, 1));
    QVERIFY(stopped(session, kTwoMotors, 2));
}

void TestStopScript::aBoardOfTheOlderProtocolStops_data()
{
    QTest::addColumn<QString>("profile");
    QTest::addColumn<int>("cut"); ///< bytes of a frame that a dying program got out
    for (const char *profile : {"legacy", "legacy-text", "powerpc"})
        for (int cut = 0; cut < 9; ++cut)
            QTest::addRow("%s %d", profile, cut) << QString::fromLatin1(profile) << cut;
}

void TestStopScript::aBoardOfTheOlderProtocolStops()
{
    QFETCH(const QString, profile);
    QFETCH(const int, cut);
    FcpBench bench(qPrintable(profile));
    QVERIFY(bench.ready);
    QVERIFY(bench.start());
    bench.runFor(100ms);
    // SET_RAMP of 100 rpm, as far as it came.
    Bytes frame = *fcp::encodeRequest({1, fcp::SetRamp{100, 500}});
    frame.resize(static_cast<std::size_t>(cut));
    play(bench, {{frame, 20ms}}, 1);
    play(bench, bench.drive->stopScript(), cut == 0 ? 1 : kTwoSeconds);
    QVERIFY(stopped(bench, support::boardOf(qPrintable(profile))));
}

void TestStopScript::aDriveOnSpiStopsInEitherState_data()
{
    QTest::addColumn<bool>("streams");
    QTest::addColumn<bool>("taken"); ///< the script, before the drive went into the other state
    QTest::newRow("config") << false << false;
    QTest::newRow("cyclic") << true << false;
    QTest::newRow("cyclic, taken before") << true << true;
}

void TestStopScript::aDriveOnSpiStopsInEitherState()
{
    QFETCH(const bool, streams);
    QFETCH(const bool, taken);
    McbPair pair;
    QVERIFY(pair.meet());
    pair.drive->arm();
    QVERIFY(pair.ask(Command{}).outcome == Outcome::Ok);
    QVERIFY(pair.runUntilState(MotorState::Running));
    std::vector<Output> script = pair.drive->stopScript();
    if (streams) {
        Stream stream;
        stream.fast = {pair.id("FBK_CUR_A_VALUE")};
        const auto id = pair.submit(stream);
        if (!taken)
            QVERIFY(pair.runUntilEnded(id));
        QVERIFY(
            pair.runUntil([&] { return pair.board->frameBytes() > mcb::kConfigFrameBytes; }, 5s));
        script = pair.drive->stopScript();
    }
    QVERIFY(pair.board->servo().state() == simulation::Servo::State::Enabled);
    for (const Output &output : script) {
        pair.now += output.gapBefore;
        pair.board->advance(pair.now);
        (void)pair.board->exchange(output.bytes, pair.now);
    }
    pair.now += 50ms;
    pair.board->advance(pair.now);
    QVERIFY(pair.board->servo().state() != simulation::Servo::State::Enabled);
}

void TestStopScript::beforeAutoKnowsItSpeaksEveryLanguage()
{
    const auto mcp = makeDrive({.protocol = Protocol::Mcp, .baud = 115200, .patience = {}});
    const auto older = makeDrive({.protocol = Protocol::Fcp, .baud = 115200, .patience = {}});
    const auto any = makeDrive({.protocol = Protocol::Auto, .baud = 115200, .patience = {}});
    any->connect(TimePoint{1s});
    Bytes all, expected;
    for (const Output &output : any->stopScript())
        all.insert(all.end(), output.bytes.begin(), output.bytes.end());
    for (const auto *drive : {mcp.get(), older.get()})
        for (const Output &output : drive->stopScript())
            expected.insert(expected.end(), output.bytes.begin(), output.bytes.end());
    QCOMPARE(all, expected);
}

void TestStopScript::theScriptStartsNothing()
{
    support::Session session;
    QVERIFY(session.runUntilState(MotorState::Idle));
    play(session, session.drive->stopScript(), kTwoSeconds);
    QVERIFY(stopped(session));
}

/// Or the tests above would prove nothing.
void TestStopScript::withoutItTheMotorGoesOn()
{
    support::Session session;
    QVERIFY(session.startMotor());
    play(session, {}, kTwoSeconds);
    QVERIFY(!stopped(session));
    FcpBench bench("legacy");
    QVERIFY(bench.start());
    play(bench, {}, kTwoSeconds);
    QVERIFY(!stopped(bench, support::boardOf("legacy")));
}

QTEST_GUILESS_MAIN(TestStopScript)
#include "tst_stop_script.moc"

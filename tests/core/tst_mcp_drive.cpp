// McpDrive against the simulated board: what a person's session is made of, on virtual time.
#include "support/link_pair.h"

#include "mcp/protocol.h"
#include "mcp/request.h"

#include <QTest>

#include <cmath>

using namespace drive;
using support::LinkPair;
using namespace std::chrono_literals;

namespace {

/// A session that is connected, identified and, if wanted, armed.
struct Session : LinkPair {
    explicit Session(
        bool toArm = true, const simulation::BoardOptions &options = {}, std::uint64_t seed = 1)
        : LinkPair(options, seed)
    {
        connect();
        ready = runUntilIdentified();
        if (toArm)
            drive->arm();
    }
    bool ready = false;

    WishId startMotor()
    {
        const WishId wish = submit(Command{MotorAction::Start, 1});
        runUntilState(MotorState::Running);
        return wish;
    }
};

std::vector<std::uint16_t> commandsIn(const std::vector<Bytes> &requests)
{
    std::vector<std::uint16_t> commands;
    for (const Bytes &request : requests)
        if (const auto decoded = mcp::decodeRequest(request))
            commands.push_back(decoded->command);
    return commands;
}

[[maybe_unused]] std::size_t count(const std::vector<Bytes> &requests, mcp::CommandId command)
{
    const auto all = commandsIn(requests);
    return static_cast<std::size_t>(
        std::count(all.begin(), all.end(), static_cast<std::uint16_t>(command)));
}

bool moves(const Bytes &request)
{
    const auto decoded = mcp::decodeRequest(request);
    if (!decoded)
        return true;
    if (decoded->command == static_cast<std::uint16_t>(mcp::CommandId::GetRegister))
        return false;
    if (decoded->command != static_cast<std::uint16_t>(mcp::CommandId::SetRegister))
        return true;
    for (const auto &write : mcp::decodeSetList(decoded->content).writes)
        if (write.id.element() < 20 || write.id.element() > 22 || write.id.type() != 5)
            return true;
    return false;
}

} // namespace

class TestMcpDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void connectsAndSaysWhatBoardItIs();
    void nothingMovesUnasked();
    void readsWatchesAndNotices();
};

void TestMcpDrive::connectsAndSaysWhatBoardItIs()
{
    Session session(false);
    QVERIFY(session.ready);
    QVERIFY(session.link == LinkState::Connected);
    const Identified &board = *session.identified;
    QCOMPARE(board.identity.motors, 1);
    QVERIFY(board.identity.knownFirmware);
    QVERIFY(board.identity.version.starts_with("6.4"));
    QVERIFY(!board.identity.firmware.empty());
    QVERIFY(!board.identity.controlBoard.empty());
    QCOMPARE(board.streaming.tickHz, 16000.0);
    QCOMPARE(board.streaming.maxSignals, 10U);
    QCOMPARE(board.streaming.linkBytesPerSecond, 184320.0);
    QVERIFY(board.limits.at(0).maxSpeedRpm > 0);
    QVERIFY(board.limits.at(0).nominalCurrentAmps > 0);
    QVERIFY(board.limits.at(0).polePairs > 0);
    for (const Capability &capability : board.capabilities)
        QVERIFY2(capability.available, capability.reason.c_str());
    QCOMPARE(board.catalog->readScale(session.id("I_Q")).unit, "A");
    // Version first, then the state, then the datalog stopped, then the rest.
    QCOMPARE(session.requests.at(0), (Bytes{0x10, 0x00, 0x28, 0x00}));
    QCOMPARE(session.requests.at(1), (Bytes{0x10, 0x00, 0x19, 0x00, 0x49, 0x00}));
    QCOMPARE(session.requests.at(2).at(2), 0x29);
    QCOMPARE(session.requests.at(2).at(3), 0x05);
    QVERIFY(session.runUntil(
        [&] { return session.status.contains(1) && session.status[1].speedRpm; }, 1s));
    QVERIFY(session.status[1].state == MotorState::Idle);
    QCOMPARE(session.status[1].stateName, "IDLE");
}

void TestMcpDrive::nothingMovesUnasked()
{
    Session session;
    session.submit(Watch{{session.id("I_Q_MEAS"), session.id("BUS_VOLTAGE")}, 50ms});
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(2s);
    session.board->reset();
    session.runFor(3s);
    QVERIFY(session.link == LinkState::Connected);
    for (const Bytes &request : session.requests)
        QVERIFY(!moves(request));
}

void TestMcpDrive::readsWatchesAndNotices()
{
    Session session(false);
    const WishId read = session.submit(Read{{session.id("BUS_VOLTAGE"), session.id("MOTOR_NAME"),
        session.id("SPEED_KP"), session.id("MOTOR_CONFIG"), session.id("ENCODER_SPEED")}});
    QVERIFY(session.runUntilEnded(read));
    QVERIFY(session.outcome(read) == Outcome::Ok);
    QVERIFY(session.values[session.id("BUS_VOLTAGE")].status == ReadStatus::Ok);
    QVERIFY(std::get<std::int64_t>(session.values[session.id("BUS_VOLTAGE")].value) > 0);
    QCOMPARE(std::get<Bytes>(session.values[session.id("MOTOR_CONFIG")].value).size(), 60U);
    QVERIFY(session.values[session.id("ENCODER_SPEED")].status == ReadStatus::NotSupported);

    std::vector<RegisterId> everything;
    for (const auto &info : session.identified->catalog->registers())
        if (info.readable() && !info.stub)
            everything.push_back(session.identified->catalog->withMotor(info, 1));
    int rounds = 0, unsupported = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *batch = std::get_if<RegistersRead>(&event)) {
            for (const Reading &reading : batch->readings) {
                rounds += reading.id == session.id("BUS_VOLTAGE");
                unsupported += reading.id == session.id("ENCODER_SPEED");
            }
        }
    };
    session.submit(Watch{everything, 100ms});
    session.runFor(3s);
    QVERIFY2(rounds >= 10, std::to_string(rounds).c_str());
    QCOMPARE(unsupported, 1);
    QCOMPARE(session.counters.timeouts, 0U);
}

QTEST_APPLESS_MAIN(TestMcpDrive)
#include "tst_mcp_drive.moc"

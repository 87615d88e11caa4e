// The static board of the older serial protocol where firmware surprises: half duplex, the frame timer, old bytes, what
// waits for the motor to run, and how a client brings a half received frame to its end.
#include "simulation/fcp/board.h"
#include "simulation/fcp/motor_board.h"

#include <QtTest>

#include <random>

using namespace simulation;
using namespace std::chrono_literals;
using fcp::encodeAck;
using fcp::encodeFrame;
using fcp::encodeNack;
using fcp::ErrorCode;

class TestFcpBoard : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anAnswerTakesItsTimeOnTheLine();
    void whatComesWhileItSendsIsLost();
    void aDeadTimerLeavesAFrameHalfReceived();
    void aLiveTimerRefusesAFrameThatTakesTooLong();
    void checksComeInTheOrderOfTheFirmware();
    void aGoodMotorIsSelectedEvenIfItsFrameIsRefused();
    void whatIsTooShortIsFilledWithOldBytes();
    void speedsAreKeptInStepsOf16Bits_data();
    void speedsAreKeptInStepsOf16Bits();
    void commandsWaitUntilTheMotorRuns();
    void ofTwoQuickWritesOfReferencesTheFirstIsLost();
    void aRevUpWhereThereIsNoneHangsTheFirmware();
    void missingPartsOfABuildAreRefused_data();
    void missingPartsOfABuildAreRefused();
    void statesMoveOnlyWhereTheyMay();
    void clearedReferencesAreZero();
    void powerPcRefusesWhatItsTextDoesNotKnow();
    void aHalfReceivedFrameCanAlwaysBeFilledUp();
    void faultsOfTheLineAreAsAsked();
    void aResetMakesItAsItWas();
    void aMotorGoesThroughTheStatesOfAMoment();
};

namespace {

constexpr Duration kByte = wireTime(1, 115200);

/// A board and its time. Each request waits until all is silent again.
struct Bench {
    explicit Bench(FcpRig rig = {}, Duration delay = {})
        : board(std::move(rig), 115200, delay)
    {
    }
    Bytes pass(Duration time)
    {
        board.advance(now += time);
        return board.takeOutput();
    }
    Bytes send(const Bytes &bytes)
    {
        board.receive(bytes, now);
        return pass(100ms);
    }
    Bytes ask(std::uint8_t header, const Bytes &payload)
    {
        return send(encodeFrame(header, payload));
    }

    FcpBoard board;
    TimePoint now{};
};

FcpRig runningRig()
{
    FcpRig rig;
    rig.motors[0].state = 6;
    return rig;
}

const Bytes kOk = encodeAck();

} // namespace

void TestFcpBoard::anAnswerTakesItsTimeOnTheLine()
{
    Bench bench({}, 2ms);
    bench.board.receive(encodeFrame(0x02, Bytes{0x02}), bench.now);
    QVERIFY(bench.pass(4 * kByte + 2ms).empty());
    QCOMPARE(bench.pass(kByte), Bytes{0xF0});
    QVERIFY(bench.board.nextWake() == bench.now + kByte);
    QCOMPARE(bench.pass(3 * kByte), (Bytes{0x01, 0x00, 0xF1}));
    QVERIFY(bench.board.nextWake() > bench.now + 1s);
}

void TestFcpBoard::whatComesWhileItSendsIsLost()
{
    Bench bench;
    Bytes two = encodeFrame(0x02, Bytes{0x02});
    const Bytes second = encodeFrame(0x02, Bytes{0x03});
    two.insert(two.end(), second.begin(), second.end());
    QCOMPARE(bench.send(two), encodeAck(Bytes{0}));
    QCOMPARE(bench.send(second), encodeAck(Bytes{1}));
}

void TestFcpBoard::aDeadTimerLeavesAFrameHalfReceived()
{
    Bench bench;
    QVERIFY(bench.send({0x02, 0x01}).empty());
    QVERIFY(bench.pass(10s).empty());
    QCOMPARE(bench.send({0x02, 0x05}), encodeAck(Bytes{0}));
    bench.board.expireFrame(); // nothing is under way
    QVERIFY(bench.pass(100ms).empty());
}

void TestFcpBoard::aLiveTimerRefusesAFrameThatTakesTooLong()
{
    FcpRig rig;
    rig.frameTimer = 25ms;
    Bench bench(rig);
    bench.board.receive(Bytes{0x02, 0x01}, bench.now);
    QVERIFY(bench.pass(kByte + 25ms - 1ns).empty()); // from the header on, not from the last byte
    QVERIFY(bench.board.nextWake() == bench.now + 1ns);
    QCOMPARE(bench.pass(100ms), encodeNack(ErrorCode::Timeout));
    QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{0}));
    QVERIFY(bench.pass(1s).empty());
}

void TestFcpBoard::checksComeInTheOrderOfTheFirmware()
{
    Bench bench;
    QVERIFY(bench.send({0x02, 0xFF}).empty());
    QCOMPARE(bench.send({0x42, 0x01, 0x05, 0x00}), encodeNack(ErrorCode::BadChecksum));
    QCOMPARE(bench.ask(0x5E, {}), encodeNack(ErrorCode::BadMotor));
    QCOMPARE(bench.ask(0x1E, {}), encodeNack(ErrorCode::BadFrameCode));
    QCOMPARE(bench.ask(0x00, {}), encodeNack(ErrorCode::Undefined));
    QCOMPARE(bench.ask(0x12, Bytes(8, 0)), encodeNack(ErrorCode::Undefined));
}

void TestFcpBoard::aGoodMotorIsSelectedEvenIfItsFrameIsRefused()
{
    FcpRig rig;
    rig.motors.resize(2);
    Bench bench(rig);
    QCOMPARE(bench.send({0x42, 0x01, 0x05, 0x00}), encodeNack(ErrorCode::BadChecksum));
    QCOMPARE(bench.ask(0x02, {0x00}), encodeAck(Bytes{0}));
    QCOMPARE(bench.ask(0x5E, {}), encodeNack(ErrorCode::BadFrameCode));
    QCOMPARE(bench.ask(0x02, {0x00}), encodeAck(Bytes{1}));
}

void TestFcpBoard::whatIsTooShortIsFilledWithOldBytes()
{
    Bench bench(runningRig());
    QCOMPARE(bench.ask(0x01, {0x05, 0x34, 0x12}), kOk);
    QCOMPARE(bench.ask(0x01, {0x05, 0x78}), kOk);
    QCOMPARE(bench.ask(0x02, {0x05}), encodeAck(Bytes{0x78, 0x12}));
    QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{6}));
    QCOMPARE(bench.ask(0x03, {}), kOk); // runs command 2, a stop
    QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{7}));
}

void TestFcpBoard::speedsAreKeptInStepsOf16Bits_data()
{
    QTest::addColumn<int>("asked");
    QTest::addColumn<int>("kept");
    QTest::newRow("cut") << 1000 << 996;
    QTest::newRow("cut toward zero") << -1999 << -1998;
    QTest::newRow("too small") << 5 << 0;
    QTest::newRow("wraps") << 200000 << -193218;
    QTest::newRow("least") << INT32_MIN << 6 * std::int16_t(INT32_MIN / 6);
}

void TestFcpBoard::speedsAreKeptInStepsOf16Bits()
{
    QFETCH(int, asked);
    QFETCH(int, kept);
    Bench bench;
    QCOMPARE(bench.ask(0x07, ByteWriter().s32(asked).u16(0).take()), kOk);
    QCOMPARE(bench.ask(0x02, {0x5B}), encodeAck(ByteWriter().s32(kept).take()));
}

void TestFcpBoard::commandsWaitUntilTheMotorRuns()
{
    Bench bench;
    QCOMPARE(bench.ask(0x07, ByteWriter().s32(600).u16(100).take()), kOk);
    bench.board.executeBuffered();
    QCOMPARE(bench.ask(0x02, {0x04}), encodeAck(Bytes(4, 0)));
    bench.board.setState(6);
    QCOMPARE(bench.ask(0x02, {0x04}), encodeAck(Bytes(4, 0)));
    bench.board.executeBuffered();
    QCOMPARE(bench.ask(0x02, {0x04}), encodeAck(ByteWriter().s32(600).take()));
    // A torque ramp of which only the lower 16 bits count.
    QCOMPARE(bench.ask(0x0D, ByteWriter().s32(40000).u16(0).take()), kOk);
    QCOMPARE(bench.ask(0x02, {0x03}), encodeAck(Bytes{0}));
    bench.board.executeBuffered();
    QCOMPARE(bench.ask(0x02, {0x08}), encodeAck(ByteWriter().s16(-25536).take()));
}

void TestFcpBoard::ofTwoQuickWritesOfReferencesTheFirstIsLost()
{
    Bench bench(runningRig());
    QCOMPARE(bench.ask(0x01, {0x08, 0x10, 0x00}), kOk);
    QCOMPARE(bench.ask(0x01, {0x0C, 0x20, 0x00}), kOk);
    bench.board.executeBuffered();
    QCOMPARE(bench.ask(0x02, {0x08}), encodeAck(Bytes{0, 0}));
    QCOMPARE(bench.ask(0x02, {0x0C}), encodeAck(Bytes{0x20, 0}));
    QCOMPARE(bench.ask(0x02, {0x41}), encodeAck(Bytes{0x20, 0})); // the same under its other number
}

void TestFcpBoard::aRevUpWhereThereIsNoneHangsTheFirmware()
{
    FcpRig rig;
    rig.motors[0].revUp.resize(5);
    Bench with(rig);
    QCOMPARE(with.ask(0x09, Bytes(9, 5)), kOk); // stage 5 lands somewhere else
    QCOMPARE(with.ask(0x02, {0x22}), encodeAck(Bytes{5}));
    Bench without;
    QCOMPARE(without.ask(0x02, {0x22}), encodeAck(Bytes{0}));
    QCOMPARE(without.ask(0x08, {0}), encodeAck(Bytes(8, 0)));
    QVERIFY(without.ask(0x09, Bytes(9, 0)).empty());
    QVERIFY(without.board.server().hangs());
    QVERIFY(without.ask(0x02, {0x22}).empty());
    QVERIFY(without.send({0x02, 0x01, 0x05, 0x00}).empty());
    without.board.reset();
    QCOMPARE(without.ask(0x02, {0x22}), encodeAck(Bytes{0}));
}

void TestFcpBoard::missingPartsOfABuildAreRefused_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<int>("readError"); // 0: none
    QTest::addColumn<int>("writeError");
    QTest::newRow("PLL") << 0x10 << 3 << 5;
    QTest::newRow("CORDIC") << 0x12 << 3 << 2;
    QTest::newRow("flux weakening") << 0x16 << 3 << 5;
    QTest::newRow("feed forward") << 0x46 << 3 << 5;
    QTest::newRow("PFC") << 0x4F << 3 << 5;
    QTest::newRow("DAC") << 0x1C << 3 << 0;
    QTest::newRow("DAC source") << 0x23 << 3 << 2;
    QTest::newRow("unknown") << 0xC8 << 3 << 2;
    QTest::newRow("read only") << 0x1E << 0 << 2;
}

void TestFcpBoard::missingPartsOfABuildAreRefused()
{
    QFETCH(int, id);
    QFETCH(int, readError);
    QFETCH(int, writeError);
    FcpRig rig;
    rig.motors[0].sensing = FcpMotor::Sensing::Hall;
    Bench bench(rig);
    const auto number = static_cast<std::uint8_t>(id);
    const Bytes read = bench.ask(0x02, {number});
    const Bytes write = bench.ask(0x01, {number, 1, 0, 0, 0});
    if (readError == 0)
        QCOMPARE(int(read[0]), 0xF0);
    else
        QCOMPARE(read, encodeNack(static_cast<ErrorCode>(readError)));
    QCOMPARE(write, writeError == 0 ? kOk : encodeNack(static_cast<ErrorCode>(writeError)));
}

void TestFcpBoard::statesMoveOnlyWhereTheyMay()
{
    for (int before = 0; before <= 20; ++before) {
        for (int command = 1; command <= 14; ++command) {
            FcpRig rig;
            rig.motors[0].state = static_cast<std::uint8_t>(before);
            Bench bench(rig);
            bench.ask(0x03, {static_cast<std::uint8_t>(command)});
            const bool starts = command == 1 || command == 6;
            const bool stops = command == 2 || command == 6 || command == 14;
            const int after = before == 0 && starts ? 3
                : before == 6 && stops              ? 7
                : before == 11 && command == 7      ? 9
                                                    : before;
            QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{static_cast<std::uint8_t>(after)}));
        }
    }
}

void TestFcpBoard::clearedReferencesAreZero()
{
    FcpRig rig = runningRig();
    rig.motors[0].registers = {{0x08, 5}, {0x0C, 6}};
    Bench bench(rig);
    QCOMPARE(bench.ask(0x03, {0x09}), kOk);
    QCOMPARE(bench.ask(0x02, {0x08}), encodeAck(Bytes{0, 0}));
    QCOMPARE(bench.ask(0x02, {0x0C}), encodeAck(Bytes{0, 0}));
}

void TestFcpBoard::powerPcRefusesWhatItsTextDoesNotKnow()
{
    FcpRig rig;
    rig.dialect = fcp::Dialect::PowerPc;
    Bench bench(rig);
    for (const int code : {0x00, 0x0B, 0x0C, 0x0D, 0x0E, 0x12})
        QCOMPARE(
            bench.ask(static_cast<std::uint8_t>(code), {}), encodeNack(ErrorCode::BadFrameCode));
    QCOMPARE(bench.ask(0x03, {0x02}), encodeAck(Bytes{0x02}));
    QCOMPARE(bench.ask(0x03, {0x05}), encodeNack(ErrorCode::WrongCommand));
    QCOMPARE(bench.ask(0x09, Bytes(9, 0)), encodeNack(ErrorCode::WrongSet)); // no rev-up
    QCOMPARE(bench.ask(0x08, {0}), encodeNack(ErrorCode::WrongSet));
    QCOMPARE(bench.ask(0x01, {0x41, 7, 0}), kOk); // write-only
    QCOMPARE(bench.ask(0x01, {0x00, 1}), encodeNack(ErrorCode::WrongSet));
}

void TestFcpBoard::aHalfReceivedFrameCanAlwaysBeFilledUp()
{
    std::mt19937 random(5);
    for (int run = 0; run < 600; ++run) {
        Bench bench;
        Bytes broken{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random())};
        for (std::size_t left = random() % 130; left > 0; --left)
            broken.push_back(static_cast<std::uint8_t>(random()));
        broken.resize(random() % (broken.size() + 1));
        bench.send(broken);
        bool known = false;
        for (int attempt = 0; attempt < 2 && !known; ++attempt) {
            for (int count = 0; count < 131; ++count) {
                const Bytes answer = bench.send({0xFF});
                if (!answer.empty() && answer[0] == fcp::kNackHeader)
                    break;
            }
            known = bench.ask(0x06, {}).size() == 35;
        }
        QVERIFY2(known || bench.board.server().hangs(), qPrintable(QString::number(run)));
    }
}

void TestFcpBoard::faultsOfTheLineAreAsAsked()
{
    Bench bench;
    bench.board.corruptAfter(2);
    QCOMPARE(bench.ask(0x02, {0x02}), (Bytes{0xF0, 0x01, 0x01, 0xF1}));
    QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{0}));
    bench.board.mute(50ms);
    QVERIFY(bench.ask(0x02, {0x02}).empty());
    QCOMPARE(bench.ask(0x02, {0x02}), encodeAck(Bytes{0}));
    bench.board.inject(Bytes{0xE0, 0x01});
    QCOMPARE(bench.pass(Duration(1)), (Bytes{0xE0, 0x01}));
    bench.board.setFaults(0x0002);
    bench.board.setFaults(0x0040);
    QCOMPARE(bench.ask(0x02, {0x01}), encodeAck(Bytes{0x42, 0, 0x40, 0}));
}

void TestFcpBoard::aResetMakesItAsItWas()
{
    Bench bench;
    QCOMPARE(bench.ask(0x01, {0x05, 1, 0}), kOk);
    bench.send({0x02, 0x01});
    bench.board.reset();
    QCOMPARE(bench.ask(0x02, {0x05}), encodeAck(Bytes{0, 0}));
}

void TestFcpBoard::aMotorGoesThroughTheStatesOfAMoment()
{
    BoardOptions options;
    options.profile = "legacy";
    options.baud = 460800; // a question and its answer within a turn of the medium-frequency task
    const auto board = makeFcpBoard(options);
    TimePoint now{};
    std::vector<int> seen;
    const auto look = [&](Duration time) {
        for (const TimePoint end = now + time; now < end;) {
            board->receive(encodeFrame(0x22, Bytes{0x02}), now); // STATUS of motor 1
            board->advance(now += 400us);
            const Bytes answer = board->takeOutput();
            QCOMPARE(answer.size(), std::size_t{4});
            if (seen.empty() || seen.back() != answer[2])
                seen.push_back(answer[2]);
        }
    };
    const auto command = [&](std::uint8_t id) {
        board->receive(encodeFrame(0x23, Bytes{id}), now);
        board->advance(now += 400us);
        QCOMPARE(board->takeOutput(), encodeAck({}));
    };
    look(5ms);
    command(0x01);
    look(4s);
    command(0x02);
    look(2s);
    QCOMPARE(seen, (std::vector<int>{0, 3, 16, 17, 4, 19, 5, 6, 7, 8, 9, 0}));
}

QTEST_APPLESS_MAIN(TestFcpBoard)
#include "tst_legacy_board.moc"

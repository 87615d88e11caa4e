// The simulated MCB drive with its motor, by frames alone: state machine, modes, gains, and the faults it can be told.
// Virtual time.
#include "mcb/master.h"
#include "simulation/mcb/board.h"

#include <QtTest>

#include <bit>
#include <cmath>

using namespace std::chrono_literals;
using mcb::Command;
using mcb::Master;
using simulation::McbBoard;
using simulation::McbBoardOptions;

class TestMcbServo : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itWakesUpDisabled();
    void theStateMachineIsWalked();
    void enablingNeedsEveryStep();
    void theVelocityIsFollowed();
    void aRampBeginsAtStandstill();
    void theCurrentIsFollowed();
    void thePositionIsReached();
    void aModeThatItHasNotIsRefused();
    void aFaultIsToldAndReset();
    void aGainReachesTheLoop();
    void aLimitBoundsASetPoint();
    void theCyclicStateMovesTheMotor();
    void newerFirmwareHasOtherTypes();
    void everyFaultStrikes_data();
    void everyFaultStrikes();
};

namespace {

/// A drive and a master that asks it, one millisecond a look.
struct Bench {
    explicit Bench(McbBoardOptions options = {})
        : board(simulation::makeMcbBoard(std::move(options)))
    {
        master.connect(now);
        pump();
    }
    std::unique_ptr<McbBoard> board;
    Master master;
    TimePoint now{1s};
    std::vector<Master::Done> ended;
    std::vector<Master::Cycle> cycles;

    void pump()
    {
        for (;;) {
            for (auto &event : master.takeEvents()) {
                if (const auto *done = std::get_if<Master::Done>(&event))
                    ended.push_back(*done);
                else if (const auto *cycle = std::get_if<Master::Cycle>(&event))
                    cycles.push_back(*cycle);
            }
            const auto outputs = master.takeOutput();
            if (outputs.empty())
                return;
            for (const Output &output : outputs)
                master.receive(board->exchange(output.bytes, now), now);
        }
    }
    void run(Duration time)
    {
        for (const TimePoint end = now + time; now < end;) {
            now += 1ms;
            board->advance(now);
            master.handleTimeout(now);
            pump();
        }
    }
    Master::Done ask(Master::Request request)
    {
        const std::size_t before = ended.size();
        master.send(std::move(request), now);
        pump();
        for (int i = 0; i < 3000 && ended.size() == before; ++i)
            run(1ms);
        return ended.size() > before ? ended.back() : Master::Done{{}, Master::End::Unknown};
    }
    std::uint32_t bits(std::uint16_t address)
    {
        return static_cast<std::uint32_t>(
            mcb::numberOf(ask({Command::Read, address}).words, 4).value_or(0));
    }
    std::uint16_t word(std::uint16_t address) { return static_cast<std::uint16_t>(bits(address)); }
    double real(std::uint16_t address) { return double{std::bit_cast<float>(bits(address))}; }
    Master::End put(std::uint16_t address, std::uint16_t value)
    {
        return ask({Command::Write, address, {value}}).end;
    }
    Master::End put(std::uint16_t address, float value)
    {
        return ask(
            {Command::Write, address, mcb::wordsOfNumber(std::bit_cast<std::uint32_t>(value), 4)})
            .end;
    }
    bool enable()
    {
        put(0x010, std::uint16_t{0x06});
        put(0x010, std::uint16_t{0x07});
        put(0x010, std::uint16_t{0x0F});
        for (int i = 0; i < 2000 && (word(0x011) & 0x6F) != 0x27; ++i)
            run(1ms);
        return (word(0x011) & 0x6F) == 0x27;
    }
};

} // namespace

void TestMcbServo::itWakesUpDisabled()
{
    Bench bench;
    QCOMPARE(bench.word(0x011) & 0x6F, 0x40);
    QCOMPARE(bench.word(0x015), std::uint16_t{3});
    QVERIFY(std::abs(bench.real(0x060) - 24.0) < 1.0);
    QCOMPARE(bench.real(0x031), 0.0);
    QCOMPARE(bench.real(0x079), 0.0); // its loop is not asked for a speed
}

void TestMcbServo::theStateMachineIsWalked()
{
    Bench bench;
    QCOMPARE(bench.put(0x010, std::uint16_t{0x06}), Master::End::Ok);
    QCOMPARE(bench.word(0x011) & 0x6F, 0x21);
    bench.put(0x010, std::uint16_t{0x07});
    QCOMPARE(bench.word(0x011) & 0x6F, 0x23);
    bench.put(0x010, std::uint16_t{0x0F});
    QCOMPARE(bench.word(0x011) & 0x6F, 0x23); // while it aligns its encoder
    bench.run(1500ms);
    QCOMPARE(bench.word(0x011), std::uint16_t{0x1637});
    bench.put(0x010, std::uint16_t{0x02}); // quick stop
    QCOMPARE(bench.word(0x011) & 0x6F, 0x07);
    bench.run(600ms);
    QCOMPARE(bench.word(0x011) & 0x6F, 0x40);
}

void TestMcbServo::enablingNeedsEveryStep()
{
    Bench bench;
    bench.put(0x010, std::uint16_t{0x0F});
    bench.run(1500ms);
    QCOMPARE(bench.word(0x011) & 0x6F, 0x40);
}

void TestMcbServo::theVelocityIsFollowed()
{
    Bench bench;
    bench.put(0x021, 20.0F);
    QVERIFY(bench.enable());
    bench.run(1s);
    QVERIFY2(
        std::abs(bench.real(0x031) - 20.0) < 1.0, qPrintable(QString::number(bench.real(0x031))));
    QVERIFY(std::abs(bench.real(0x079) - 20.0) < 0.2);
    bench.put(0x021, -10.0F);
    bench.run(1s);
    QVERIFY(std::abs(bench.real(0x031) + 10.0) < 1.0);
    bench.put(0x010, std::uint16_t{0x06});
    QCOMPARE(bench.word(0x011) & 0x6F, 0x21);
    bench.run(3s);
    QVERIFY(std::abs(bench.real(0x031)) < 0.2);
}

/// Also to the speed that the firmware has from its start.
void TestMcbServo::aRampBeginsAtStandstill()
{
    Bench bench;
    const auto nominal =
        static_cast<float>(bench.board->servo().axis().firmware.speedReference_rpm() / 60.0);
    QVERIFY(nominal > 10.0F);
    bench.put(0x014, std::uint16_t{19});
    bench.put(0x021, nominal);
    bench.put(0x026, nominal); // in a second
    QVERIFY(bench.enable());
    bench.run(300ms);
    QVERIFY2(
        bench.real(0x079) < 0.5 * double{nominal}, qPrintable(QString::number(bench.real(0x079))));
    bench.run(1s);
    QVERIFY(std::abs(bench.real(0x031) - double{nominal}) < 1.0);
}

void TestMcbServo::theCurrentIsFollowed()
{
    Bench bench;
    QCOMPARE(bench.put(0x014, std::uint16_t{2}), Master::End::Ok);
    bench.put(0x01A, 1.0F);
    QVERIFY(bench.enable());
    bench.run(50ms);
    QVERIFY2(
        std::abs(bench.real(0x03B) - 1.0) < 0.2, qPrintable(QString::number(bench.real(0x03B))));
}

void TestMcbServo::thePositionIsReached()
{
    Bench bench;
    QVERIFY(bench.enable());
    bench.put(0x014, std::uint16_t{20});
    QCOMPARE(bench.ask({Command::Write, 0x020, mcb::wordsOfNumber(2000, 4)}).end, Master::End::Ok);
    bench.run(2s);
    const auto position = static_cast<std::int32_t>(bench.bits(0x030));
    QVERIFY2(std::abs(position - 2000) < 40, qPrintable(QString::number(position)));
}

void TestMcbServo::aModeThatItHasNotIsRefused()
{
    Bench bench;
    const auto done = bench.ask({Command::Write, 0x014, {275}});
    QCOMPARE(done.end, Master::End::Refused);
    QCOMPARE(bench.word(0x014), std::uint16_t{3});
}

void TestMcbServo::aFaultIsToldAndReset()
{
    Bench bench;
    QVERIFY(bench.enable());
    bench.board->setFaults(0x02);
    bench.run(10ms);
    QCOMPARE(bench.word(0x011) & 0x4F, 0x08);
    QCOMPARE(bench.bits(0x00F), std::uint32_t{0x3210});
    bench.put(0x010, std::uint16_t{0x80});
    QCOMPARE(bench.word(0x011) & 0x4F, 0x08); // it is still there
    bench.board->setFaults(0);
    bench.run(10ms);
    bench.put(0x010, std::uint16_t{0x00});
    bench.put(0x010, std::uint16_t{0x80});
    QCOMPARE(bench.word(0x011) & 0x6F, 0x40);
}

void TestMcbServo::aGainReachesTheLoop()
{
    Bench bench;
    const double before = bench.real(0x50A);
    QVERIFY(before > 0.0);
    const auto numerator = bench.board->servo().axis().firmware.tuning().speedKp;
    QCOMPARE(bench.put(0x50A, static_cast<float>(before / 2.0)), Master::End::Ok);
    bench.run(2ms);
    QVERIFY(std::abs(bench.board->servo().axis().firmware.tuning().speedKp - numerator / 2) <= 1);
    QVERIFY(std::abs(bench.real(0x50A) - before / 2.0) < before * 0.01);
}

void TestMcbServo::aLimitBoundsASetPoint()
{
    Bench bench;
    bench.put(0x1E8, 5.0F);
    bench.put(0x021, 20.0F);
    QVERIFY(bench.enable());
    bench.run(1s);
    QVERIFY(bench.real(0x031) < 6.0);
}

void TestMcbServo::theCyclicStateMovesTheMotor()
{
    Bench bench;
    QVERIFY(bench.enable());
    bench.master.setCyclicOutput({0x0F, 0x0000, 0x4120}); // enabled, 10 turns a second
    bench.master.switchOn({{{0x010, 2}, {0x021, 4}}, {{0x011, 2}, {0x031, 4}}}, 1ms, bench.now);
    bench.run(1s);
    QVERIFY(bench.cycles.size() > 900);
    const auto &input = bench.cycles.back().input;
    QCOMPARE(input[0] & 0x6F, 0x27);
    const float velocity = std::bit_cast<float>(input[1] | std::uint32_t{input[2]} << 16);
    QVERIFY(std::abs(velocity - 10.0F) < 1.0F);
}

void TestMcbServo::newerFirmwareHasOtherTypes()
{
    McbBoardOptions options;
    options.servo.newer = true;
    Bench older, newer(options);
    const auto typeOf = [](Bench &bench, std::uint16_t address) {
        const auto words = bench.ask({Command::GetInfo, address}).words;
        return mcb::infoOf({words[0], words[1], 0, 0});
    };
    QCOMPARE(*typeOf(older, 0x068).type, mcb::Type::UInt32);
    QCOMPARE(*typeOf(newer, 0x068).type, mcb::Type::Float);
    QCOMPARE(typeOf(newer, 0x50A).cyclic, mcb::Cyclic::Rx);
}

void TestMcbServo::everyFaultStrikes_data()
{
    QTest::addColumn<int>("fault");
    for (const auto &row : simulation::mcbFaultList())
        QTest::newRow(std::string(row.name).c_str()) << static_cast<int>(row.fault);
}

/// The answer of a drive that does it always is not what an honest one says, or none; and yet the master goes on.
void TestMcbServo::everyFaultStrikes()
{
    QFETCH(int, fault);
    McbBoardOptions options;
    options.faults = {{static_cast<simulation::McbFault>(fault), 3}};
    Bench honest, bench(options);
    std::size_t different = 0;
    for (int i = 0; i < 60; ++i) {
        for (const Command command : {Command::Read, Command::Idle}) {
            const Bytes frame = mcb::encodeFrame({0x014, command, false, {}, {}});
            const TimePoint now = bench.now + i * 1ms;
            different += honest.board->exchange(frame, now) != bench.board->exchange(frame, now);
        }
    }
    const bool hidden = fault == static_cast<int>(simulation::McbFault::Reset);
    QVERIFY(hidden || different > 5);
}

QTEST_GUILESS_MAIN(TestMcbServo)
#include "tst_mcb_servo.moc"

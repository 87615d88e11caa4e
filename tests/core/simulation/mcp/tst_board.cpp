// The simulated board at its pins: connection, registers, motor, datalog, on virtual time.
#include "support/board_bench.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace support;

namespace {

constexpr std::uint16_t kOk = 0;
constexpr int kSpeedSteps = 12; ///< rpm; the observer counts in 6

Bytes speedRamp(int rpm, unsigned ms)
{
    return ByteWriter()
        .u16(1U << 3)
        .u16(mcp::reg::kSpeedRamp.withMotor(1).bits)
        .u16(6)
        .s32(rpm)
        .u16(ms)
        .take();
}

} // namespace

class TestBoard : public QObject {
    Q_OBJECT

private slots:
    void everyProfileConnects_data();
    void everyProfileConnects();
    void startRunsUpAndStopComesToRest();
    void currentsAreTwoCleanSinusoids120DegreesApart();
    void aPayloadWithoutPauseIsLostWithoutAnError();
    void aFaultStopsTheMotorUntilItIsAcknowledged();
    void theSameSeedGivesTheSameBytes();
};

void TestBoard::everyProfileConnects_data()
{
    QTest::addColumn<QString>("profile");
    for (const std::string &name : simulation::profileNames())
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

void TestBoard::everyProfileConnects()
{
    QFETCH(QString, profile);
    BoardOptions options;
    options.profile = profile.toStdString();
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.get(mcp::reg::kStatus), 0);
}

void TestBoard::startRunsUpAndStopComesToRest()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.command(3), Bytes{kOk});
    QVERIFY(bench.waitForState(6));
    QVERIFY(bench.now - TimePoint{} < 1500ms);
    QCOMPARE(bench.ask(speedRamp(2400, 300)), Bytes{kOk});
    bench.pass(1s);
    QVERIFY(std::abs(bench.get(mcp::reg::kSpeedMeas) - 2400) <= kSpeedSteps);
    QCOMPARE(bench.command(4), Bytes{kOk});
    QVERIFY(bench.waitForState(0));
    bench.pass(200ms);
    QCOMPARE(bench.get(mcp::reg::kSpeedMeas), 0);
    // Backwards from rest: nothing without a sensor runs through zero.
    QCOMPARE(bench.ask(speedRamp(-1500, 600)), Bytes{kOk});
    QCOMPARE(bench.command(3), Bytes{kOk});
    QVERIFY(bench.waitForState(6));
    bench.pass(1500ms);
    QVERIFY(std::abs(bench.get(mcp::reg::kSpeedMeas) + 1500) <= kSpeedSteps);
    QCOMPARE(bench.command(4), Bytes{kOk});
    QVERIFY(bench.waitForState(0));
    bench.pass(200ms);
    QCOMPARE(bench.get(mcp::reg::kSpeedMeas), 0);
}

void TestBoard::currentsAreTwoCleanSinusoids120DegreesApart()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.command(3), Bytes{kOk});
    QVERIFY(bench.waitForState(6));
    bench.pass(1s);
    ByteWriter set;
    set.u16(1U << 3)
        .u16(0x0529)
        .u16(11)
        .u16(2048)
        .u8(0)
        .u8(2)
        .u8(255)
        .u8(0)
        .u16(0x07D1)
        .u16(0x0811)
        .u8(1);
    QCOMPARE(bench.ask(set.take()), Bytes{kOk});
    bench.async.clear();
    std::vector<double> a, b;
    std::uint32_t next = 0;
    for (const auto &packet : bench.packets(500ms)) {
        ByteReader reader(packet.payload);
        const std::uint32_t stamp = reader.u32();
        QVERIFY(next == 0 || stamp == next);
        while (reader.left() > 2) {
            a.push_back(reader.s16());
            b.push_back(reader.s16());
            next = stamp + 510;
        }
    }
    QVERIFY(a.size() > 6000);
    // 1500 rpm and 4 pole pairs are 100 Hz, give and take the 6 rpm that the firmware cannot see: how far the vector of
    // the currents turned tells the frequency. Correlate over whole periods of it.
    double turned = 0.0;
    std::complex<double> before;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::complex<double> vector(a[i], (2.0 * b[i] + a[i]) / std::numbers::sqrt3);
        if (i > 0)
            turned += std::arg(vector / before);
        before = vector;
    }
    const double step = turned / static_cast<double>(a.size() - 1);
    const double hertz = step / (2.0 * std::numbers::pi) * 16000.0;
    QVERIFY2(std::abs(hertz - 100.0) < 0.8, qPrintable(QString::number(hertz)));
    const double period = 2.0 * std::numbers::pi / step;
    const auto count =
        static_cast<std::size_t>(std::floor(static_cast<double>(a.size()) / period) * period);
    const auto phasor = [&](const std::vector<double> &x) {
        std::complex<double> sum;
        for (std::size_t i = 0; i < count; ++i)
            sum +=
                x[i] * std::polar(2.0 / static_cast<double>(count), -step * static_cast<double>(i));
        return sum;
    };
    const auto pa = phasor(a), pb = phasor(b);
    QVERIFY2(std::abs(pa) > 300.0, qPrintable(QString::number(std::abs(pa))));
    QVERIFY(std::abs(std::abs(pa) - std::abs(pb)) < 0.02 * std::abs(pa));
    const double lag = std::arg(pa / pb) * 180.0 / std::numbers::pi;
    QVERIFY2(std::abs(lag - 120.0) < 1.0, qPrintable(QString::number(lag)));
    double rest = 0.0, all = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double fit = (pa * std::polar(1.0, step * static_cast<double>(i))).real();
        rest += (a[i] - fit) * (a[i] - fit);
        all += a[i] * a[i];
    }
    QVERIFY2(rest < 0.01 * all, qPrintable(QString::number(rest / all)));
}

void TestBoard::aPayloadWithoutPauseIsLostWithoutAnError()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    bench.pass(100us);
    bench.sendRequest(ByteWriter().u16(2U << 3).u16(0x0049).u16(0x0049).take(), 0us);
    QCOMPARE(bench.packets(20ms).size(), 0);
    QCOMPARE(bench.get(mcp::reg::kStatus), 0);
    bench.send(aspep::Ping{.number = 2});
    const auto reply = bench.packets(5ms);
    QCOMPARE(reply.size(), 1);
    QVERIFY(std::get<aspep::Ping>(reply[0].header).parity); // one request was accepted, not two
}

void TestBoard::aFaultStopsTheMotorUntilItIsAcknowledged()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.command(3), Bytes{kOk});
    QVERIFY(bench.waitForState(6));
    bench.board->setFaults(0x0040);
    QVERIFY(bench.waitForState(10));
    QCOMPARE(bench.get(mcp::reg::kFaultsFlags), 0x00400040);
    QCOMPARE(bench.command(7), Bytes{kOk});
    QCOMPARE(bench.get(mcp::reg::kStatus), 10);
    bench.board->setFaults(0);
    QVERIFY(bench.waitForState(11));
    QCOMPARE(bench.get(mcp::reg::kFaultsFlags), 0x00000040);
    QCOMPARE(bench.command(3), Bytes{1});
    QCOMPARE(bench.command(7), Bytes{kOk});
    QCOMPARE(bench.get(mcp::reg::kStatus), 0);
    QCOMPARE(bench.get(mcp::reg::kFaultsFlags), 0);
}

void TestBoard::theSameSeedGivesTheSameBytes()
{
    const auto run = [](std::uint64_t seed) {
        BoardOptions options;
        options.seed = seed;
        BoardBench bench(options);
        bench.connect();
        ByteWriter set;
        set.u16(1U << 3).u16(0x0529).u16(9).u16(512).u8(0).u8(1).u8(255).u8(0).u16(0x07D1).u8(1);
        bench.ask(set.take());
        bench.pass(50ms);
        return bench.heard;
    };
    const Bytes once = run(7);
    QVERIFY(once.size() > 1000);
    QCOMPARE(run(7), once);
    QVERIFY(run(8) != once);
}

QTEST_APPLESS_MAIN(TestBoard)
#include "tst_board.moc"

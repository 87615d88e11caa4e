// The simulated board at its pins: connection, registers, motor, datalog, on virtual time.
#include "aspep/packet.h"
#include "base/crc.h"
#include "mcp/protocol.h"
#include "simulation/simulated_board.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace std::chrono_literals;
using simulation::BoardOptions;

namespace {

constexpr std::uint16_t kOk = 0;

/// A Controller that does the least: it sends bytes, lets time pass and cuts what comes back into packets.
struct Bench {
    explicit Bench(BoardOptions options = {})
        : board(simulation::makeBoard(options))
    {
        pass(1ms);
    }

    void pass(Duration time)
    {
        now += time;
        board->advance(now);
        const Bytes bytes = board->takeOutput();
        heard.insert(heard.end(), bytes.begin(), bytes.end());
    }
    void send(const aspep::Header &header)
    {
        const auto bytes = aspep::encodeHeader(header);
        board->receive(bytes, now);
    }
    void sendRequest(ByteView payload, Duration pause = 1500us)
    {
        send(aspep::Data{false, static_cast<std::uint16_t>(payload.size())});
        pass(pause);
        board->receive(payload, now);
    }
    std::vector<aspep::Packet> packets(Duration time)
    {
        pass(time);
        std::vector<aspep::Packet> out;
        std::size_t at = 0;
        while (at + 4 <= heard.size()) {
            const auto header =
                aspep::decodeHeader({heard[at], heard[at + 1], heard[at + 2], heard[at + 3]});
            if (!header)
                break;
            aspep::Packet packet{*header, {}};
            std::size_t size = 0;
            if (const auto *data = std::get_if<aspep::Data>(&*header))
                size = data->length;
            if (at + 4 + size > heard.size())
                break;
            const auto from = heard.begin() + static_cast<std::ptrdiff_t>(at + 4);
            packet.payload.assign(from, from + static_cast<std::ptrdiff_t>(size));
            out.push_back(packet);
            at += 4 + size;
        }
        heard.erase(heard.begin(), heard.begin() + static_cast<std::ptrdiff_t>(at));
        return out;
    }
    bool connect()
    {
        send(aspep::Beacon{});
        const auto offer = packets(3ms);
        if (offer.size() != 1)
            return false;
        send(offer[0].header);
        packets(3ms);
        send(aspep::Ping{.number = 1});
        const auto reply = packets(3ms);
        return reply.size() == 1 && std::get<aspep::Ping>(reply[0].header).configured;
    }
    /// The response's payload, status last; empty if there is none. Async packets are kept.
    Bytes ask(ByteView payload)
    {
        sendRequest(payload);
        Bytes answer;
        for (const auto &packet : packets(20ms)) {
            const auto *data = std::get_if<aspep::Data>(&packet.header);
            if (data != nullptr && data->response)
                answer = packet.payload;
            else
                async.push_back(packet.payload);
        }
        return answer;
    }
    std::int32_t get(mcp::RegisterId id)
    {
        ByteWriter request;
        request.u16(2U << 3).u16(id.withMotor(1).bits);
        const Bytes answer = ask(request.take());
        std::uint32_t value = 0;
        for (std::size_t i = 0; i + 1 < answer.size() && i < 4; ++i)
            value |= std::uint32_t{answer[i]} << (8 * i);
        return static_cast<std::int32_t>(value);
    }
    Bytes command(unsigned id) { return ask(ByteWriter().u16(id << 3 | 1U).take()); }
    bool waitForState(std::int32_t state)
    {
        for (int i = 0; i < 100; ++i) {
            if (get(mcp::reg::kStatus) == state)
                return true;
        }
        return false;
    }

    TimePoint now{};
    std::unique_ptr<simulation::SimulatedBoard> board;
    Bytes heard;
    std::vector<Bytes> async;
};

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
    Bench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.get(mcp::reg::kStatus), 0);
}

void TestBoard::startRunsUpAndStopComesToRest()
{
    Bench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.command(3), Bytes{kOk});
    QVERIFY(bench.waitForState(6));
    QVERIFY(bench.now - TimePoint{} < 1500ms);
    QCOMPARE(bench.ask(speedRamp(2400, 300)), Bytes{kOk});
    bench.pass(1s);
    QCOMPARE(bench.get(mcp::reg::kSpeedMeas), 2400);
    QCOMPARE(bench.ask(speedRamp(-1500, 600)), Bytes{kOk});
    bench.pass(2s);
    QCOMPARE(bench.get(mcp::reg::kSpeedMeas), -1500);
    QCOMPARE(bench.command(4), Bytes{kOk});
    QVERIFY(bench.waitForState(0));
    bench.pass(200ms);
    QCOMPARE(bench.get(mcp::reg::kSpeedMeas), 0);
}

void TestBoard::currentsAreTwoCleanSinusoids120DegreesApart()
{
    Bench bench;
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
    // 1500 rpm and 4 pole pairs: 100 Hz, 160 samples a period; correlate over whole periods.
    const std::size_t count = a.size() / 160 * 160;
    const auto phasor = [&](const std::vector<double> &x) {
        std::complex<double> sum;
        for (std::size_t i = 0; i < count; ++i)
            sum += x[i]
                * std::polar(2.0 / static_cast<double>(count),
                    -2.0 * std::numbers::pi * static_cast<double>(i) / 160.0);
        return sum;
    };
    const auto pa = phasor(a), pb = phasor(b);
    QVERIFY2(std::abs(pa) > 300.0, qPrintable(QString::number(std::abs(pa))));
    QVERIFY(std::abs(std::abs(pa) - std::abs(pb)) < 0.02 * std::abs(pa));
    const double lag = std::arg(pa / pb) * 180.0 / std::numbers::pi;
    QVERIFY2(std::abs(lag - 120.0) < 1.0, qPrintable(QString::number(lag)));
    double rest = 0.0, all = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double fit =
            (pa * std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(i) / 160.0)).real();
        rest += (a[i] - fit) * (a[i] - fit);
        all += a[i] * a[i];
    }
    QVERIFY2(rest < 0.001 * all, qPrintable(QString::number(rest / all)));
}

void TestBoard::aPayloadWithoutPauseIsLostWithoutAnError()
{
    Bench bench;
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
    Bench bench;
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
        Bench bench(options);
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

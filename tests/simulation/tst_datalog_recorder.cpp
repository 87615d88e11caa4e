// The datalog of the simulated board, packet by packet: layout, marks, refusals, the stop.
#include "support/board_bench.h"

#include <QTest>

using namespace support;

namespace {

constexpr std::uint16_t kIa = 0x07D1, kIb = 0x0811, kStatus = 0x0049, kSpeed = 0x0059;

std::uint32_t stamp(const aspep::Packet &packet) { return ByteReader(packet.payload).u32(); }
int mark(const aspep::Packet &packet) { return packet.payload[packet.payload.size() - 2]; }

} // namespace

class TestDatalogRecorder : public QObject {
    Q_OBJECT

private slots:
    void aFullPacketHasThePrintedSize();
    void mfValuesFollowBlocksCountedInEachPacket();
    void theStopSendsWhatThereIsWithoutMfValues();
    void theSameMarkChangesNothing();
    void onlyTheLastOfQuickConfigurationsIsUsed();
    void aRefusalLeavesItsFieldsBehind();
    void mfAtTheEndNeedsHfRegisters();
    void whatTheLineCannotCarryIsAJumpInTime();
    void theTimestampWraps();
    void aFaultFlushesInOlderFirmware();
};

void TestDatalogRecorder::aFullPacketHasThePrintedSize()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(2048, 4, {kIa, kIb}, 255, {}, 9)), Bytes{0});
    const auto packets = bench.packets(500ms);
    QVERIFY(packets.size() >= 2);
    QCOMPARE(packets[0].payload.size(), std::size_t{2046});
    QCOMPARE(stamp(packets[1]) - stamp(packets[0]), 510U * 5U);
    QCOMPARE(mark(packets[0]), 9);
    QCOMPARE(packets[0].payload.back(), 0);
}

void TestDatalogRecorder::mfValuesFollowBlocksCountedInEachPacket()
{
    BoardOptions options;
    options.wide = true;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    // after every second block one byte and four bytes: 2 + (2 + 5) + 2 + (2 + 5) ...
    QCOMPARE(bench.ask(bench.datalog(64, 0, {kIa}, 1, {kStatus, kSpeed}, 1)), Bytes{0});
    const auto packets = bench.packets(50ms);
    QVERIFY(packets.size() > 2);
    // room for blocks up to index 64 - 7 - 2 = 55: 4, 6, 13, 15, 22, 24, 31, 33, 40, 42, 49, 51, 58
    QCOMPARE(packets[0].payload.size(), std::size_t{60});
    QCOMPARE(stamp(packets[1]) - stamp(packets[0]), 12U);
}

void TestDatalogRecorder::theStopSendsWhatThereIsWithoutMfValues()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(2048, 9, {kIa}, 254, {kIb}, 1)), Bytes{0});
    bench.sendRequest(bench.datalog(0, 0, {}, 255, {}, 0));
    const auto packets = bench.packets(100ms);
    QCOMPARE(
        packets.size(), std::size_t{2}); // the flushed packet, the response; silence after that
    QVERIFY(packets[0].payload.size() < 100);
    QCOMPARE(packets[0].payload.size() % 2, std::size_t{0});
    QVERIFY(std::get<aspep::Data>(packets[1].header).response);
}

void TestDatalogRecorder::theSameMarkChangesNothing()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(512, 0, {kIa}, 255, {}, 5)), Bytes{0});
    bench.packets(50ms);
    QCOMPARE(bench.ask(bench.datalog(256, 0, {kIa, kIb}, 255, {}, 5)), Bytes{0});
    const auto packets = bench.packets(50ms);
    QVERIFY(packets.size() > 2);
    QCOMPARE(packets.back().payload.size(), std::size_t{512});
}

void TestDatalogRecorder::onlyTheLastOfQuickConfigurationsIsUsed()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(2048, 9, {kIa}, 255, {}, 1)), Bytes{0}); // 640 ms a packet
    QCOMPARE(bench.ask(bench.datalog(512, 0, {kIa}, 255, {}, 2)), Bytes{0});
    QCOMPARE(bench.ask(bench.datalog(256, 0, {kIb}, 255, {}, 3)), Bytes{0});
    const auto packets = bench.packets(1s);
    QCOMPARE(mark(packets[0]), 1);
    for (std::size_t i = 1; i < packets.size(); ++i)
        QCOMPARE(mark(packets[i]), 3);
}

void TestDatalogRecorder::aRefusalLeavesItsFieldsBehind()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(4096, 0, {kIa}, 255, {}, 1)), Bytes{9});
    QCOMPARE(bench.ask(bench.datalog(7, 0, {kIa}, 255, {}, 1)), Bytes{9});
    QCOMPARE(
        bench.ask(bench.datalog(2048, 0, std::vector<unsigned>(11, kIa), 255, {}, 1)), Bytes{10});
    QCOMPARE(bench.packets(200ms).size(), std::size_t{0});
    QCOMPARE(bench.ask(bench.datalog(512, 0, {kIa}, 255, {}, 1)), Bytes{0});
    QVERIFY(bench.packets(100ms).size() > 3);
}

void TestDatalogRecorder::mfAtTheEndNeedsHfRegisters()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(64, 0, {}, 254, {kIa}, 1)), Bytes{0});
    QCOMPARE(bench.packets(300ms).size(), std::size_t{0});
}

void TestDatalogRecorder::whatTheLineCannotCarryIsAJumpInTime()
{
    BoardOptions options;
    options.hfHz = 20000;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(
        bench.ask(bench.datalog(1024, 0, std::vector<unsigned>(6, kIa), 255, {}, 1)), Bytes{0});
    const auto packets = bench.packets(300ms);
    QVERIFY(packets.size() > 20);
    // 84 blocks a packet; 1018 bytes of line time are 110 ticks
    const std::uint32_t step = stamp(packets[15]) - stamp(packets[5]);
    QVERIFY2(step > 1090 && step < 1130, qPrintable(QString::number(step)));
}

void TestDatalogRecorder::theTimestampWraps()
{
    BoardOptions options;
    options.firstTimestamp = 0xFFFFFF00U;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(128, 0, {kIa}, 255, {}, 1)), Bytes{0});
    std::uint32_t expected = 0;
    for (const auto &packet : bench.packets(100ms)) {
        QVERIFY(expected == 0 || stamp(packet) == expected);
        expected = stamp(packet) + 61;
    }
    QVERIFY(expected > 0 && expected < 10000);
}

void TestDatalogRecorder::aFaultFlushesInOlderFirmware()
{
    for (const bool older : {false, true}) {
        BoardOptions options;
        options.profile = older ? "mcsdk-6.2" : "mcsdk-6.4";
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.ask(bench.datalog(2048, 9, {kIa}, 255, {}, 1)), Bytes{0}); // 640 ms a packet
        bench.board->setFaults(0x0040);
        QCOMPARE(bench.packets(50ms).size(), std::size_t{older ? 1U : 0U});
    }
}

QTEST_APPLESS_MAIN(TestDatalogRecorder)
#include "tst_datalog_recorder.moc"

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
    void aFaultFlushesInProfilerBuilds();
    void theTasksOfTwoMotorsCountTogether();
    void bothMotorsCanBeLogged();
    void anHsoBuildKeepsTheSignalBeforeAnUnknownOne();
    void sixStepHasNone();
    void thePrintedStructureRecordsAsPrinted();
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
    // The flushed packet, the response; silence after that.
    QCOMPARE(packets.size(), std::size_t{2});
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

void TestDatalogRecorder::aFaultFlushesInProfilerBuilds()
{
    BoardOptions options;
    options.build.emplace();
    options.build->profiler = true;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(2048, 9, {kIa}, 255, {}, 1)), Bytes{0});
    bench.board->setFaults(0x0040);
    QCOMPARE(bench.packets(50ms).size(), std::size_t{1});
}

void TestDatalogRecorder::theTasksOfTwoMotorsCountTogether()
{
    for (const int motors : {1, 2}) {
        BoardOptions options;
        options.motors = motors;
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.ask(bench.datalog(256, 3, {kIa}, 255, {}, 1)), Bytes{0});
        const auto packets = bench.packets(500ms);
        QVERIFY(packets.size() > 3);
        // 125 blocks a packet, every fourth tick of 16000 or 32000 a second
        QCOMPARE(stamp(packets[1]) - stamp(packets[0]), 500U);
        QVERIFY(std::abs(static_cast<int>(packets.size()) - 16 * motors) <= 1);
    }
}

void TestDatalogRecorder::bothMotorsCanBeLogged()
{
    BoardOptions options;
    options.motors = 2;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(ByteWriter().u16(3U << 3 | 2U).take()), Bytes{0}); // START_MOTOR of motor 2
    bench.pass(1500ms);
    constexpr unsigned kSpeed1 = 0x0B91, kSpeed2 = 0x0B92, kSpeed3 = 0x0B93;
    QCOMPARE(bench.ask(bench.datalog(64, 0, {kSpeed1, kSpeed2, kSpeed3}, 255, {}, 1)), Bytes{0});
    const auto packets = bench.packets(20ms);
    QVERIFY(!packets.empty());
    ByteReader reader(packets[0].payload);
    reader.u32();
    QCOMPARE(reader.s16(), std::int16_t{0});
    QVERIFY(reader.s16() > 200); // 0.1 Hz
    QCOMPARE(reader.s16(), std::int16_t{0}); // there is no third
}

void TestDatalogRecorder::anHsoBuildKeepsTheSignalBeforeAnUnknownOne()
{
    constexpr unsigned kBetaCurrent = 0x0219, kAngle = 0x1119, kUnknown = 0x0279,
                       kStateHso = 0x0049;
    for (const char *profile : {"hso", "mcsdk-6.4"}) {
        BoardOptions options;
        options.profile = profile;
        const bool hso = options.profile == "hso";
        const std::vector<unsigned> known = hso ? std::vector<unsigned>{kBetaCurrent, kAngle}
                                                : std::vector<unsigned>{0x0B51, 0x0B51};
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.command(3), Bytes{0});
        bench.pass(2s);
        QCOMPARE(bench.ask(bench.datalog(64, 0, known, 255, {}, 1)), Bytes{0});
        bench.packets(20ms);
        QCOMPARE(
            bench.ask(bench.datalog(64, 0, {known[1], hso ? kStateHso : kUnknown}, 255, {}, 2)),
            Bytes{0});
        bool turned = false;
        for (const auto &packet : bench.packets(50ms)) {
            if (mark(packet) != 2)
                continue;
            ByteReader reader(packet.payload);
            reader.u32();
            const auto first = reader.s16(), second = reader.s16();
            // The angle is still in the second slot.
            QCOMPARE(second, hso ? first : std::int16_t{0});
            turned = turned || first != 0;
        }
        QVERIFY(turned);
    }
}

void TestDatalogRecorder::sixStepHasNone()
{
    BoardOptions options;
    options.profile = "six-step";
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(64, 0, {kIa}, 255, {}, 1)), Bytes{5});
    QCOMPARE(bench.packets(50ms).size(), std::size_t{0});
}

void TestDatalogRecorder::thePrintedStructureRecordsAsPrinted()
{
    BoardOptions options;
    options.profile = "spec";
    options.txAsyncMax = 64;
    options.wide = true;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const auto configure = [&](unsigned hfRate, const std::vector<unsigned> &hf, unsigned mfRate,
                               const std::vector<unsigned> &mf, unsigned more = 0) {
        ByteWriter out;
        out.u16(1U << 3).u16(0x0528).u16(
            static_cast<unsigned>(5 + 2 * (hf.size() + mf.size()) + more));
        out.u8(hfRate).u8(static_cast<unsigned>(hf.size()));
        out.u8(mfRate).u8(static_cast<unsigned>(mf.size()));
        for (const auto &list : {hf, mf}) {
            for (const unsigned id : list)
                out.u16(id);
        }
        out.u8(7);
        for (unsigned i = 0; i < more; ++i)
            out.u8(0);
        return bench.ask(out.take());
    };
    QCOMPARE(configure(0, std::vector<unsigned>(11, kIa), 255, {}), Bytes{9});
    QCOMPARE(configure(0, {kIa}, 255, {}, 1), Bytes{10});
    QCOMPARE(configure(0, {0x0591}, 255, {}), Bytes{5}); // BUS_VOLTAGE cannot be logged

    // The state as 32 bits every third task, the current every second: in six tasks 3 x 2 + 2 x 4 bytes.
    QCOMPARE(configure(1, {kIa}, 2, {kStatus}), Bytes{0});
    const auto packets = bench.packets(50ms);
    QVERIFY(packets.size() > 3);
    const Bytes &payload = packets[2].payload;
    QCOMPARE(payload.back(), 7); // Mark
    QCOMPARE(payload[payload.size() - 2], 0); // async id
    // Full when not another block of six fits: 24 tasks of 14 bytes in six are 56, and the next is full.
    QVERIFY(payload.size() > 64 - 6 && payload.size() <= 64);
    const std::uint32_t step = stamp(packets[3]) - stamp(packets[2]);
    QVERIFY2(step >= 21 && step <= 27, qPrintable(QString::number(step)));

    QCOMPARE(configure(0, {kIa}, 254, {kSpeed}), Bytes{0}); // the same mark, and it is applied
    const auto once = bench.packets(50ms);
    QVERIFY(once.size() > 3);
    QCOMPARE(once.back().payload.size(), std::size_t{64});
    QCOMPARE(stamp(once[3]) - stamp(once[2]), 27U); // 27 currents, then the speed
}

QTEST_APPLESS_MAIN(TestDatalogRecorder)
#include "tst_datalog_recorder.moc"

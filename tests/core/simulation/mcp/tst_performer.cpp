// What ASPEP does on the simulated board where it surprises: facts of sections A and B that no shared session covers.
#include "support/board_bench.h"

#include <QTest>

using namespace support;

namespace {

Bytes getRequest(std::initializer_list<unsigned> ids)
{
    ByteWriter request;
    request.u16(2U << 3);
    for (const unsigned id : ids)
        request.u16(id);
    return request.take();
}

aspep::Beacon sizes(unsigned rx, unsigned sync, unsigned async)
{
    return {.version = 0,
        .dataCrc = false,
        .rxUnits = static_cast<std::uint8_t>(rx),
        .txSyncUnits = static_cast<std::uint8_t>(sync),
        .txAsyncUnits = static_cast<std::uint8_t>(async)};
}

/// The only packet that comes back; a Nack of 0 if there is none or more than one.
aspep::Header only(const std::vector<aspep::Packet> &packets)
{
    return packets.size() == 1 ? packets[0].header : aspep::Header{aspep::Nack{0}};
}

} // namespace

class TestPerformer : public QObject {
    Q_OBJECT

private slots:
    void aForcedPayloadCrcIsTwoConstantBytes();
    void aSmallerBeaconKeepsTheOldLimits();
    void aLargerBeaconDisconnects();
    void aWrongVersionStillShrinks();
    void twoPingsBehindAnAsyncPacketGiveOneReply();
    void olderFirmwareCutsThePingNumber();
    void olderFirmwareNeedsNoPause();
    void twoPacketsInARowAreBothLost();
    void afterAnErrorOneBurstIsSwallowed();
    void anUnfinishedStreamGoesOnAfterRecovery();
    void theTextIsConnectedByItsBeacon();
    void theTextNegotiatesFromWhatTheBoardCan();
    void theTextStopsTheDatalogWithItsBeacon();
};

void TestPerformer::aForcedPayloadCrcIsTwoConstantBytes()
{
    BoardOptions options;
    options.dataCrc = true;
    BoardBench bench(options);
    aspep::Beacon offer;
    offer.dataCrc = true;
    bench.send(offer);
    const auto agreed = only(bench.packets(3ms));
    QVERIFY(std::get<aspep::Beacon>(agreed).dataCrc);
    bench.send(agreed);
    bench.packets(3ms);
    bench.send(aspep::Ping{});
    bench.packets(3ms);
    Bytes request = getRequest({0x0049});
    bench.send(aspep::Data{false, static_cast<std::uint16_t>(request.size())});
    bench.pass(2ms);
    request.insert(request.end(), {0x12, 0x34}); // never looked at
    bench.board->receive(request, bench.now);
    bench.pass(10ms);
    QCOMPARE(Bytes(bench.heard.begin() + 4, bench.heard.end()), (Bytes{0, 0, 0xCA, 0xFE}));
}

void TestPerformer::aSmallerBeaconKeepsTheOldLimits()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    bench.send(sizes(1, 1, 1));
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{sizes(1, 1, 1)});
    bench.send(aspep::Ping{});
    bench.packets(3ms);
    Bytes request = getRequest({});
    for (int i = 0; i < 50; ++i) // 102 bytes for a limit that now reads 64, and 201 bytes back
        request.insert(request.end(), {0x59, 0x00});
    QCOMPARE(bench.ask(request).size(), std::size_t{201});
}

void TestPerformer::aLargerBeaconDisconnects()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    bench.send(sizes(63, 127, 127));
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{sizes(7, 7, 32)});
    bench.send(aspep::Ping{.number = 9});
    QVERIFY(!std::get<aspep::Ping>(only(bench.packets(3ms))).configured);
}

void TestPerformer::aWrongVersionStillShrinks()
{
    BoardBench bench;
    aspep::Beacon wrong = sizes(3, 3, 8);
    wrong.version = 3;
    bench.send(wrong);
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{sizes(3, 3, 8)});
    bench.send(sizes(7, 7, 32));
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{sizes(3, 3, 8)});
    bench.board->reset();
    bench.send(sizes(7, 7, 32));
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{sizes(7, 7, 32)});
}

void TestPerformer::twoPingsBehindAnAsyncPacketGiveOneReply()
{
    BoardOptions options;
    options.baud = 115200;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(2048, 0, {0x07D1, 0x0811}, 255, {}, 1)), Bytes{0});
    bench.packets(100ms); // the line is full of async packets of 178 ms from here on
    bench.send(aspep::Ping{.number = 21});
    bench.pass(10ms);
    bench.send(aspep::Ping{.number = 22});
    int replies = 0;
    std::uint16_t number = 0;
    for (const auto &packet : bench.packets(600ms)) {
        if (const auto *ping = std::get_if<aspep::Ping>(&packet.header)) {
            ++replies;
            number = ping->number;
        }
    }
    QCOMPARE(replies, 1);
    QCOMPARE(number, 22);
}

void TestPerformer::olderFirmwareCutsThePingNumber()
{
    BoardOptions options;
    options.profile = "mcsdk-6.2";
    BoardBench bench(options);
    QVERIFY(bench.connect());
    bench.send(aspep::Ping{.number = 0x1235});
    QCOMPARE(std::get<aspep::Ping>(only(bench.packets(3ms))).number, 0x50);
}

void TestPerformer::olderFirmwareNeedsNoPause()
{
    BoardOptions options;
    options.profile = "mcsdk-6.2";
    BoardBench bench(options);
    QVERIFY(bench.connect());
    bench.sendRequest(getRequest({0x0049}), 0us);
    QCOMPARE(bench.packets(5ms).size(), std::size_t{1});
}

void TestPerformer::twoPacketsInARowAreBothLost()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    bench.pass(50us);
    bench.send(aspep::Ping{.number = 5});
    bench.send(aspep::Ping{.number = 6});
    QCOMPARE(bench.packets(10ms).size(), std::size_t{0});
    bench.send(aspep::Ping{.number = 7});
    QCOMPARE(std::get<aspep::Ping>(only(bench.packets(3ms))).number, 7);
}

void TestPerformer::afterAnErrorOneBurstIsSwallowed()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    const Bytes badCrc{0x06, 0x00, 0x00, 0x70};
    bench.board->receive(badCrc, bench.now);
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{aspep::Nack{4}});
    bench.board->receive(badCrc, bench.now);
    QCOMPARE(bench.packets(3ms).size(), std::size_t{0});
    bench.board->receive(badCrc, bench.now);
    QCOMPARE(only(bench.packets(3ms)), aspep::Header{aspep::Nack{4}});
    // Its header is swallowed, its payload is taken for a header.
    bench.sendRequest(getRequest({0x0049}));
    QCOMPARE(only(bench.packets(5ms)), aspep::Header{aspep::Nack{4}});
}

void TestPerformer::anUnfinishedStreamGoesOnAfterRecovery()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(512, 0, {0x07D1}, 255, {}, 3)), Bytes{0});
    bench.packets(50ms);
    bench.send(sizes(7, 7, 32));
    bench.packets(100ms);
    QCOMPARE(bench.packets(100ms).size(), std::size_t{0});
    bench.send(aspep::Ping{});
    const auto packets = bench.packets(100ms);
    QVERIFY(packets.size() > 3);
    QCOMPARE(packets.back().payload[packets.back().payload.size() - 2], 3);
}

void TestPerformer::theTextIsConnectedByItsBeacon()
{
    BoardOptions options;
    options.profile = "spec";
    BoardBench bench(options);
    bench.send(sizes(7, 7, 32));
    bench.packets(3ms);
    QCOMPARE(bench.ask(getRequest({0x0049})), (Bytes{0, 0}));
}

void TestPerformer::theTextNegotiatesFromWhatTheBoardCan()
{
    BoardOptions options;
    options.profile = "spec";
    BoardBench bench(options);
    const auto answer = [&](const aspep::Beacon &offer) {
        bench.send(offer);
        const auto packets = bench.packets(5ms);
        return packets.empty() ? aspep::Beacon{} : std::get<aspep::Beacon>(packets[0].header);
    };
    QVERIFY(answer(sizes(1, 1, 0)) == sizes(1, 1, 0));
    QVERIFY(answer(sizes(7, 7, 32)) == sizes(7, 7, 32)); // nothing was lost for good
    aspep::Beacon other = sizes(3, 3, 3);
    other.version = 5;
    QVERIFY(answer(other) == sizes(7, 7, 32));
    bench.send(aspep::Ping{});
    QVERIFY(!std::get<aspep::Ping>(bench.packets(5ms).at(0).header).configured);
}

void TestPerformer::theTextStopsTheDatalogWithItsBeacon()
{
    BoardOptions options;
    options.profile = "spec";
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(bench.datalog(256, 0, {0x07D1}, 255, {}, 3)), Bytes{0});
    QVERIFY(bench.packets(50ms).size() > 3);
    QVERIFY(bench.connect() || bench.connect()); // the first answer may stand behind a packet
    bench.packets(50ms);
    QCOMPARE(bench.packets(200ms).size(), std::size_t{0});
}

QTEST_APPLESS_MAIN(TestPerformer)
#include "tst_performer.moc"

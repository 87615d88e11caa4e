// The framer: packets from any split of the stream, and after the first bad byte nothing that is not proved.
#include "aspep/framer.h"
#include "base/crc.h"
#include "support/virtual_link.h"

using namespace support;
using aspep::Framer;
using aspep::Packet;
using Step = aspep::Framer::Step;

class TestFramer : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everySplitGivesTheSamePackets();
    void afterABadHeaderEverythingIsDiscarded();
    void itSaysWhatWasBad_data();
    void itSaysWhatWasBad();
    void lengthsAreBoundedBeforeAByteIsStored();
    void aNegotiatedPayloadCrcIsChecked();
    void itKnowsWhatIsMissing();
    void itKnowsWhatAScannerWouldWaitFor();
    void everyFlippedHeaderBitIsSeen();
    void twoPacketsOfAStreamInARowProveWhereTheyBegin();
    void oneAloneOrAnotherLookProvesNothing();
};

namespace {

struct Read {
    std::vector<Packet> packets;
    Step end = Step::NeedBytes;
};

Read feed(Framer &framer, ByteView bytes)
{
    Read read;
    Packet packet;
    for (;;) {
        const Step step = framer.next(bytes, packet);
        if (step == Step::NeedBytes)
            return read;
        if (step == Step::Packet)
            read.packets.push_back(std::move(packet));
        else
            read.end = step;
    }
}

Bytes crcPacket(const Bytes &payload, std::uint16_t crc)
{
    return packet(true, payload)
        + Bytes{static_cast<std::uint8_t>(crc), static_cast<std::uint8_t>(crc >> 8)};
}

} // namespace

void TestFramer::everySplitGivesTheSamePackets()
{
    const Bytes stream = kBoard + packet(false, hex("01 02 03 04 05")) + packet(true, hex("00"))
        + packet(true, {}) + kConfigured;
    Framer whole;
    const auto wanted = feed(whole, stream).packets;
    QCOMPARE(wanted.size(), std::size_t{5});
    QCOMPARE(wanted[1].payload, hex("01 02 03 04 05"));
    for (std::size_t chunk = 1; chunk < stream.size(); ++chunk) {
        Framer framer;
        std::vector<Packet> packets;
        for (std::size_t at = 0; at < stream.size(); at += chunk) {
            const ByteView part = ByteView(stream).subspan(at, std::min(chunk, stream.size() - at));
            for (Packet &one : feed(framer, part).packets)
                packets.push_back(std::move(one));
        }
        QVERIFY(packets == wanted);
        QVERIFY(framer.inStep() && !framer.midPacket());
    }
}

void TestFramer::afterABadHeaderEverythingIsDiscarded()
{
    Framer framer;
    const auto read = feed(framer, hex("05 C7 01 04") + kBoard + kConfigured);
    QVERIFY(read.packets.empty());
    QCOMPARE(int(read.end), int(Step::BadHeaderCrc));
    QVERIFY(!framer.inStep());
    QCOMPARE(framer.discardedBytes(), std::uint64_t{12});
    framer.resynchronise();
    QCOMPARE(feed(framer, kBoard).packets.size(), std::size_t{1});
}

void TestFramer::itSaysWhatWasBad_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("what");
    QTest::newRow("crc") << QByteArray::fromHex("05C70104") << int(Step::BadHeaderCrc);
    QTest::newRow("type 3") << QByteArray::fromHex("43230110") << int(Step::UnknownType);
    QTest::newRow("configured once") << QByteArray::fromHex("16000020") << int(Step::Inconsistent);
}

void TestFramer::itSaysWhatWasBad()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, what);
    Bytes header(bytes.begin(), bytes.end());
    const std::uint32_t bits = ByteReader(header).u32() & 0x0FFFFFFFU;
    if (what == int(Step::Inconsistent)) // the CRC of the table row is only a place holder
        header[3] = static_cast<std::uint8_t>((header[3] & 0x0F) | crc4(bits) << 4);
    Framer framer;
    QCOMPARE(int(feed(framer, header).end), what);
}

void TestFramer::lengthsAreBoundedBeforeAByteIsStored()
{
    Framer framer;
    framer.setLimits({256, 2048, false});
    QCOMPARE(feed(framer, packet(true, Bytes(256, 1))).packets.size(), std::size_t{1});
    QCOMPARE(feed(framer, packet(false, Bytes(2048, 1))).packets.size(), std::size_t{1});
    QCOMPARE(int(feed(framer, packet(true, Bytes(257, 1))).end), int(Step::TooLong));
    framer.resynchronise();
    QCOMPARE(int(feed(framer, header(aspep::Data{false, 2049})).end), int(Step::TooLong));
}

void TestFramer::aNegotiatedPayloadCrcIsChecked()
{
    Framer framer;
    framer.setLimits({256, 2048, true});
    const Bytes payload = hex("19 00");
    QCOMPARE(feed(framer, crcPacket(payload, 0xB9EB)).packets.at(0).payload, payload);
    // What firmware sends: CA FE.
    QCOMPARE(feed(framer, crcPacket(payload, 0xFECA)).packets.at(0).payload, payload);
    // Nothing follows an empty payload.
    QCOMPARE(feed(framer, packet(true, {})).packets.size(), std::size_t{1});
    QCOMPARE(int(feed(framer, crcPacket(payload, 0xB9EA)).end), int(Step::BadPayloadCrc));
}

void TestFramer::itKnowsWhatIsMissing()
{
    Framer framer;
    QVERIFY(!framer.midPacket());
    (void)feed(framer, hex("49 00"));
    QCOMPARE(framer.missing(), std::size_t{2});
    (void)feed(framer, hex("00 70 01"));
    QCOMPARE(framer.missing(), std::size_t{3});
    framer.resynchronise();
    QVERIFY(!framer.midPacket());
    QCOMPARE(framer.discardedBytes(), std::uint64_t{5});
}

void TestFramer::itKnowsWhatAScannerWouldWaitFor()
{
    Framer framer;
    (void)feed(framer, hex("FF FF FF FF"));
    QCOMPARE(framer.missingToScanner(), std::size_t{0});
    (void)feed(framer, packet(true, Bytes(51, 0)));
    QCOMPARE(framer.missingToScanner(), std::size_t{0});
    (void)feed(framer, hex("00 3A 03 00 F0 01")); // looks like a response of 51 bytes
    QCOMPARE(framer.missingToScanner(), std::size_t{50});
    (void)feed(framer, Bytes(49, 0));
    QCOMPARE(framer.missingToScanner(), std::size_t{1});
}

void TestFramer::everyFlippedHeaderBitIsSeen()
{
    for (const Bytes &good :
        {kBoard, kConfigured, header(aspep::Nack{4}), header(aspep::Data{true, 4})}) {
        for (int bit = 0; bit < 32; ++bit) {
            Bytes bytes = good;
            bytes[static_cast<std::size_t>(bit / 8)] ^= static_cast<std::uint8_t>(1U << bit % 8);
            Framer framer;
            const auto read = feed(framer, bytes);
            QVERIFY(read.packets.empty() && read.end != Step::NeedBytes);
        }
    }
}

namespace {

/// A packet of a stream: a timestamp, values, mark and id.
Bytes ofStream(std::uint32_t number, std::uint8_t mark = 7)
{
    ByteWriter payload;
    payload.u32(number * 255);
    for (unsigned i = 0; i < 30; ++i)
        payload.u16(static_cast<std::uint16_t>(number * 1000 + i * 37));
    payload.u8(mark).u8(0);
    return packet(false, payload.take());
}

} // namespace

void TestFramer::twoPacketsOfAStreamInARowProveWhereTheyBegin()
{
    constexpr std::uint32_t kPackets = 12, kSpoilt = 4;
    const std::size_t size = ofStream(0).size(), from = kSpoilt * (size + 5);
    Bytes whole;
    std::vector<Bytes> sent;
    for (std::uint32_t i = 0; i < kPackets; ++i) {
        const Bytes one = ofStream(i);
        whole = whole + one + packet(true, hex("00")); // and an answer behind each
        sent.emplace_back(one.begin() + 4, one.end());
    }
    std::size_t cheap = 0;
    for (std::size_t at = from; at < from + size; ++at) {
        Bytes bytes = whole;
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
        Framer framer;
        std::vector<Bytes> good;
        for (std::size_t i = 0; i < bytes.size(); i += 16) {
            const ByteView part =
                ByteView(bytes).subspan(i, std::min<std::size_t>(16, bytes.size() - i));
            for (const Packet &one : feed(framer, part).packets)
                if (std::find(sent.begin(), sent.end(), one.payload) != sent.end())
                    good.push_back(one.payload);
        }
        QVERIFY(std::is_sorted(good.begin(), good.end(), [&](const Bytes &a, const Bytes &b) {
            return std::find(sent.begin(), sent.end(), a) < std::find(sent.begin(), sent.end(), b);
        }));
        QVERIFY(std::adjacent_find(good.begin(), good.end()) == good.end()); // none twice
        cheap += good.size() == kPackets - 1 ? 1 : 0;
    }
    // The rest are headers whose CRC is right by chance, and lengths that swallow what follows.
    QVERIFY2(cheap * 10 >= size * 9, std::to_string(cheap).c_str());
}

void TestFramer::oneAloneOrAnotherLookProvesNothing()
{
    const Bytes begun = ofStream(0) + ofStream(1) + hex("FF FF FF FF");
    for (const Bytes &behind : {ofStream(2) + kBoard, ofStream(2) + ofStream(3, 8),
             ofStream(2, 8) + ofStream(3, 8), ofStream(2) + hex("01") + ofStream(3)}) {
        Framer framer;
        QCOMPARE(feed(framer, begun).packets.size(), std::size_t{2});
        QVERIFY(feed(framer, behind).packets.empty());
        QVERIFY(!framer.inStep());
    }
    Framer framer; // nothing was learnt
    QCOMPARE(feed(framer, hex("FF FF FF FF") + ofStream(2) + ofStream(3)).packets.size(),
        std::size_t{0});
    QVERIFY(!framer.inStep());
}

QTEST_APPLESS_MAIN(TestFramer)
#include "tst_framer.moc"

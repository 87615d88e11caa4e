// ASPEP headers against captured bytes and against every field.
#include "aspep/packet.h"

#include <QtTest>

using namespace aspep;

class TestPacket : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void headersMatchTheWire_data();
    void headersMatchTheWire();
    void everySingleFlippedBitIsRefused();
};

namespace {

HeaderBytes headerBytes(std::uint32_t wire)
{
    return {static_cast<std::uint8_t>(wire >> 24), static_cast<std::uint8_t>(wire >> 16),
        static_cast<std::uint8_t>(wire >> 8), static_cast<std::uint8_t>(wire)};
}

struct Vector {
    const char *name;
    Header header;
    std::uint32_t wire; ///< the four bytes in wire order, first byte highest
};

// Captured from a 6.3.2 board and its vendor tool, or computed by the compiled firmware.
const Vector kVectors[] = {
    {"widest beacon, CRC offered", Beacon{0, true, 63, 127, 127}, 0x85FFFFBF},
    {"widest beacon", Beacon{0, false, 63, 127, 127}, 0x05FFFF0F},
    {"256 / 256 / 2048", Beacon{0, false, 7, 7, 32}, 0x05C70114},
    {"128 / 128 / 2048", Beacon{0, false, 3, 3, 32}, 0x05C300D4},
    {"128 / 128 / no async", Beacon{0, false, 3, 3, 0}, 0x05C30060},
    {"empty beacon", Beacon{0, false, 0, 0, 0}, 0x05000050},
    {"version 7", Beacon{7, true, 63, 127, 127}, 0xF5FFFFAF},
    {"ping 0", Ping{false, false, 0, 0}, 0x06000060},
    {"ping 1", Ping{false, false, 0, 1}, 0x06100020},
    {"ping 0xFFFF", Ping{false, false, 0, 0xFFFF}, 0x06F0FFFF},
    {"ping reply C=1 N=0", Ping{true, false, 0, 0}, 0x36000090},
    {"ping reply C=1 N=1", Ping{true, true, 0, 0}, 0xF60000C0},
    {"ping reply C=0 N=1", Ping{false, true, 0, 0}, 0xC6000030},
    {"ping reply on link 1", Ping{true, true, 1, 0x1234}, 0xF6412361},
    {"nack 1", Nack{1}, 0x0F0101A0},
    {"nack 2", Nack{2}, 0x0F020250},
    {"nack 4", Nack{4}, 0x0F0404C0},
    {"nack 5", Nack{5}, 0x0F050590},
    {"empty data", Data{false, 0}, 0x09000090},
    {"data 4", Data{false, 4}, 0x49000070},
    {"data 13", Data{false, 13}, 0xD9000040},
    {"data 256", Data{false, 256}, 0x091000D0},
    {"async 2046", Data{false, 2046}, 0xE97F00C0},
    {"async 4096", Data{false, 4096}, 0x09000170},
    {"async 8128", Data{false, 8128}, 0x09FC0140},
    {"response 1", Data{true, 1}, 0x1A000020},
    {"response 51", Data{true, 51}, 0x3A0300F0},
    {"response 4096", Data{true, 4096}, 0x0A000140},
};

} // namespace

void TestPacket::headersMatchTheWire_data()
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Vector &vector : kVectors)
        QTest::newRow(vector.name) << index++;
}

void TestPacket::headersMatchTheWire()
{
    QFETCH(int, index);
    const Vector &vector = kVectors[index];
    QCOMPARE(encodeHeader(vector.header), headerBytes(vector.wire));
    const auto decoded = decodeHeader(headerBytes(vector.wire));
    QVERIFY(decoded.has_value());
    QVERIFY(*decoded == vector.header);
}

void TestPacket::everySingleFlippedBitIsRefused()
{
    for (const Vector &vector : kVectors) {
        for (int bit = 0; bit < 32; ++bit) {
            const auto decoded = decodeHeader(headerBytes(vector.wire ^ (1U << bit)));
            QVERIFY(!decoded.has_value());
        }
    }
}

QTEST_APPLESS_MAIN(TestPacket)
#include "tst_packet.moc"

// The checksums against their definition, bit by bit.
#include "base/crc.h"

#include <QtTest>

#include <random>

class TestCrc : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void crc16HasItsPublishedCheckValue();
    void crc16EqualsTheDefinitionAtEveryLength();
};

namespace {

std::uint16_t bitByBit(ByteView bytes)
{
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc ^= unsigned(byte) << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U);
        crc &= 0xFFFFU;
    }
    return static_cast<std::uint16_t>(crc);
}

} // namespace

void TestCrc::crc16HasItsPublishedCheckValue()
{
    const Bytes text{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    QCOMPARE(crc16Xmodem(text), std::uint16_t(0x31C3));
    QCOMPARE(crc16Xmodem({}), std::uint16_t(0));
}

void TestCrc::crc16EqualsTheDefinitionAtEveryLength()
{
    std::mt19937 random(1);
    Bytes bytes;
    for (int length = 0; length < 600; ++length) {
        QCOMPARE(crc16Xmodem(bytes), bitByBit(bytes));
        bytes.push_back(static_cast<std::uint8_t>(random()));
    }
}

QTEST_APPLESS_MAIN(TestCrc)
#include "tst_crc.moc"

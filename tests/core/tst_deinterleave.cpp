// Interleaved samples to columns: every way of doing it brings the same samples and touches nothing else.
#include "mcp/deinterleave.h"

#include <QtTest>

#include <random>
#include <vector>

class TestDeinterleave : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyWayFollowsTheDefinition_data();
    void everyWayFollowsTheDefinition();
};

namespace {

using Way = void (*)(const std::uint8_t *, std::size_t, std::size_t, std::int16_t *, std::size_t);
constexpr std::int16_t kUntouched = 0x5A5A;

/// What the packets' layout says, value by value; everything around the columns stays as it was.
std::vector<std::int16_t> expected(const std::vector<std::uint8_t> &bytes, std::size_t offset,
    std::size_t width, std::size_t blocks, std::size_t pitch)
{
    std::vector<std::int16_t> columns(width * pitch + 16, kUntouched);
    for (std::size_t b = 0; b < blocks; ++b) {
        for (std::size_t s = 0; s < width; ++s) {
            const std::size_t at = offset + 2 * (b * width + s);
            columns[8 + s * pitch + b] = static_cast<std::int16_t>(bytes[at] + 256 * bytes[at + 1]);
        }
    }
    return columns;
}

} // namespace

void TestDeinterleave::everyWayFollowsTheDefinition_data()
{
    QTest::addColumn<bool>("portable");
    QTest::newRow("of this processor") << false;
    QTest::newRow("portable") << true;
}

void TestDeinterleave::everyWayFollowsTheDefinition()
{
    QFETCH(bool, portable);
    const Way way = portable ? &mcp::deinterleavePortable : &mcp::deinterleave;
    std::mt19937 random(7);
    for (std::size_t width = 1; width <= 12; ++width) {
        for (std::size_t blocks = 0; blocks <= 41; ++blocks) {
            // Exactly as many bytes as are read: a sanitizer sees one more.
            const std::size_t offset = random() % 4;
            std::vector<std::uint8_t> bytes(offset + 2 * width * blocks);
            for (std::uint8_t &byte : bytes)
                byte = static_cast<std::uint8_t>(random());
            const std::size_t pitch = blocks + random() % 5;
            std::vector<std::int16_t> columns(width * pitch + 16, kUntouched);
            way(bytes.data() + offset, width, blocks, columns.data() + 8, pitch);
            QVERIFY2(columns == expected(bytes, offset, width, blocks, pitch),
                qPrintable(QStringLiteral("%1 signals, %2 blocks").arg(width).arg(blocks)));
        }
    }
}

QTEST_APPLESS_MAIN(TestDeinterleave)
#include "tst_deinterleave.moc"

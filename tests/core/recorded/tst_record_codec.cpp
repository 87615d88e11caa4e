// Entries of a recording to bytes and back.
#include "recorded/block.h"
#include "recorded/crc32.h"
#include "recorded/decoder.h"
#include "recorded/encoder.h"
#include "recorded/entry_codec.h"

#include <QtTest>

#include <limits>

using namespace recorded;

class TestRecordCodec : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theChecksumIsThatOfZlib();
    void everyKindOfEntryReadsBack();
    void samplesReadBackAtTheirExtremes();
    void aSlowSignalOfFloatsReadsBackAsOne();
    void whatDoesNotFitIsRefused();
    void everyCutPayloadIsOneError();
    void absurdLengthsAllocateNothing();
    void aBlockIsWhatPcapngSays();
    void everyFlippedBitOfABlockIsSeen();
};

namespace {

capture::StreamLayout codecLayout()
{
    return {7, 16000.0, 1.25, 2,
        {{0x51, "I_A", "A", 0.001, 0.0}, {0x91, "ANGLE\u00b0,\"x\"", "", -3.5e-12, 32768.0}},
        {{0x11, "SPEED", "rpm", 6.0, 0.0}}};
}

capture::SampleBlock samples()
{
    return {7, 1'000'000'000'000, 3, {1, -2, 32767, -32768, 0, 5},
        {{1'000'000'000'002, {-2147483647}}, {1'000'000'000'004, {2147483647}}}, 12};
}

std::vector<Entry> oneOfEach()
{
    return {Begin{-5, "Rotorscope 0.1", "/dev/ttyACM0"}, codecLayout(), capture::StreamLayout{},
        samples(), PolledRegister{0x11, "BUS_VOLTAGE@2", "V"},
        PolledValues{{{0x11, -3, 0.1}, {0x12, 5, std::numeric_limits<double>::infinity()}}},
        Happening{"motor state", {{"state", "RUN"}, {"fault", ""}}},
        RegisterSnapshot{"before", "{\"a\": 1}\n"}, Note{1, 2, "here"}, Lost{1, 2, 3},
        End{End::Reason::DiskFull, "No space left on device", 4, 5}};
}

/// Two entries are the same if they give the same bytes.
void compare(const Entry &a, const Entry &b)
{
    QCOMPARE(a.index(), b.index());
    QCOMPARE(encodeEntry(a).value(), encodeEntry(b).value());
}

ByteView view(const char *text)
{
    return {reinterpret_cast<const std::uint8_t *>(text), std::strlen(text)};
}

} // namespace

void TestRecordCodec::theChecksumIsThatOfZlib()
{
    QCOMPARE(crc32({}), 0U);
    QCOMPARE(crc32(view("123456789")), 0xCBF43926U); // the check value of the catalogues of CRCs
    QCOMPARE(crc32(view("The quick brown fox jumps over the lazy dog")), 0x414FA339U);
}

void TestRecordCodec::everyKindOfEntryReadsBack()
{
    for (const Entry &entry : oneOfEach()) {
        const auto payload = encodeEntry(entry);
        QVERIFY(payload.has_value());
        const auto decoded = decodeEntry(*payload);
        QVERIFY2(decoded.has_value(), qPrintable(QString::number(entry.index())));
        QCOMPARE(decoded->repeat, Repeat::No);
        compare(decoded->entry, entry);
    }
    const auto begin = decodeEntry(encodeEntry(oneOfEach()[0]).value());
    QCOMPARE(std::get<Begin>(begin->entry), std::get<Begin>(oneOfEach()[0]));
    const auto repeated = decodeEntry(encodeEntry(codecLayout(), Repeat::Yes).value());
    QCOMPARE(repeated->repeat, Repeat::Yes);
    const auto &read = std::get<capture::StreamLayout>(repeated->entry);
    QCOMPARE(read.fast[1].name, codecLayout().fast[1].name);
    QCOMPARE(read.fast[1].factor, codecLayout().fast[1].factor);
    QCOMPARE(read.slow[0].unit, std::string("rpm"));
    QCOMPARE(read.fastStep, 2U);
}

void TestRecordCodec::samplesReadBackAtTheirExtremes()
{
    const auto decoded = decodeEntry(encodeEntry(samples()).value());
    const auto &read = std::get<capture::SampleBlock>(decoded->entry);
    QCOMPARE(read.fast, samples().fast);
    QCOMPARE(read.firstTick, samples().firstTick);
    QCOMPARE(read.lostTicks, samples().lostTicks);
    QCOMPARE(read.slow.size(), std::size_t(2));
    QCOMPARE(read.slow[1].tick, samples().slow[1].tick);
    QCOMPARE(read.slow[1].values, samples().slow[1].values);
}

void TestRecordCodec::aSlowSignalOfFloatsReadsBackAsOne()
{
    capture::StreamLayout mixed = codecLayout();
    mixed.slow.push_back({0x19, "CURRENT", "A", 1.0, 0.0, true});
    const auto decoded = decodeEntry(encodeEntry(mixed).value());
    QVERIFY(decoded);
    const auto &read = std::get<capture::StreamLayout>(decoded->entry);
    QCOMPARE(read.slow.size(), std::size_t{2});
    QVERIFY(!read.slow[0].real && read.slow[1].real);
}

void TestRecordCodec::whatDoesNotFitIsRefused()
{
    capture::SampleBlock ragged = samples();
    ragged.fast.pop_back();
    capture::SampleBlock uneven = samples();
    uneven.slow[1].values.push_back(1);
    capture::StreamLayout wide;
    wide.fast.resize(kMostSignals + 1);
    for (const Entry &entry :
        {Entry(ragged), Entry(uneven), Entry(wide), Entry(Note{0, 0, std::string(70'000, 'x')}),
            Entry(RegisterSnapshot{"", std::string(kMostPayload, 'x')})})
        QCOMPARE(encodeEntry(entry).error(), PayloadError::TooLong);
}

void TestRecordCodec::everyCutPayloadIsOneError()
{
    for (const Entry &entry : oneOfEach()) {
        const Bytes whole = encodeEntry(entry).value();
        for (std::size_t length = 0; length < whole.size(); ++length)
            QVERIFY(!decodeEntry(ByteView(whole).first(length)));
    }
    QCOMPARE(decodeEntry(view("XS\x01\x05")).error(), PayloadError::NotOurs);
    QCOMPARE(decodeEntry(view("RS\x02\x05")).error(), PayloadError::NotOurs);
    QCOMPARE(decodeEntry(view("RS\x01\x7f")).error(), PayloadError::UnknownKind);
}

void TestRecordCodec::absurdLengthsAllocateNothing()
{
    // 4 billion rows, groups and values that are not there.
    const Bytes rows = ByteWriter()
                           .text("RS")
                           .u8(1)
                           .u8(3)
                           .u32(7)
                           .u64(0)
                           .u64(0)
                           .u32(0xFFFFFFFF)
                           .u16(1024)
                           .u16(0)
                           .u32(0)
                           .take();
    const Bytes groups = ByteWriter()
                             .text("RS")
                             .u8(1)
                             .u8(3)
                             .u32(7)
                             .u64(0)
                             .u64(0)
                             .u32(0)
                             .u16(0)
                             .u16(0)
                             .u32(0xFFFFFFFF)
                             .take();
    const Bytes values = ByteWriter().text("RS").u8(1).u8(5).u32(0xFFFFFFFF).take();
    const Bytes json = ByteWriter().text("RS").u8(1).u8(7).u16(0).u32(0xFFFFFFFF).take();
    for (const Bytes &payload : {rows, groups, values, json})
        QCOMPARE(decodeEntry(payload).error(), PayloadError::Malformed);
}

/// Byte by byte against draft-ietf-opsawg-pcapng, section 4.3.
void TestRecordCodec::aBlockIsWhatPcapngSays()
{
    const Bytes block =
        packetBlock({Interface::Link, 0x0102030405060708, 2, 9, 0}, Bytes{0xAA, 0xBB, 0xCC});
    QCOMPARE(block.size(), blockSize(3));
    const Bytes front{6, 0, 0, 0, 72, 0, 0, 0, 0, 0, 0, 0, 4, 3, 2, 1, 8, 7, 6, 5, 3, 0, 0, 0, 3, 0,
        0, 0, 0xAA, 0xBB, 0xCC, 0, 2, 0, 4, 0, 2, 0, 0, 0, 5, 0, 8, 0, 9, 0, 0, 0};
    QCOMPARE(Bytes(block.begin(), block.begin() + 48), front);
    const Bytes hash{3, 0, 5, 0, 2};
    QCOMPARE(Bytes(block.begin() + 52, block.begin() + 57), hash);
    const Bytes back{0, 0, 0, 0, 72, 0, 0, 0};
    QCOMPARE(Bytes(block.end() - 8, block.end()), back);
    const auto head = packetHead(block, 100);
    QVERIFY(head.has_value());
    QCOMPARE(head->at, 0x0102030405060708);
    QCOMPARE(head->number, 9U);
    QCOMPARE(packetData(*head, block)->size(), std::size_t(3));
    QVERIFY(!packetHead(block, 2)); // more data than is allowed
}

void TestRecordCodec::everyFlippedBitOfABlockIsSeen()
{
    const ByteView text = view("RS some payload");
    const Bytes sound =
        packetBlock({Interface::Entries, 5, 0, 1, 0}, Bytes(text.begin(), text.end()));
    const std::size_t padding = kFixedHead + text.size();
    for (std::size_t bit = 0; bit < sound.size() * 8; ++bit) {
        Bytes flipped = sound;
        flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        const auto head = packetHead(flipped, kMostPayload);
        const bool taken = head && packetData(*head, flipped);
        // Padding, the options' own padding and end, and the second length carry nothing.
        const std::size_t at = bit / 8;
        const bool carries = at < padding || (at >= padding + 1 && at < sound.size() - 11);
        QVERIFY2(!taken || !carries, qPrintable(QString::number(at)));
    }
}

QTEST_APPLESS_MAIN(TestRecordCodec)
#include "tst_record_codec.moc"

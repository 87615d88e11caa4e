// Datalog configurations, the shape of their packets, and packets turned into samples.
#include "mcp/datalog_decoder.h"
#include "support/virtual_link.h"

using namespace mcp;
using support::hex;

class TestDatalog : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void configurationsMatchTheWire();
    void idsWithoutAMotorAreRefused();
    void whatOnlyStopsIsReadToo();
    void theRegisterFollowsTheLinkId();
    void twoSignalsIn2048BytesFill2046();
    void lengthsThatFitNoLayoutAreTold();
    void theBufferIsLargeButFreshAndShort();
    void theBufferHoldsWholeGroups();
    void samplesComeOutSignalBySignal();
    void slowValuesFollowTheirBlocks();
    void aPacketThatIsSentOffEarlyHasNoSlowGroup();
    void aBlockThatIsUsedAgainKeepsItsRoom();
    void unsignedSignalsAreStoredLessHalfTheirRange();
    void missingTicksAreCountedAsLost();
    void timeRunsOverTheWrapOfTheCounter();
    void anOldMarkIsReadUntilTheNewOneIsSeen();
    void otherServicesMarksAndLengthsAreCountedAndSkipped();
    void aFarJumpNeedsTwoPacketsToBeBelieved();
    void aCounterThatWentBackBeginsANewEpoch();
};

namespace {

const RegisterId kIa{0x07D1};
const RegisterId kIb{0x0811};
const RegisterId kSpeed{0x0B91};

DatalogConfig config(std::uint16_t size, std::vector<RegisterId> fast, std::uint8_t mark = 1)
{
    DatalogConfig c;
    c.bufferSize = size;
    c.fast = std::move(fast);
    c.mark = mark;
    return c;
}

Bytes payload(std::uint32_t timestamp, std::initializer_list<int> samples, std::uint8_t mark = 1,
    std::uint8_t id = 0)
{
    ByteWriter w;
    w.u32(timestamp);
    for (const int sample : samples)
        w.s16(sample);
    return w.u8(mark).u8(id).take();
}

using Samples = std::vector<std::int16_t>;

} // namespace

void TestDatalog::configurationsMatchTheWire()
{
    QCOMPARE(*encodeDatalog(datalogStop(8128)), hex("00 08 00 00 FF 00 00")); // captured
    QCOMPARE(*encodeDatalog(datalogStop(512)), hex("00 02 00 00 FF 00 00"));
    const DatalogConfig start = config(2048, {{0x08D1}, {0x0911}});
    const Bytes wire = hex("00 08 00 02 FF 00 D1 08 11 09 01");
    QCOMPARE(*encodeDatalog(start), wire);
    QVERIFY(*decodeDatalog(wire) == start);
    QVERIFY(decodeDatalog(hex("00 08 00 00 FF 00 00"))->stops());
}

void TestDatalog::idsWithoutAMotorAreRefused()
{
    QCOMPARE(encodeDatalog(config(2048, {{0x08D0}})).error(), CodecError::NoMotor);
    DatalogConfig slow = config(2048, {kIa});
    slow.slow = {{0x0B90}};
    QCOMPARE(encodeDatalog(slow).error(), CodecError::NoMotor);
}

void TestDatalog::whatOnlyStopsIsReadToo()
{
    QVERIFY(decodeDatalog(hex("00 00"))->stops());
    QVERIFY(decodeDatalog(hex("00 00 00 09 FF 00 00"))->stops());
    QCOMPARE(decodeDatalog(hex("00")).error(), CodecError::TooShort);
    QCOMPARE(decodeDatalog(hex("00 08 00 02 FF 00 D1 08")).error(), CodecError::TooShort);
    QCOMPARE(decodeDatalog(hex("00 08 00 02 FF 00 D1 08 11 09")).error(), CodecError::TooShort);
}

void TestDatalog::theRegisterFollowsTheLinkId()
{
    QCOMPARE(int(datalogRegister(0).bits), 0x0529);
    QCOMPARE(int(datalogRegister(1).bits), 0x0569);
}

void TestDatalog::twoSignalsIn2048BytesFill2046()
{
    const DatalogLayout layout(config(2048, {kIa, kIb}));
    QCOMPARE(*layout.fullLength(), std::size_t{2046});
    QCOMPARE(layout.fullBlocks(), std::size_t{510});
    QCOMPARE(*layout.blocksIn(2046), std::size_t{510});
    // refused: below one block and 6 bytes
    QVERIFY(!DatalogLayout(config(9, {kIa, kIb})).fullLength());
    QCOMPARE(*DatalogLayout(config(10, {kIa, kIb})).fullLength(), std::size_t{10});
}

void TestDatalog::lengthsThatFitNoLayoutAreTold()
{
    DatalogConfig c = config(256, {kIa, kIb});
    c.slow = {kSpeed};
    c.slowRate = 2; // three blocks of 4 bytes, then 2 bytes
    const DatalogLayout layout(c);
    QCOMPARE(*layout.blocksIn(6), std::size_t{0});
    QCOMPARE(*layout.blocksIn(6 + 8), std::size_t{2});
    QVERIFY(!layout.blocksIn(6 + 12)); // the third block without its MF group
    QCOMPARE(*layout.blocksIn(6 + 14), std::size_t{3});
    QVERIFY(!layout.blocksIn(6 + 15));
    QVERIFY(!layout.blocksIn(5));
    c.slowRate = kSlowAtEnd;
    QCOMPARE(*DatalogLayout(c).blocksIn(6 + 62 * 4 + 2), std::size_t{62}); // full: 256 bytes
    QCOMPARE(*DatalogLayout(c).blocksIn(6 + 4), std::size_t{1}); // sent off early: no group
    QVERIFY(!DatalogLayout(c).blocksIn(6 + 4 + 2));
    c.fast.clear();
    QVERIFY(!DatalogLayout(c).fullLength()); // never sent
}

void TestDatalog::theBufferIsLargeButFreshAndShort()
{
    const DatalogConfig two = config(0, {kIa, kIb});
    const auto blocks = [](DatalogConfig c, std::uint16_t size) {
        c.bufferSize = size;
        c.mark = 1;
        return DatalogLayout(c).fullBlocks();
    };
    const DatalogConfig four = config(0, {kIa, kIb, kIa, kIb});
    // All of it: 12 ms, 11 ms on the line.
    QCOMPARE(int(*chooseBufferSize(four, {2048, 22000, 1843200})), 2048);
    const auto one = chooseBufferSize(config(0, {kIa}), {2048, 16000, 1843200});
    QCOMPARE(blocks(config(0, {kIa}), *one), std::size_t{192}); // 12 ms at 16 kHz
    const auto slowLine = chooseBufferSize(two, {2048, 16000, 115200});
    QVERIFY(*slowLine <= 226 && *slowLine > 218); // 20 ms of 11520 bytes a second
    DatalogConfig rare = two;
    rare.fastRate = 255;
    // 16 ms apart.
    QCOMPARE(blocks(rare, *chooseBufferSize(rare, {2048, 16000, 1843200})), std::size_t{1});
    QVERIFY(!chooseBufferSize(two, {0, 16000, 1843200}));
    QVERIFY(!chooseBufferSize(two, {9, 16000, 1843200}));
    QVERIFY(!chooseBufferSize(config(0, {}), {2048, 16000, 1843200}));
}

void TestDatalog::theBufferHoldsWholeGroups()
{
    DatalogConfig c = config(0, {kIa});
    c.slow = {kSpeed};
    c.slowRate = 6;
    c.bufferSize = *chooseBufferSize(c, {2048, 16000, 1843200});
    c.mark = 1;
    const DatalogLayout layout(c);
    QCOMPARE(layout.fullBlocks() % 7, std::size_t{0});
    QVERIFY(layout.fullBlocks() > 7);
    c.fastRate = 255;
    c.slowRate = 19; // a group takes 320 ms
    c.bufferSize = *chooseBufferSize(c, {2048, 16000, 1843200});
    QCOMPARE(DatalogLayout(c).fullBlocks(), std::size_t{20});
    c.slowRate = 253;
    QVERIFY(!chooseBufferSize(c, {256, 16000, 1843200})); // would never send its MF values
}

void TestDatalog::samplesComeOutSignalBySignal()
{
    for (std::size_t lines = 1; lines <= 10; ++lines) {
        DatalogDecoder decoder(16000);
        decoder.expect(7, config(2048, std::vector<RegisterId>(lines, kIa)));
        ByteWriter w;
        w.u32(1000);
        for (int block = 0; block < 20; ++block)
            for (std::size_t s = 0; s < lines; ++s)
                w.s16(static_cast<int>(s) * 1000 - block);
        const auto block = decoder.decode(w.u8(1).u8(0).take());
        QVERIFY(block.has_value());
        QCOMPARE(block->stream, capture::StreamId{7});
        QCOMPARE(block->firstTick, capture::Tick{1000});
        QCOMPARE(block->count, 20U);
        QCOMPARE(block->fast.size(), 20 * lines);
        for (std::size_t s = 0; s < lines; ++s)
            for (std::size_t i = 0; i < 20; ++i)
                QCOMPARE(
                    int(block->fast[s * 20 + i]), static_cast<int>(s) * 1000 - static_cast<int>(i));
    }
}

void TestDatalog::slowValuesFollowTheirBlocks()
{
    DatalogConfig c = config(64, {kIa});
    c.fastRate = 1;
    c.slowRate = 1;
    c.slow = {{0x0049}, kSpeed, {0x0059}}; // 8, 16 and 32 bits
    DatalogDecoder decoder(16000);
    decoder.expect(1, c, {{}, {true, false, false}});
    const auto block = decoder.decode(
        hex("64000000 0100 0200 FF FEFF 01000080 0300 0400 01 0500 02000000 0500 01 00"));
    QVERIFY(block.has_value());
    QVERIFY((block->fast == Samples{1, 2, 3, 4, 5}));
    QCOMPARE(block->slow.size(), std::size_t{2});
    QCOMPARE(block->slow[0].tick, capture::Tick{102}); // that of the second block
    QVERIFY((block->slow[0].values == std::vector<std::int32_t>{255, -2, INT32_MIN + 1}));
    QCOMPARE(block->slow[1].tick, capture::Tick{106});
    QVERIFY((block->slow[1].values == std::vector<std::int32_t>{1, 5, 2}));
}

void TestDatalog::aPacketThatIsSentOffEarlyHasNoSlowGroup()
{
    DatalogConfig c = config(14, {kIa}); // full with three blocks
    c.slowRate = kSlowAtEnd;
    c.slow = {kSpeed};
    DatalogDecoder decoder(16000);
    decoder.expect(1, c);
    const auto whole = decoder.decode(payload(0, {1, 2, 3, 77}));
    QVERIFY((whole->fast == Samples{1, 2, 3}));
    QCOMPARE(whole->slow.at(0).values.at(0), 77);
    QCOMPARE(whole->slow.at(0).tick, capture::Tick{2});
    const auto last = decoder.decode(payload(3, {4, 5})); // a stop or a fault cut it short
    QVERIFY((last->fast == Samples{4, 5}));
    QVERIFY(last->slow.empty());
    QCOMPARE(last->lostTicks, capture::Tick{0});
}

void TestDatalog::aBlockThatIsUsedAgainKeepsItsRoom()
{
    DatalogConfig c = config(64, {kIa});
    c.slow = {kSpeed};
    c.slowRate = 1; // a group after every second block
    DatalogDecoder decoder(16000);
    decoder.expect(1, c);
    const auto packet = [](std::uint32_t at) {
        ByteWriter w;
        w.u32(at).s16(1).s16(2).u16(77).s16(3).s16(4).u16(78);
        return w.u8(1).u8(0).take();
    };
    capture::SampleBlock block;
    QVERIFY(decoder.decode(packet(0), block));
    const std::int16_t *samples = block.fast.data();
    const capture::SlowGroup *groups = block.slow.data();
    const std::int32_t *values = block.slow[1].values.data();
    block.lostTicks = 5;
    QVERIFY(decoder.decode(packet(4), block));
    QVERIFY((block.fast == Samples{1, 2, 3, 4}));
    QCOMPARE(block.slow.size(), std::size_t{2});
    QCOMPARE(block.slow[1].tick, capture::Tick{7});
    QCOMPARE(block.slow[1].values, std::vector<std::int32_t>{78});
    QCOMPARE(block.lostTicks, capture::Tick{0});
    QVERIFY(block.fast.data() == samples && block.slow.data() == groups);
    QVERIFY(block.slow[1].values.data() == values);
}

void TestDatalog::unsignedSignalsAreStoredLessHalfTheirRange()
{
    DatalogDecoder decoder(16000);
    decoder.expect(1, config(64, {kIa, kIb}), {{false, true}, {}});
    const auto block = decoder.decode(payload(0, {1, 0, 2, -1}));
    QVERIFY((block->fast == Samples{1, 2, -32768, 32767}));
}

void TestDatalog::missingTicksAreCountedAsLost()
{
    DatalogConfig c = config(64, {kIa});
    c.fastRate = 3;
    DatalogDecoder decoder(16000);
    decoder.expect(1, c);
    QCOMPARE(decoder.decode(payload(100, {1, 2}))->lostTicks, capture::Tick{0});
    QCOMPARE(decoder.decode(payload(108, {1, 2}))->lostTicks, capture::Tick{0});
    const auto block = decoder.decode(payload(128, {1, 2}));
    QCOMPARE(block->lostTicks, capture::Tick{12});
    QCOMPARE(block->firstTick, capture::Tick{128});
    QCOMPARE(decoder.stats().lostTicks, std::uint64_t{12});
    QVERIFY(!decoder.decode(payload(138, {1}))); // not a whole number of steps
    QCOMPARE(decoder.stats().badTime, std::uint64_t{1});
    QCOMPARE(decoder.decode(payload(136, {1}))->lostTicks, capture::Tick{0});
}

void TestDatalog::timeRunsOverTheWrapOfTheCounter()
{
    DatalogDecoder decoder(16000);
    decoder.expect(1, config(64, {kIa}));
    std::uint32_t timestamp = 0xFFFFFFFFU - 1000;
    capture::Tick expected = timestamp;
    for (int i = 0; i < 1000; ++i) {
        const auto block = decoder.decode(payload(timestamp, {1, 2, 3}));
        QCOMPARE(block->firstTick, expected);
        QCOMPARE(block->lostTicks, capture::Tick{0});
        timestamp += 3;
        expected += 3;
    }
    QVERIFY(expected > 0xFFFFFFFFLL);
    QCOMPARE(decoder.epoch(), 0U);
}

void TestDatalog::anOldMarkIsReadUntilTheNewOneIsSeen()
{
    DatalogDecoder decoder(16000);
    decoder.expect(1, config(64, {kIa}, 1));
    QVERIFY(decoder.decode(payload(0, {1, 2}, 1)));
    decoder.expect(2, config(64, {kIa, kIb}, 2));
    decoder.expect(3, config(64, {kIb, kIa}, 3));
    QCOMPARE(decoder.decode(payload(2, {1, 2}, 1))->stream, capture::StreamId{1});
    const auto block = decoder.decode(payload(90, {1, 2}, 3)); // the one between was never started
    QCOMPARE(block->stream, capture::StreamId{3});
    QCOMPARE(block->lostTicks, capture::Tick{0});
    QVERIFY(!decoder.decode(payload(91, {1, 2}, 1)));
    QCOMPARE(decoder.stats().unknownMark, std::uint64_t{1});
}

void TestDatalog::otherServicesMarksAndLengthsAreCountedAndSkipped()
{
    DatalogDecoder decoder(16000);
    decoder.expect(1, config(20, {kIa, kIb}));
    QVERIFY(!decoder.decode(payload(0, {1, 2}, 1, 1)));
    QVERIFY(!decoder.decode(payload(0, {1, 2}, 9)));
    QVERIFY(!decoder.decode(payload(0, {1, 2, 3})));
    QVERIFY(!decoder.decode(payload(0, {1, 2, 3, 4, 5, 6, 7, 8}))); // longer than a full packet
    QVERIFY(!decoder.decode(hex("01 00")));
    QVERIFY(!decoder.decode({}));
    const auto &stats = decoder.stats();
    QCOMPARE(stats.otherId, std::uint64_t{1});
    QCOMPARE(stats.unknownMark, std::uint64_t{1});
    QCOMPARE(stats.badLength, std::uint64_t{4});
    QCOMPARE(stats.skipped(), std::uint64_t{6});
    QCOMPARE(stats.packets, std::uint64_t{0});
}

void TestDatalog::aFarJumpNeedsTwoPacketsToBeBelieved()
{
    DatalogDecoder decoder(1000);
    decoder.expect(1, config(64, {kIa}));
    QVERIFY(decoder.decode(payload(0, {1, 2})));
    QVERIFY(!decoder.decode(payload(500000, {1, 2}))); // noise
    QCOMPARE(decoder.decode(payload(2, {1, 2}))->lostTicks, capture::Tick{0});
    QVERIFY(!decoder.decode(payload(500000, {1, 2})));
    const auto believed = decoder.decode(payload(500002, {1, 2}));
    QCOMPARE(believed->firstTick, capture::Tick{500002});
    QCOMPARE(believed->lostTicks, capture::Tick{500002 - 4});
    QCOMPARE(decoder.epoch(), 0U);
}

void TestDatalog::aCounterThatWentBackBeginsANewEpoch()
{
    DatalogDecoder decoder(1000);
    decoder.expect(1, config(64, {kIa}));
    QVERIFY(decoder.decode(payload(70000, {1, 2})));
    QVERIFY(!decoder.decode(payload(10, {1, 2})));
    const auto block = decoder.decode(payload(12, {1, 2}));
    QCOMPARE(block->firstTick, capture::Tick{12});
    QCOMPARE(block->lostTicks, capture::Tick{0});
    QCOMPARE(decoder.epoch(), 1U);
    QCOMPARE(decoder.stats().timeRestarts, std::uint64_t{1});
}

QTEST_APPLESS_MAIN(TestDatalog)
#include "tst_datalog.moc"

// The overview of a recording: every peak in a bounded room, and nothing taken for one that is none.
#include "capture/capture.h"
#include "recorded/decoder.h"
#include "recorded/encoder.h"
#include "recorded/overview.h"

#include <QtTest>

#include <random>

using namespace recorded;
using capture::CodeRange;
using capture::Tick;

class TestRecordOverview : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everySampleIsInItsStretch_data();
    void everySampleIsInItsStretch();
    void itKeepsToItsShare();
    void eachLayoutHasItsOwn();
    void aClockThatRunsBackIsNoPartOfIt();
    void itIsReadBackAsItWasWritten();
    void whatIsNoneIsNotTakenForOne();
    void itsPictureHasThePeaksOfTheSamples();
    void aReaderThatDoesNotKnowItPassesOverIt();
};

namespace {

constexpr std::size_t kPlenty = 100'000'000;

capture::StreamLayout layoutOf(std::size_t signalCount, std::uint32_t step = 1)
{
    capture::StreamLayout layout{1, 16000.0, 0.0, step, {}, {}};
    for (std::size_t i = 0; i < signalCount; ++i)
        layout.fast.push_back({catalog::RegisterId(i + 1), "S", "A", 0.5, 0.0});
    return layout;
}

/// A stream with gaps, block by block.
std::vector<capture::SampleBlock> blocksOf(
    std::size_t signalCount, std::size_t blocks, std::uint32_t step, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::vector<capture::SampleBlock> all;
    Tick tick = 1000;
    for (std::size_t b = 0; b < blocks; ++b) {
        const auto count = static_cast<std::uint32_t>(1 + random() % 900);
        capture::SampleBlock block{1, tick, count, {}, {}, 0};
        for (std::size_t i = 0; i < count * signalCount; ++i)
            block.fast.push_back(static_cast<std::int16_t>(random() % 2000));
        block.fast[random() % block.fast.size()] = 20'000;
        tick += Tick{count} * step;
        if (random() % 8 == 0)
            tick += static_cast<Tick>(random() % 100'000);
        all.push_back(std::move(block));
    }
    return all;
}

Overview overviewOf(const capture::StreamLayout &layout,
    const std::vector<capture::SampleBlock> &blocks, std::size_t most = kPlenty)
{
    OverviewMaker maker;
    maker.begin(layout);
    for (const auto &block : blocks)
        maker.add(block);
    auto all = maker.take(most);
    return all.size() == 1 ? all.front() : Overview{};
}

} // namespace

void TestRecordOverview::everySampleIsInItsStretch_data()
{
    QTest::addColumn<int>("blocks");
    QTest::addColumn<int>("step");
    QTest::newRow("few") << 1 << 1;
    QTest::newRow("some") << 30 << 1;
    QTest::newRow("many") << 3000 << 1;
    QTest::newRow("every third tick") << 800 << 3;
}

void TestRecordOverview::everySampleIsInItsStretch()
{
    QFETCH(int, blocks);
    QFETCH(int, step);
    const auto all = blocksOf(3, std::size_t(blocks), std::uint32_t(step), 5);
    const Overview overview = overviewOf(layoutOf(3, std::uint32_t(step)), all);
    QVERIFY(overview.bins() > 0 && overview.bins() <= 8192);
    std::vector<std::vector<CodeRange>> plain(
        3, std::vector<CodeRange>(overview.bins(), CodeRange::nothing()));
    for (const auto &block : all) {
        for (std::size_t s = 0; s < 3; ++s) {
            for (std::uint32_t i = 0; i < block.count; ++i) {
                const Tick tick = block.firstTick + Tick{i} * step - overview.first;
                const std::int16_t code = block.fast[s * block.count + i];
                plain[s].at(std::size_t(tick / overview.binTicks)).include({code, code});
            }
        }
    }
    for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t bin = 0; bin < overview.bins(); ++bin) {
            QCOMPARE(overview.columns[s][bin].min, plain[s][bin].min);
            QCOMPARE(overview.columns[s][bin].max, plain[s][bin].max);
        }
    }
}

void TestRecordOverview::itKeepsToItsShare()
{
    const auto blocks = blocksOf(4, 500, 1, 6);
    for (const std::size_t most : {1'000'000U, 50'000U, 20'000U, 9'000U}) {
        const Overview overview = overviewOf(layoutOf(4), blocks, most);
        QVERIFY(overview.bins() > 0);
        QVERIFY(overview.bins() * 4 * sizeof(CodeRange) <= most);
    }
    QCOMPARE(overviewOf(layoutOf(4), blocks, 1'000).bins(), std::size_t(0)); // no picture
    // However many signals: one block holds it.
    const Overview wide = overviewOf(layoutOf(1000), blocksOf(1000, 40, 1, 7));
    QVERIFY(wide.bins() > 0);
    QVERIFY(encodeOverview(wide).has_value());
}

void TestRecordOverview::eachLayoutHasItsOwn()
{
    OverviewMaker maker;
    const auto blocks = blocksOf(2, 3, 1, 8);
    maker.add(blocks[0]); // of no layout
    maker.begin(layoutOf(2));
    maker.begin(layoutOf(2)); // the one before has nothing
    maker.add(blocks[0]);
    maker.begin({});
    maker.begin(layoutOf(2));
    maker.add(blocks[1]);
    maker.begin(layoutOf(3));
    const auto all = maker.take(kPlenty);
    QCOMPARE(all.size(), std::size_t(2));
    QCOMPARE(all[1].first, blocks[1].firstTick);
    QVERIFY(maker.take(kPlenty).empty());
}

void TestRecordOverview::aClockThatRunsBackIsNoPartOfIt()
{
    auto blocks = blocksOf(1, 4, 1, 9);
    const std::size_t bins = overviewOf(layoutOf(1), blocks).bins();
    capture::SampleBlock odd = blocks[0];
    odd.firstTick = -5000;
    blocks.push_back(odd);
    odd.firstTick = std::numeric_limits<Tick>::max() - 10'000;
    blocks.push_back(odd);
    odd.stream = 9;
    odd.firstTick = 2000;
    blocks.push_back(odd);
    odd.stream = 1;
    odd.fast.pop_back();
    blocks.push_back(odd);
    QCOMPARE(overviewOf(layoutOf(1), blocks).bins(), bins);
}

void TestRecordOverview::itIsReadBackAsItWasWritten()
{
    const Overview overview = overviewOf(layoutOf(3), blocksOf(3, 100, 1, 10));
    const auto read = decodeOverview(*encodeOverview(overview));
    QVERIFY(read.has_value());
    QVERIFY(read->layout == overview.layout);
    QCOMPARE(read->first, overview.first);
    QCOMPARE(read->binTicks, overview.binTicks);
    QCOMPARE(read->bins(), overview.bins());
    for (std::size_t s = 0; s < 3; ++s)
        for (std::size_t bin = 0; bin < overview.bins(); ++bin)
            QVERIFY(read->columns[s][bin].min == overview.columns[s][bin].min
                && read->columns[s][bin].max == overview.columns[s][bin].max);
}

void TestRecordOverview::whatIsNoneIsNotTakenForOne()
{
    const Overview overview = overviewOf(layoutOf(1), blocksOf(1, 1, 1, 11));
    const Bytes good = *encodeOverview(overview);
    for (std::size_t size = 0; size < good.size(); ++size)
        QVERIFY(!decodeOverview(ByteView(good).first(size)));
    QCOMPARE(
        int(decodeOverview(*encodeEntry(Note{0, 1, "x"})).error()), int(PayloadError::UnknownKind));
    std::mt19937 random(12);
    for (int i = 0; i < 20'000; ++i) { // whatever it is, it can be shown
        Bytes bad = good;
        for (std::uint64_t n = 1 + random() % 4; n > 0; --n)
            bad[random() % std::min<std::size_t>(bad.size(), 120)] =
                static_cast<std::uint8_t>(random());
        if (const auto read = decodeOverview(bad)) {
            capture::Capture capture;
            restore(*read, capture);
            if (const auto span = capture.timeSpan())
                QVERIFY(span->to >= span->from);
        }
    }
}

void TestRecordOverview::itsPictureHasThePeaksOfTheSamples()
{
    const auto blocks = blocksOf(2, 2000, 1, 13);
    capture::Capture samples;
    samples.begin(layoutOf(2));
    for (const auto &block : blocks)
        samples.append(block);
    capture::Capture shown;
    restore(overviewOf(layoutOf(2), blocks), shown);
    QVERIFY(shown.size(1) <= std::size_t{2} * 8192);
    constexpr std::size_t kColumns = 1500;
    const auto span = *samples.timeSpan();
    for (const capture::ChannelId id : {1U, 2U}) {
        const auto wanted = samples.columns(id, span.from, span.to, kColumns);
        const auto found = shown.columns(id, span.from, span.to, kColumns);
        for (std::size_t i = 1; i + 1 < kColumns; ++i) {
            if (wanted[i].empty())
                continue;
            capture::MinMax near = found[i - 1];
            near.include(found[i]);
            near.include(found[i + 1]);
            QVERIFY(near.max >= wanted[i].max && near.min <= wanted[i].min);
        }
        QVERIFY(shown.info(id)->name.find("overview") != std::string::npos);
    }
}

void TestRecordOverview::aReaderThatDoesNotKnowItPassesOverIt()
{
    Encoder encoder({0, "test", "here"});
    Bytes file = encoder.head().bytes;
    encoder.add(0, layoutOf(2));
    std::uint64_t samples = 0;
    for (const auto &block : blocksOf(2, 300, 1, 14)) {
        samples += block.fast.size();
        encoder.add(0, block);
    }
    encoder.flushAll();
    const auto put = [&] {
        std::size_t size = 0;
        for (const Block &block : encoder.takeBlocks()) {
            file.insert(file.end(), block.bytes.begin(), block.bytes.end());
            size += block.bytes.size();
        }
        return size;
    };
    put();
    encoder.addOverview(1);
    const std::size_t size = put();
    QVERIFY(size > 1000);
    QVERIFY(double(size) <= 0.015 * double(file.size()));
    encoder.end(1, {});
    put();
    Decoder decoder;
    decoder.feed(file);
    decoder.finish();
    std::uint64_t found = 0;
    while (const auto step = decoder.next()) {
        const auto *item = std::get_if<Item>(&*step);
        QVERIFY(item); // no damage
        if (const auto *block = std::get_if<capture::SampleBlock>(&item->entry))
            found += block->fast.size();
    }
    QCOMPARE(found, samples);
    QCOMPARE(decoder.ending()->samples, samples);
}

QTEST_APPLESS_MAIN(TestRecordOverview)
#include "tst_record_overview.moc"

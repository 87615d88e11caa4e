// A recording, whole and damaged: what is sound is read, what is missing is told, nothing is made up.
#include "recorded/decoder.h"
#include "recorded/encoder.h"
#include "recorded/restore.h"

#include <QtTest>

#include <map>
#include <random>
#include <set>

using namespace recorded;

class TestRecordDecoder : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatWasRecordedIsRead();
    void itReadsTheSameHoweverItIsFed();
    void samplesBecomeColumnsWithoutAWordAboutGapsLost();
    void aCutAnywhereKeepsAllWholeBlocks();
    void aFlippedByteAnywhereCostsItsBlockOnly();
    void bytesTakenOutOrPutInCostTheirBlocksOnly();
    void aBlockThatIsMissingIsTold();
    void samplesBehindALostLayoutWaitForTheNextOne();
    void aLostLayoutWhoseIdWasUsedBeforeIsNews();
    void valuesBehindALostRegisterWaitForTheNextOne();
    void aRecordingWithoutAnEndWasInterrupted();
    void theEndFitsThePlaceThatWasKeptForIt();
    void otherFilesAreNoRecordings();
    void atMost2Point1BytesASample();
};

namespace {

/// What a reader made of a file.
struct Read {
    std::vector<Item> items;
    std::vector<Damage> damage;
    std::optional<End> ending;
    bool recording = false;
};

Read read(ByteView file, std::size_t piece = 1 << 20)
{
    Decoder decoder;
    Read result;
    const auto drain = [&] {
        while (auto step = decoder.next()) {
            if (auto *item = std::get_if<Item>(&*step))
                result.items.push_back(std::move(*item));
            else
                result.damage.push_back(std::get<Damage>(*step));
        }
    };
    for (std::size_t at = 0; at < file.size(); at += piece) {
        decoder.feed(file.subspan(at, std::min(piece, file.size() - at)));
        drain();
    }
    decoder.finish();
    drain();
    result.ending = decoder.ending();
    result.recording = decoder.isRecording();
    return result;
}

capture::StreamLayout layout(capture::StreamId id = 1)
{
    return {id, 16000.0, 0.5, 1, {{1, "A", "A", 0.1, 0.0}, {2, "B", "V", 0.5, 0.0}},
        {{3, "S", "rpm", 6.0, 0.0}}};
}

capture::SampleBlock block(capture::Tick tick, std::uint32_t count, capture::StreamId id = 1)
{
    capture::SampleBlock result{id, tick, count, {}, {{tick + count - 1, {int(tick)}}}, 0};
    for (std::uint32_t i = 0; i < 2 * count; ++i)
        result.fast.push_back(static_cast<std::int16_t>(tick + capture::Tick{7} * i));
    return result;
}

/// A file and where its blocks begin.
struct File {
    Bytes bytes;
    std::vector<std::size_t> starts;

    void put(const Block &block)
    {
        starts.push_back(bytes.size());
        bytes.insert(bytes.end(), block.bytes.begin(), block.bytes.end());
    }
    void put(Encoder &encoder)
    {
        for (const Block &block : encoder.takeBlocks())
            put(block);
    }
    std::size_t end(std::size_t i) const
    {
        return i + 1 < starts.size() ? starts[i + 1] : bytes.size();
    }
};

Encoder::Config small() { return {.blockBytes = 200, .linkBytes = 64, .repeatBytes = 600}; }

/// A little of everything, in a few dozen short blocks.
File recordedFile()
{
    Encoder encoder({1'700'000'000, "test", "sim"}, small());
    File file;
    file.put(encoder.head());
    encoder.add(0, layout());
    for (Nanos i = 0; i < 12; ++i) {
        encoder.add(i * 1000, block(i * 40, 40));
        encoder.add(i * 1000 + 1,
            LinkBytes{i % 2 == 0 ? LinkBytes::Direction::Received : LinkBytes::Direction::Sent,
                Bytes(50, static_cast<std::uint8_t>(i))});
        if (i == 3)
            encoder.add(4000, PolledRegister{9, "U", "V"});
        if (i > 3)
            encoder.add(i * 1000 + 2, PolledValues{{{9, i * 1'000'000, double(i) * 0.1}}});
        encoder.add(i * 1000 + 3, Happening{"state", {{"n", std::to_string(i)}}});
    }
    encoder.end(20'000, {});
    file.put(encoder);
    return file;
}

/// Items by the place of their block, as text that can be compared.
std::map<std::uint64_t, std::size_t> kinds(const Read &read)
{
    std::map<std::uint64_t, std::size_t> result;
    for (const Item &item : read.items)
        result[item.offset] = item.entry.index();
    return result;
}

} // namespace

void TestRecordDecoder::whatWasRecordedIsRead()
{
    const Read result = read(recordedFile().bytes);
    QVERIFY(result.recording);
    QVERIFY(result.damage.empty());
    QVERIFY(result.ending.has_value());
    QCOMPARE(result.ending->reason, End::Reason::Stopped);
    capture::Capture capture;
    Restorer restorer(capture);
    Bytes received;
    int happenings = 0;
    for (const Item &item : result.items) {
        restorer.accept(item.entry);
        happenings += std::holds_alternative<Happening>(item.entry);
        const auto *link = std::get_if<LinkBytes>(&item.entry);
        if (link && link->direction == LinkBytes::Direction::Received)
            received.insert(received.end(), link->bytes.begin(), link->bytes.end());
    }
    QCOMPARE(happenings, 12);
    QCOMPARE(received.size(), std::size_t(300));
    QCOMPARE(received[299], std::uint8_t(10));
    QCOMPARE(capture.channels().size(), std::size_t(4));
    const auto fast = *capture.find(2);
    QCOMPARE(capture.size(fast), 480U);
    QCOMPARE(capture.channel(fast)->fast()->segments().size(), std::size_t(1));
    QCOMPARE(capture.channel(fast)->fast()->at(45), std::int16_t(40 + 7 * (40 + 5)));
    QCOMPARE(capture.size(*capture.find(3)), 12U);
    QCOMPARE(capture.lastValue(*capture.find(9)), std::optional(11 * 0.1));
    QCOMPARE(capture.info(*capture.find(9))->name, std::string("U"));
    QCOMPARE(result.ending->samples, 480U * 2 + 12U);
    QCOMPARE(
        capture.refused().otherStream + capture.refused().malformed + capture.refused().backwards,
        0U);
}

void TestRecordDecoder::itReadsTheSameHoweverItIsFed()
{
    const File file = recordedFile();
    const auto whole = kinds(read(file.bytes));
    for (const std::size_t piece : {1U, 3U, 17U, 64U, 1000U}) {
        const Read result = read(file.bytes, piece);
        QCOMPARE(kinds(result), whole);
        QVERIFY(result.damage.empty());
    }
}

/// Packets of samples are put together; a gap between them stays one.
void TestRecordDecoder::samplesBecomeColumnsWithoutAWordAboutGapsLost()
{
    Encoder encoder({0, "test", ""});
    File file;
    file.put(encoder.head());
    encoder.add(0, layout());
    for (const capture::Tick tick : {0, 100, 200, 350, 450}) {
        capture::SampleBlock one = block(tick, 100);
        one.lostTicks = tick == 350 ? 50 : 0;
        encoder.add(tick, std::move(one));
    }
    encoder.end(1000, {});
    file.put(encoder);
    const Read result = read(file.bytes);
    std::vector<std::pair<capture::Tick, std::uint32_t>> blocks;
    for (const Item &item : result.items) {
        if (const auto *one = std::get_if<capture::SampleBlock>(&item.entry))
            blocks.emplace_back(one->firstTick, one->count);
    }
    const decltype(blocks) expected{{0, 300}, {350, 200}};
    QCOMPARE(blocks, expected);
}

void TestRecordDecoder::aCutAnywhereKeepsAllWholeBlocks()
{
    const File file = recordedFile();
    const auto whole = kinds(read(file.bytes));
    for (std::size_t length = 0; length < file.bytes.size(); ++length) {
        const Read result = read(ByteView(file.bytes).first(length));
        auto expected = whole;
        std::erase_if(expected, [&](const auto &item) {
            const auto at = std::find(file.starts.begin(), file.starts.end(), item.first);
            // The first block holds the file's head and two entries behind it.
            const std::size_t end = at == file.starts.end()
                ? file.end(0)
                : file.end(static_cast<std::size_t>(at - file.starts.begin()));
            return end > length;
        });
        QCOMPARE(kinds(result), expected);
        QVERIFY(!result.ending);
        const bool clean = length == 0
            || std::find(file.starts.begin(), file.starts.end(), length) != file.starts.end();
        if (length >= file.end(0)) {
            QCOMPARE(result.damage.empty(), clean);
            if (!clean) {
                QCOMPARE(result.damage[0].kind, Damage::Kind::CutShort);
                QCOMPARE(result.damage[0].offset + result.damage[0].bytes, length);
            }
        }
    }
}

void TestRecordDecoder::aFlippedByteAnywhereCostsItsBlockOnly()
{
    const File file = recordedFile();
    const auto whole = kinds(read(file.bytes));
    for (std::size_t at = 0; at < file.bytes.size(); ++at) {
        Bytes damaged = file.bytes;
        damaged[at] ^= 0x5A;
        const Read result = read(damaged);
        const auto there = kinds(result);
        const auto next = std::upper_bound(file.starts.begin(), file.starts.end(), at);
        const std::size_t start = *std::prev(next);
        const bool head = start == 0;
        for (const auto &[offset, kind] : whole) {
            // Samples whose layout was hit are no use until it is repeated.
            const bool mine = head ? offset < file.end(0) : offset == start;
            if (!mine && !(start == file.starts[1] && kind == 3))
                QVERIFY2(there.contains(offset) && there.at(offset) == kind,
                    qPrintable(QStringLiteral("byte %1, block %2")
                                   .arg(QString::number(at), QString::number(offset))));
        }
        for (const auto &[offset, kind] : there)
            QVERIFY(whole.contains(offset)
                || std::find(file.starts.begin(), file.starts.end(), offset) != file.starts.end());
        if (!head && !there.contains(start) && whole.contains(start)) {
            QVERIFY(!result.damage.empty());
            QCOMPARE(result.damage[0].offset, start);
            QCOMPARE(result.damage[0].bytes,
                file.bytes.size() == start + result.damage[0].bytes ? result.damage[0].bytes
                                                                    : *next - start);
        }
    }
}

void TestRecordDecoder::bytesTakenOutOrPutInCostTheirBlocksOnly()
{
    const File file = recordedFile();
    std::mt19937 random(5);
    for (int round = 0; round < 500; ++round) {
        const std::size_t from = file.end(0) + random() % (file.bytes.size() - file.end(0));
        const std::size_t length = std::min<std::size_t>(random() % 900, file.bytes.size() - from);
        const bool out = random() % 2 == 0;
        Bytes damaged = file.bytes;
        const auto at = damaged.begin() + static_cast<std::ptrdiff_t>(from);
        if (out)
            damaged.erase(at, at + static_cast<std::ptrdiff_t>(length));
        else
            damaged.insert(at, length, static_cast<std::uint8_t>(random() % 8));
        const Read result = read(damaged);
        std::multiset<std::pair<Nanos, std::size_t>> there;
        for (const Item &item : result.items)
            there.emplace(item.at, item.entry.index());
        const Read whole = read(file.bytes);
        std::size_t missing = 0;
        for (const Item &item : whole.items) {
            const auto start = static_cast<std::size_t>(item.offset);
            const auto next = std::upper_bound(file.starts.begin(), file.starts.end(), start);
            const std::size_t end = next == file.starts.end() ? file.bytes.size() : *next;
            const bool touched =
                out ? start < from + length && end > from : start < from && end > from;
            const auto found = there.find({item.at, item.entry.index()});
            if (found == there.end()) {
                ++missing;
                QVERIFY(touched || item.entry.index() == 3); // a layout may be what was touched
            }
        }
        QVERIFY(missing == 0 || !result.damage.empty());
    }
}

void TestRecordDecoder::aBlockThatIsMissingIsTold()
{
    const File file = recordedFile();
    Bytes shorter = file.bytes;
    const std::size_t i = 5;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(file.starts[i]),
        shorter.begin() + static_cast<std::ptrdiff_t>(file.starts[i + 2]));
    const Read result = read(shorter);
    QCOMPARE(result.damage.size(), std::size_t(1));
    const Damage expected{Damage::Kind::Missing, file.starts[i], 0, 2};
    QCOMPARE(result.damage[0], expected);
}

void TestRecordDecoder::samplesBehindALostLayoutWaitForTheNextOne()
{
    const File file = recordedFile();
    Bytes damaged = file.bytes;
    damaged[file.starts[1] + 40] ^= 1; // within the layout
    const Read result = read(damaged);
    QCOMPARE(result.damage[0].kind, Damage::Kind::Unreadable);
    QCOMPARE(result.damage[1].kind, Damage::Kind::Undescribed);
    capture::Capture capture;
    Restorer restorer(capture);
    for (const Item &item : result.items)
        restorer.accept(item.entry);
    const std::uint64_t kept = capture.size(*capture.find(1));
    QVERIFY(kept > 240 && kept < 480);
}

/// As of a drive whose registers are all read in turn: no block of samples is ever written.
/// The board's count begins anew: same id, other origin.
void TestRecordDecoder::aLostLayoutWhoseIdWasUsedBeforeIsNews()
{
    Encoder encoder({1'700'000'000, "test", "sim"}, small());
    File file;
    file.put(encoder.head());
    encoder.add(0, layout());
    for (Nanos i = 0; i < 4; ++i)
        encoder.add(i * 1000, block(i * 40, 40));
    file.put(encoder);
    capture::StreamLayout later = layout();
    later.originSeconds = 10.0;
    encoder.add(5000, later);
    file.put(encoder);
    const std::size_t lost = file.starts.back();
    for (Nanos i = 0; i < 12; ++i)
        encoder.add(6000 + i * 1000, block(i * 40, 40));
    encoder.end(20'000, {});
    file.put(encoder);
    file.bytes[lost + 40] ^= 1;
    capture::Capture capture;
    Restorer restorer(capture);
    for (const Item &item : read(file.bytes).items)
        restorer.accept(item.entry);
    QVERIFY(capture.timeSpan()->to > 10.0);
}

void TestRecordDecoder::valuesBehindALostRegisterWaitForTheNextOne()
{
    Encoder encoder({0, "test", ""}, small());
    File file;
    file.put(encoder.head());
    encoder.add(0, PolledRegister{9, "U", "V"});
    for (Nanos i = 1; i <= 100; ++i)
        encoder.add(i, PolledValues{{{9, i * 1'000'000, double(i)}}});
    encoder.end(200, {});
    file.put(encoder);
    const auto restored = [](const Read &read) {
        capture::Capture capture;
        Restorer restorer(capture);
        for (const Item &item : read.items)
            restorer.accept(item.entry);
        return capture;
    };
    const Read whole = read(file.bytes);
    QVERIFY(whole.damage.empty());
    QCOMPARE(restored(whole).size(*restored(whole).find(9)), 100U);
    file.bytes[file.starts[1] + 40] ^= 1; // within the register's name
    const Read result = read(file.bytes);
    QCOMPARE(result.damage.size(), std::size_t(2));
    QCOMPARE(result.damage[0].kind, Damage::Kind::Unreadable);
    QCOMPARE(result.damage[1].kind, Damage::Kind::Undescribed);
    const capture::Capture kept = restored(result);
    QVERIFY(kept.find(9));
    QVERIFY(kept.size(*kept.find(9)) > 50 && kept.size(*kept.find(9)) < 100);
    QCOMPARE(kept.lastValue(*kept.find(9)), std::optional(100.0));
    QCOMPARE(kept.info(*kept.find(9))->name, std::string("U"));
}

void TestRecordDecoder::aRecordingWithoutAnEndWasInterrupted()
{
    const File file = recordedFile();
    const Read result = read(ByteView(file.bytes).first(file.starts.back()));
    QVERIFY(result.damage.empty());
    QVERIFY(!result.ending);
}

void TestRecordDecoder::theEndFitsThePlaceThatWasKeptForIt()
{
    Encoder encoder({0, "test", ""}, small());
    File file;
    file.put(encoder.head());
    encoder.add(0, layout());
    encoder.add(0, block(0, 100));
    encoder.flushAll();
    file.put(encoder);
    const auto end = encoder.endInReserve(5, {End::Reason::DiskFull, std::string(1000, 'x'), 0, 0});
    QVERIFY(end.offset + end.bytes.size() <= file.end(0));
    std::copy(end.bytes.begin(), end.bytes.end(),
        file.bytes.begin() + static_cast<std::ptrdiff_t>(end.offset));
    const Read result = read(file.bytes);
    QVERIFY(result.damage.empty());
    QCOMPARE(result.ending->reason, End::Reason::DiskFull);
    QCOMPARE(result.ending->samples, 201U);
    QCOMPARE(result.ending->text, std::string(200, 'x'));
}

void TestRecordDecoder::otherFilesAreNoRecordings()
{
    std::mt19937 random(1);
    Bytes noise(100'000);
    for (std::uint8_t &byte : noise)
        byte = static_cast<std::uint8_t>(random() % 12); // many a 6 to begin with
    QVERIFY(!read(noise).recording);
    QVERIFY(read(noise).items.empty());
    QVERIFY(!read({}).recording);
    const File file = recordedFile();
    const Read headOnly = read(ByteView(file.bytes).first(100)); // the section, as any pcapng has
    QVERIFY(!headOnly.recording);
}

/// Goal P12, with the packets of a link that carries eight signals at 20 kHz.
void TestRecordDecoder::atMost2Point1BytesASample()
{
    Encoder encoder({0, "test", ""});
    capture::StreamLayout wide = layout();
    wide.slow.clear();
    wide.fast.resize(8, wide.fast[0]);
    std::size_t bytes = encoder.head().bytes.size();
    encoder.add(0, wide);
    std::uint64_t samples = 0;
    Nanos now = 0;
    for (capture::Tick tick = 0; tick < 400'000; tick += 128) {
        now = tick * 50'000;
        encoder.add(
            now, capture::SampleBlock{1, tick, 128, std::vector<std::int16_t>(1024, 5), {}, 0});
        encoder.flush(now);
        for (const Block &one : encoder.takeBlocks()) {
            bytes += one.bytes.size();
            samples += one.samples;
        }
    }
    QVERIFY(samples > 3'000'000);
    QVERIFY2(double(bytes) / double(samples) <= 2.01, "more bytes a sample than two and a little");
}

QTEST_APPLESS_MAIN(TestRecordDecoder)
#include "tst_record_decoder.moc"

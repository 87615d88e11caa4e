// The WAV file, byte by byte against RIFF: every code is in it, gaps are marked and never filled.
#include "base/bytes.h"
#include "capture/wav_export.h"
#include "support/channels/every_channel.h"

#include <QtTest>

#include <map>

using namespace capture;

class TestWavExport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyCodeIsInItsPlace();
    void gapsAreCuePointsAndNothingIsFilledIn();
    void theLongestFileHasRoomForAllItsGaps();
    void onlyInstantsThatAllSignalsHaveAreWritten();
    void aRangeIsExact();
    void onlyRatesInTheRangeCount();
    void whatCannotBeAWavFileIsNamed();
};

namespace {

struct Wav {
    std::vector<std::vector<std::int16_t>> channels;
    std::uint32_t rate = 0;
    std::map<std::string, Bytes> chunks;
};

/// A reader of its own, after the description of RIFF.
Wav parse(const std::string &file)
{
    Wav wav;
    const Bytes bytes(file.begin(), file.end());
    ByteReader in(bytes);
    const auto name = [&in] {
        const ByteView four = in.take(4);
        return std::string(four.begin(), four.end());
    };
    if (name() != "RIFF" || in.u32() != file.size() - 8 || name() != "WAVE")
        return {};
    while (in.left() > 0 && in.ok()) {
        const std::string id = name();
        const std::uint32_t size = in.u32();
        const ByteView content = in.take(size);
        in.take(size % 2);
        wav.chunks[id] = Bytes(content.begin(), content.end());
    }
    if (!in.ok())
        return {};
    ByteReader format(wav.chunks["fmt "]);
    const bool pcm = format.u16() == 1;
    wav.channels.resize(format.u16());
    wav.rate = format.u32();
    const std::uint32_t bytesASecond = format.u32();
    const std::uint16_t frame = format.u16();
    if (!pcm || format.u16() != 16 || frame != 2 * wav.channels.size()
        || bytesASecond != wav.rate * frame)
        return {};
    ByteReader data(wav.chunks["data"]);
    while (data.left() > 0) {
        for (auto &channel : wav.channels)
            channel.push_back(data.s16());
    }
    return wav;
}

std::string write(WavWriter &writer)
{
    std::string file;
    std::string_view piece;
    while (writer.next(piece))
        file += piece;
    return file;
}

std::int16_t code(int signal, Tick tick)
{
    return static_cast<std::int16_t>(tick * 13 + std::int64_t(signal) * 7001);
}

void append(Capture &capture, StreamId stream, Tick tick, int count, Tick lost = 0)
{
    SampleBlock block{stream, tick, static_cast<std::uint32_t>(count), {}, {}, lost};
    for (int signal = 0; signal < 2; ++signal) {
        for (Tick i = 0; i < count; ++i)
            block.fast.push_back(code(signal, tick + i));
    }
    capture.append(block);
}

StreamLayout wavLayout(StreamId id = 1)
{
    return {id, 16000.0, 0.5, 1, {{1, "A", "A", 0.1, 0.0}, {2, "B", "V", 0.25, 32768.0}}, {}};
}

} // namespace

void TestWavExport::everyCodeIsInItsPlace()
{
    Capture capture;
    capture.begin(wavLayout());
    constexpr int kCount = 150'001; // more than a chunk of the store and a piece of the file
    for (Tick tick = 0; tick < kCount; tick += 1000)
        append(capture, 1, tick, int(std::min<Tick>(1000, kCount - tick)));
    capture.appendPolled(9, "U", "V", 0.6, 1.0); // not fast: left out
    WavWriter writer(support::everyChannel(capture));
    QCOMPARE(writer.problem(), ExportProblem::None);
    const Wav wav = parse(write(writer));
    QCOMPARE(wav.rate, 16000U);
    QCOMPARE(wav.channels.size(), std::size_t(2));
    for (int signal = 0; signal < 2; ++signal) {
        const auto &channel = wav.channels[std::size_t(signal)];
        QCOMPARE(channel.size(), std::size_t(kCount));
        for (Tick tick = 0; tick < kCount; ++tick)
            QCOMPARE(channel[std::size_t(tick)], code(signal, tick));
    }
    QCOMPARE(writer.frames(), std::uint64_t(kCount));
    QCOMPARE(writer.progress(), 1.0);
    const Bytes &info = wav.chunks.at("LIST");
    const std::string text(info.begin(), info.end());
    QVERIFY(text.find("A [A] = (code + 0) x 0.1; B [V] = (code + 32768) x 0.25") != text.npos);
    QVERIFY(!wav.chunks.contains("cue "));
}

void TestWavExport::gapsAreCuePointsAndNothingIsFilledIn()
{
    Capture capture;
    capture.begin(wavLayout());
    append(capture, 1, 0, 100);
    append(capture, 1, 1700, 100, 1600);
    append(capture, 1, 1800, 50);
    WavWriter writer(support::everyChannel(capture));
    QCOMPARE(writer.gaps(), std::size_t(1));
    const Wav wav = parse(write(writer));
    QCOMPARE(wav.channels.at(0).size(), std::size_t(250));
    QCOMPARE(wav.channels[0][99], code(0, 99));
    QCOMPARE(wav.channels[0][100], code(0, 1700));
    ByteReader cue(wav.chunks.at("cue "));
    QCOMPARE(cue.u32(), 1U);
    QCOMPARE(cue.u32(), 1U); // its name
    QCOMPARE(cue.u32(), 100U); // the frame behind the gap
}

void TestWavExport::theLongestFileHasRoomForAllItsGaps()
{
    Capture capture;
    capture.begin(wavLayout());
    for (Tick tick = 0; tick < 12'000 * Tick{1'234'567}; tick += 1'234'567)
        append(capture, 1, tick, 2, 1'234'565);
    WavWriter writer(support::everyChannel(capture));
    QCOMPARE(writer.gaps(), std::size_t(10'000)); // more are not marked
    const std::string file = write(writer);
    const Wav wav = parse(file);
    QCOMPARE(wav.channels.at(0).size(), std::size_t(24'000));
    const std::size_t rest = file.size() - wav.chunks.at("data").size();
    QVERIFY(WavWriter::kMostDataBytes + rest <= 0xFFFFFFFFU);
}

/// Signals of two streams that overlap in time are not there together; those of one with different beginnings are.
void TestWavExport::onlyInstantsThatAllSignalsHaveAreWritten()
{
    Capture capture;
    StreamLayout one = wavLayout(1);
    one.fast.pop_back();
    capture.begin(one);
    capture.append({1, 0, 3, {1, 2, 3}, {}, 0});
    capture.begin(wavLayout(2));
    append(capture, 2, 3, 10);
    WavWriter writer(support::everyChannel(capture));
    const Wav wav = parse(write(writer));
    QCOMPARE(wav.channels.size(), std::size_t(2));
    QCOMPARE(wav.channels[0].size(), std::size_t(10));
    QCOMPARE(wav.channels[0][0], code(0, 3));
}

void TestWavExport::aRangeIsExact()
{
    Capture capture;
    capture.begin(wavLayout());
    append(capture, 1, 0, 1000);
    WavWriter writer(
        support::everyChannel(capture), TimeSpan{0.5 + 160 / 16000.0, 0.5 + 320 / 16000.0});
    const Wav wav = parse(write(writer));
    QCOMPARE(wav.channels.at(1).size(), std::size_t(160));
    QCOMPARE(wav.channels[1].front(), code(1, 160));
    QCOMPARE(wav.channels[1].back(), code(1, 319));
    // From sample to sample, wherever the time in seconds lies as a floating-point number.
    const Snapshot channels = support::everyChannel(capture);
    for (Index first = 0; first + 10 < 1000; ++first) {
        const Channel &channel = channels->front();
        const TimeSpan ten{toSeconds(channel.timeOf(first)), toSeconds(channel.timeOf(first + 10))};
        WavWriter some(channels, ten);
        QCOMPARE(some.frames(), 10U);
        QCOMPARE(parse(write(some)).channels.at(0).front(), code(0, Tick(first)));
    }
}

/// A stream went on with every second sample: each part is a file, both are none.
void TestWavExport::onlyRatesInTheRangeCount()
{
    Capture capture;
    capture.begin(wavLayout());
    append(capture, 1, 0, 160); // up to 0.51 s
    StreamLayout slower = wavLayout(2);
    slower.fastStep = 2;
    capture.begin(slower);
    append(capture, 2, 160, 80); // up to 0.52 s
    const Snapshot channels = support::everyChannel(capture);
    QCOMPARE(channels->size(), 2U);
    const WavWriter fast(channels, TimeSpan{0.0, 0.51});
    QCOMPARE(fast.problem(), ExportProblem::None);
    QCOMPARE(fast.rate(), 16000U);
    QCOMPARE(fast.frames(), 160U);
    const WavWriter slow(channels, TimeSpan{0.51, 1.0});
    QCOMPARE(slow.problem(), ExportProblem::None);
    QCOMPARE(slow.rate(), 8000U);
    QCOMPARE(slow.frames(), 80U);
    QCOMPARE(WavWriter(channels, TimeSpan{0.5, 0.5101}).problem(), ExportProblem::DifferentRates);
    QCOMPARE(WavWriter(channels).problem(), ExportProblem::DifferentRates);
    QCOMPARE(WavWriter(channels, TimeSpan{2.0, 3.0}).problem(), ExportProblem::NoFastSamples);
}

void TestWavExport::whatCannotBeAWavFileIsNamed()
{
    Capture none;
    none.appendPolled(9, "U", "V", 0.6, 1.0);
    QCOMPARE(WavWriter(support::everyChannel(none)).problem(), ExportProblem::NoFastSamples);
    Capture rates;
    rates.begin(wavLayout());
    append(rates, 1, 0, 10);
    StreamLayout slower = wavLayout(2);
    slower.fast = {{5, "C", "A", 1.0, 0.0}};
    slower.fastStep = 2;
    rates.begin(slower);
    rates.append({2, 20, 2, {1, 2}, {}, 0});
    QCOMPARE(WavWriter(support::everyChannel(rates)).problem(), ExportProblem::DifferentRates);
    WavWriter writer(support::everyChannel(rates));
    std::string_view piece;
    QVERIFY(!writer.next(piece));
}

QTEST_APPLESS_MAIN(TestWavExport)
#include "tst_wav_export.moc"

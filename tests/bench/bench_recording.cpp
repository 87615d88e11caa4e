// P12: what a recording costs, in time and bytes, and how fast it is read, with eight signals at 20 kHz.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "recorded/decoder.h"
#include "recorded/restore.h"
#include "session/recording/file.h"
#include "session/recording/reader.h"

#include <QFile>
#include <QTemporaryDir>

namespace {

using namespace bench;

constexpr double kSeconds = 60.0;
constexpr std::size_t kBatch = 128; ///< samples a packet, as a link brings them
constexpr auto kRows = static_cast<std::size_t>(kSeconds * kTickHz);

struct Minute {
    QTemporaryDir folder;
    std::vector<capture::SampleBlock> blocks;
    std::vector<Bytes> link; ///< the same as on the line, about
    int files = 0;

    Minute()
    {
        std::vector<std::vector<std::int16_t>> columns;
        for (int s = 0; s < kSignals; ++s)
            columns.push_back(motorSignal(s, kRows));
        for (std::size_t done = 0; done < kRows; done += kBatch) {
            const std::size_t count = std::min(kBatch, kRows - done);
            capture::SampleBlock block{
                1, static_cast<capture::Tick>(done), static_cast<std::uint32_t>(count), {}, {}, 0};
            for (const auto &signal : columns)
                block.fast.insert(block.fast.end(), signal.begin() + std::ptrdiff_t(done),
                    signal.begin() + std::ptrdiff_t(done + count));
            const auto *bytes = reinterpret_cast<const std::uint8_t *>(block.fast.data());
            link.emplace_back(bytes, bytes + block.fast.size() * 2);
            link.back().insert(link.back().end(), 12, 0); // header, timestamp, mark, checksum
            blocks.push_back(std::move(block));
        }
    }
    QString path() { return folder.filePath(QString::number(++files)); }

    /// A minute to a file, as the recorder's thread writes it. Returns the size of the file.
    std::uint64_t record(const QString &path, bool samples)
    {
        QString text;
        session::RecordingFile file(session::makeDiskSink(path, text), {0, "bench", ""});
        require(file.open(), "the recording was not opened");
        file.add(0, motorLayout());
        recorded::Nanos now = 0;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            now = static_cast<recorded::Nanos>(double(i * kBatch) / kTickHz * 1e9);
            if (samples)
                file.add(now, blocks[i]);
            else
                file.add(
                    now, recorded::LinkBytes{recorded::LinkBytes::Direction::Received, link[i]});
            file.flush(now);
        }
        require(file.end(), "the recording was not ended");
        return file.counts().bytes;
    }
};

Minute &minute()
{
    static Minute made;
    return made;
}

void recordingCosts(benchmark::State &state)
{
    Minute &m = minute();
    const double samples = double(kRows) * kSignals;
    std::uint64_t size = 0;
    const Pair pair = pairedRatio(
        state,
        [&] {
            QFile file(m.path());
            require(file.open(QIODevice::WriteOnly | QIODevice::Unbuffered), "no file");
            for (const Bytes &bytes : m.link)
                file.write(reinterpret_cast<const char *>(bytes.data()), qint64(bytes.size()));
            file.remove();
        },
        [&] {
            const QString path = m.path();
            size = m.record(path, true);
            QFile::remove(path);
        });
    report({"P12", "writing a recording of 8 signals at 20 kHz, without the program's thread",
        Measured::cost(pair), "appending the bytes of the line to a file"});
    report({"P12 bytes", "in the file, samples", double(size) / samples, "two bytes a sample"});
    const QString path = m.path();
    report({"P12 bytes", "in the file, bytes of the line", double(m.record(path, false)) / samples,
        "two bytes a sample"});
    QFile::remove(path);
}

void readingBack(benchmark::State &state)
{
    Minute &m = minute();
    const QString path = m.path();
    m.record(path, true);
    const auto read = [&] {
        capture::Capture capture;
        const auto report = session::readRecording(path, capture);
        require(report && report->samples == kRows * kSignals && report->damage.empty(),
            "the recording does not read back");
        require(capture.size(capture.streaming().front()) == kRows, "samples are missing");
    };
    const Pair pair = pairedRatio(
        state,
        [&] {
            QFile file(path);
            require(file.open(QIODevice::ReadOnly) && !file.readAll().isEmpty(), "no file");
        },
        read);
    report({"P12 opening", "opening a recording", kSeconds / pair.bSeconds, "real time"});
    report({"P12", "opening a recording", Measured::cost(pair), "reading the file into memory"});
}

} // namespace

BENCHMARK(recordingCosts)->Iterations(5)->UseManualTime();
BENCHMARK(readingBack)->Iterations(7)->UseManualTime();

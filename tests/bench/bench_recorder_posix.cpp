// N10: what the recorder's thread computes while four signals at 20 kHz, 160 kB/s, come to it as a session tells them,
// in real time. Linux only, by the scheduler's count; elsewhere the figure is left out.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "session/recording/recording.h"

#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QTemporaryDir>
#include <QTimer>

#include <optional>
#include <set>

namespace {

using namespace bench;

constexpr int kSignalCount = 4;
constexpr std::size_t kBatch = 128; ///< samples a packet
constexpr int kWarm_ms = 1500;
constexpr int kRun_ms = 10'000;

std::set<QString> threads()
{
    const QStringList names =
        QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    return {names.begin(), names.end()};
}

/// Seconds that a thread has computed.
std::optional<double> computed(const QString &thread)
{
    QFile file(QStringLiteral("/proc/self/task/%1/schedstat").arg(thread));
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    return file.readAll().split(' ').front().toDouble() * 1e-9;
}

void wait(int milliseconds)
{
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
}

void recorderThread(benchmark::State &state)
{
    const std::set<QString> before = threads();
    QTemporaryDir folder;
    const auto tap = std::make_shared<session::RecordingTap>();
    session::Recording recording(tap);
    QString recorder;
    for (const QString &thread : threads())
        if (!before.contains(thread))
            recorder = thread;
    if (recorder.isEmpty() || !computed(recorder)) {
        leaveOut("N10", "the system does not say what a thread computes");
        state.SkipWithError("no schedstat");
        return;
    }
    MotorStream stream;
    stream.layout.fast.resize(kSignalCount);
    capture::Capture unseen; // of the board, which has been told its layout
    stream.record(unseen, kBatch);
    QElapsedTimer clock;
    clock.start();
    const auto now = [&clock] { return TimePoint(std::chrono::nanoseconds(clock.nsecsElapsed())); };
    std::uint64_t told = 0;
    QTimer packets;
    QObject::connect(&packets, &QTimer::timeout, &packets, [&] {
        while (double(told) < double(clock.nsecsElapsed()) * 1e-9 * kTickHz) {
            tap->onEvent(stream.next(kBatch), now());
            told += kBatch;
        }
    });
    recording.start(folder.filePath(QStringLiteral("r.pcapng")),
        session::RecordingTap::Content::Samples, QStringLiteral("bench"), QString());
    session::RecordingResult result;
    QEventLoop ended;
    QObject::connect(&recording, &session::Recording::finished, &ended,
        [&](const session::RecordingResult &got) {
            result = got;
            ended.quit();
        });
    tap->onEvent(drive::StreamStarted{stream.layout}, now());
    packets.start(4);
    wait(kWarm_ms);
    double share = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        const double start = *computed(recorder);
        QElapsedTimer elapsed;
        elapsed.start();
        wait(kRun_ms);
        const double used = *computed(recorder) - start;
        share = used / (double(elapsed.nsecsElapsed()) * 1e-9) * 100.0;
        state.SetIterationTime(used);
    }
    packets.stop();
    recording.stop();
    ended.exec();
    require(result.complete
            && double(result.last.counts.samples)
                > 0.95 * kSignalCount * kTickHz * kRun_ms / 1000.0,
        "the recording is not complete");
    report({"N10 recorder", "the recorder's thread, 160 kB/s", share, "% of a core"});
}

} // namespace

BENCHMARK(recorderThread)->Iterations(1)->UseManualTime();

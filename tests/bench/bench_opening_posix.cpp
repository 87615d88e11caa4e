// N15: from the wish to open a long recording, of which nothing is in memory, to the painted window with all of it in
// the picture. The real window. A file of 1e9 samples; ROTORSCOPE_BENCH_SAMPLES=1e10 for a larger one, by hand.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "session/recording/file.h"
#include "support/window_rig.h"
#include "widgets/scope/view.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <fcntl.h>
#include <unistd.h>

#include <string>

namespace {

using namespace bench;

constexpr double kUsual = 1e9; ///< samples
/// Samples of a signal: a quarter of a second, as the recorder gathers them.
constexpr std::size_t kBatch = 5000;

/// A recording of so many samples of all signals together, which is on the disk and nowhere else.
class LongRecording {
public:
    explicit LongRecording(double samples)
        : path(m_folder.filePath(QStringLiteral("long.pcapng")))
        , seconds(samples / kSignals / kTickHz)
    {
        QString text;
        session::RecordingFile file(session::makeDiskSink(path, text), {0, "bench", ""});
        require(file.open(), "the recording was not opened");
        MotorStream stream;
        capture::Capture before;
        stream.record(before, MotorStream::kPeriod);
        file.add(0, stream.layout);
        const double end = double(stream.ticks()) + seconds * kTickHz;
        while (double(stream.ticks()) < end) {
            const auto now = recorded::Nanos(double(stream.ticks()) / kTickHz * 1e9);
            file.add(now, stream.next(kBatch));
            file.flush(now);
        }
        require(file.end(), "the recording was not ended");
    }

    /// The next reader gets it from the disk.
    void forget() const
    {
        QFile file(path);
        require(file.open(QIODevice::ReadWrite) && fsync(file.handle()) == 0
                && posix_fadvise(file.handle(), 0, 0, POSIX_FADV_DONTNEED) == 0,
            "the recording stays in memory");
    }

private:
    QTemporaryDir m_folder;

public:
    const QString path;
    const double seconds;
};

void firstPicture(benchmark::State &state)
{
    const QByteArray wanted = qgetenv("ROTORSCOPE_BENCH_SAMPLES");
    const double samples = wanted.isEmpty() ? kUsual : wanted.toDouble();
    const LongRecording recording(samples);
    std::vector<double> seconds;
    double memory = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        facts::WindowRig rig;
        rig.window.resize(1920, 1080);
        const widgets::ScopeView &scope = *rig.window.scope();
        recording.forget();
        QCoreApplication::processEvents();
        const double before = residentBytes();
        QElapsedTimer clock;
        clock.start();
        rig.window.openFile(recording.path);
        const auto whole = [&] {
            return scope.channels().size() == kSignals
                && scope.visibleRange().span() > 0.99 * recording.seconds;
        };
        quint64 drawn = scope.redraws();
        while (!whole() || scope.redraws() == drawn) {
            if (!whole())
                drawn = scope.redraws();
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            require(clock.elapsed() < 60'000, "no picture after a minute");
        }
        seconds.push_back(double(clock.nsecsElapsed()) * 1e-9);
        memory = std::max(memory, residentBytes() - before);
        state.SetIterationTime(seconds.back());
    }
    if (wanted.isEmpty())
        leaveOut("N15 1e10", "20 GB are written by hand only: ROTORSCOPE_BENCH_SAMPLES=1e10");
    const std::string what =
        " of a recording of " + std::to_string(samples / 1e9) + "e9 samples, cold";
    const std::string goal = samples > 5e9 ? "N15 1e10" : "N15 1e9";
    report({goal, "first picture" + what, Measured(seconds), "the clock"});
    report({"N15 memory", "until the first picture" + what, memory / 1e6, "the program before"});
}

} // namespace

BENCHMARK(firstPicture)->Iterations(3)->UseManualTime();

// P4: a frame while samples stream: 333 samples of each of eight signals are appended, the picture moves on by them and
// is drawn anew. Against QCPGraph with the same samples and window, and against our own short window.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "widgets/scope/view.h"

#include <qcustomplot.h>

#include <cmath>

namespace {

using namespace bench;

constexpr std::size_t kFrame = 333; ///< samples of a signal in a 60th of a second
constexpr double kTenMinutes = 600.0;
constexpr double kFrameMs = 1000.0 / 60.0;

/// Our scope, the window's worth of samples recorded.
struct Scope {
    capture::Capture capture{capture::Capture::Config{.maxBytes = std::size_t{8} << 30}};
    widgets::EventLog events;
    widgets::ScopeView view{capture, events};
    MotorStream stream;
    double window;

    explicit Scope(double seconds)
        : window(seconds)
    {
        stream.record(capture, static_cast<std::size_t>(std::lround(seconds * kTickHz)));
        view.setAttribute(Qt::WA_DontShowOnScreen);
        view.resize(1920, 1080);
        view.show();
        for (const auto &info : capture.channels())
            view.addChannel(info.id);
        view.fitAll();
        QCoreApplication::processEvents();
    }
    void frame()
    {
        stream.append(capture, kFrame);
        const double newest = double(stream.ticks()) / kTickHz;
        view.setVisibleRange(newest - window, newest);
        view.findChild<QCustomPlot *>()->replot(QCustomPlot::rpQueuedRefresh);
    }
    bool complete() const
    {
        return capture.size(capture.channels().back().id) == std::uint64_t(stream.ticks());
    }
};

/// The plot library's own graphs, used as its documentation says for such data.
struct Graphs {
    QCustomPlot plot;
    std::vector<std::vector<std::int16_t>> signalList;
    std::size_t ticks = 0;
    double window;

    explicit Graphs(double seconds)
        : window(seconds)
    {
        plot.setAttribute(Qt::WA_DontShowOnScreen);
        plot.resize(1920, 1080);
        plot.show();
        for (int s = 0; s < kSignals; ++s) {
            signalList.push_back(motorSignal(s, MotorStream::kPeriod));
            plot.addGraph()->setPen(QPen(QColor::fromHsv(s * 40, 255, 200), 1));
        }
        append(static_cast<std::size_t>(std::lround(seconds * kTickHz)));
        const double factor = motorLayout().fast[0].factor;
        plot.yAxis->setRange(-33000 * factor, 33000 * factor);
    }
    void append(std::size_t count)
    {
        const double factor = motorLayout().fast[0].factor;
        QVector<QCPGraphData> data(static_cast<qsizetype>(count));
        for (int s = 0; s < kSignals; ++s) {
            const auto &codes = signalList[std::size_t(s)];
            for (std::size_t i = 0; i < count; ++i)
                data[qsizetype(i)] = {
                    double(ticks + i) / kTickHz, codes[(ticks + i) % codes.size()] * factor};
            plot.graph(s)->data()->add(data, true);
        }
        ticks += count;
    }
    void frame()
    {
        append(kFrame);
        const double newest = double(ticks) / kTickHz;
        for (int s = 0; s < kSignals; ++s)
            plot.graph(s)->data()->removeBefore(newest - window);
        plot.xAxis->setRange(newest - window, newest);
        plot.replot(QCustomPlot::rpQueuedRefresh);
    }
};

void streamingAgainstGraphs(benchmark::State &state)
{
    Scope scope(kTenMinutes);
    Graphs graphs(kTenMinutes);
    const Pair pair = pairedRatio(
        state, [&] { scope.frame(); }, [&] { graphs.frame(); });
    require(scope.complete(), "samples are missing from the store");
    report({"P4 ten minutes", "replot of 8 x 20 kHz, 10 min window", Measured::faster(pair),
        "QCPGraph, default, add and removeBefore"});
}

void streamingWindows(benchmark::State &state)
{
    Scope seconds(10.0);
    Scope hour(3600.0);
    const Pair pair = pairedRatio(
        state, [&] { seconds.frame(); }, [&] { hour.frame(); });
    require(hour.complete(), "samples are missing from the store");
    report({"P4 hour", "replot with a window of 1 h", Measured::cost(pair),
        "the same with a window of 10 s"});
}

void streamingWorstFrames(benchmark::State &state)
{
    Scope scope(kTenMinutes);
    std::vector<double> frames;
    for ([[maybe_unused]] auto _ : state) {
        const double start = cpuSeconds();
        scope.frame();
        frames.push_back(cpuSeconds() - start);
        state.SetIterationTime(frames.back());
    }
    require(scope.complete(), "samples are missing from the store");
    const double p99 = quantile(frames, 0.99) * 1e3;
    state.counters["p50_ms"] = quantile(frames, 0.5) * 1e3;
    state.counters["p99_ms"] = p99;
    report({"P4 worst", "replot, 10 min window", p99 / kFrameMs, "16.7 ms of computing"});
}

} // namespace

BENCHMARK(streamingAgainstGraphs)->Iterations(7)->UseManualTime();
BENCHMARK(streamingWindows)->Iterations(150)->UseManualTime();
BENCHMARK(streamingWorstFrames)->Iterations(600)->UseManualTime();

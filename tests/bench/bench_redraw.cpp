// P1, P2, P3: a redraw of the scope against QCPGraph on the same data, against its own cost with ten times fewer
// samples, and against the least a redraw in QCustomPlot can cost. 1920 x 1080, the key range moves every time.
#include "widgets/scope/drawing/wide_registers.h"
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "widgets/scope/drawing/trace_image.h"
#include "widgets/scope/scope_view.h"

#include <qcustomplot.h>

#include <memory>

namespace {

using namespace bench;

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;

/// The scope with all signals in one plot, fully zoomed out.
struct Scope {
    capture::Capture capture;
    widgets::EventLog events;
    widgets::ScopeView view{capture, events};
    double span = 0;
    int moved = 0;

    explicit Scope(std::size_t samples, int signalCount = kSignals)
    {
        MotorStream stream;
        stream.layout.fast.resize(std::size_t(signalCount));
        stream.record(capture, samples);
        view.setAttribute(Qt::WA_DontShowOnScreen);
        view.resize(kWidth, kHeight);
        view.show();
        for (const auto &info : capture.channels())
            view.addChannel(info.id);
        span = capture.timeSpan()->to;
        view.fitAll();
        QCoreApplication::processEvents();
    }
    void redraw()
    {
        // A little further each time, so that nothing can be answered from a cache.
        const double shift = span * 1e-5 * (++moved % 100);
        view.setVisibleRange(shift, shift + span);
        view.findChild<QCustomPlot *>()->replot(QCustomPlot::rpQueuedRefresh);
    }
};

/// The same data as the plot library draws them by itself.
struct Graphs {
    QCustomPlot plot;
    double span = 0;
    int moved = 0;

    Graphs(std::size_t samples, bool antialiased)
    {
        plot.setAttribute(Qt::WA_DontShowOnScreen);
        plot.resize(kWidth, kHeight);
        plot.show();
        const double factor = motorLayout().fast[0].factor;
        for (int s = 0; s < kSignals; ++s) {
            QVector<QCPGraphData> data(static_cast<qsizetype>(samples));
            const auto codes = motorSignal(s, std::min(samples, MotorStream::kPeriod));
            for (std::size_t i = 0; i < samples; ++i)
                data[qsizetype(i)] = {double(i) / kTickHz, codes[i % codes.size()] * factor};
            QCPGraph *graph = plot.addGraph();
            graph->data()->set(data, true);
            graph->setPen(QPen(QColor::fromHsv(s * 40, 255, 200), 1));
        }
        if (!antialiased)
            plot.setNotAntialiasedElements(QCP::aeAll);
        span = double(samples) / kTickHz;
        plot.yAxis->setRange(-33000 * factor, 33000 * factor);
    }
    void redraw()
    {
        const double shift = span * 1e-5 * (++moved % 100);
        plot.xAxis->setRange(shift, shift + span);
        plot.replot(QCustomPlot::rpQueuedRefresh);
    }
};

void redrawAgainstGraphs(benchmark::State &state, bool antialiased, const char *against)
{
    const auto samples = static_cast<std::size_t>(state.range(0));
    Scope scope(samples);
    Graphs graphs(samples, antialiased);
    const Pair pair = pairedRatio(
        state, [&] { scope.redraw(); }, [&] { graphs.redraw(); });
    report({"P1", "redraw 8 x " + std::to_string(samples) + " fully out, 1920x1080: times faster",
        pair.ratio, samples >= 10'000'000 ? ">= 50" : ">= 50 at 8 x 10000000", against});
}

void redrawAgainstGraphsDefault(benchmark::State &state)
{
    redrawAgainstGraphs(state, true, "QCPGraph, default");
}
void redrawAgainstGraphsPlain(benchmark::State &state)
{
    redrawAgainstGraphs(state, false, "QCPGraph, not antialiased");
}

void growth(benchmark::State &state)
{
    const auto samples = static_cast<std::size_t>(state.range(0));
    Scope few(100'000);
    Scope many(samples);
    const Pair pair = pairedRatio(
        state, [&] { few.redraw(); }, [&] { many.redraw(); });
    report({"P2", "redraw of 8 x " + std::to_string(samples) + ": times the cost", pair.ratio,
        "<= 1.25", "the same redraw of 8 x 100000"});
}

/// More samples than the partners can hold.
void growthOfOne(benchmark::State &state)
{
    const auto samples = static_cast<std::size_t>(state.range(0));
    Scope few(100'000, 1);
    Scope many(samples, 1);
    const Pair pair = pairedRatio(
        state, [&] { few.redraw(); }, [&] { many.redraw(); });
    report({"P2", "redraw of 1 x " + std::to_string(samples) + ": times the cost", pair.ratio,
        "<= 1.25", "the same redraw of 1 x 100000"});
}

/// One-sample peaks anywhere, at several zooms: each must show in its column. Reports how many did not.
void peaks(benchmark::State &state)
{
    constexpr std::int64_t kSamples = 3'000'000;
    capture::Capture capture;
    capture::StreamLayout layout = motorLayout();
    layout.fast.resize(1);
    layout.fast[0].factor = 1.0;
    capture.begin(layout);
    std::vector<std::int64_t> places;
    std::vector<std::int16_t> samples(kSamples, 0);
    for (std::int64_t i = 1; i < 1400; ++i) {
        places.push_back(i * 2137 + i % 13);
        samples[std::size_t(places.back())] = static_cast<std::int16_t>(1000 + i);
    }
    capture.append({1, 0, kSamples, samples, {}, 0});
    const capture::ChannelId id = capture.channels()[0].id;
    std::uint64_t missed = 0;
    while (state.KeepRunning()) {
        for (const double zoom : {1.0, 3.0, 10.0, 77.0}) {
            const double span = kSamples / kTickHz / zoom;
            for (const std::int64_t place : places) {
                const double time = double(place) / kTickHz;
                const double from = std::max(0.0, time - span / 3);
                const auto columns = capture.columns(id, from, from + span, kWidth);
                const auto column = std::size_t((time - from) / span * kWidth);
                float highest = 0;
                for (std::size_t x = column ? column - 1 : 0; x <= column + 1 && x < kWidth; ++x)
                    highest = std::max(highest, columns[x].max);
                missed += highest < float(samples[std::size_t(place)]);
            }
        }
    }
    state.counters["missed"] = double(missed);
    report({"P2", "one-sample peaks missed in 4 zooms x 1399", double(missed), "0", "all of them"});
    require(missed == 0, "a peak of one sample is not in the picture");
}

/// The least that is possible inside QCustomPlot: an empty replot, the fills of the same columns and one blit.
void againstTheLimit(benchmark::State &state)
{
    Scope scope(1'000'000);
    QCustomPlot empty;
    empty.setAttribute(Qt::WA_DontShowOnScreen);
    empty.resize(kWidth, kHeight);
    empty.show();
    const QRect area = scope.view.plotRect(0);
    std::vector<widgets::PixelColumns> columns;
    for (const auto &info : scope.capture.channels()) {
        const auto range = scope.view.valueRangeOf(info.id);
        const double perUnit = area.height() / (range.to - range.from);
        const auto extremes =
            scope.capture.columns(info.id, 0, scope.span, std::size_t(area.width()));
        widgets::PixelColumns own(area.width());
        for (int x = 0; x < area.width(); ++x) {
            const capture::MinMax &column = extremes[std::size_t(x)];
            own.set(x, int((range.to - double(column.max)) * perUnit),
                int((range.to - double(column.min)) * perUnit));
        }
        columns.push_back(std::move(own));
    }
    QImage image(area.size(), QImage::Format_RGB32);
    QPixmap target(kWidth, kHeight);
    int moved = 0;
    const Pair pair = pairedRatio(
        state,
        [&] {
            ++moved;
            empty.xAxis->setRange(moved % 100, 1000 + moved % 100);
            empty.replot(QCustomPlot::rpQueuedRefresh);
            image.fill(Qt::white);
            widgets::clearWideRegisters(); // as our own picture does: the limit of what is possible
            for (const widgets::PixelColumns &own : columns)
                widgets::fillColumns(image, own, 0xFF0072B2);
            QPainter(&target).drawImage(area.topLeft(), image);
        },
        [&] { scope.redraw(); });
    report({"P3", "redraw 8 x 1000000 in QCustomPlot: times the cost", pair.ratio, "<= 1.35",
        "empty replot + the same fills + one blit"});
}

} // namespace

BENCHMARK(redrawAgainstGraphsDefault)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Iterations(15)
    ->UseManualTime();
BENCHMARK(redrawAgainstGraphsPlain)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Iterations(15)
    ->UseManualTime();
BENCHMARK(growth)->Arg(1'000'000)->Arg(10'000'000)->Iterations(150)->UseManualTime();
BENCHMARK(growthOfOne)->Arg(10'000'000)->Arg(100'000'000)->Iterations(150)->UseManualTime();
BENCHMARK(peaks)->Iterations(1);
BENCHMARK(againstTheLimit)->Iterations(150)->UseManualTime();

// P1, P2, P3: a picture of the scope, fully out, against QCPGraph on the same data and against the least that a replot
// in QCustomPlot can cost; and whether every peak is on the screen. 1920 x 1080, the key range moves every time. Whole
// frames are in bench_frames.cpp.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "widgets/scope/view.h"

#include <qcustomplot.h>

#include <cstring>
#include <functional>
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
    QPixmap picture{kWidth, kHeight};
    double span = 0;
    int moved = 0;

    explicit Scope(std::size_t samples)
        : Scope([samples](capture::Capture &into) { MotorStream().record(into, samples); })
    {
    }
    explicit Scope(const std::function<void(capture::Capture &)> &record)
    {
        record(capture);
        view.setAttribute(Qt::WA_DontShowOnScreen);
        view.resize(kWidth, kHeight);
        view.show();
        for (const auto &info : capture.channels())
            view.addChannel(info.id);
        span = capture.timeSpan()->to;
        view.fitAll();
        QCoreApplication::processEvents();
    }
    /// As for a window, which the scope paints itself, into a picture like the partner's.
    void redraw()
    {
        move();
        view.catchUp();
        plot().render(&picture, {}, {}, QWidget::DrawChildren);
    }
    /// The plot library's way, into its own picture, which no window takes.
    void replot()
    {
        move();
        plot().replot(QCustomPlot::rpQueuedRefresh);
    }

private:
    QCustomPlot &plot() { return *view.findChild<QCustomPlot *>(); }
    /// A little further and a hair longer or shorter each time, so that nothing can be answered from a cache.
    void move()
    {
        const double shift = span * 1e-5 * (++moved % 100);
        view.setVisibleRange(shift, shift + span * (moved % 2 == 0 ? 1.0 : 1.0 + 1e-5));
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

void redrawAgainstGraphs(benchmark::State &state, bool antialiased, bool replots)
{
    const auto samples = static_cast<std::size_t>(state.range(0));
    Scope scope(samples);
    Graphs graphs(samples, antialiased);
    const Pair pair = pairedRatio(
        state, [&] { replots ? scope.replot() : scope.redraw(); }, [&] { graphs.redraw(); });
    const bool judged = antialiased && !replots && samples >= 10'000'000;
    report({judged ? "P1 fully out" : "P1",
        (replots ? "replot of 8 x " : "picture of 8 x ") + std::to_string(samples)
            + ", flat, fully out",
        Measured::faster(pair), antialiased ? "QCPGraph, default" : "QCPGraph, not antialiased"});
}

/// Peaks of one sample, up and down, anywhere, at several zooms: each must be on the screen, in its column and its row.
void peaks(benchmark::State &state)
{
    constexpr std::int64_t kSamples = 3'000'000;
    constexpr int kBand = 200; ///< of the samples around zero: less than the least peak
    std::vector<std::int64_t> places;
    std::vector<std::int16_t> samples(kSamples, 0);
    for (std::int64_t i = 1; i < 1400; ++i) {
        places.push_back(i * 2137 + i % 13);
        samples[std::size_t(places.back())] =
            static_cast<std::int16_t>((i % 2 == 0 ? 1 : -1) * (kBand + 10 * i));
    }
    Scope scope([&samples](capture::Capture &capture) {
        capture::StreamLayout layout = motorLayout();
        layout.fast.resize(1);
        layout.fast[0].factor = 1.0;
        capture.begin(layout);
        capture.append({1, 0, kSamples, samples, {}, 0});
    });
    const capture::ChannelId id = scope.view.channels().front();
    const QRgb ink = scope.view.colorOf(id).rgb();
    std::uint64_t missed = 0, looked = 0;
    while (state.KeepRunning()) {
        for (const int pictures : {1, 3, 10, 77}) {
            const double span = scope.span / pictures;
            for (int picture = 0; picture < pictures; ++picture) {
                const double from = span * picture;
                scope.view.setVisibleRange(from, from + span);
                scope.view.catchUp();
                scope.view.findChild<QCustomPlot *>()->replot();
                const QRect area = scope.view.plotRect(0); // its margins follow the labels
                const auto range = scope.view.valueRangeOf(id);
                const QImage image =
                    scope.view.grab().toImage().convertToFormat(QImage::Format_RGB32);
                for (const std::int64_t place : places) {
                    const double x = (double(place) / kTickHz - from) / span * area.width();
                    // Labels of the last value stand at the right edge.
                    if (x < 1.0 || x > area.width() - 100)
                        continue;
                    const double y = (range.to - double(samples[std::size_t(place)]))
                        / (range.to - range.from) * area.height();
                    ++looked;
                    // The edge of a column is rounded by a sixteenth of it; a row is one of those that share it.
                    bool seen = false;
                    for (const double dx : {0.0, -1.0 / 16, 1.0 / 16})
                        for (const int dy : {0, -1, 1})
                            seen = seen
                                || image.pixel(area.left() + int(x + dx), area.top() + int(y) + dy)
                                    == ink;
                    missed += seen ? 0 : 1;
                }
            }
        }
    }
    state.counters["missed"] = double(missed);
    report({"P2 peaks", "peaks of one sample, up and down, at 4 zooms", double(missed),
        std::to_string(looked) + " on the screen"});
    require(missed == 0, "a peak of one sample is not in the picture");
}

/// What no replot in QCustomPlot can do without: an empty one, a picture cleared once, and one blit.
void againstTheLimit(benchmark::State &state)
{
    constexpr std::size_t kCount = 1'000'000;
    const bool ragged = state.range(0) != 0;
    Scope scope([ragged](capture::Capture &into) {
        if (ragged)
            Ragged(kCount, Ragged::Wave::Motor).record(into);
        else
            MotorStream().record(into, kCount);
    });
    QCustomPlot empty;
    empty.setAttribute(Qt::WA_DontShowOnScreen);
    empty.resize(kWidth, kHeight);
    empty.show();
    const QRect area = scope.view.plotRect(0);
    QImage image(area.size(), QImage::Format_RGB32);
    QPixmap target(kWidth, kHeight);
    int moved = 0;
    const Pair pair = pairedRatio(
        state,
        [&] {
            ++moved;
            empty.xAxis->setRange(moved % 100, 1000 + moved % 100);
            empty.replot(QCustomPlot::rpQueuedRefresh);
            std::memset(image.bits(), 0xff, std::size_t(image.sizeInBytes()));
            QPainter(&target).drawImage(area.topLeft(), image);
        },
        [&] { scope.replot(); });
    report({ragged ? "P3 ragged" : "P3 flat",
        std::string("replot of 8 x 1000000, ") + (ragged ? "ragged" : "flat"), Measured::cost(pair),
        "empty replot + memset + blit"});
}

} // namespace

BENCHMARK_CAPTURE(redrawAgainstGraphs, default, true, false)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Iterations(15)
    ->UseManualTime();
BENCHMARK_CAPTURE(redrawAgainstGraphs, plain, false, false)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Iterations(15)
    ->UseManualTime();
BENCHMARK_CAPTURE(redrawAgainstGraphs, replot, true, true)
    ->Arg(10'000'000)
    ->Iterations(15)
    ->UseManualTime();
BENCHMARK(peaks)->Iterations(1);
BENCHMARK(againstTheLimit)->Arg(0)->Arg(1)->Iterations(150)->UseManualTime();

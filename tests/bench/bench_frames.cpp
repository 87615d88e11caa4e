// N3 to N8: whole frames of the window's scope, from the wish to the painted widget, on ragged data. 1920 x 1080, the
// time axis moves every time.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/view.h"

#include <qcustomplot.h>

#include <QBackingStore>
#include <QScreen>

#include <functional>
#include <memory>

namespace {

using namespace bench;

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr double kFrameMs = 1000.0 / 60.0;

/// Counts what is painted of a widget.
class Painted : public QObject {
public:
    explicit Painted(QWidget &of) { of.installEventFilter(this); }
    /// Does something after which it has to be painted, and waits until it is.
    void after(const std::function<void()> &change)
    {
        const int before = m_count;
        change();
        while (m_count == before)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

private:
    bool eventFilter(QObject *, QEvent *event) override
    {
        m_count += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }
    int m_count = 0;
};

/// What the picture that the window is painted into has of its own for one pixel of the window: a screen may promise
/// more.
double pixelsOf(const QWidget &window)
{
    return window.backingStore()->paintDevice()->devicePixelRatioF();
}

QCustomPlot &plotOf(QWidget &widget) { return *widget.findChild<QCustomPlot *>(); }

struct Scope {
    capture::Capture capture{capture::Capture::Config{.maxBytes = std::size_t{8} << 30}};
    widgets::EventLog events;
    widgets::ScopeView view{capture, events};
    Painted painted{plotOf(view)};
    double span = 0;
    int moved = 0;

    explicit Scope(const std::function<void(capture::Capture &)> &record, QScreen *on = nullptr)
    {
        record(capture);
        if (on != nullptr) {
            view.setScreen(on);
            view.move(on->geometry().topLeft());
        }
        view.resize(kWidth, kHeight);
        view.show();
        for (const auto &info : capture.channels())
            view.addChannel(info.id);
        span = capture.timeSpan()->to;
        view.fitAll();
        QCoreApplication::processEvents();
    }
    explicit Scope(const Ragged &data, QScreen *on = nullptr)
        : Scope([&data](capture::Capture &into) { data.record(into); }, on)
    {
    }
    /// As a hand drags it: the picture before is made use of.
    void dragged(double seconds) { show(seconds, 1.0); }
    /// A hair longer or shorter than before: all of it is painted.
    void frame(double seconds) { show(seconds, moved % 2 == 0 ? 1.0 : 1.0 + 1e-5); }
    void frame() { frame(span); }

private:
    void show(double seconds, double stretch)
    {
        const double shift = seconds * 1e-3 * (++moved % 100);
        const quint64 before = view.redraws();
        const double from = (span - seconds) / 2 + shift;
        painted.after([&] { view.setVisibleRange(from, from + seconds * stretch); });
        while (view.redraws() == before) // what was painted was the one before
            painted.after([] {});
    }
};

/// The plot library's own way.
struct Graphs {
    QCustomPlot plot;
    Painted painted{plot};
    double span = 0;
    int moved = 0;

    explicit Graphs(const Ragged &data)
        : span(double(data.count()) / kTickHz)
    {
        plot.resize(kWidth, kHeight);
        plot.show();
        const double factor = motorLayout().fast[0].factor;
        for (int s = 0; s < data.signalCount(); ++s) {
            QVector<QCPGraphData> points(static_cast<qsizetype>(data.count()));
            for (std::size_t i = 0; i < data.count(); ++i)
                points[qsizetype(i)] = {double(i) / kTickHz, data.at(s, i) * factor};
            QCPGraph *graph = plot.addGraph();
            graph->data()->set(points, true);
            graph->setPen(QPen(QColor::fromHsv(s * 40, 255, 200), 1));
        }
        plot.yAxis->setRange(-33000 * factor, 33000 * factor);
        QCoreApplication::processEvents();
    }
    void frame(double seconds)
    {
        const double shift = seconds * 1e-3 * (++moved % 100);
        const double from = (span - seconds) / 2 + shift;
        plot.xAxis->setRange(from, from + seconds);
        painted.after([this] { plot.replot(QCustomPlot::rpQueuedRefresh); });
    }
};

void frameAgainstGraphs(benchmark::State &state)
{
    const auto shown = static_cast<std::size_t>(state.range(0));
    const Ragged data(10'000'000, Ragged::Wave::Motor);
    Scope scope(data);
    Graphs graphs(data);
    const double seconds = shown == 0 ? scope.span : double(shown) / kTickHz;
    const bool dragged = state.range(1) != 0;
    const Pair pair = pairedRatio(
        state, [&] { dragged ? scope.dragged(seconds) : scope.frame(seconds); },
        [&] { graphs.frame(seconds); });
    const std::string many = shown == 0 ? "fully out" : std::to_string(shown);
    const std::string what = "frame of 8 x 10000000, ragged, in view: " + many;
    if (dragged)
        report({"N3", what + ", dragged", Measured::faster(pair), "QCPGraph, default, its frame"});
    else
        report({"N3 " + many, what, Measured::faster(pair), "QCPGraph, default, its frame"});
}

void frameOfMore(benchmark::State &state)
{
    const auto samples = static_cast<std::size_t>(state.range(0));
    Scope few(Ragged(100'000, Ragged::Wave::Peaks));
    Scope many(Ragged(samples, Ragged::Wave::Peaks));
    const Pair pair = pairedRatio(
        state, [&] { few.frame(); }, [&] { many.frame(); });
    report({"N4 " + std::to_string(samples), "frame of 8 x " + std::to_string(samples),
        Measured::cost(pair), "the same picture of 8 x 100000"});
}

void frameOfValues(benchmark::State &state)
{
    const Ragged data(5'000'000, Ragged::Wave::Motor);
    Scope fast(data);
    Scope values([&data](capture::Capture &into) { data.import(into); });
    report({"N5 memory", "values at equal steps",
        double(values.capture.bytes()) / double(data.count() * kSignals), "nothing"});
    const Pair pair = pairedRatio(
        state, [&] { fast.frame(); }, [&] { values.frame(); });
    report({"N5 frame", "frame of 8 x 5000000 imported values", Measured::cost(pair),
        "the same of recorded samples"});
}

/// A stream at 20 kHz, 333 samples a frame, ten seconds in view.
struct Stream {
    static constexpr std::size_t kFrame = 333;
    static constexpr double kSeconds = 10.0;
    MotorStream data;
    std::unique_ptr<Scope> scope;
    std::unique_ptr<widgets::MathChannels> math;

    explicit Stream(int formulas)
    {
        scope = std::make_unique<Scope>(
            [this](capture::Capture &into) { data.record(into, std::size_t(kSeconds * kTickHz)); });
        math = std::make_unique<widgets::MathChannels>(scope->capture);
        widgets::ScopeView &view = scope->view;
        QObject::connect(math.get(), &widgets::MathChannels::made, &view,
            [this, &view](const QString &, quint32 before) {
                view.removeChannel(before);
                for (const auto &entry : math->entries())
                    if (entry.channel != 0 && !view.channels().contains(entry.channel))
                        view.addChannel(entry.channel);
            });
        QList<widgets::MathFormula> all;
        for (int i = 0; i < formulas; ++i)
            all.append({QStringLiteral("M%1").arg(i + 1),
                QStringLiteral("A%1 * A%2 + A%1").arg(i % 8).arg((i + 1) % 8), true});
        math->setFormulas(all);
        QCoreApplication::processEvents();
        while (!complete())
            math->advance();
    }
    bool complete() const
    {
        for (const auto &entry : math->entries())
            if (scope->capture.size(entry.channel) + 2 < scope->capture.size(1))
                return false;
        return true;
    }
    void frame()
    {
        data.append(scope->capture, kFrame);
        math->advance();
        const double newest = double(data.ticks()) / kTickHz;
        scope->painted.after([&] { scope->view.setVisibleRange(newest - kSeconds, newest); });
    }
};

void mathBesideStream(benchmark::State &state)
{
    Stream without(0);
    Stream with(16);
    std::vector<double> frames;
    const Pair pair = pairedRatio(
        state, [&] { without.frame(); },
        [&] {
            const double start = cpuSeconds();
            with.frame();
            frames.push_back(cpuSeconds() - start);
        });
    require(with.complete(), "the math channels stay behind");
    report({"N6 math", "stream of 8 x 20 kHz with 16 math channels, drawn", Measured::cost(pair),
        "the stream without"});
    report(
        {"N6 frame", "the same", quantile(frames, 0.99) * 1e3 / kFrameMs, "16.7 ms of computing"});
}

/// Sixteen earlier records, newest first, each `by` seconds before the one after it.
std::vector<widgets::Ghost> sixteenRecords(double by)
{
    std::vector<widgets::Ghost> ghosts;
    for (int i = 0; i < 16; ++i)
        ghosts.push_back({nullptr, -by * (i + 1), 110 - 5 * i});
    return ghosts;
}

/// While the picture is moved, and the records with it: all of them are other columns each time.
void persistence(benchmark::State &state)
{
    constexpr double kSeconds = 1.0;
    const Ragged data(1'000'000, Ragged::Wave::Motor);
    Scope plain(data);
    Scope sixteen(data);
    sixteen.view.ghosts().setRecords(sixteenRecords(kSeconds));
    const Pair pair = pairedRatio(
        state, [&] { plain.frame(kSeconds); }, [&] { sixteen.frame(kSeconds); });
    report({"N7 persistence", "frame of 8 traces with 16 records behind them, moved",
        Measured::cost(pair), "the frame without"});
}

/// As a trigger brings them: 20 records of a second a second, 60 frames. The picture stands still in between.
void triggered(benchmark::State &state)
{
    constexpr double kBy = 0.05;
    constexpr double kSeconds = 1.0;
    const Ragged data(1'000'000, Ragged::Wave::Motor);
    Scope plain(data);
    Scope sixteen(data);
    sixteen.view.ghosts().setRecords(sixteenRecords(kBy));
    const auto third = [](Scope &scope) {
        for (int frame = 0; frame < 3; ++frame) {
            const double from = 20.0 + kBy * scope.moved;
            scope.moved += frame == 0 ? 1 : 0;
            const quint64 before = scope.view.redraws();
            scope.painted.after([&] {
                scope.view.setVisibleRange(from, from + kSeconds);
                scope.view.redraw();
            });
            while (scope.view.redraws() == before)
                scope.painted.after([] {});
        }
    };
    const Pair pair = pairedRatio(
        state, [&] { third(plain); },
        [&] {
            sixteen.view.ghosts().setRecords(sixteenRecords(kBy));
            third(sixteen);
        });
    report({"N7 triggered", "three frames of 8 traces with 16 records, one of them new",
        Measured::cost(pair), "the frames without"});
}

/// One that has four pixels for each logical one (3840 x 2160 at 200 %); nullptr if there is none.
QScreen *fineScreen()
{
    for (QScreen *screen : QGuiApplication::screens())
        if (screen->devicePixelRatio() == 2.0)
            return screen;
    return nullptr;
}

void frameOfMorePixels(benchmark::State &state)
{
    constexpr double kFastScreenMs = 4.1; ///< of the 4.17 between two pictures of 240 a second
    QScreen *fine = fineScreen();
    if (fine == nullptr)
        return leaveOut("N8", "no screen at 200 % (tests/bench/screens.json gives one)");
    const Ragged data(10'000'000, Ragged::Wave::Motor);
    Scope plain(data);
    Scope sharp(data, fine);
    std::vector<double> plainFrames, sharpFrames;
    const auto timed = [](Scope &scope, std::vector<double> &into) {
        const double start = cpuSeconds();
        scope.frame();
        into.push_back((cpuSeconds() - start) * 1e3);
    };
    const Pair pair = pairedRatio(
        state, [&] { timed(plain, plainFrames); }, [&] { timed(sharp, sharpFrames); });
    require(pixelsOf(plain.view) == 1.0 && pixelsOf(sharp.view) == 2.0,
        "both pictures have as many pixels");
    report({"N8 4K", "frame of 8 x 10000000, 4K at 200 %", Measured::cost(pair), "1080p"});
    report(
        {"N8 frame", "the same", quantile(sharpFrames, 0.99) / kFrameMs, "16.7 ms of computing"});
    report({"N8 240 Hz", "the frame at 1080p", quantile(plainFrames, 0.999) / kFastScreenMs,
        "4.1 ms of computing"});
}

void draggedInMorePixels(benchmark::State &state)
{
    QScreen *fine = fineScreen();
    if (fine == nullptr)
        return; // said already
    const Ragged data(10'000'000, Ragged::Wave::Motor);
    Scope anew(data, fine);
    Scope dragged(data, fine);
    std::vector<double> frames;
    const Pair pair = pairedRatio(
        state, [&] { anew.frame(); },
        [&] {
            const double start = cpuSeconds();
            dragged.dragged(dragged.span);
            frames.push_back((cpuSeconds() - start) * 1e3);
        });
    report({"N8", "frame of 8 x 10000000, 4K at 200 %, dragged", Measured::cost(pair),
        "painted anew"});
    report({"N8", "the same", quantile(frames, 0.99) / kFrameMs, "16.7 ms of computing"});
}

void manySignals(benchmark::State &state)
{
    Scope eight(Ragged(1'000'000, Ragged::Wave::Motor));
    Scope many(Ragged(1'000'000, Ragged::Wave::Motor, 32));
    const Pair pair = pairedRatio(
        state, [&] { eight.frame(); }, [&] { many.frame(); });
    report({"N7 signals", "frame of 32 x 1000000, ragged, in one plot", Measured::cost(pair),
        "that of 8"});
}

void manyGaps(benchmark::State &state)
{
    const Ragged data(1'000'000, Ragged::Wave::Motor);
    Scope whole(data);
    Scope torn([&data](capture::Capture &into) { data.record(into, 10); });
    const Pair pair = pairedRatio(
        state, [&] { whole.frame(); }, [&] { torn.frame(); });
    report({"N7 gaps", "frame of 8 x 1000000 with 100000 gaps in view", Measured::cost(pair),
        "the frame without"});
}

} // namespace

BENCHMARK(frameAgainstGraphs)->Args({0, 0})->Args({0, 1})->Iterations(9)->UseManualTime();
BENCHMARK(frameAgainstGraphs)
    ->ArgsProduct({{10'000, 3'000, 1'000}, {0, 1}})
    ->Iterations(51)
    ->UseManualTime();
BENCHMARK(frameOfMore)->Arg(10'000'000)->Arg(72'000'000)->Iterations(101)->UseManualTime();
BENCHMARK(frameOfValues)->Iterations(51)->UseManualTime();
BENCHMARK(mathBesideStream)->Iterations(101)->UseManualTime();
BENCHMARK(persistence)->Iterations(51)->UseManualTime();
BENCHMARK(triggered)->Iterations(51)->UseManualTime();
BENCHMARK(frameOfMorePixels)->Iterations(301)->UseManualTime();
BENCHMARK(draggedInMorePixels)->Iterations(101)->UseManualTime();
BENCHMARK(manySignals)->Iterations(51)->UseManualTime();
BENCHMARK(manyGaps)->Iterations(51)->UseManualTime();

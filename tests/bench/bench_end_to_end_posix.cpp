// P5: bytes of a line to pixels, in real time: a simulated board in a process of its own writes 1.2 MB/s to a
// pseudo-terminal, the real window reads, decodes, keeps and draws them with an hour in view. Against QCPGraph that is
// fed by the same session with ten minutes in view. POSIX only: pseudo-terminals.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "support/window_rig.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"

#include <qcustomplot.h>

#include <QElapsedTimer>
#include <QProcess>

#include <array>
#include <numeric>

namespace {

using namespace bench;

/// Room for more than the stream, which is never planned to fill its line.
constexpr std::uint32_t kBaud = 14'000'000;
constexpr int kControlHz = 75'000; ///< eight signals of two bytes: 1.2 MB/s
constexpr int kPatience_ms = 20'000;
constexpr double kHour = 3600.0;
constexpr double kTenMinutes = 600.0;
constexpr double kBytes = 1.15e6; ///< a second, that must have come at least
constexpr std::array kNames{"I_A", "I_B", "I_ALPHA_MEAS", "I_BETA_MEAS", "I_Q_MEAS", "I_D_MEAS",
    "I_Q_REF", "STOPLL_EL_ANGLE"};

template <class Condition>
bool until(Condition condition)
{
    return QTest::qWaitFor(condition, kPatience_ms);
}

/// The board's process, from its start to the end of this object.
class Board {
public:
    Board()
    {
        m_process.start(QStringLiteral(ROTORSCOPE_BENCH_BOARD),
            {QString::number(kBaud), QString::number(kControlHz)});
        require(m_process.waitForReadyRead(kPatience_ms), "the simulated board did not start");
        m_endpoint.kind = session::Endpoint::Kind::Serial;
        m_endpoint.path = QString::fromLocal8Bit(m_process.readLine()).trimmed();
        m_endpoint.baud = kBaud;
    }
    Board(const Board &) = delete;
    Board &operator=(const Board &) = delete;
    ~Board()
    {
        m_process.closeWriteChannel();
        m_process.waitForFinished(kPatience_ms);
    }
    const session::Endpoint &endpoint() const { return m_endpoint; }

private:
    QProcess m_process;
    session::Endpoint m_endpoint;
};

void connectTo(const Board &board, widgets::Device &device)
{
    device.open(board.endpoint());
    require(until([&] { return device.answering() && device.identified(); }), "no connection");
}

std::vector<catalog::RegisterId> wantedIds(const widgets::Device &device)
{
    std::vector<catalog::RegisterId> ids;
    for (const char *name : kNames)
        ids.push_back(device.catalog()->resolve(name).value_or(0));
    return ids;
}

/// What a stretch of real time brought.
struct Stretch {
    double seconds = 0.0;
    double cpu = 0.0;
    double samples = 0.0; ///< of all signals
    double lost = 0.0; ///< control periods
    double frames = 0.0;
};

template <class Samples, class Frames>
Stretch measure(int milliseconds, const widgets::Device &device, Samples samples, Frames frames)
{
    const auto lost = [&] {
        return double(device.counters().streamLostTicks) + double(device.droppedForDisplay());
    };
    const Stretch before{0.0, cpuSeconds(), double(samples()), lost(), double(frames())};
    QElapsedTimer clock;
    clock.start();
    QEventLoop loop;
    QTimer::singleShot(milliseconds, Qt::PreciseTimer, &loop, &QEventLoop::quit);
    loop.exec();
    return {double(clock.nsecsElapsed()) * 1e-9, cpuSeconds() - before.cpu,
        double(samples()) - before.samples, lost() - before.lost, double(frames()) - before.frames};
}

/// The window with an hour of the eight signals behind it, and the stream running on.
class Ours {
public:
    explicit Ours(const Board &board)
    {
        m_rig.window.resize(1920, 1080);
        widgets::Device &device = m_rig.workbench.device();
        capture::StreamLayout layout;
        QObject::connect(&device, &widgets::Device::streamStarted, &m_rig.window,
            [&layout](const capture::StreamLayout &started) {
                if (started.fast.size() == kNames.size())
                    layout = started;
            });
        connectTo(board, device);
        show(wantedIds(device));
        require(until([&] { return layout.fast.size() == kNames.size(); }), "no stream");
        device.close();
        require(until([&] { return !device.portOpen(); }), "the port was not closed");
        recordAnHour(layout);
        connectTo(board, device);
        const capture::Capture &capture = m_rig.workbench.capture();
        require(until([&] { return capture.timeSpan()->to > kHour; }), "no stream behind the hour");
        m_ids = capture.streaming();
        const double newest = capture.timeSpan()->to;
        require(m_ids.front() == m_first, "the stream does not continue the hour");
        widgets::ScopeView *scope = m_rig.window.scope();
        scope->setVisibleRange(newest - kHour, newest);
        scope->time().setFollowing(true);
        // As for a motor that is driven: neither link nor scope takes its time.
        device.setArmed(true);
        require(until([&] { return device.armed(); }), "not armed");
        scope->setCalm(false);
        const quint64 drawn = scope->redraws();
        require(until([&] { return scope->redraws() > drawn + 20; }), "nothing is drawn");
    }
    ~Ours()
    {
        m_rig.workbench.device().close();
        until([&] { return !m_rig.workbench.device().portOpen(); });
    }
    Stretch run(int milliseconds)
    {
        const capture::Capture &capture = m_rig.workbench.capture();
        return measure(
            milliseconds, m_rig.workbench.device(),
            [&] {
                return std::accumulate(m_ids.begin(), m_ids.end(), std::uint64_t{0},
                    [&](std::uint64_t sum, auto id) { return sum + capture.size(id); });
            },
            [&] { return m_rig.window.scope()->redraws(); });
    }

private:
    void show(const std::vector<catalog::RegisterId> &ids)
    {
        widgets::SignalSelection &selection = *m_rig.window.selection();
        const auto before = selection.plan().wanted();
        for (const widgets::WantedSignal &signal : before)
            selection.remove(signal.id);
        for (const auto id : ids)
            selection.add(id, 0);
    }
    void recordAnHour(const capture::StreamLayout &layout)
    {
        capture::Capture &capture = m_rig.workbench.capture();
        capture.clear();
        MotorStream hour;
        hour.layout = layout;
        hour.layout.tickHz = kTickHz;
        hour.layout.originSeconds = 0.0;
        hour.record(capture, static_cast<std::size_t>(kHour * kTickHz));
        m_first = capture.streaming().front();
    }

    facts::WindowRig m_rig;
    std::vector<capture::ChannelId> m_ids;
    capture::ChannelId m_first = 0;
};

/// A plot of the library's own graphs on the same session: what comes is added, what is older than the window is
/// removed, and a timer draws.
class Graphs {
public:
    explicit Graphs(const Board &board)
    {
        m_plot.resize(1920, 1080);
        m_plot.show();
        fill();
        widgets::Device &device = m_workbench.device();
        QObject::connect(&device, &widgets::Device::samplesArrived, &m_plot,
            [this](const capture::SampleBlock &block) { add(block); });
        connectTo(board, device);
        device.submit(drive::Stream{wantedIds(device), 1, {}, 1});
        require(until([&] { return m_samples > 0; }), "no stream");
        QObject::connect(&m_timer, &QTimer::timeout, &m_plot, [this] { draw(); });
        m_timer.start(16);
    }
    ~Graphs()
    {
        m_timer.stop();
        m_workbench.device().close();
        until([&] { return !m_workbench.device().portOpen(); });
    }
    Stretch run(int milliseconds)
    {
        return measure(
            milliseconds, m_workbench.device(), [this] { return m_samples; },
            [this] { return m_frames; });
    }

private:
    void fill()
    {
        for (int s = 0; s < kSignals; ++s) {
            const auto codes = motorSignal(s, MotorStream::kPeriod);
            QVector<QCPGraphData> data(static_cast<qsizetype>(kTenMinutes * kTickHz));
            for (qsizetype i = 0; i < data.size(); ++i)
                data[i] = {double(i) / kTickHz, double(codes[std::size_t(i) % codes.size()])};
            m_plot.addGraph()->data()->set(data, true);
            m_plot.graph(s)->setPen(QPen(QColor::fromHsv(s * 40, 255, 200), 1));
        }
        m_plot.yAxis->setRange(-33000, 33000);
    }
    void add(const capture::SampleBlock &block)
    {
        const std::size_t count = block.count;
        QVector<QCPGraphData> data(static_cast<qsizetype>(count));
        for (std::size_t s = 0; s * count < block.fast.size(); ++s) {
            for (std::size_t i = 0; i < count; ++i)
                data[qsizetype(i)] = {
                    m_newest + double(i) / kControlHz, double(block.fast[s * count + i])};
            m_plot.graph(int(s))->data()->add(data, true);
        }
        m_newest += double(count) / kControlHz;
        m_samples += block.fast.size();
    }
    void draw()
    {
        for (int s = 0; s < kSignals; ++s)
            m_plot.graph(s)->data()->removeBefore(m_newest - kTenMinutes);
        m_plot.xAxis->setRange(m_newest - kTenMinutes, m_newest);
        m_plot.replot();
        ++m_frames;
    }

    QCustomPlot m_plot;
    QTimer m_timer;
    double m_newest = kTenMinutes;
    std::size_t m_samples = 0;
    std::uint64_t m_frames = 0;
    widgets::Workbench m_workbench; // last: its session tells the plot
};

void endToEnd(benchmark::State &state)
{
    const Board board;
    Stretch ours, graphs;
    double bytes = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        // On a machine that has no time left the board's process is the one that is late.
        for (int attempt = 0; attempt < 3 && bytes < kBytes; ++attempt) {
            ours = Ours(board).run(10'000);
            bytes = ours.samples * 2.0 / ours.seconds;
        }
        graphs = Graphs(board).run(4'000);
        state.SetIterationTime(ours.cpu);
    }
    if (bytes < kBytes) {
        leaveOut("P5", "the machine was too busy for the simulated board");
        state.SkipWithError("the board wrote less than 1.2 MB/s");
        return;
    }
    const double frames = ours.frames / ours.seconds;
    state.counters["bytes_per_s"] = bytes;
    state.counters["frames_per_s"] = frames;
    state.counters["partner_frames_per_s"] = graphs.frames / graphs.seconds;
    report({"P5 core", "1.2 MB/s end to end, 1 h in view", ours.cpu / ours.seconds * 100.0,
        "real time, all threads of the whole window"});
    report({"P5 frames", "the same", frames, "real time"});
    report({"P5 lost", "the same", ours.lost,
        std::to_string(std::llround(ours.samples / kSignals)) + " periods"});
    report({"P5", "the same: times the frames a second", frames / (graphs.frames / graphs.seconds),
        "QCPGraph on the same session with 10 min in view"});
}

} // namespace

BENCHMARK(endToEnd)->Iterations(1)->UseManualTime();

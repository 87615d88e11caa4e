// N1, N2: how long the window's thread computes at a stretch while a picture of 70 s of 8 x 20 kHz runs, with each tool
// open; and events by the thousand. The real window; samples come from a timer in the place of a port.
#include "bench/motor_data.h"
#include "bench/paired.h"
#include "support/watchdog/beats.h"
#include "support/window_rig.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/measuring/measure_panel.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"

#include <QAction>
#include <QComboBox>
#include <QTimer>
#include <QTreeView>

#include <array>
#include <functional>

namespace {

using namespace bench;
using support::Beat;

constexpr double kPicture_s = 70.0;
constexpr int kWatched_ms = 10'000;
constexpr std::size_t kBatch = 333; ///< samples in a 60th of a second

/// The window, connected, on a running picture of eight signals.
class Running {
public:
    Running()
    {
        rig.window.resize(1920, 1080);
        widgets::Device &device = rig.workbench.device();
        device.disconnect(SIGNAL(openWished(session::Endpoint)));
        device.disconnect(SIGNAL(closeWished()));
        facts::connectBoard(device);
        facts::feed(device, {board()});
        m_data.layout = layout();
        // The window shows what is planned: signals that the board has.
        widgets::SignalSelection &selection = *rig.window.selection();
        const auto before = selection.plan().wanted();
        for (const widgets::WantedSignal &signal : before)
            selection.remove(signal.id);
        for (const capture::StreamSignal &signal : m_data.layout.fast)
            selection.add(signal.id, 0);
        m_data.record(rig.workbench.capture(), std::size_t(kPicture_s * kTickHz));
        facts::feed(device, {drive::StreamStarted{m_data.layout}});
        widgets::ScopeView &scope = *rig.window.scope();
        scope.setVisibleRange(0.0, kPicture_s);
        scope.time().setFollowing(true);
        scope.setCalm(false);
        m_feed.callOnTimeout(
            &rig.window, [this] { facts::feed(rig.workbench.device(), {m_data.next(kBatch)}); });
        m_feed.setTimerType(Qt::PreciseTimer);
        m_feed.start(16);
    }
    ~Running()
    {
        m_feed.stop();
        rig.workbench.device().portChanged(session::PortState::Closed, {});
    }

    /// Under registers as boards have them.
    static capture::StreamLayout layout()
    {
        capture::StreamLayout layout = motorLayout();
        for (std::uint32_t s = 0; s < layout.fast.size(); ++s)
            layout.fast[s].id = facts::kCurrentA + 0x40 * s;
        return layout;
    }
    /// One that has the eight signals.
    static drive::Identified board()
    {
        drive::Identified board = facts::identified();
        std::vector<catalog::RegisterInfo> registers;
        for (const capture::StreamSignal &signal : layout().fast) {
            registers.push_back(facts::makeRegister(signal.id, signal.name, "Current loop"));
            registers.back().quantity = catalog::Quantity::Current;
            registers.back().streaming = catalog::Streaming::Fast;
        }
        catalog::Scales scales;
        scales.ampsPerDigit = 0.002;
        board.catalog = std::make_shared<const catalog::Catalog>(
            std::move(registers), 1, std::vector<catalog::Scales>{scales});
        board.streaming = {kTickHz, kSignals, 2048, 1e6};
        return board;
    }

    void live(int milliseconds)
    {
        QEventLoop loop;
        QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
        loop.exec();
    }
    void open(const char *dock)
    {
        rig.find<QAction>((std::string(dock) + "Open").c_str())->trigger();
        live(500); // what it does once is no part of it
    }
    void rest() { m_feed.stop(); } ///< no samples from now on
    void choose(const char *box, int index) { rig.find<QComboBox>(box)->setCurrentIndex(index); }

    facts::WindowRig rig;

private:
    MotorStream m_data;
    QTimer m_feed;
};

struct Tool {
    const char *name;
    void (*open)(Running &);
};

void openMath(Running &running)
{
    QList<widgets::MathFormula> all;
    for (int i = 0; i < 16; ++i)
        all.append({QStringLiteral("M%1").arg(i + 1),
            QStringLiteral("A%1 * A%2 + A%1").arg(i % 8).arg((i + 1) % 8), true});
    running.rig.workbench.math().setFormulas(all);
    running.open("mathDock");
}

void openMeasures(Running &running)
{
    running.open("measureDock");
    QList<widgets::NamedMeasure> all;
    for (int i = 0; i < widgets::kMostMeasures; ++i) {
        widgets::NamedMeasure measure;
        measure.signal = QStringLiteral("A%1").arg(i % 8);
        measure.quantity = widgets::allQuantities()[i % 14];
        all.append(measure);
    }
    running.rig.window.findChild<widgets::MeasurePanel *>()->setMeasures(all);
}

constexpr Tool kTools[] = {
    {"no tool", [](Running &) {}},
    {"spectrum, Hann", [](Running &running) { running.open("spectrumDock"); }},
    {"spectrum, flat top",
        [](Running &running) {
            running.open("spectrumDock");
            running.choose("spectrumWindow", 1);
        }},
    {"spectrum, Blackman-Harris",
        [](Running &running) {
            running.open("spectrumDock");
            running.choose("spectrumWindow", 2);
        }},
    {"XY of the picture",
        [](Running &running) {
            running.open("xyDock");
            running.choose("xyKind", 4);
        }},
    {"16 math channels", &openMath},
    {"32 measurements", &openMeasures},
    {"cursors", [](Running &running) { running.rig.window.scope()->cursorActions().toggle(); }},
    {"overview", [](Running &running) { running.rig.window.scope()->setOverviewVisible(true); }},
    {"events", [](Running &running) { running.open("eventDock"); }},
};

void stalls(benchmark::State &state)
{
    const Tool &tool = kTools[state.range(0)];
    Running running;
    tool.open(running);
    running.live(1000);
    const quint64 drawn = running.rig.window.scope()->redraws();
    Beat::forget();
    for ([[maybe_unused]] auto _ : state)
        running.live(kWatched_ms);
    const Beat::Told told = Beat::told();
    const widgets::ScopeView &view = *running.rig.window.scope();
    require(view.channels().size() >= kSignals && view.visibleRange().span() > kPicture_s - 1.0
            && view.visibleRange().to > kPicture_s + 1.0,
        "the picture does not run over all signals");
    state.counters["redraws_per_s"] =
        double(running.rig.window.scope()->redraws() - drawn) * 1e3 / kWatched_ms;
    report({"N1 stall", std::string("70 s of 8 x 20 kHz, ") + tool.name, told.longest_s * 1e3,
        "computing time of the window's thread"});
}

std::vector<widgets::ScopeEvent> eventsOf(int count)
{
    std::vector<widgets::ScopeEvent> all;
    for (int i = 0; i < count; ++i)
        all.push_back(
            {0, i * 1e-3, widgets::EventKind::Command, QStringLiteral("event %1").arg(i)});
    return all;
}

/// As opening a file brings them, and one after the other as a board does; the list is in view.
void events(benchmark::State &state)
{
    constexpr int kMany = 20'000;
    Running running;
    running.open("eventDock");
    running.rest(); // the frames of a running picture beside it are no part of it
    widgets::EventLog &log = running.rig.workbench.events();
    const auto &list = *running.rig.window.findChild<QTreeView *>(QStringLiteral("eventList"));
    const auto settled = [] {
        for (int i = 0; i < 5; ++i)
            QCoreApplication::processEvents();
    };
    const auto atOnce = [&](int count) {
        log.setEvents(eventsOf(count));
        settled();
    };
    const Pair pair = pairedRatio(
        state, [&] { atOnce(kMany); }, [&] { atOnce(2 * kMany); });
    log.clear();
    settled();
    const double start = cpuSeconds();
    for (int i = 0; i < kMany; ++i) {
        log.add(widgets::EventKind::Command, i * 1e-3, QStringLiteral("event"));
        if (i % 100 == 0)
            QCoreApplication::processEvents();
    }
    while (!list.updatesEnabled()) // until the last ones are painted, too
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    settled();
    report({"N2 events", "20000 events of a file, the list in view", pair.aSeconds, "computing"});
    report({"N2 events", "20000 events one by one", cpuSeconds() - start, "computing"});
    report({"N2 growth", "twice as many of a file", Measured::cost(pair), "20000"});
}

} // namespace

BENCHMARK(stalls)->DenseRange(0, std::size(kTools) - 1)->Iterations(1);
BENCHMARK(events)->Iterations(5)->UseManualTime();

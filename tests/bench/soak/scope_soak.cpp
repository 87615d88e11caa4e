// Minutes of a full-rate capture in the real window, in real time: five signals at 16 kHz from the simulated board inside
// the program, while a driver turns the wheel and drags the picture without a pause. Prints what was lost, what the
// memory grew by, and how long the GUI thread was away between two beats of a timer; docs/performance.md reads it.
#include "support/window_rig.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/signals/signal_selection.h"

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::array kSignals{"I_A", "I_B", "I_Q_MEAS", "I_D_MEAS", "STOPLL_EL_ANGLE"};
constexpr int kPatience_ms = 30'000;
constexpr auto kBeat = 5ms;
constexpr auto kFrame = 16ms; ///< between two acts of the hand

int failed(const char *what)
{
    std::fprintf(stderr, "scope-soak: %s\n", what);
    return 1;
}

template <class Condition>
bool until(Condition condition)
{
    return QTest::qWaitFor(condition, kPatience_ms);
}

/// Milliseconds between two beats of a timer of the GUI thread.
class Heart : public QObject {
public:
    Heart()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, [this] {
            const auto now = Clock::now();
            m_beats.push_back(std::chrono::duration<double, std::milli>(now - m_last).count());
            m_last = now;
        });
        m_timer.start(kBeat);
    }
    double quantile(double part)
    {
        std::sort(m_beats.begin(), m_beats.end());
        const auto last = static_cast<double>(m_beats.size() - 1);
        return m_beats[static_cast<std::size_t>(std::lround(part * last))];
    }
    std::size_t count() const { return m_beats.size(); }

private:
    QTimer m_timer;
    Clock::time_point m_last = Clock::now();
    std::vector<double> m_beats;
};

/// Zooms out to minutes and in to samples, drags to and fro; every act asks for a redraw.
class Hand : public QObject {
public:
    explicit Hand(facts::WindowRig &rig)
        : m_rig(rig)
        , m_plot(rig.find<QWidget>("scopePlot"))
    {
        connect(&m_timer, &QTimer::timeout, this, &Hand::act);
        m_timer.start(kFrame);
    }
    std::uint64_t acts() const { return m_acts; }

private:
    void act()
    {
        const QRect area = m_rig.window.scope()->plotRect(0);
        const QPoint middle = area.center();
        const auto step = static_cast<int>(m_acts++ % 240);
        if (step < 80) // in and out again
            turn(middle, step < 40 ? 120 : -120);
        else if (step == 80)
            mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton);
        else if (step < 239)
            mouse(QEvent::MouseMove,
                middle + QPoint(int(0.4 * area.width() * std::sin(step / 10.0)), 0), Qt::NoButton);
        else
            mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton);
    }
    void turn(const QPoint &at, int angle)
    {
        QWheelEvent wheel(at, m_plot->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
            Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_plot, &wheel);
    }
    void mouse(QEvent::Type type, const QPoint &at, Qt::MouseButton button)
    {
        const Qt::MouseButtons held =
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, m_plot->mapToGlobal(at), button, held, Qt::NoModifier);
        QApplication::sendEvent(m_plot, &event);
    }

    facts::WindowRig &m_rig;
    QWidget *m_plot;
    QTimer m_timer;
    std::uint64_t m_acts = 0;
};

/// What the process holds, in MiB; nothing where the system does not tell it in this way.
std::optional<double> residentMiB()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    for (const QByteArray &line : file.readAll().split('\n')) {
        if (line.startsWith("VmRSS:"))
            return line.mid(6).simplified().split(' ').front().toDouble() / 1024.0;
    }
    return {};
}

/// Replaces what the scope shows at first by the five signals; whether all of them stream.
bool showSignals(facts::WindowRig &rig)
{
    const auto &catalog = *rig.workbench.device().catalog();
    std::vector<catalog::RegisterId> ids;
    for (const char *name : kSignals)
        ids.push_back(catalog.resolve(name).value_or(0));
    for (const auto id : ids)
        rig.window.selection()->add(id, 0);
    for (const auto &info : rig.workbench.capture().channels()) {
        if (std::find(ids.begin(), ids.end(), info.registerId) == ids.end())
            rig.window.selection()->remove(info.registerId);
    }
    return until([&] { return rig.workbench.capture().streaming().size() == kSignals.size(); });
}

int soak(int seconds)
{
    facts::WindowRig rig;
    rig.sayYesToMotion();
    rig.window.resize(1280, 720);
    auto &device = rig.workbench.device();
    device.open(session::Endpoint{});
    if (!until([&] { return device.answering() && device.identified(); }))
        return failed("no connection");
    if (!until([&] { return rig.workbench.capture().streaming().size() > 1; }) || !showSignals(rig))
        return failed("the five signals are not recorded");
    device.setArmed(true);
    if (!until([&] { return device.armed(); }))
        return failed("not armed");
    QTest::mouseClick(rig.find<QPushButton>("start"), Qt::LeftButton);
    const auto &capture = rig.workbench.capture();
    const auto ids = capture.streaming();
    const auto samples = [&] {
        return std::accumulate(ids.begin(), ids.end(), std::uint64_t{0},
            [&](std::uint64_t sum, capture::ChannelId id) { return sum + capture.size(id); });
    };
    const auto resident = residentMiB();
    const std::size_t bytes = capture.bytes();
    const std::uint64_t before = samples();
    const auto counters = device.counters();
    const quint64 redraws = rig.window.scope()->redraws();
    const auto start = Clock::now();
    Heart heart;
    Hand hand(rig);
    QEventLoop loop;
    QTimer::singleShot(std::chrono::seconds(seconds), &loop, &QEventLoop::quit);
    loop.exec();
    const double took = std::chrono::duration<double>(Clock::now() - start).count();
    const auto after = device.counters();
    const auto taken = static_cast<double>(samples() - before);
    std::printf("%.1f s, %zu signals: %.0f samples, %.1f per second and signal\n", took, ids.size(),
        taken, taken / took / static_cast<double>(ids.size()));
    std::printf("control periods lost %llu, time-outs %llu, state %s\n",
        static_cast<unsigned long long>(after.streamLostTicks - counters.streamLostTicks),
        static_cast<unsigned long long>(after.timeouts - counters.timeouts),
        device.status(1).state == drive::MotorState::Running ? "running" : "not running");
    std::printf(
        "columns %.3f bytes a sample", static_cast<double>(capture.bytes() - bytes) / taken);
    if (const auto now = residentMiB(); now && resident)
        std::printf(", process %+.1f MiB (%.3f bytes a sample)", *now - *resident,
            (*now - *resident) * 1048576.0 / taken);
    std::printf("\n%llu acts of the hand, %.1f redraws a second\n",
        static_cast<unsigned long long>(hand.acts()),
        static_cast<double>(rig.window.scope()->redraws() - redraws) / took);
    std::printf("between beats (%zu): p50 %.1f  p99 %.1f  p99.9 %.1f  max %.1f ms\n", heart.count(),
        heart.quantile(0.5), heart.quantile(0.99), heart.quantile(0.999), heart.quantile(1.0));
    device.stop();
    device.close();
    until([&] { return !device.portOpen(); });
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    widgets::Application app(argc, argv);
    const int seconds = argc > 1 ? QString::fromLocal8Bit(argv[1]).toInt() : 600;
    return seconds > 0 ? soak(seconds) : failed("usage: rotorscope-scope-soak [SECONDS]");
}

// Minutes of a full-rate capture in the real window, in real time: five signals at 16 kHz from the simulated board
// inside the program, while a driver turns the wheel and drags the picture without a pause. Prints what was lost, what
// the memory grew by, and how long the GUI thread was away between two beats of a timer; docs/performance.md reads it.
#include "bench/soak/restless_hand.h"

#include <cstdio>
#include <numeric>

namespace {

using Clock = std::chrono::steady_clock;
using namespace bench;
using namespace std::chrono_literals;

constexpr auto kBeat = 5ms;

int failed(const char *what)
{
    std::fprintf(stderr, "scope-soak: %s\n", what);
    return 1;
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

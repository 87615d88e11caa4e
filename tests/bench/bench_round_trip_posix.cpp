// P11, first half: four bytes to a device and eight bytes back over a pseudo-terminal, through the program's own port
// in a worker thread, from there and from the GUI thread; against a thread that polls and reads. Real time, for waiting
// is what counts: the three take turns, and the median round trip of each turn is compared. POSIX only:
// pseudo-terminals.
#include "bench/paired.h"
#include "session/transports/serial_transport.h"
#include "support/pseudo_terminal.h"

#include <QEventLoop>
#include <QThread>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#ifdef __linux__
#include <sched.h>
#endif

namespace {

using namespace bench;

constexpr std::size_t kAnswer = 8; ///< bytes
constexpr int kTrips = 500; ///< a turn
const Bytes kRequest{1, 2, 3, 4};

using SteadyClock = std::chrono::steady_clock;

double micros(SteadyClock::time_point since)
{
    return std::chrono::duration<double, std::micro>(SteadyClock::now() - since).count();
}

/// Keeps this thread, and those it makes meanwhile, on one core: whether a partner is woken on the same core or on
/// another one that sleeps decides more than how it waits.
class OneCore {
public:
    OneCore()
    {
#ifdef __linux__
        ::sched_getaffinity(0, sizeof m_before, &m_before);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(static_cast<unsigned>(::sched_getcpu()), &one);
        ::sched_setaffinity(0, sizeof one, &one);
#endif
    }
    OneCore(const OneCore &) = delete;
    OneCore &operator=(const OneCore &) = delete;
    ~OneCore()
    {
#ifdef __linux__
        ::sched_setaffinity(0, sizeof m_before, &m_before);
#endif
    }

private:
#ifdef __linux__
    cpu_set_t m_before{};
#endif
};

/// Answers every four bytes that come to its terminal by eight.
class EchoDevice {
public:
    EchoDevice()
        : m_thread([this] { serve(); })
    {
    }
    EchoDevice(const EchoDevice &) = delete;
    EchoDevice &operator=(const EchoDevice &) = delete;
    ~EchoDevice()
    {
        m_end = true;
        m_thread.join();
    }
    const QString &path() const { return m_terminal.path(); }

private:
    void serve()
    {
        std::size_t bytes = 0;
        pollfd source{m_terminal.master(), POLLIN, 0};
        while (!m_end) {
            ::poll(&source, 1, 20);
            for (bytes += m_terminal.read().size(); bytes >= kRequest.size();
                 bytes -= kRequest.size())
                m_terminal.write(Bytes(kAnswer, 7));
        }
    }
    support::PseudoTerminal m_terminal;
    std::atomic<bool> m_end = false;
    std::thread m_thread;
};

/// Median round trip of a thread with poll and read, microseconds.
double pollAndRead(const EchoDevice &device)
{
    const int fd = ::open(device.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    require(fd >= 0, "the terminal does not open");
    std::vector<double> trips;
    std::thread([&] {
        pollfd source{fd, POLLIN, 0};
        std::array<std::uint8_t, 64> answer{};
        for (int i = 0; i < kTrips; ++i) {
            const auto start = SteadyClock::now();
            require(::write(fd, kRequest.data(), kRequest.size()) == ssize_t(kRequest.size()),
                "nothing was written");
            for (std::size_t got = 0; got < kAnswer;) {
                ::poll(&source, 1, 1000);
                const auto count = ::read(fd, answer.data(), answer.size());
                got += count > 0 ? static_cast<std::size_t>(count) : 0;
            }
            trips.push_back(micros(start));
        }
    }).join();
    ::close(fd);
    return quantile(trips, 0.5);
}

/// The program's port in a worker thread; the next request leaves from there or from this thread.
class PortInWorker {
public:
    explicit PortInWorker(const QString &path)
        : m_port(new session::SerialTransport(path, 1'843'200))
    {
        m_port->moveToThread(&m_worker);
        QObject::connect(&m_worker, &QThread::finished, m_port, &QObject::deleteLater);
        m_worker.start();
        session::PortProblem problem{};
        QMetaObject::invokeMethod(
            m_port, [&] { problem = m_port->open({}).problem; }, Qt::BlockingQueuedConnection);
        require(problem == session::PortProblem::None, "the port does not open");
    }
    PortInWorker(const PortInWorker &) = delete;
    PortInWorker &operator=(const PortInWorker &) = delete;
    ~PortInWorker()
    {
        m_worker.quit();
        m_worker.wait();
    }

    /// Median round trip, microseconds. @param fromHere  from the calling thread; else from the worker
    double roundTrip(bool fromHere)
    {
        std::vector<double> trips;
        SteadyClock::time_point start;
        std::size_t got = 0;
        QEventLoop loop;
        const auto send = [&] {
            start = SteadyClock::now();
            if (fromHere)
                QMetaObject::invokeMethod(m_port, [this] { m_port->write(kRequest, {}); });
            else
                m_port->write(kRequest, {});
        };
        const auto receive = [&](const QByteArray &bytes) {
            got += static_cast<std::size_t>(bytes.size());
            if (got < kAnswer)
                return;
            got = 0;
            trips.push_back(micros(start));
            if (trips.size() < kTrips)
                send();
            else
                QMetaObject::invokeMethod(&loop, &QEventLoop::quit, Qt::QueuedConnection);
        };
        // Its signal runs the lambda in the thread of the context: here, by a queued hop, or in the worker.
        const QObject *context = fromHere ? static_cast<QObject *>(&loop) : m_port;
        const auto connection = QObject::connect(
            m_port, &session::Transport::received, context, receive, Qt::AutoConnection);
        QMetaObject::invokeMethod(
            const_cast<QObject *>(context), send, Qt::QueuedConnection); // NOLINT
        loop.exec();
        QObject::disconnect(connection);
        return quantile(trips, 0.5);
    }

private:
    session::SerialTransport *m_port;
    QThread m_worker;
};

void roundTrips(benchmark::State &state)
{
    const OneCore oneCore;
    const EchoDevice plain, ported;
    PortInWorker port(ported.path());
    std::vector<double> worker, gui, polled;
    for ([[maybe_unused]] auto _ : state) {
        polled.push_back(pollAndRead(plain));
        worker.push_back(port.roundTrip(false) / polled.back());
        gui.push_back(port.roundTrip(true) / (worker.back() * polled.back()));
        state.SetIterationTime(polled.back() * 1e-6);
    }
    state.counters["poll_us"] = quantile(polled, 0.5);
    // Pinned beside a thread of the kernel, the partner takes several times as long: nothing is shown then.
    constexpr double kLeast_us = 15.0, kMost_us = 40.0;
    if (const double poll = quantile(polled, 0.5); poll < kLeast_us || poll > kMost_us) {
        leaveOut(
            "N11", "poll and read took " + std::to_string(std::lround(poll)) + " us, not 15 to 40");
        return;
    }
    report({"N11 worker", "round trip worker to device", Measured(worker),
        "a thread with poll and read"});
    report({"N11 window", "round trip GUI to worker to device and back", Measured(gui),
        "the worker alone"});
}

} // namespace

BENCHMARK(roundTrips)->Iterations(15)->UseManualTime();

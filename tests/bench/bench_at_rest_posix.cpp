// N9: what the program computes, and how often it is woken, beside a board whose motor stands: seen, hidden, and
// without a board. From the scheduler's statistics of its threads. Left out, with the reason, where these or an X
// server are missing.
#include "bench/paired.h"

#if ROTORSCOPE_HAS_X11

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <filesystem>
#include <sys/wait.h>

#include "bench/x_server_posix.h" // last: X defines words of Qt's headers

namespace {

using namespace bench;

constexpr int kSettle_ms = 6'000; ///< start, connection, and what is made behind the first picture
constexpr int kStretch_ms = 5'000;

/// Of all threads of a process, since their start.
struct Work {
    double cpu_s = 0.0;
    double wakeUps = 0.0;
};

double numberAfter(const QByteArray &text, const char *key)
{
    const qsizetype at = text.indexOf(key);
    return at < 0 ? 0.0
                  : text.mid(at + qsizetype(qstrlen(key))).trimmed().split('\n')[0].toDouble();
}

QByteArray content(const std::filesystem::path &path)
{
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Work workOf(pid_t process)
{
    Work work;
    std::error_code ended; // a thread may, while they are counted
    const auto tasks = std::filesystem::path("/proc") / std::to_string(process) / "task";
    for (const auto &task : std::filesystem::directory_iterator(tasks, ended)) {
        work.cpu_s += content(task.path() / "schedstat").split(' ')[0].toDouble() * 1e-9;
        work.wakeUps += numberAfter(content(task.path() / "status"), "\nvoluntary_ctxt_switches:");
    }
    return work;
}

struct Rest {
    double core = 0.0; ///< % of one
    double wakeUps = 0.0; ///< a second
};

void wait(const Server &server, int ms)
{
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < ms;)
        bench::pause(server.display());
}

Rest restOf(const Server &server, pid_t process)
{
    const Work before = workOf(process);
    QElapsedTimer clock;
    clock.start();
    wait(server, kStretch_ms);
    const Work after = workOf(process);
    const double seconds = double(clock.nsecsElapsed()) * 1e-9;
    return {
        (after.cpu_s - before.cpu_s) / seconds * 100.0, (after.wakeUps - before.wakeUps) / seconds};
}

QByteArray titleOf(const Server &server, Window window)
{
    Atom type{};
    int format = 0;
    unsigned long size = 0, more = 0;
    unsigned char *name = nullptr;
    XGetWindowProperty(server.display(), window, XInternAtom(server.display(), "_NET_WM_NAME", 0),
        0, 256, 0, AnyPropertyType, &type, &format, &size, &more, &name);
    const QByteArray title(reinterpret_cast<const char *>(name), static_cast<qsizetype>(size));
    XFree(name);
    return title;
}

/// The program on a home of its own, from its start to the end of this object.
class Program {
public:
    Program(const Server &server, const std::vector<QByteArray> &arguments)
        : m_server(server)
    {
        std::vector<QByteArray> words{ROTORSCOPE_BIN "/rotorscope"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        m_process = spawnOn(server, m_home.path().toLocal8Bit(), words);
        QElapsedTimer clock;
        for (clock.start(); !m_window && clock.elapsed() < kPatience_ms;
             m_window = paintedWindow(server.display()))
            bench::pause(server.display());
        require(m_window.has_value(), "the program painted no window");
        wait(server, kSettle_ms);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;
    ~Program()
    {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
    pid_t process() const { return m_process; }
    Window window() const { return *m_window; }

private:
    const Server &m_server;
    const QTemporaryDir m_home;
    pid_t m_process = 0;
    std::optional<Window> m_window;
};

void atRest(benchmark::State &state)
{
    const Server server;
    if (server.display() == nullptr || workOf(::getpid()).cpu_s <= 0.0) {
        leaveOut("N9",
            server.display() == nullptr ? "Xvfb does not run"
                                        : "the system does not say what a process computes");
        state.SkipWithError("no Xvfb, or no statistics");
        return;
    }
    QProcess board;
    board.start(QStringLiteral(ROTORSCOPE_BENCH_BOARD),
        {QStringLiteral("1843200"), QStringLiteral("16000")});
    require(board.waitForReadyRead(kPatience_ms), "the simulated board did not start");
    const QByteArray port = board.readLine().trimmed();
    std::vector<double> core, wakeUps, hidden, without;
    for ([[maybe_unused]] auto _ : state) {
        {
            const Program program(server, {"--port", port, "--connect"});
            require(titleOf(server, program.window()).contains(port), "it is not connected");
            const Rest seen = restOf(server, program.process());
            core.push_back(seen.core);
            wakeUps.push_back(seen.wakeUps);
            XUnmapWindow(server.display(), program.window());
            XSync(server.display(), False); // else it is told with the next question
            wait(server, 500);
            hidden.push_back(restOf(server, program.process()).core);
        }
        const Program alone(server, {});
        without.push_back(restOf(server, alone.process()).core);
        state.SetIterationTime(kStretch_ms * 3e-3);
    }
    board.closeWriteChannel();
    board.waitForFinished(kPatience_ms);
    report({"N9 rest", "connected, the motor stands", Measured(core), "real time"});
    report({"N9 woken", "the same, all threads", Measured(wakeUps), "real time"});
    report({"N9 hidden", "connected, not to be seen", Measured(hidden), "real time"});
    report({"N9 alone", "without a board", Measured(without), "real time"});
}

} // namespace

BENCHMARK(atRest)->Iterations(3)->UseManualTime();

#endif

// N12: what a start computes until the program rests, four seconds after its first picture on an X server, against
// PulseView in turn with it on the same server. A picture is there once half of the places looked at in a window are
// painted. Left out, with the reason, where there is no PulseView or no server of our own to start.
#include "bench/paired.h"

#if ROTORSCOPE_HAS_X11

#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <filesystem>
#include <sys/resource.h>
#include <sys/wait.h>

#include "bench/x_server_posix.h" // last: X defines words of Qt's headers

namespace {

using namespace bench;

constexpr int kRest_ms = 4'000; ///< then a program has made what is made behind its first picture

struct StartUp {
    double cpu = 0.0;
    double wall = 0.0;
};

/// A user's home as it is before the first start, the server, and a program to its first picture.
StartUp startOnce(
    const Server &server, const QByteArray &program, const std::vector<QByteArray> &moreEnvironment)
{
    const QTemporaryDir home;
    QElapsedTimer clock;
    clock.start();
    const pid_t child = spawnOn(server, home.path().toLocal8Bit(), {program}, moreEnvironment);
    while (!paintedWindow(server.display()) && clock.elapsed() < kPatience_ms)
        pause(server.display());
    const double wall = double(clock.nsecsElapsed()) * 1e-9;
    for (clock.start(); clock.elapsed() < kRest_ms;)
        pause(server.display());
    ::kill(child, SIGKILL);
    int status = 0;
    rusage use{};
    ::wait4(child, &status, 0, &use);
    require(wall * 1e3 < kPatience_ms && WIFSIGNALED(status), "a program painted no window");
    while (paintedWindow(server.display()))
        pause(server.display());
    const auto seconds = [](const timeval &time) {
        return double(time.tv_sec) + double(time.tv_usec) * 1e-6;
    };
    return {seconds(use.ru_utime) + seconds(use.ru_stime), wall};
}

/// @param variables  for PulseView, about its decoders: some hundred programs in Python
void startUp(benchmark::State &state, const std::vector<QByteArray> &variables, const char *goal,
    const char *against)
{
    const QByteArray peer =
        QStandardPaths::findExecutable(QStringLiteral("pulseview")).toLocal8Bit();
    const Server server;
    if (peer.isEmpty() || server.display() == nullptr) {
        leaveOut("N12", peer.isEmpty() ? "PulseView is not installed" : "Xvfb does not run");
        state.SkipWithError("no PulseView, or no Xvfb");
        return;
    }
    const QByteArray ours = ROTORSCOPE_BIN "/rotorscope";
    // from the disk into memory
    startOnce(server, ours, {});
    startOnce(server, peer, variables);
    std::vector<double> cpu, wall;
    for ([[maybe_unused]] auto _ : state) {
        const StartUp own = startOnce(server, ours, {});
        const StartUp other = startOnce(server, peer, variables);
        cpu.push_back(own.cpu / other.cpu);
        wall.push_back(own.wall / other.wall);
        state.counters["ours_ms"] = own.cpu * 1e3;
        state.counters["pulseview_ms"] = other.cpu * 1e3;
        state.SetIterationTime(own.cpu);
    }
    report({goal, "start until it rests", Measured(cpu), against});
    report({"N12", "start to first picture, real time", Measured(wall), against});
}

/// PulseView's decoders as Debian's package brings them: without byte code, whatever a start by root has left beside
/// them.
class Decoders {
public:
    Decoders()
    {
        namespace fs = std::filesystem;
        const fs::path from = "/usr/share/libsigrokdecode/decoders";
        const fs::path to = m_folder.path().toStdString();
        if (!fs::exists(from))
            return; // PulseView without decoders: it starts faster
        for (const fs::directory_entry &entry : fs::recursive_directory_iterator(from)) {
            const fs::path target = to / fs::relative(entry.path(), from);
            if (entry.path().extension() != ".py")
                continue;
            fs::create_directories(target.parent_path());
            fs::copy_file(entry.path(), target);
        }
    }
    QByteArray variable() const { return "SIGROKDECODE_DIR=" + m_folder.path().toLocal8Bit(); }

private:
    QTemporaryDir m_folder;
};

/// As a user's account starts it, which may not write byte code beside the package's decoders.
void startAgainstPulseView(benchmark::State &state)
{
    const Decoders decoders;
    startUp(state, {decoders.variable(), "PYTHONDONTWRITEBYTECODE=1"}, "N12 start",
        "PulseView, as a person's account starts it");
}

/// As it starts where root has started it before: the first start compiles, the others find that.
void startAgainstCompiledPulseView(benchmark::State &state)
{
    const Decoders decoders;
    startUp(state, {decoders.variable()}, "N12", "PulseView whose decoders root has compiled");
}

} // namespace

BENCHMARK(startAgainstPulseView)->Iterations(5)->UseManualTime();
BENCHMARK(startAgainstCompiledPulseView)->Iterations(5)->UseManualTime();

#endif

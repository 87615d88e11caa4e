// N12: what a start computes until the program rests, four seconds after its first picture on an X server, against PulseView
// in turn with it on the same server. A picture is there once half of the places looked at in a window are painted. Left out, with the reason, where there is no PulseView or no server of our own to start.
#include "bench/paired.h"

#if ROTORSCOPE_HAS_X11

#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace bench;

constexpr int kPatience_ms = 20'000;
constexpr int kRest_ms = 4'000; ///< then a program has made what is made behind its first picture
constexpr int kLeastSize = 300; ///< pixels: smaller windows are none to work in
constexpr int kPlaces = 8; ///< looked at in a window, across and down

/// In a child between fork and exec: it ends with this process, whatever ends that, and complains to nobody.
void prepareServer()
{
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    ::dup2(::open("/dev/null", O_RDWR), STDERR_FILENO);
}

/// A program that says nothing; it ends with its X server. Not by fork(), whose copy of this process's pages, hundreds of
/// megabytes after other benchmarks, would be part of what the program computed.
pid_t spawn(char *const *words, char *const *environment)
{
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_RDWR, 0);
    pid_t child = 0;
    const int error = posix_spawn(&child, words[0], &actions, nullptr, words, environment);
    posix_spawn_file_actions_destroy(&actions);
    require(error == 0, "a program does not start");
    return child;
}

/// An X server without a screen and without a window manager.
class Server {
public:
    Server()
    {
        m_process.setChildProcessModifier(prepareServer);
        m_process.start(QStringLiteral("Xvfb"),
            {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                QStringLiteral("0"), QStringLiteral("1920x1080x24"), QStringLiteral("-nolisten"),
                QStringLiteral("tcp")});
        if (m_process.waitForStarted() && m_process.waitForReadyRead(kPatience_ms))
            m_name = ':' + m_process.readLine().trimmed();
        if (!m_name.isEmpty())
            m_display = XOpenDisplay(m_name.constData());
        // A window can be gone between two questions about it; by default such an error ends the program.
        XSetErrorHandler([](Display *, XErrorEvent *) { return 0; });
    }
    Server(const Server &) = delete;
    Server &operator=(const Server &) = delete;
    ~Server()
    {
        if (m_display != nullptr)
            XCloseDisplay(m_display);
        m_process.terminate();
        m_process.waitForFinished(kPatience_ms);
    }
    Display *display() const { return m_display; } ///< nullptr if there is none
    const QByteArray &name() const { return m_name; }

private:
    QProcess m_process;
    QByteArray m_name;
    Display *m_display = nullptr;
};

/// Half of the places in it have another colour than the bare screen.
bool painted(Display *display, Window window, const XWindowAttributes &is)
{
    XImage *image = XGetImage(display, window, 0, 0, static_cast<unsigned>(is.width),
        static_cast<unsigned>(is.height), AllPlanes, ZPixmap);
    if (image == nullptr)
        return false;
    int bright = 0;
    for (int place = 0; place < kPlaces * kPlaces; ++place) {
        const int x = (2 * (place % kPlaces) + 1) * is.width / (2 * kPlaces);
        const int y = (2 * (place / kPlaces) + 1) * is.height / (2 * kPlaces);
        bright += (XGetPixel(image, x, y) & 0xFFFFFFU) != 0 ? 1 : 0;
    }
    XDestroyImage(image);
    return bright * 2 >= kPlaces * kPlaces;
}

/// For a millisecond, or until the server has something to say.
void pause(Display *display)
{
    pollfd server{ConnectionNumber(display), POLLIN, 0};
    ::poll(&server, 1, 1);
}

bool anyWindowPainted(Display *display)
{
    Window root{}, parent{}, *windows = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &windows, &count) == 0)
        return false;
    bool found = false;
    for (unsigned i = 0; i < count && !found; ++i) {
        XWindowAttributes is{};
        found = XGetWindowAttributes(display, windows[i], &is) != 0 && is.map_state == IsViewable
            && is.width >= kLeastSize && is.height >= kLeastSize && is.x >= 0 && is.y >= 0
            && is.x + is.width <= 1920 && is.y + is.height <= 1080
            && painted(display, windows[i], is);
    }
    if (windows != nullptr)
        XFree(windows);
    return found;
}

struct StartUp {
    double cpu = 0.0;
    double wall = 0.0;
};

/// A person's home as it is before the first start, the server, and a program to its first picture.
StartUp startOnce(
    const Server &server, QByteArray program, const std::vector<QByteArray> &moreEnvironment)
{
    const QTemporaryDir home;
    const QByteArray folder = home.path().toLocal8Bit();
    std::vector<QByteArray> environment{"DISPLAY=" + server.name(), "HOME=" + folder,
        "XDG_RUNTIME_DIR=" + folder, "QT_QPA_PLATFORM=xcb", "LC_ALL=C.UTF-8",
        "PATH=" + qgetenv("PATH")};
    environment.insert(environment.end(), moreEnvironment.begin(), moreEnvironment.end());
    std::vector<char *> variables;
    for (QByteArray &variable : environment)
        variables.push_back(variable.data());
    variables.push_back(nullptr);
    const std::array<char *, 2> words{program.data(), nullptr};
    QElapsedTimer clock;
    clock.start();
    const pid_t child = spawn(words.data(), variables.data());
    while (!anyWindowPainted(server.display()) && clock.elapsed() < kPatience_ms)
        pause(server.display());
    const double wall = double(clock.nsecsElapsed()) * 1e-9;
    for (clock.start(); clock.elapsed() < kRest_ms;)
        pause(server.display());
    ::kill(child, SIGKILL);
    int status = 0;
    rusage use{};
    ::wait4(child, &status, 0, &use);
    require(wall * 1e3 < kPatience_ms && WIFSIGNALED(status), "a program painted no window");
    while (anyWindowPainted(server.display()))
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

/// PulseView's decoders as Debian's package brings them: without byte code, whatever a start by root has left beside them.
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

/// As a person's account starts it, which may not write byte code beside the package's decoders.
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

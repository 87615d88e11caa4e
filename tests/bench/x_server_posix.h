// An X server without a screen and a program on it, watched from another process: when its window is painted.
#pragma once

#include "bench/paired.h"

#include <QByteArray>
#include <QProcess>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <csignal>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <spawn.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <unistd.h>

namespace bench {

inline constexpr int kPatience_ms = 20'000;
inline constexpr int kLeastSize = 300; ///< pixels: smaller windows are none to work in
inline constexpr int kPlaces = 8; ///< looked at in a window, across and down

/// In a child between fork and exec: it ends with this process, whatever ends that, and prints nothing.
inline void prepareServer()
{
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    ::dup2(::open("/dev/null", O_RDWR), STDERR_FILENO);
}

/// A program that says nothing; it ends with its X server. Not by fork(), whose copy of this process's pages, hundreds
/// of megabytes after other benchmarks, would be part of what the program computed.
inline pid_t spawn(char *const *words, char *const *environment)
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
inline bool painted(Display *display, Window window, const XWindowAttributes &is)
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
inline void pause(Display *display)
{
    pollfd server{ConnectionNumber(display), POLLIN, 0};
    ::poll(&server, 1, 1);
}

/// A window that stands on the screen, large enough to work in, and is painted.
inline std::optional<Window> paintedWindow(Display *display)
{
    Window root{}, parent{}, *windows = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &windows, &count) == 0)
        return {};
    std::optional<Window> found;
    for (unsigned i = 0; i < count && !found; ++i) {
        XWindowAttributes is{};
        if (XGetWindowAttributes(display, windows[i], &is) != 0 && is.map_state == IsViewable
            && is.width >= kLeastSize && is.height >= kLeastSize && is.x >= 0 && is.y >= 0
            && is.x + is.width <= 1920 && is.y + is.height <= 1080
            && painted(display, windows[i], is))
            found = windows[i];
    }
    if (windows != nullptr)
        XFree(windows);
    return found;
}

/// Starts it with a user's home as it is before the first start.
/// @param words  the program and its arguments
inline pid_t spawnOn(const Server &server, const QByteArray &home, std::vector<QByteArray> words,
    const std::vector<QByteArray> &moreEnvironment = {})
{
    std::vector<QByteArray> environment{"DISPLAY=" + server.name(), "HOME=" + home,
        "XDG_RUNTIME_DIR=" + home, "QT_QPA_PLATFORM=xcb", "LC_ALL=C.UTF-8",
        "PATH=" + qgetenv("PATH")};
    environment.insert(environment.end(), moreEnvironment.begin(), moreEnvironment.end());
    std::vector<char *> arguments, variables;
    for (QByteArray &word : words)
        arguments.push_back(word.data());
    for (QByteArray &variable : environment)
        variables.push_back(variable.data());
    arguments.push_back(nullptr);
    variables.push_back(nullptr);
    return spawn(arguments.data(), variables.data());
}

} // namespace bench

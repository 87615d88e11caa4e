// An X server without a screen, and the hands of a user on it: a pointer and keys that reach a program as any
// keyboard's and mouse's do. POSIX; needs Xvfb and xdotool.
#pragma once

#include <QByteArray>
#include <QPoint>
#include <QProcess>
#include <QStringList>

#include <array>
#include <csignal>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace support {

/// Runs as long as it lives; made before the application that is shown on it.
class XServer {
public:
    XServer()
    {
        std::array<int, 2> told{};
        if (::pipe(told.data()) != 0)
            return;
        m_process = ::fork();
        if (m_process == 0) {
            ::close(told[0]);
            // Where it writes its number, once it listens.
            const std::string number = std::to_string(told[1]);
            ::execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x800x24",
                "-nolisten", "tcp", "-noreset", static_cast<char *>(nullptr));
            ::_exit(127);
        }
        ::close(told[1]);
        for (char digit = 0; ::read(told[0], &digit, 1) == 1 && digit != '\n';)
            m_number += digit;
        m_told = told[0]; // open until the end: a server that cannot write there complains
    }
    XServer(const XServer &) = delete;
    XServer &operator=(const XServer &) = delete;
    ~XServer()
    {
        if (m_process > 0) {
            ::kill(m_process, SIGTERM);
            ::waitpid(m_process, nullptr, 0);
        }
        ::close(m_told);
    }

    bool runs() const { return !m_number.empty(); }
    QByteArray display() const { return ':' + QByteArray::fromStdString(m_number); }
    pid_t process() const { return m_process; }

private:
    pid_t m_process = -1;
    int m_told = -1;
    std::string m_number;
};

/// What xdotool does on the display of this program. Returns when the server has it, not when a window has seen it.
class Hands {
public:
    static bool move(QPoint global)
    {
        return act({QStringLiteral("mousemove"), QString::number(global.x()),
            QString::number(global.y())});
    }
    static bool press() { return act({QStringLiteral("mousedown"), QStringLiteral("1")}); }
    static bool release() { return act({QStringLiteral("mouseup"), QStringLiteral("1")}); }
    static bool key(const char *name) { return act({QStringLiteral("key"), QLatin1String(name)}); }

private:
    static bool act(const QStringList &words)
    {
        return QProcess::execute(QStringLiteral("xdotool"), words) == 0;
    }
};

} // namespace support

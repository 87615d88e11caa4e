// A pseudo-terminal for tests: the master side is this object, the slave's path is what a program opens as its port.
// POSIX only.
#pragma once

#include "base/bytes.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace support {

class PseudoTerminal {
public:
    PseudoTerminal()
        : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
    {
        ::grantpt(m_master);
        ::unlockpt(m_master);
        std::array<char, 64> path{}; // ptsname() has one for all threads
        ::ptsname_r(m_master, path.data(), path.size());
        m_path = QString::fromLocal8Bit(path.data());
        // The slave starts with an echo, and a master without any slave reads errors: so one is opened, made raw
        // and kept.
        m_slave = ::open(qPrintable(m_path), O_RDWR | O_NOCTTY | O_CLOEXEC);
        termios settings{};
        ::tcgetattr(m_slave, &settings);
        ::cfmakeraw(&settings);
        ::tcsetattr(m_slave, TCSANOW, &settings);
        ::fcntl(m_master, F_SETFL, ::fcntl(m_master, F_GETFL) | O_NONBLOCK);
    }
    PseudoTerminal(const PseudoTerminal &) = delete;
    PseudoTerminal &operator=(const PseudoTerminal &) = delete;
    ~PseudoTerminal() { unplug(); }

    const QString &path() const { return m_path; }
    int master() const { return m_master; }

    void write(ByteView bytes) { m_written += ::write(m_master, bytes.data(), bytes.size()); }
    Bytes read()
    {
        Bytes bytes(65536);
        const auto count = ::read(m_master, bytes.data(), bytes.size());
        bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return bytes;
    }
    /// What pulling the cable does.
    void unplug()
    {
        for (int *fd : {&m_slave, &m_master}) {
            if (*fd >= 0)
                ::close(*fd);
            *fd = -1;
        }
    }

    /// From then on the master hears the end of the last program that has the port open.
    void closeSlave()
    {
        ::close(m_slave);
        m_slave = -1;
    }

private:
    int m_master = -1;
    int m_slave = -1;
    ssize_t m_written = 0;
    QString m_path;
};

} // namespace support

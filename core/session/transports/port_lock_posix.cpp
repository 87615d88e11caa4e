#include "session/transports/port_lock.h"

#include "session/link/guardian.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/serial.h>
#endif

namespace session {

PortProblem problemOf(int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return PortProblem::NoPermission;
    case EBUSY:
    case EWOULDBLOCK:
        return PortProblem::Busy;
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case EIO:
        return PortProblem::NotFound;
    default:
        return PortProblem::Other;
    }
}

namespace {

PortError errorOf(int error, const QString &path)
{
    const PortProblem problem = problemOf(error);
    if (problem == PortProblem::Busy)
        return {problem, portHolder(path)};
    return {problem, QString::fromLocal8Bit(std::strerror(error))};
}

} // namespace

PortLock::~PortLock() { release(); }

PortError PortLock::acquire(const QString &path)
{
    release();
    // No controlling terminal, no waiting for a carrier, nothing inherited by programs started
    // later.
    m_fd = ::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (m_fd < 0)
        return errorOf(errno, path);
    if (::isatty(m_fd) == 0 && !isSpiPath(path)) {
        release();
        return {PortProblem::NotFound, QString()};
    }
    if (::flock(m_fd, LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        release();
        return errorOf(error, path);
    }
    return {};
}

void PortLock::release()
{
    if (m_fd < 0)
        return;
    ::flock(m_fd, LOCK_UN);
    ::close(m_fd);
    m_fd = -1;
}

QString portHolder(const QString &path)
{
    QString guardian; // whose program has ended, or is the one to name
    const QStringList pids =
        QDir(QStringLiteral("/proc")).entryList({QStringLiteral("[0-9]*")}, QDir::Dirs);
    for (const QString &pid : pids) {
        const QDir fds(QStringLiteral("/proc/%1/fd").arg(pid));
        const QFileInfoList entries =
            fds.entryInfoList(QDir::Files | QDir::System | QDir::NoDotAndDotDot);
        for (const QFileInfo &entry : entries) {
            if (entry.symLinkTarget() != path)
                continue;
            QFile name(QStringLiteral("/proc/%1/comm").arg(pid));
            if (!name.open(QIODevice::ReadOnly))
                return {};
            const QString comm = QString::fromLocal8Bit(name.readLine(64)).trimmed();
            const QString holder = QStringLiteral("%1 (pid %2)").arg(comm, pid);
            if (comm != QLatin1String(Guardian::kName))
                return holder;
            guardian = holder;
        }
    }
    return guardian;
}

PortHealth checkPort(qintptr handle)
{
    const int fd = static_cast<int>(handle);
    pollfd state{.fd = fd, .events = 0, .revents = 0};
    PortHealth health;
    if (::poll(&state, 1, 0) > 0)
        health.hungUp = (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
    int count = 0;
    health.inputWaiting = ::ioctl(fd, FIONREAD, &count) == 0 && count > 0;
    count = 0;
    health.outputWaiting = ::ioctl(fd, TIOCOUTQ, &count) == 0 && count > 0;
    return health;
}

void askForLowLatency(qintptr handle)
{
#ifdef __linux__
    const int fd = static_cast<int>(handle);
    serial_struct settings{};
    if (::ioctl(fd, TIOCGSERIAL, &settings) != 0 || (settings.flags & ASYNC_LOW_LATENCY) != 0)
        return;
    settings.flags |= ASYNC_LOW_LATENCY;
    ::ioctl(fd, TIOCSSERIAL, &settings);
#else
    Q_UNUSED(handle);
#endif
}

} // namespace session

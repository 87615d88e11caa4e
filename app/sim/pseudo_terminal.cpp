// POSIX pseudo-terminals. The far end is closed while no client is there, so that the hang-up tells whether one is
// present; its raw mode stays as long as our end is open.
#include "pseudo_terminal.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace sim {

namespace {

std::string reason(const std::string &what) { return what + ": " + std::strerror(errno); }

/// Where a symbolic link points to; nothing if the path is none.
std::string linkTarget(const std::string &path)
{
    std::array<char, 256> target{};
    const ssize_t size = readlink(path.c_str(), target.data(), target.size());
    return size > 0 ? std::string(target.data(), static_cast<std::size_t>(size)) : std::string();
}

bool makeRaw(const char *path)
{
    const int fd = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (fd < 0)
        return false;
    termios settings{};
    bool done = tcgetattr(fd, &settings) == 0;
    if (done) {
        cfmakeraw(&settings);
        settings.c_cc[VMIN] = 1;
        settings.c_cc[VTIME] = 0;
        done = tcsetattr(fd, TCSANOW, &settings) == 0;
    }
    ::close(fd);
    return done;
}

} // namespace

PseudoTerminal::~PseudoTerminal() { ::close(m_master); }

Result<std::unique_ptr<Port>, std::string> PseudoTerminal::open()
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0)
        return fail(reason("no pseudo-terminal"));
    std::unique_ptr<PseudoTerminal> terminal(new PseudoTerminal(master));
    if (grantpt(master) != 0 || unlockpt(master) != 0)
        return fail(reason("no pseudo-terminal"));
    const char *path = ptsname(master);
    if (path == nullptr || !makeRaw(path))
        return fail(reason("no raw pseudo-terminal"));
    terminal->m_path = path;
    fcntl(master, F_SETFD, FD_CLOEXEC);
    fcntl(master, F_SETFL, O_NONBLOCK);
    return terminal;
}

bool PseudoTerminal::clientPresent()
{
    pollfd state{m_master, POLLIN, 0};
    ::poll(&state, 1, 0);
    const bool hungUp = (state.revents & POLLHUP) != 0 && (state.revents & POLLIN) == 0;
    if (hungUp && m_present)
        tcflush(m_master, TCIOFLUSH);
    m_present = !hungUp;
    return m_present;
}

Bytes PseudoTerminal::read()
{
    Bytes bytes;
    std::array<std::uint8_t, 4096> piece{};
    const ssize_t count = ::read(m_master, piece.data(), piece.size());
    if (count > 0)
        bytes.assign(piece.begin(), piece.begin() + count);
    return bytes;
}

void PseudoTerminal::write(ByteView bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = ::write(m_master, bytes.data(), bytes.size());
        if (count <= 0)
            return;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

Result<SymbolicLink, std::string> SymbolicLink::make(
    const std::string &path, const std::string &target)
{
    // Only what an earlier simulator left behind makes room; any other link stays.
    if (linkTarget(path).starts_with("/dev/"))
        unlink(path.c_str());
    if (symlink(target.c_str(), path.c_str()) != 0)
        return fail(reason("cannot make the link " + path));
    SymbolicLink link;
    link.m_path = path;
    link.m_target = target;
    return link;
}

SymbolicLink::SymbolicLink(SymbolicLink &&other) noexcept
    : m_path(std::exchange(other.m_path, {}))
    , m_target(std::move(other.m_target))
{
}

SymbolicLink &SymbolicLink::operator=(SymbolicLink &&other) noexcept
{
    std::swap(m_path, other.m_path);
    std::swap(m_target, other.m_target);
    return *this;
}

SymbolicLink::~SymbolicLink()
{
    if (m_path.empty())
        return;
    // Only while it is still ours: a later simulator may have taken the name over.
    if (linkTarget(m_path) == m_target)
        unlink(m_path.c_str());
}

} // namespace sim

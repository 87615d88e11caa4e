#include "interrupt.h"

#include <QSocketNotifier>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace cli {

namespace {

constexpr std::size_t kMost = 4; ///< that wait for signals at once, each in a thread of its own

/// A signal handler may do next to nothing: it writes the signal's number into each pipe. -1: no pipe.
std::array<std::atomic<int>, kMost> g_pipes{-1, -1, -1, -1};

void onSignal(int number)
{
    const int before = errno;
    const auto byte = static_cast<unsigned char>(number);
    for (const auto &pipe : g_pipes) {
        if (const int end = pipe.load(); end >= 0) {
            [[maybe_unused]] const auto written = ::write(end, &byte, 1);
        }
    }
    errno = before;
}

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

} // namespace

Interrupt::Interrupt(QObject *parent)
    : QObject(parent)
{
    if (::pipe(m_pipe.data()) != 0)
        return;
    for (const int end : m_pipe) {
        ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::fcntl(end, F_SETFL, O_NONBLOCK);
    }
    auto *notifier = new QSocketNotifier(m_pipe[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this] {
        unsigned char number = 0;
        while (::read(m_pipe[0], &number, 1) == 1)
            raise(number);
    });
    for (auto &pipe : g_pipes)
        if (int none = -1; pipe.compare_exchange_strong(none, m_pipe[1]))
            break;
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int number : kSignals)
        ::sigaction(number, &action, nullptr);
}

const char *Interrupt::help() { return "Ctrl-C stops the motor that this run started."; }

Interrupt::~Interrupt()
{
    for (auto &pipe : g_pipes)
        if (int mine = m_pipe[1]; mine >= 0)
            pipe.compare_exchange_strong(mine, -1);
    const auto waits = [](const std::atomic<int> &pipe) { return pipe.load() >= 0; };
    if (std::none_of(g_pipes.begin(), g_pipes.end(), waits))
        for (const int number : kSignals)
            std::signal(number, SIG_DFL);
    for (const int end : m_pipe)
        if (end >= 0)
            ::close(end);
}

void Interrupt::raise(int number)
{
    if (m_number == 0)
        m_number = number;
    Q_EMIT raised();
}

} // namespace cli

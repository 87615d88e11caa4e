// rotorscope-sim: a simulated board behind a pseudo-terminal or a TCP port, in real time. One thread waits for the
// client, for standard input, for a signal and for the board's next event.
#include "describe.h"
#include "lists.h"
#include "options.h"
#include "pseudo_terminal.h"
#include "served.h"
#include "tcp_port.h"

#include "base/terminal_text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <string>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace {

constexpr int kDone = 0, kUsage = 2, kNoPort = 5;
constexpr Duration kIdleStep = std::chrono::milliseconds(5); ///< how soon a new client is noticed
/// A board looks for a header every 0.5 ms: behind twice that it may have missed the pause.
constexpr Duration kLate = std::chrono::milliseconds(1);

int g_signalPipe = -1; ///< written by the signal handler

void onSignal(int)
{
    const int before = errno;
    const char byte = 0;
    [[maybe_unused]] const ssize_t sent = write(g_signalPipe, &byte, 1);
    errno = before;
}

/// The board's time: real time without the stretches in which this program was stopped, for a board cannot make up
/// for an hour at once.
class Clock {
public:
    TimePoint now()
    {
        const auto real = std::chrono::steady_clock::now().time_since_epoch();
        const auto step = std::chrono::duration_cast<Duration>(real - m_last);
        m_last = real;
        m_now += step < kLongestStep ? step : kStopped;
        return m_now;
    }

private:
    static constexpr Duration kLongestStep = std::chrono::seconds(1);
    static constexpr Duration kStopped = 2 * kLate; ///< what such a stretch counts
    std::chrono::steady_clock::duration m_last{};
    TimePoint m_now{};
};

void say(int descriptor, const std::string &text)
{
    [[maybe_unused]] const ssize_t sent = write(descriptor, text.data(), text.size());
}

/// One sentence. What it quotes of options, files and words may come from anywhere.
void sayError(const std::string &sentence)
{
    say(STDERR_FILENO, "rotorscope-sim: " + terminalText(sentence) + '\n');
}

/// The read end of a pipe that becomes readable on SIGTERM, SIGINT and SIGHUP; -1 if there is none.
int catchSignals()
{
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0)
        return -1;
    for (const int end : ends) {
        fcntl(end, F_SETFD, FD_CLOEXEC);
        fcntl(end, F_SETFL, O_NONBLOCK);
    }
    g_signalPipe = ends[1];
    struct sigaction action { };
    action.sa_handler = onSignal;
    for (const int number : {SIGTERM, SIGINT, SIGHUP})
        sigaction(number, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    return ends[0];
}

/// Bytes keep their time only if this program is woken at once. Where that is not allowed it runs as others do.
void askForPromptness()
{
    sched_param priority{};
    priority.sched_priority = sched_get_priority_min(SCHED_FIFO) + 1;
    sched_setscheduler(0, SCHED_FIFO, &priority);
#ifdef __linux__
    prctl(PR_SET_TIMERSLACK, 1UL);
#endif
}

class Simulator {
public:
    Simulator(const sim::Served &served, sim::Port &port, bool control, int signals)
        : m_served(served)
        , m_device(*served.device)
        , m_port(port)
        , m_control(control)
        , m_signals(signals)
    {
    }

    void run()
    {
        m_device.advance(m_clock.now());
        while (!m_ended)
            step();
    }

private:
    void step();
    void receive(const Bytes &bytes, TimePoint now);
    void wait(bool present, std::array<pollfd, 3> &sources);
    void readWords();

    const sim::Served &m_served;
    simulation::ByteDevice &m_device;
    sim::Port &m_port;
    bool m_control;
    int m_signals;
    bool m_ended = false;
    std::string m_line;
    Clock m_clock;
    TimePoint m_looked{}; ///< at the line, before now
};

void Simulator::wait(bool present, std::array<pollfd, 3> &sources)
{
    // poll() passes over negative descriptors.
    sources[0] = {m_signals, POLLIN, 0};
    sources[1] = {m_control ? STDIN_FILENO : -1, POLLIN, 0};
    sources[2] = {present ? m_port.descriptor() : -1, POLLIN, 0};
    const TimePoint now = m_clock.now();
    const Duration left =
        std::clamp(present ? m_device.nextWake() - now : kIdleStep, Duration(0), kIdleStep);
    const timespec timeout{0, left.count()};
    ppoll(sources.data(), sources.size(), &timeout, nullptr);
}

void Simulator::step()
{
    const bool present = m_port.clientPresent();
    std::array<pollfd, 3> sources{};
    wait(present, sources);
    const TimePoint now = m_clock.now();
    if (sources[0].revents != 0)
        m_ended = true;
    if (present && sources[2].revents != 0)
        receive(m_port.read(), now);
    m_device.advance(now);
    m_looked = now;
    if (sources[1].revents != 0)
        readWords();
    const Bytes output = m_device.takeOutput();
    if (present && !output.empty())
        m_port.write(output);
}

/// While this program had no core the line went on: what it reads in one piece then may have been sent with its pause,
/// which a real board would have seen.
void Simulator::receive(const Bytes &bytes, TimePoint now)
{
    const bool late = now - m_looked >= kLate && bytes.size() > m_device.headerBytes();
    const ByteView all = bytes;
    const std::size_t before = late ? m_device.headerBytes() : 0;
    m_device.receive(all.first(before), m_looked);
    m_device.receive(all.subspan(before), now);
}

void Simulator::readWords()
{
    std::array<char, 4096> piece{};
    const ssize_t count = read(STDIN_FILENO, piece.data(), piece.size());
    if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) {
        m_ended = true;
        return;
    }
    for (ssize_t i = 0; i < count && !m_ended; ++i) {
        if (piece[static_cast<std::size_t>(i)] != '\n') {
            if (m_line.size() < 65536)
                m_line.push_back(piece[static_cast<std::size_t>(i)]);
            continue;
        }
        const auto obeyed = m_served.obey(m_line);
        m_line.clear();
        if (!obeyed)
            sayError(obeyed.error());
        else if (*obeyed == sim::Obeyed::Quit)
            m_ended = true;
    }
}

int serve(const sim::Options &options)
{
    const auto served = options.serve(options);
    if (!served) {
        sayError(served.error());
        return kUsage;
    }
    const auto port = options.tcp ? sim::TcpPort::open(*options.tcp) : sim::PseudoTerminal::open();
    if (!port) {
        sayError(port.error());
        return kNoPort;
    }
    sim::SymbolicLink link;
    if (!options.link.empty()) {
        auto made = sim::SymbolicLink::make(options.link, (*port)->address());
        if (!made) {
            sayError(made.error());
            return kNoPort;
        }
        link = std::move(*made);
    }
    const int signals = catchSignals();
    askForPromptness();
    say(STDOUT_FILENO, "ready " + (*port)->address() + '\n');
    Simulator(*served, **port, options.control, signals).run();
    return kDone;
}

/// What is printed instead of serving.
std::string listing(const sim::Options &options)
{
    switch (options.action) {
    case sim::Action::Help:
        return std::string(sim::helpText());
    case sim::Action::ListLiars:
        return sim::liarList();
    case sim::Action::ListProfiles:
        return sim::profileList();
    case sim::Action::ListOptions:
        return sim::optionList();
    case sim::Action::ListMotors:
        return sim::motorList();
    case sim::Action::Describe:
        return sim::describe(options.board);
    case sim::Action::Serve:
        break;
    }
    return {};
}

} // namespace

int main(int argc, char **argv)
{
    const auto options = sim::readOptions({argv + std::min(argc, 1), argv + argc});
    if (!options) {
        sayError(options.error());
        return kUsage;
    }
    if (options->action == sim::Action::Serve)
        return serve(*options);
    say(STDOUT_FILENO, listing(*options));
    return kDone;
}

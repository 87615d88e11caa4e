// The child process, and the hooks of the program. What runs in the child, in a signal handler
// or at exit() allocates nothing and takes no lock.
#include "session/link/guardian.h"

#include "session/link/stop_page_posix.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/socket.h>
#include <syslog.h>
#include <termios.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace session {

namespace {

/// A computer that stood still as a whole is given so long to stamp before it counts as frozen.
constexpr int kSecondThought_ms = 50;
constexpr int kLook_ms = 200; ///< how often the child looks whether a motor is driven
constexpr int kCrashRepetitions = 2, kExitRepetitions = 3;

/// What the program sends to the child; with a descriptor if there is a port.
struct Word {
    std::uint32_t port{};
};

// Of this program's hooks; a handler has nowhere else to look.
StopPage *hookPage = nullptr;
std::atomic<int> hookPort{-1};
std::atomic<std::uint32_t> hookPortNumber{0};
std::atomic<bool> hookUsed{false};
constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};
std::array<struct sigaction, kCrashes.size()> actionsBefore;

// ---- the child ------------------------------------------------------------------------------------------------------

void say(std::string_view words)
{
    [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, words.data(), words.size());
    ::syslog(LOG_WARNING, "%.*s", static_cast<int>(words.size()), words.data());
}

class Child {
public:
    Child(StopPage &page, int program)
        : m_page(page)
        , m_program(program)
    {
    }

    void run()
    {
        for (;;) {
            pollfd program{m_program, POLLIN, {}};
            ::poll(&program, 1, wait_ms());
            if (program.revents != 0 && !listen()) {
                if (driven())
                    act("rotorscope: the program ended while it drove a motor; its guardian stops "
                        "all motors\n");
                return;
            }
            if (program.revents == 0 && frozen())
                act("rotorscope: the program froze while it drove a motor; its guardian stops all "
                    "motors\n");
        }
    }

private:
    bool driven() const { return m_port >= 0 && m_page.driven.load() != 0; }
    Nanoseconds left() const
    {
        return m_page.stamp.load() + Guardian::kFrozenAfter / std::chrono::nanoseconds(1)
            - monotonicNow();
    }
    int wait_ms() const
    {
        if (m_port < 0)
            return -1;
        if (!driven())
            return kLook_ms;
        return static_cast<int>(std::clamp<Nanoseconds>(left() / kMillisecond + 1, 1, 10'000));
    }
    bool frozen() const
    {
        if (!driven() || left() > 0)
            return false;
        pauseFor(kSecondThought_ms * kMillisecond);
        return driven() && left() <= 0;
    }
    void act(std::string_view words)
    {
        m_page.stopping.store(m_number);
        say(words);
        stopMotors(m_page, m_port, Guardian::kRepetitions);
        ::tcflush(m_port, TCIFLUSH); // answers that are not waited for
        accept(-1);
        m_page.stopped.store(m_number);
    }
    void accept(int port)
    {
        if (m_port >= 0)
            ::close(m_port);
        m_port = port;
    }
    /// False: the program has ended.
    bool listen()
    {
        Word word;
        iovec data{&word, sizeof word};
        alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
        msghdr message{};
        message.msg_iov = &data;
        message.msg_iovlen = 1;
        message.msg_control = control.data();
        message.msg_controllen = control.size();
        const ssize_t count = ::recvmsg(m_program, &message, 0);
        if (count != ssize_t{sizeof word})
            return count < 0 && (errno == EINTR || errno == EAGAIN);
        int port = -1;
        const cmsghdr *header = CMSG_FIRSTHDR(&message);
        if (header != nullptr && header->cmsg_type == SCM_RIGHTS)
            std::memcpy(&port, CMSG_DATA(header), sizeof port);
        accept(port);
        m_number = word.port;
        return true;
    }

    StopPage &m_page;
    int m_program;
    int m_port = -1;
    std::uint32_t m_number = 0;
};

/// Of a terminal's signals, and of a session's end, the child hears nothing: it ends with the program. It holds nothing
/// of it but standard error.
void runChild(StopPage &page, int program)
{
    ::setsid();
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGUSR1, SIGUSR2})
        ::signal(number, SIG_IGN);
#ifdef __linux__
    ::prctl(PR_SET_NAME, Guardian::kName);
#endif
    [[maybe_unused]] const int moved = ::chdir("/");
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    constexpr int kMostInherited = 256;
    for (int descriptor = STDERR_FILENO + 1; descriptor < kMostInherited; ++descriptor)
        if (descriptor != program)
            ::close(descriptor);
    Child(page, program).run();
}

// ---- the program ----------------------------------------------------------------------------------------------------

/// From the program itself, which is about to end.
void stopFromHere(int repetitions)
{
    const int port = hookPort.load();
    if (hookPage == nullptr || port < 0 || hookPage->driven.load() == 0 || hookUsed.exchange(true))
        return;
    hookPage->stopping.store(hookPortNumber.load()); // the session sends nothing any more
    stopMotors(*hookPage, port, repetitions);
}

void onCrash(int number)
{
    stopFromHere(kCrashRepetitions);
    for (std::size_t i = 0; i < kCrashes.size(); ++i)
        if (kCrashes[i] == number)
            ::sigaction(number, &actionsBefore[i], nullptr);
    ::raise(number);
}

void onExit() { stopFromHere(kExitRepetitions); }

void installHooks(StopPage &page)
{
    hookPage = &page;
    // A stack that has run over needs another one.
    static std::array<char, 1 << 16> stack;
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    ::sigaltstack(&other, nullptr);
    struct sigaction action { };
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < kCrashes.size(); ++i)
        ::sigaction(kCrashes[i], &action, &actionsBefore[i]);
    std::atexit(onExit);
}

class Program final : public Guardian {
public:
    Program(StopPage &page, int child)
        : m_page(page)
        , m_child(child)
    {
    }
    ~Program() override
    {
        letGo();
        ::close(m_child);
    }

    void watch(int descriptor) override
    {
        hookPortNumber.store(++m_number);
        hookPort.store(descriptor);
        send(descriptor);
    }
    void letGo() override { watch(-1); }
    void setScript(const std::vector<Output> &script, std::uint32_t baud) override;
    void setDriven(bool driven) override
    {
        stamp();
        m_page.driven.store(driven ? 1 : 0);
    }
    void stamp() override { m_page.stamp.store(monotonicNow()); }
    Act act() const override
    {
        return m_number == 0                     ? Act::None
            : m_page.stopped.load() == m_number  ? Act::Stopped
            : m_page.stopping.load() == m_number ? Act::Stopping
                                                 : Act::None;
    }

private:
    void send(int descriptor);

    StopPage &m_page;
    int m_child;
    std::uint32_t m_number = 0; ///< of the port
};

void Program::send(int descriptor)
{
    Word word{m_number};
    iovec data{&word, sizeof word};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    msghdr message{};
    message.msg_iov = &data;
    message.msg_iovlen = 1;
    if (descriptor >= 0) {
        message.msg_control = control.data();
        message.msg_controllen = control.size();
        cmsghdr *header = CMSG_FIRSTHDR(&message);
        header->cmsg_level = SOL_SOCKET;
        header->cmsg_type = SCM_RIGHTS;
        header->cmsg_len = CMSG_LEN(sizeof descriptor);
        std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
    }
    ::sendmsg(m_child, &message, MSG_NOSIGNAL); // a child that is gone guards nothing
}

void Program::setScript(const std::vector<Output> &script, std::uint32_t baud)
{
    StopScript next;
    std::size_t used = 0;
    Duration before{};
    for (const Output &output : script) {
        if (next.parts == kMostParts || used + output.bytes.size() > kMostBytes)
            break;
        StopScript::Part &part = next.part[next.parts++];
        part.pause_us = static_cast<std::uint32_t>(
            (output.gapBefore + before) / std::chrono::microseconds(1) + 1);
        part.size = static_cast<std::uint16_t>(output.bytes.size());
        std::copy(
            output.bytes.begin(), output.bytes.end(), next.bytes.begin() + std::ptrdiff_t(used));
        used += output.bytes.size();
        before = wireTime(output.bytes.size(), baud);
    }
    const std::uint32_t published = m_page.scripts.load(std::memory_order_relaxed);
    if (std::memcmp(&m_page.script[published & 1U], &next, sizeof next) == 0)
        return;
    m_page.script[(published + 1) & 1U] = next;
    m_page.scripts.store(published + 1, std::memory_order_release);
}

} // namespace

std::shared_ptr<Guardian> startGuardian(const char *&why)
{
    void *memory = ::mmap(
        nullptr, sizeof(StopPage), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    std::array<int, 2> ends{};
    if (memory == MAP_FAILED || ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
        why = "no guardian: the system gives no memory or no socket for it";
        return nullptr;
    }
    auto &page = *new (memory) StopPage;
    const pid_t child = ::fork();
    if (child == 0) {
        runChild(page, ends[1]);
        ::_exit(0);
    }
    ::close(ends[1]);
    ::fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    if (child < 0) {
        ::close(ends[0]);
        why = "no guardian: the system makes no process for it";
        return nullptr;
    }
    installHooks(page);
    return std::make_shared<Program>(page, ends[0]);
}

} // namespace session

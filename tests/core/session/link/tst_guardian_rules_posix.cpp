// What a guardian does on its line, for each way in which a program may end or go on: how often the script leaves, in
// what rhythm, and who still has the port. The programs are forked here and have nothing but a guardian; all live at
// once. The whole programs, at random instants, are in tst_guardian_posix.
#include "session/link/guardian.h"
#include "session/link/stop_page_posix.h"
#include "support/pseudo_terminal.h"

#include <QtTest>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstring>
#include <deque>
#include <dlfcn.h>
#include <functional>
#include <map>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#ifdef __linux__
#include <linux/spi/spidev.h>
#include <sys/prctl.h>
#endif

using namespace session;
using namespace std::chrono_literals;

namespace {

using RealClock = std::chrono::steady_clock;
using RealInstant = RealClock::time_point;

constexpr std::uint32_t kLineBaud = 1'843'200;
const Bytes kHead{'A', 'B'}, kBody{'C', 'D', 'E'};
const std::vector<Output> kScript{{kHead, 0ms}, {kBody, 10ms}};

/// What is noted across processes.
struct Notes {
    std::atomic<int> transfers{0}, bytes{0};
    std::array<char, 64> sent{};
};
Notes *notes = nullptr;

} // namespace

/// A SPI bus that notes what it is given; all else is the system's.
// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name): the library's are reserved names
extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept
{
    va_list more;
    va_start(more, request);
    void *data = va_arg(more, void *);
    va_end(more);
#ifdef __linux__
    if (request == SPI_IOC_MESSAGE(1) && notes != nullptr) {
        spi_ioc_transfer transfer{};
        std::memcpy(&transfer, data, sizeof transfer);
        const auto *from =
            reinterpret_cast<const char *>(static_cast<std::uintptr_t>(transfer.tx_buf));
        const int at = notes->bytes.fetch_add(static_cast<int>(transfer.len));
        for (unsigned i = 0; i < transfer.len && at + int(i) < int(notes->sent.size()); ++i)
            notes->sent[static_cast<std::size_t>(at) + i] = from[i];
        if (transfer.rx_buf != 0)
            ++notes->transfers;
        return 0;
    }
#endif
    return static_cast<int>(::syscall(SYS_ioctl, descriptor, request, data));
}

namespace {

/// What a line does with what is written to it, in order: takes so many bytes, or fails with that error.
struct Answer {
    ssize_t taken = 0;
    int error = 0;
};
std::deque<Answer> *lineAnswers = nullptr; ///< while the test itself writes
int writesOfNothing = 0, polls = 0, pollResult = 0;

} // namespace

// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name)
extern "C" ssize_t write(int delineAnswersor, const void *bytes, std::size_t size)
{
    if (lineAnswers == nullptr)
        return ::syscall(SYS_write, delineAnswersor, bytes, size);
    writesOfNothing += size == 0 ? 1 : 0;
    if (lineAnswers->empty())
        return ::syscall(SYS_write, delineAnswersor, bytes, size);
    const Answer answer = lineAnswers->front();
    lineAnswers->pop_front();
    if (answer.error == 0) {
        errno = EAGAIN; // of a call before it
        return ::syscall(SYS_write, delineAnswersor, bytes,
            std::min(size, static_cast<std::size_t>(answer.taken)));
    }
    errno = answer.error;
    return -1;
}

// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name)
extern "C" int poll(pollfd *files, nfds_t count, int wait_ms)
{
    if (lineAnswers == nullptr)
        return static_cast<int>(::syscall(SYS_poll, files, count, wait_ms));
    polls += count == 1 ? 1 : 0;
    return pollResult;
}

bool forkFails = false;

/// A system that has no process to give.
extern "C" pid_t fork() noexcept
{
    static const auto real = reinterpret_cast<pid_t (*)()>(::dlsym(RTLD_NEXT, "fork"));
    return forkFails ? -1 : real();
}

namespace {

void pauseUntil(RealInstant when)
{
    pauseFor(std::chrono::nanoseconds(when - RealClock::now()).count());
}

std::vector<pid_t> childrenOf(pid_t process)
{
    std::vector<pid_t> pids;
    QFile file(QStringLiteral("/proc/%1/task/%1/children").arg(process));
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray &child : file.readAll().simplified().split(' '))
            if (!child.isEmpty())
                pids.push_back(child.toInt());
    return pids;
}

/// How often a process went to sleep.
int wakesOf(pid_t process)
{
    QFile file(QStringLiteral("/proc/%1/status").arg(process));
    if (!file.open(QIODevice::ReadOnly))
        return -1;
    const QByteArray text = file.readAll();
    const qsizetype at = text.indexOf("\nvoluntary_ctxt_switches:");
    return at < 0 ? -1 : text.mid(text.indexOf(':', at) + 1).trimmed().split('\n').first().toInt();
}

/// What the system says of a process, from its state on; empty: there is none.
QByteArrayList statOf(pid_t process)
{
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray text = file.readAll();
    return text.mid(text.lastIndexOf(')') + 2).split(' ');
}

/// Hundredths of a second that a process has run.
int ranOf(pid_t process)
{
    const QByteArrayList words = statOf(process);
    return words.isEmpty() ? -1 : words.at(11).toInt() + words.at(12).toInt();
}

bool lives(pid_t process)
{
    const QByteArrayList words = statOf(process);
    return !words.isEmpty() && words.front() != "Z";
}

// Of a program whose own handler was there before the guardian's: it says what the guardian knows by then, and exits.
const Guardian *known = nullptr;
int knownTold = -1;
void tellAndExit(int)
{
    const char word = "nst"[static_cast<int>(known->act())];
    [[maybe_unused]] const ssize_t count = ::write(knownTold, &word, 1);
    ::exit(5);
}

/// Until there is no stack left.
int useUp(int depth)
{
    std::array<volatile char, 4096> room{};
    room[0] = static_cast<char>(depth);
    return depth < 0 ? 0 : useUp(depth + 1) + room[0];
}

/// A line, and a program that has it and does something with a guardian.
class Life {
public:
    using Held = std::shared_ptr<Guardian>;
    using Deed = std::function<void(Held &, int port, int told)>;

    explicit Life(const Deed &deed, int port = -1)
    {
        [[maybe_unused]] const int made = ::pipe2(m_errors.data(), O_CLOEXEC | O_NONBLOCK)
            + ::pipe2(m_told.data(), O_CLOEXEC | O_NONBLOCK);
        const int own =
            ::open(qPrintable(m_terminal.path()), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        m_pid = ::fork();
        if (m_pid == 0) {
            for (const int one : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
                ::dup2(m_errors[1], one);
            m_terminal.closeSlave();
            for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
                ::signal(number, SIG_DFL); // those of Qt's tests ask a debugger first
            ::signal(SIGILL, tellAndExit);
            stack_t none{}; // that of Qt's tests
            none.ss_flags = SS_DISABLE;
            ::sigaltstack(&none, nullptr);
            const char *why = nullptr;
            Held guardian = startGuardian(why);
            deed(guardian, port >= 0 ? port : own, m_told[1]);
            ::_exit(0);
        }
        for (const int end : {own, m_errors[1], m_told[1]})
            ::close(end);
        m_terminal.closeSlave();
    }
    Life(const Life &) = delete;
    Life &operator=(const Life &) = delete;
    ~Life()
    {
        ::kill(m_pid, SIGKILL);
        if (!m_status)
            ::waitpid(m_pid, nullptr, 0);
        ::close(m_errors[0]);
        ::close(m_told[0]);
    }

    void look()
    {
        const RealInstant now = RealClock::now();
        const Bytes in = m_terminal.read();
        if (!in.empty())
            pieces.emplace_back(now, in);
        pollfd line{m_terminal.master(), POLLIN, 0};
        if (::poll(&line, 1, 0) > 0 && (line.revents & POLLHUP) != 0 && !letGo)
            letGo = now; // the port is closed everywhere
        std::array<char, 256> text{};
        for (ssize_t count = 0; (count = ::read(m_errors[0], text.data(), text.size())) > 0;)
            said.append(text.data(), static_cast<qsizetype>(count));
        for (ssize_t count = 0; (count = ::read(m_told[0], text.data(), text.size())) > 0;)
            told.append(text.data(), static_cast<qsizetype>(count));
        int status = 0;
        if (!m_status && ::waitpid(m_pid, &status, WNOHANG) == m_pid) {
            m_status = status;
            ended = now;
        }
    }
    QByteArray all() const
    {
        QByteArray bytes;
        for (const auto &piece : pieces)
            bytes.append(reinterpret_cast<const char *>(piece.second.data()),
                static_cast<qsizetype>(piece.second.size()));
        return bytes;
    }
    Duration first() const { return pieces.empty() ? Duration{} : pieces.front().first - begun; }
    Duration since(std::optional<RealInstant> when) const
    {
        return when ? *when - begun : Duration(1h);
    }
    std::optional<int> status() const { return m_status; }
    pid_t pid() const { return m_pid; }

    RealInstant begun = RealClock::now();
    std::optional<RealInstant> ended, letGo;
    std::vector<std::pair<RealInstant, Bytes>> pieces;
    QByteArray said, told;

private:
    support::PseudoTerminal m_terminal;
    std::array<int, 2> m_errors{}, m_told{};
    pid_t m_pid = -1;
    std::optional<int> m_status;
};

void drive(Guardian &guardian, int port, const std::vector<Output> &script = kScript)
{
    guardian.setScript(script, kLineBaud);
    guardian.watch(port);
    guardian.setDriven(true);
}

std::vector<Output> parts(int count, std::size_t size)
{
    return std::vector<Output>(static_cast<std::size_t>(count), {Bytes(size, 'x'), 0ms});
}

using Held = Life::Held;
const std::map<QByteArray, Life::Deed> kDeeds{
    {"killed",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::raise(SIGKILL);
        }},
    {"frozen",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::raise(SIGSTOP);
        }},
    {"wakes",
        [](Held &g, int port, int told) {
            const auto tell = [&] {
                const char word = "nst"[static_cast<int>(g->act())];
                [[maybe_unused]] const ssize_t count = ::write(told, &word, 1);
            };
            tell();
            drive(*g, port);
            tell();
            const RealInstant began = RealClock::now();
            for (const Duration time : {2900ms, 4000ms, 5500ms}) {
                pauseUntil(began + time);
                tell();
            }
            g->setDriven(false);
            g->watch(port); // again: nothing was done with that one
            tell();
        }},
    {"stamps",
        [](Held &g, int port, int) {
            drive(*g, port);
            for (int i = 0; i < 8; ++i) {
                pauseFor(500 * kMillisecond);
                g->stamp();
            }
            g->setDriven(false);
            ::raise(SIGKILL);
        }},
    {"drives nothing",
        [](Held &g, int port, int) {
            g->setScript(kScript, kLineBaud);
            g->watch(port);
            pauseFor(3500 * kMillisecond); // without a stamp
            ::raise(SIGKILL);
        }},
    {"has let go",
        [](Held &g, int port, int) {
            drive(*g, port);
            g->letGo();
            ::close(port);
            pauseFor(4 * kSecond);
            ::abort();
        }},
    {"exits",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::exit(3);
        }},
    {"exits at rest",
        [](Held &g, int port, int) {
            g->setScript(kScript, kLineBaud);
            g->watch(port);
            ::exit(3);
        }},
    {"no port",
        [](Held &g, int, int) {
            g->setScript(kScript, kLineBaud);
            g->setDriven(true);
            ::exit(4);
        }},
    {"another script",
        [](Held &g, int port, int) {
            drive(*g, port, parts(1, 4));
            for (const char last : {'z', 'z', 'y'})
                g->setScript({{Bytes{static_cast<std::uint8_t>(last)}, 0ms}}, kLineBaud);
            ::raise(SIGKILL);
        }},
    {"many parts",
        [](Held &g, int port, int) {
            drive(*g, port, parts(60, 1));
            ::raise(SIGKILL);
        }},
    {"as many parts as there may be",
        [](Held &g, int port, int) {
            drive(*g, port, parts(48, 1));
            ::raise(SIGKILL);
        }},
    {"many bytes",
        [](Held &g, int port, int) {
            drive(*g, port, parts(3, 512));
            ::raise(SIGKILL);
        }},
    {"slow line",
        [](Held &g, int port, int) {
            g->setScript({{Bytes(48, 'x'), 0ms}, {Bytes{'y'}, 10ms}, {Bytes{'z'}, 0ms}}, 9600);
            g->watch(port);
            g->setDriven(true);
            ::raise(SIGKILL);
        }},
    {"another port",
        [](Held &g, int port, int) {
            std::array<int, 2> before{};
            [[maybe_unused]] const int made = ::pipe(before.data());
            drive(*g, before[1]);
            pauseFor(100 * kMillisecond);
            g->letGo(); // which is no end
            g->watch(port);
            ::raise(SIGKILL);
        }},
    {"SIGSEGV",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::raise(SIGSEGV);
        }},
    {"SIGABRT",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::abort();
        }},
    {"SIGFPE at rest",
        [](Held &g, int port, int) {
            g->setScript(kScript, kLineBaud);
            g->watch(port);
            ::raise(SIGFPE);
        }},
    {"SIGILL with a handler of its own",
        [](Held &g, int port, int told) {
            known = g.get();
            knownTold = told;
            drive(*g, port);
            ::raise(SIGILL);
        }},
    {"no stack left",
        [](Held &g, int port, int) {
            drive(*g, port);
            ::_exit(useUp(0));
        }},
    {"has started another program",
        [](Held &g, int port, int) {
            drive(*g, port);
            if (::fork() == 0)
                ::execl("/bin/sleep", "sleep", "2", nullptr);
            pauseFor(100 * kMillisecond);
            ::raise(SIGKILL);
        }},
    {"speaks while its guardian acts",
        [](Held &g, int port, int told) {
            drive(*g, port);
            pauseFor(3300 * kMillisecond);
            const RealInstant began = RealClock::now();
            for (int i = 0; i < 2000; ++i)
                g->letGo();
            const char word = RealClock::now() - began < 500ms ? 'q' : 's';
            [[maybe_unused]] const ssize_t count = ::write(told, &word, 1);
        }},
    {"left for good",
        [](Held &g, int port, int) {
            drive(*g, port);
            g.reset(); // as a session's end does
            pauseFor(300 * kMillisecond);
            ::close(port);
            pauseFor(4 * kSecond);
            ::_exit(0);
        }},
};

} // namespace

class TestGuardianRules : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { m_lives.clear(); }

    void theScriptLeavesSoOften_data();
    void theScriptLeavesSoOften();
    void aKilledProgramIsActedForAtOnceAndInARhythm();
    void aFrozenProgramIsActedForAfterThreeSeconds();
    void whoWakesUpKnowsWhatWasDone();
    void aBusyGuardianKeepsNobody();
    void theEndStaysWhatItWas();
    void whatIsLetGoIsLetGo();
    void theGuardianHoldsNothingOfItsProgram();
    void theLastScriptCounts();
    void aScriptIsCutAtAWholePart();
    void pausesAreKeptOnASlowLine();
    void noGuardianIsLeftBehindItsProgram() { QCOMPARE(m_left, 0); }
    void aGuardianSleeps();
    void aSpiBusIsNoStream();
    void aFullLineKeepsNobody();
    void whatStillWaitsToLeaveIsTakenBack();
    void pausesAreWhole();
    void withoutMeansThereIsNone();

private:
    Life &life(const char *name) { return *m_lives.at(name); }
    std::map<QByteArray, std::unique_ptr<Life>> m_lives;
    QMap<QByteArray, QString> m_ofGuardian;
    std::unique_ptr<Life> m_spi;
    int m_left = 0, m_wakes = -1, m_ran = -1;
    bool m_dismissed = false;
};

void TestGuardianRules::initTestCase()
{
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    notes = new (::mmap(
        nullptr, sizeof(Notes), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Notes;
    const RealInstant began = RealClock::now();
    for (const auto &[name, deed] : kDeeds)
        m_lives[name] = std::make_unique<Life>(deed);
    std::array<int, 2> bus{};
    [[maybe_unused]] const int made = ::pipe2(bus.data(), O_CLOEXEC | O_NONBLOCK);
    m_spi = std::make_unique<Life>(kDeeds.at("killed"), bus[1]);
    const Life &frozen = life("frozen");
    std::vector<pid_t> guardian;
    for (RealInstant now = began; now < began + 6500ms; now = RealClock::now()) {
        for (auto &one : m_lives)
            one.second->look();
        m_spi->look();
        if (guardian.empty() && now > began + 1s) {
            guardian = childrenOf(frozen.pid());
            QCOMPARE(guardian.size(), 1U);
            const QString proc = QStringLiteral("/proc/%1/").arg(guardian[0]);
            const auto linkOf = [&](const char *name) {
                return QFileInfo(proc + QLatin1String(name)).symLinkTarget();
            };
            for (const char *name : {"cwd", "fd/0", "fd/1"})
                m_ofGuardian[name] = linkOf(name);
            QFile comm(proc + QStringLiteral("comm"));
            if (comm.open(QIODevice::ReadOnly))
                m_ofGuardian["comm"] = QString::fromLocal8Bit(comm.readAll());
            m_ofGuardian["fds"] = QString::number(
                QDir(proc + QStringLiteral("fd")).entryList(QDir::Files | QDir::System).size());
            m_ofGuardian["session"] = QString::number(::getsid(guardian[0]) == guardian[0]);
            for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGUSR1, SIGUSR2})
                ::kill(guardian[0], number);
        }
        if (m_wakes < 0 && now > began + 2800ms) {
            const auto guardianOf = [&](const char *name) {
                return childrenOf(life(name).pid()).at(0);
            };
            m_wakes = wakesOf(guardianOf("drives nothing"));
            for (const char *name : {"drives nothing", "has let go", "frozen"})
                m_ran = std::max(m_ran, ranOf(guardianOf(name)));
            const auto left = childrenOf(life("left for good").pid());
            m_dismissed = std::none_of(left.begin(), left.end(), lives);
        }
        pollfd none{-1, 0, 0};
        ::poll(&none, 1, 1);
    }
    std::array<char, 64> text{};
    QVERIFY(::read(bus[0], text.data(), text.size()) <= 0);
    for (const pid_t child : childrenOf(::getpid())) { // orphans come here
        const bool program = child == m_spi->pid()
            || std::any_of(m_lives.begin(), m_lives.end(),
                [child](const auto &one) { return one.second->pid() == child; });
        if (!program && ::waitpid(child, nullptr, WNOHANG) == 0) {
            ++m_left;
            ::kill(child, SIGKILL);
        }
    }
}

void TestGuardianRules::theScriptLeavesSoOften_data()
{
    QTest::addColumn<int>("times");
    for (const auto &[name, times] :
        std::initializer_list<std::pair<const char *, int>>{{"killed", 20}, {"frozen", 20},
            {"wakes", 20}, {"stamps", 0}, {"drives nothing", 0}, {"has let go", 0}, {"exits", 23},
            {"exits at rest", 0}, {"no port", 0}, {"another port", 20}, {"SIGSEGV", 22},
            {"SIGABRT", 22}, {"SIGILL with a handler of its own", 22}, {"no stack left", 22},
            {"SIGFPE at rest", 0}, {"left for good", 0}})
        QTest::newRow(name) << times;
}

void TestGuardianRules::theScriptLeavesSoOften()
{
    QFETCH(const int, times);
    QCOMPARE(life(QTest::currentDataTag()).all(), QByteArray("ABCDE").repeated(times));
}

void TestGuardianRules::aKilledProgramIsActedForAtOnceAndInARhythm()
{
    Life &killed = life("killed");
    QVERIFY(killed.ended && killed.letGo);
    QVERIFY(killed.pieces.front().first - *killed.ended < 500ms);
    const Duration lasted = *killed.letGo - killed.pieces.front().first;
    // Twenty in a rhythm of 100 ms; on a busy machine the first is seen late.
    QVERIFY2(lasted > 1500ms && lasted < 3s, qPrintable(QString::number(lasted.count())));
    std::vector<Duration> gaps;
    for (std::size_t i = 1; i < killed.pieces.size(); ++i)
        gaps.push_back(killed.pieces[i].first - killed.pieces[i - 1].first);
    std::nth_element(gaps.begin(), gaps.begin() + 9, gaps.end());
    QVERIFY(killed.pieces.size() >= 30); // in parts, with their pauses
    QVERIFY(gaps[9] > 8ms && gaps[9] < 40ms);
    QVERIFY(killed.said.contains("the program ended while it drove a motor"));
    // Programs that it had started hold nothing of the guardian's.
    QVERIFY(life("has started another program").first() < 1500ms);
}

void TestGuardianRules::aFrozenProgramIsActedForAfterThreeSeconds()
{
    Life &frozen = life("frozen");
    QVERIFY(frozen.said.contains("the program froze while it drove a motor"));
    QVERIFY2(frozen.first() > 3050ms && frozen.first() < 3800ms,
        qPrintable(QString::number(frozen.first().count())));
    QVERIFY(life("stamps").said.isEmpty());
    QVERIFY(life("drives nothing").said.isEmpty());
}

void TestGuardianRules::whoWakesUpKnowsWhatWasDone()
{
    QCOMPARE(life("wakes").told, QByteArray("nnnstn"));
    QCOMPARE(life("SIGILL with a handler of its own").told, QByteArray("s"));
}

void TestGuardianRules::aBusyGuardianKeepsNobody()
{
    QCOMPARE(life("speaks while its guardian acts").told, QByteArray("q"));
}

void TestGuardianRules::theEndStaysWhatItWas()
{
    const auto signalOf = [&](const char *name) {
        const int status = life(name).status().value_or(0);
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    };
    QCOMPARE(signalOf("SIGSEGV"), SIGSEGV);
    QCOMPARE(signalOf("SIGABRT"), SIGABRT);
    QCOMPARE(signalOf("SIGFPE at rest"), SIGFPE);
    const auto codeOf = [&](const char *name) { return WEXITSTATUS(*life(name).status()); };
    QCOMPARE(codeOf("exits"), 3);
    QCOMPARE(codeOf("exits at rest"), 3);
    QCOMPARE(codeOf("no port"), 4);
    QCOMPARE(codeOf("SIGILL with a handler of its own"), 5);
    QCOMPARE(signalOf("no stack left"), SIGSEGV);
}

void TestGuardianRules::whatIsLetGoIsLetGo()
{
    QVERIFY(life("has let go").since(life("has let go").letGo) < 2s);
    QVERIFY(life("left for good").since(life("left for good").letGo) < 2s);
    for (const char *name : {"exits at rest", "SIGFPE at rest"}) // nothing is held behind them
        QVERIFY(life(name).since(life(name).letGo) < 2s);
    QVERIFY(life("has let go").said.isEmpty());
    QVERIFY(life("left for good").said.isEmpty());
    QVERIFY(m_dismissed);
    // A sanitizer may have its own word at the end of a program.
    const QByteArray said = life("no port").said;
    QVERIFY2(!said.contains("the program"), said.constData());
}

void TestGuardianRules::theGuardianHoldsNothingOfItsProgram()
{
    QCOMPARE(m_ofGuardian["comm"].trimmed(), QLatin1String(Guardian::kName));
    QCOMPARE(m_ofGuardian["cwd"], QStringLiteral("/"));
    QCOMPARE(m_ofGuardian["fd/0"], QStringLiteral("/dev/null"));
    QCOMPARE(m_ofGuardian["fd/1"], QStringLiteral("/dev/null"));
    QCOMPARE(m_ofGuardian["session"], QStringLiteral("1"));
    // Three, its socket and the port; the one to the log comes when there is something to say.
    QCOMPARE(m_ofGuardian["fds"], QStringLiteral("5"));
}

/// Without a port it waits for a word, with one it looks now and then, and while a motor is driven it waits for the
/// stamp.
void TestGuardianRules::aGuardianSleeps()
{
    QVERIFY(m_wakes > 10 && m_wakes < 100);
    QVERIFY2(m_ran >= 0 && m_ran < 10, qPrintable(QString::number(m_ran)));
}

void TestGuardianRules::theLastScriptCounts()
{
    QCOMPARE(life("another script").all(), QByteArray("y").repeated(20));
}

void TestGuardianRules::aScriptIsCutAtAWholePart()
{
    QCOMPARE(life("many parts").all().size(), 20 * 48);
    QCOMPARE(life("as many parts as there may be").all().size(), 20 * 48);
    QCOMPARE(life("many bytes").all().size(), 20 * 1024);
}

void TestGuardianRules::pausesAreKeptOnASlowLine()
{
    const Life &slow = life("slow line");
    QCOMPARE(slow.all(), (QByteArray(48, 'x') + "yz").repeated(20));
    std::vector<Duration> gaps;
    for (std::size_t i = 1; i < slow.pieces.size(); ++i)
        if (slow.pieces[i].second.front() == 'y')
            gaps.push_back(slow.pieces[i].first - slow.pieces[i - 1].first);
    QVERIFY(gaps.size() > 10);
    std::sort(gaps.begin(), gaps.end());
    const Duration usual = gaps[gaps.size() / 2]; // 50 ms for the bytes, and the pause behind them
    QVERIFY2(usual > 58ms && usual < 80ms, qPrintable(QString::number(usual.count())));
}

void TestGuardianRules::aSpiBusIsNoStream()
{
    QCOMPARE(notes->bytes.load(), 20 * 5);
    QCOMPARE(notes->transfers.load(), 20 * 2);
    QCOMPARE(QByteArray(notes->sent.data(), 10), QByteArray("ABCDEABCDE"));
}

void TestGuardianRules::aFullLineKeepsNobody()
{
    struct Row {
        std::deque<Answer> answers;
        int room = 0; ///< what poll() says
        const char *left = "";
        int polls = 0;
    };
    const Row rows[] = {
        {{}, 1, "ABCDE", 0},
        {{{1, 0}, {3, 0}}, 1, "ABCDE", 0}, // in pieces
        {{{-1, EAGAIN}, {2, 0}, {-1, EINTR}}, 1, "ABCDE", 2}, // there is room again
        {{{2, 0}, {-1, EAGAIN}}, 0, "AB", 1}, // none in time: the next repetition tries again
        {{{-1, EAGAIN}}, -1, "", 1},
        {{{1, 0}, {-1, EIO}}, 1, "A", 0}, // the cable is gone
        {{{1, 0}, {0, 0}}, 1, "A", 0},
    };
    for (const Row &row : rows) {
        support::PseudoTerminal line;
        const int port =
            ::open(qPrintable(line.path()), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        StopPage page;
        page.script[0].parts = 1;
        page.script[0].part[0].size = 5;
        std::copy_n("ABCDE", 5, page.script[0].bytes.begin());
        std::deque<Answer> open = row.answers;
        polls = 0;
        pollResult = row.room;
        lineAnswers = &open;
        stopMotors(page, port, 1);
        lineAnswers = nullptr;
        QCOMPARE(polls, row.polls);
        QVERIFY(open.empty());
        pollfd come{line.master(), POLLIN, 0};
        if (*row.left != 0)
            QCOMPARE(::poll(&come, 1, 1000), 1);
        const Bytes in = line.read();
        QCOMPARE(QByteArray(reinterpret_cast<const char *>(in.data()), qsizetype(in.size())),
            QByteArray(row.left));
        ::close(port);
    }
    QCOMPARE(writesOfNothing, 0);
}

void TestGuardianRules::whatStillWaitsToLeaveIsTakenBack()
{
    support::PseudoTerminal line;
    const int port = ::open(qPrintable(line.path()), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    const Bytes earlier(4096, 'e');
    std::ptrdiff_t written = 0;
    for (ssize_t count = 0; (count = ::write(port, earlier.data(), earlier.size())) > 0;)
        written += count;
    stopMotors(StopPage{}, port, 1);
    for (Bytes in = line.read(); !in.empty(); in = line.read())
        written -= std::count(in.begin(), in.end(), 'e');
    QVERIFY(written > 0);
    ::close(port);
}

void TestGuardianRules::pausesAreWhole()
{
    const auto clock = [] {
        return std::chrono::nanoseconds(RealClock::now().time_since_epoch()).count();
    };
    for (int i = 0; i < 3; ++i) {
        const Nanoseconds before = clock(), now = monotonicNow();
        QVERIFY(before <= now && now <= clock());
        pauseFor(-kSecond);
        pauseFor(kSecond / 3);
        QVERIFY(monotonicNow() - before >= kSecond / 3);
        QVERIFY(monotonicNow() - before < kSecond);
    }
    struct sigaction action { };
    action.sa_handler = [](int) {};
    ::sigaction(SIGALRM, &action, nullptr);
    const itimerval often{{0, 20'000}, {0, 20'000}}, never{};
    const Nanoseconds begun = monotonicNow();
    ::setitimer(ITIMER_REAL, &often, nullptr);
    pauseFor(200 * kMillisecond); // signals do not cut it short
    const Nanoseconds took = monotonicNow() - begun;
    ::setitimer(ITIMER_REAL, &never, nullptr);
    QVERIFY(took >= 200 * kMillisecond);
}

/// It says why, and keeps nothing.
void TestGuardianRules::withoutMeansThereIsNone()
{
    const auto descriptors = [] {
        return QDir(QStringLiteral("/proc/self/fd")).entryList(QDir::Files | QDir::System).size();
    };
    const auto before = descriptors();
    const char *why = nullptr;
    rlimit usual{};
    ::getrlimit(RLIMIT_NOFILE, &usual);
    const rlimit none{0, usual.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    const auto socketless = startGuardian(why);
    ::setrlimit(RLIMIT_NOFILE, &usual);
    QVERIFY(!socketless);
    QCOMPARE(why, "no guardian: the system gives no memory or no socket for it");
    forkFails = true;
    const auto childless = startGuardian(why);
    forkFails = false;
    QVERIFY(!childless);
    QCOMPARE(why, "no guardian: the system makes no process for it");
    QCOMPARE(descriptors(), before);
}

QTEST_GUILESS_MAIN(TestGuardianRules)
#include "tst_guardian_rules_posix.moc"

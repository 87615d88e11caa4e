// Programs that die or freeze while they drive a motor: STOP is on the wire soon, the motor stops, and the port is
// free. A board behind a pseudo-terminal hears every byte and says when it came. The long form, with ROTORSCOPE_LONG,
// is a thousand random instants in several lanes and prints a table; with ROTORSCOPE_PART, so many per cent of them.
#include "aspep/packet.h"
#include "support/link_pair.h"
#include "support/places.h"
#include "support/pseudo_terminal.h"

#include <QtTest>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <map>
#include <mutex>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <thread>

extern char **environ;

class TestGuardian : public QObject {
    Q_OBJECT
public:
    static void initMain()
    {
        if (qEnvironmentVariableIsSet("ROTORSCOPE_LONG"))
            qputenv("QTEST_FUNCTION_TIMEOUT", "7200000"); // ms; the usual one is five minutes
    }
private Q_SLOTS:
    void whateverEndsTheProgramStopsTheMotor();
    void whoWakesUpSendsNothingAndIsDisarmed();
    void nothingIsSentWhenNothingWasDriven();
    void whatWasLeftRunningGoesOn_data();
    void whatWasLeftRunningGoesOn();
    void theGuardianIsGoneBehindANormalEnd();
};

namespace {

using namespace std::chrono_literals;
using SteadyClock = std::chrono::steady_clock;
using Instant = SteadyClock::time_point;

constexpr auto kLong = 60s;
constexpr std::uint32_t kBaud = 1'843'200;
const Bytes kStartWords{0x19, 0x00}, kStop{0x21, 0x00}; ///< of motor 1

Bytes packetOf(const Bytes &payload)
{
    const auto header =
        aspep::encodeHeader(aspep::Data{false, static_cast<std::uint16_t>(payload.size())});
    Bytes packet(header.begin(), header.end());
    packet.insert(packet.end(), payload.begin(), payload.end());
    return packet;
}

/// What a wire does and a pseudo-terminal does not: the pauses of the sender stay between its bytes. Read late, a
/// header and its payload come at once, and a board that meets them so loses the payload, as a real one does.
class Wire {
public:
    explicit Wire(std::uint32_t baud)
        : m_byteTime(wireTime(1, baud))
    {
    }
    void put(ByteView bytes, TimePoint now)
    {
        for (const std::uint8_t byte : bytes) {
            m_piece.push_back(byte);
            if (m_payload > 0 ? m_piece.size() == m_payload : m_piece.size() == aspep::kHeaderSize)
                finish(now);
        }
    }
    /// A piece that is there by now, and when it came.
    std::optional<std::pair<TimePoint, Bytes>> take(TimePoint now)
    {
        if (m_due.empty() || m_due.front().first > now)
            return std::nullopt;
        auto piece = std::move(m_due.front());
        m_due.pop_front();
        return piece;
    }

private:
    static constexpr Duration kBeforePayload = 1500us, kBetweenPackets = 2ms;

    void finish(TimePoint now)
    {
        if (std::exchange(m_payload, 0) > 0)
            return leave(kBeforePayload, m_piece.size(), now);
        aspep::HeaderBytes bytes{};
        std::copy_n(m_piece.begin(), bytes.size(), bytes.begin());
        const auto header = aspep::decodeHeader(bytes);
        if (!header)
            return leave({}, 1, now); // behind a packet that was cut
        if (const auto *data = std::get_if<aspep::Data>(&*header))
            m_payload = data->length;
        const bool again = bytes == std::exchange(m_before, bytes);
        leave(again ? Duration{} : kBetweenPackets, bytes.size(), now);
    }
    void leave(Duration gap, std::size_t size, TimePoint now)
    {
        const auto end = m_piece.begin() + static_cast<std::ptrdiff_t>(size);
        const TimePoint at = std::max(now, m_free + gap);
        m_free = at + static_cast<int>(size) * m_byteTime;
        m_due.emplace_back(at, Bytes(m_piece.begin(), end));
        m_piece.erase(m_piece.begin(), end);
    }

    Duration m_byteTime;
    Bytes m_piece;
    std::size_t m_payload = 0; ///< what is awaited; 0: a header
    aspep::HeaderBytes m_before{};
    TimePoint m_free{};
    std::deque<std::pair<TimePoint, Bytes>> m_due;
};

/// A simulated board behind a pseudo-terminal. It is heard what comes, and when, by a thread that does nothing else:
/// the board's own may be busy with its motor.
class HeardBoard {
public:
    HeardBoard()
        : m_board(simulation::makeBoard({}))
        , m_listener([this] { listen(); })
        , m_thread([this] { run(); })
    {
    }
    HeardBoard(const HeardBoard &) = delete;
    HeardBoard &operator=(const HeardBoard &) = delete;
    ~HeardBoard() { end(); }

    QString port() const { return m_terminal.path(); }

    /// When the first such packet came behind `since`; nothing if none does until `until`.
    std::optional<Instant> heard(const Bytes &payload, Instant since, Instant until)
    {
        std::unique_lock lock(m_lock);
        const Bytes packet = packetOf(payload);
        std::optional<Instant> at;
        m_changed.wait_until(lock, until, [&] { return (at = find(packet, since)).has_value(); });
        return at;
    }
    void waitUntil(Instant until)
    {
        std::unique_lock lock(m_lock);
        m_changed.wait_until(lock, until, [] { return false; });
    }
    /// The port is free: the lock can be had.
    bool free() const
    {
        const int port = ::open(qPrintable(port_()), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
        const bool locked = port >= 0 && ::flock(port, LOCK_EX | LOCK_NB) == 0;
        ::close(port);
        return locked;
    }
    bool freeUntil(Instant until)
    {
        while (!free() && SteadyClock::now() < until)
            waitUntil(SteadyClock::now() + 10ms);
        return free();
    }
    /// What came around that time, and each start and stop: a line for what was read at once.
    QString account(Instant around)
    {
        const std::lock_guard lock(m_lock);
        QString lines;
        for (auto piece = m_times.begin(); piece != m_times.end(); ++piece) {
            const auto next = std::next(piece);
            const std::size_t end = next == m_times.end() ? m_bytes.size() : next->first;
            const Bytes bytes(m_bytes.begin() + static_cast<std::ptrdiff_t>(piece->first),
                m_bytes.begin() + static_cast<std::ptrdiff_t>(end));
            const auto holds = [&bytes](const Bytes &what) {
                return std::search(bytes.begin(), bytes.end(), what.begin(), what.end())
                    != bytes.end();
            };
            const double at =
                std::chrono::duration<double, std::milli>(piece->second - around).count();
            if ((at > -150.0 && at < 400.0) || holds(kStartWords) || holds(kStop))
                lines += QStringLiteral("%1 ms  ").arg(at, 9, 'f', 1)
                    + QString::fromLatin1(QByteArray(reinterpret_cast<const char *>(bytes.data()),
                        static_cast<qsizetype>(std::min<std::size_t>(bytes.size(), 40)))
                                              .toHex(' '))
                    + QLatin1Char('\n');
        }
        return lines;
    }
    /// The board alone, behind all: what its motor does. No program may be on the line any more.
    bool motorRuns()
    {
        end();
        support::LinkPair pair;
        pair.now = TimePoint(SteadyClock::now() - m_began);
        pair.board = std::move(m_board);
        pair.connect();
        pair.runUntil([&] { return pair.status.contains(1); }, 20s);
        return pair.status[1].state == drive::MotorState::Running
            || pair.status[1].state == drive::MotorState::Starting;
    }

private:
    QString port_() const { return m_terminal.path(); }
    std::optional<Instant> find(const Bytes &packet, Instant since) const
    {
        for (auto at = m_bytes.begin();;) {
            at = std::search(at, m_bytes.end(), packet.begin(), packet.end());
            if (at == m_bytes.end())
                return std::nullopt;
            const auto last = static_cast<std::size_t>(at - m_bytes.begin()) + packet.size();
            const auto time = std::prev(m_times.upper_bound(last - 1))->second;
            if (time >= since)
                return time;
            ++at;
        }
    }
    void listen()
    {
        pollfd line{m_terminal.master(), POLLIN, 0};
        while (!m_end) {
            ::poll(&line, 1, 20);
            const Bytes in = m_terminal.read();
            if (in.empty())
                continue;
            const std::lock_guard lock(m_lock);
            m_times[m_bytes.size()] = SteadyClock::now();
            m_bytes.insert(m_bytes.end(), in.begin(), in.end());
            m_changed.notify_all();
        }
    }
    void run()
    {
        Wire wire(kBaud);
        for (std::size_t taken = 0; !m_end;) {
            Bytes in;
            {
                std::unique_lock lock(m_lock);
                m_changed.wait_for(lock, 1ms, [&] { return m_bytes.size() > taken; });
                in.assign(m_bytes.begin() + static_cast<std::ptrdiff_t>(taken), m_bytes.end());
                taken = m_bytes.size();
            }
            const TimePoint now(SteadyClock::now() - m_began);
            wire.put(in, now);
            while (const auto piece = wire.take(now))
                m_board->receive(piece->second, piece->first);
            m_board->advance(now);
            if (const Bytes out = m_board->takeOutput(); !out.empty())
                m_terminal.write(out);
        }
    }
    void end()
    {
        m_end = true;
        for (std::thread *thread : {&m_listener, &m_thread})
            if (thread->joinable())
                thread->join();
    }

    support::PseudoTerminal m_terminal;
    std::unique_ptr<simulation::SimulatedBoard> m_board;
    Instant m_began = SteadyClock::now();
    std::mutex m_lock;
    std::condition_variable m_changed;
    Bytes m_bytes;
    std::map<std::size_t, Instant> m_times; ///< of what came at once, by its first byte
    std::atomic<bool> m_end{false};
    std::thread m_listener, m_thread;
};

/// A process that is killed behind the test.
class Program {
public:
    Program(const QStringList &line, const QStringList &environment, int inherited = -1)
    {
        std::vector<QByteArray> words, variables;
        for (const QString &word : line)
            words.push_back(word.toLocal8Bit());
        for (char **one = environ; *one != nullptr; ++one)
            if (!QByteArray(*one).startsWith("QT_QPA_PLATFORM=")
                && !QByteArray(*one).startsWith("DISPLAY="))
                variables.emplace_back(*one);
        for (const QString &one : environment)
            variables.push_back(one.toLocal8Bit());
        posix_spawn_file_actions_t files{};
        ::posix_spawn_file_actions_init(&files);
        [[maybe_unused]] const int made = ::pipe(m_pipe.data());
        for (const int end : m_pipe)
            ::fcntl(end, F_SETFD, FD_CLOEXEC);
        ::posix_spawn_file_actions_adddup2(&files, m_pipe[1], STDOUT_FILENO);
        if (inherited >= 0)
            ::posix_spawn_file_actions_adddup2(&files, inherited, 9);
        m_errors.open();
        if (!qEnvironmentVariableIsSet("ROTORSCOPE_TEST_LOUD"))
            ::posix_spawn_file_actions_adddup2(&files, m_errors.handle(), STDERR_FILENO);
        auto argv = pointersTo(words), envp = pointersTo(variables);
        if (::posix_spawn(&m_pid, argv[0], &files, nullptr, argv.data(), envp.data()) != 0)
            m_pid = -1;
        ::posix_spawn_file_actions_destroy(&files);
        ::close(m_pipe[1]);
    }
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;
    ~Program()
    {
        signal(SIGKILL);
        (void)wait();
        ::close(m_pipe[0]);
    }

    void signal(int number) const
    {
        if (m_pid > 0)
            ::kill(m_pid, number);
    }
    /// Until it has ended. @return  status as waitpid() gives it
    int wait()
    {
        while (m_pid > 0 && ::waitpid(m_pid, &m_status, 0) < 0 && errno == EINTR) { }
        m_pid = -1;
        return m_status;
    }
    /// Reads what it says until those words, or its end.
    bool says(const QByteArray &words)
    {
        std::array<char, 256> piece{};
        while (!m_said.contains(words)) {
            pollfd more{m_pipe[0], POLLIN, 0};
            if (::poll(&more, 1, 30'000) <= 0)
                return false;
            const ssize_t count = ::read(m_pipe[0], piece.data(), piece.size());
            if (count <= 0)
                return false;
            m_said.append(piece.data(), static_cast<qsizetype>(count));
        }
        return true;
    }
    const QByteArray &said() const { return m_said; }
    /// Of it and of its guardian, on standard error.
    QByteArray complaints()
    {
        m_errors.seek(0);
        return m_errors.readAll();
    }

private:
    static std::vector<char *> pointersTo(std::vector<QByteArray> &texts)
    {
        std::vector<char *> pointers;
        for (QByteArray &text : texts)
            pointers.push_back(text.data());
        pointers.push_back(nullptr);
        return pointers;
    }
    pid_t m_pid = -1;
    int m_status = 0;
    std::array<int, 2> m_pipe{-1, -1};
    QByteArray m_said;
    QTemporaryFile m_errors;
};

/// An X server of its own.
class Screen {
public:
    Screen()
    {
        static std::mutex oneAtATime; // two that look for a free number at once may both fail
        const std::lock_guard lock(oneAtATime);
        std::array<int, 2> number{-1, -1};
        if (::pipe2(number.data(), O_CLOEXEC) != 0)
            return;
        m_server.emplace(
            QStringList{QStringLiteral("/usr/bin/Xvfb"), QStringLiteral("-displayfd"),
                QStringLiteral("9"), QStringLiteral("-nolisten"), QStringLiteral("tcp"),
                QStringLiteral("-screen"), QStringLiteral("0"), QStringLiteral("640x480x24")},
            QStringList{}, number[1]);
        ::close(number[1]);
        // To the end of the line: a server whose number is not read to the end gives up.
        QByteArray line;
        for (char next = 0; ::read(number[0], &next, 1) == 1 && next != '\n';)
            line.append(next);
        ::close(number[0]);
        m_name = ':' + line;
    }
    QString name() const { return QString::fromLatin1(m_name); }
    void die() { m_server->signal(SIGKILL); }

private:
    std::optional<Program> m_server;
    QByteArray m_name;
};

const QString kGuarded = support::programFile(QStringLiteral("../tests/guarded_program"));
const QString kCli = support::programFile(QStringLiteral("rotorscope-cli"));
const QString kNoScreen = QStringLiteral("QT_QPA_PLATFORM=offscreen");

QStringList captureLine(const HeardBoard &board, const char *more = nullptr)
{
    QStringList line{kCli, QStringLiteral("--patience"), QStringLiteral("1500"),
        QStringLiteral("--port"), board.port(), QStringLiteral("capture"),
        QStringLiteral("--start"), QStringLiteral("--hf"), QStringLiteral("I_A"),
        QStringLiteral("--hf-rate"), QStringLiteral("15"), QStringLiteral("--seconds"),
        QStringLiteral("60"), QStringLiteral("-o"),
        QDir::temp().filePath(
            QStringLiteral("capture-of-%1.csv").arg(QFileInfo(board.port()).fileName()))};
    if (more != nullptr)
        line.append(QString::fromLatin1(more));
    return line;
}

enum class Kind : std::uint8_t {
    Kill,
    Abort,
    Crash,
    Freeze,
    Screen,
    CommandLineKill,
    CommandLineFreeze
};
constexpr std::array kKinds{"window, SIGKILL", "window, SIGABRT", "window, SIGSEGV",
    "window, SIGSTOP", "window, X server killed", "capture --start, SIGKILL",
    "capture --start, SIGSTOP"};

bool freezes(Kind kind) { return kind == Kind::Freeze || kind == Kind::CommandLineFreeze; }

/// Milliseconds from the end to STOP. What is long behind a kill tells the machine's load in the short form.
struct Bounds {
    double kill, freezeLeast, freeze;
};
constexpr Bounds kQuiet{150.0, 2500.0, 3200.0}, kBusy{1000.0, 1500.0, 5000.0};

bool longForm() { return qEnvironmentVariableIsSet("ROTORSCOPE_LONG"); }

struct Death {
    Kind kind = Kind::Kill;
    double latency_ms = -1.0;
    QString wrong; ///< empty: as it has to be
    /// So often nothing had been started that could be stopped, for want of a screen or of time.
    int again = 0;
};

const QString kNoStart = QStringLiteral("nothing was started");

Death dieOnce(Kind kind, std::chrono::microseconds behindTheStart)
{
    Death death{kind, -1.0, {}, 0};
    HeardBoard board;
    const Instant began = SteadyClock::now();
    std::optional<Screen> screen;
    if (kind == Kind::Screen)
        screen.emplace();
    const bool commandLine = kind == Kind::CommandLineKill || kind == Kind::CommandLineFreeze;
    QStringList environment{QStringLiteral("QT_LOGGING_RULES=link=true;cli.progress=true"),
        QStringLiteral("QT_MESSAGE_PATTERN=%{time process} %{category} %{message}")};
    if (screen)
        environment +=
            {QStringLiteral("QT_QPA_PLATFORM=xcb"), QStringLiteral("DISPLAY=") + screen->name()};
    else
        environment += kNoScreen;
    Program program(commandLine ? captureLine(board)
                                : QStringList{kGuarded, board.port(), QStringLiteral("drive")},
        environment);
    Instant killed = began;
    const auto wrong = [&](const QString &what) {
        death.wrong = what;
        qInfo("%s, %.3f ms behind the start: %s\n%s%s", kKinds[static_cast<std::size_t>(kind)],
            std::chrono::duration<double, std::milli>(behindTheStart).count(), qPrintable(what),
            qPrintable(board.account(killed)), program.complaints().constData());
        return death;
    };
    const auto start = board.heard(kStartWords, began, began + 20s);
    if (!start)
        return wrong(kNoStart);
    board.waitUntil(*start + behindTheStart);
    killed = SteadyClock::now();
    if (board.heard(kStop, began, killed))
        return wrong(QStringLiteral("a STOP before the end"));
    if (kind == Kind::Screen)
        screen->die();
    else
        program.signal(freezes(kind)  ? SIGSTOP
                : kind == Kind::Abort ? SIGABRT
                : kind == Kind::Crash ? SIGSEGV
                                      : SIGKILL);
    const auto stop = board.heard(kStop, killed, killed + 10s);
    if (!stop)
        return wrong(QStringLiteral("no STOP"));
    const double latency = std::chrono::duration<double, std::milli>(*stop - killed).count();
    death.latency_ms = latency;
    if (freezes(kind))
        // The frozen program keeps its port; behind that the guardian does not.
        board.waitUntil(*stop + 2200ms);
    program.signal(SIGKILL);
    (void)program.wait();
    if (!board.freeUntil(SteadyClock::now() + 10s))
        return wrong(QStringLiteral("somebody keeps the port"));
    if (board.heard(kStartWords, killed, killed))
        return wrong(QStringLiteral("a start behind the end"));
    if (board.motorRuns())
        return wrong(QStringLiteral("the motor runs"));
    const Bounds &bounds = longForm() ? kQuiet : kBusy;
    if (freezes(kind) && latency < bounds.freezeLeast)
        return wrong(QStringLiteral("a STOP too early"));
    if (latency > (freezes(kind) ? bounds.freeze : bounds.kill))
        return wrong(QStringLiteral("a late STOP"));
    return death;
}

Death die(Kind kind, std::chrono::microseconds behindTheStart)
{
    constexpr int kTries = 3;
    Death death = dieOnce(kind, behindTheStart);
    for (int again = 1; again < kTries && death.wrong == kNoStart; ++again) {
        death = dieOnce(kind, behindTheStart);
        death.again = again;
    }
    return death;
}

/// In several lanes, because most of the time is waiting.
std::vector<Death> dieOften(const std::vector<Kind> &kinds, int lanes, std::uint64_t seed)
{
    support::Random random(seed);
    std::vector<std::chrono::microseconds> when;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        when.emplace_back(random.below(1'500'000));
    std::vector<Death> deaths(kinds.size());
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;
    for (int lane = 0; lane < lanes; ++lane)
        threads.emplace_back([&] {
            for (std::size_t i = next++; i < kinds.size(); i = next++)
                deaths[i] = die(kinds[i], when[i]);
        });
    for (std::thread &thread : threads)
        thread.join();
    return deaths;
}

void printTable(const std::vector<Death> &deaths)
{
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
        std::vector<double> times;
        QStringList wrong;
        int again = 0;
        for (const Death &death : deaths) {
            if (static_cast<std::size_t>(death.kind) != kind)
                continue;
            again += death.again;
            if (death.latency_ms >= 0.0)
                times.push_back(death.latency_ms);
            if (!death.wrong.isEmpty())
                wrong.append(death.wrong);
        }
        if (times.empty())
            continue;
        std::sort(times.begin(), times.end());
        const auto at = [&](double share) {
            return times[std::min(times.size() - 1,
                static_cast<std::size_t>(share * static_cast<double>(times.size())))];
        };
        qInfo("%-26s %5zu  p50 %7.1f  p99 %7.1f  worst %7.1f ms  tried again %d  wrong %d %s",
            kKinds[kind], times.size(), at(0.5), at(0.99), times.back(), again,
            static_cast<int>(wrong.size()), qPrintable(wrong.join(QLatin1String("; "))));
    }
}

} // namespace

void TestGuardian::whateverEndsTheProgramStopsTheMotor()
{
    // Counts of a short form and of the long one.
    struct Row {
        Kind kind;
        int few, many;
    };
    constexpr std::array kRows{Row{Kind::Kill, 3, 420}, Row{Kind::Abort, 1, 100},
        Row{Kind::Crash, 1, 80}, Row{Kind::Freeze, 1, 100}, Row{Kind::Screen, 1, 80},
        Row{Kind::CommandLineKill, 2, 170}, Row{Kind::CommandLineFreeze, 1, 50}};
    const bool many = longForm();
    bool given = false;
    const int part = qEnvironmentVariableIntValue("ROTORSCOPE_PART", &given);
    std::vector<Kind> kinds;
    for (int i = 0; i < 420; ++i)
        for (const Row &row : kRows)
            if (i < (!many ? row.few : given ? row.many * part / 100 : row.many))
                kinds.push_back(row.kind);
    const int lanes = qEnvironmentVariableIntValue("ROTORSCOPE_LANES", &given);
    const auto deaths = dieOften(kinds, given ? lanes : many ? 8 : 4, many ? 2 : 1);
    printTable(deaths);
    std::size_t again = 0;
    for (const Death &death : deaths) {
        again += static_cast<std::size_t>(death.again);
        QVERIFY2(death.wrong.isEmpty(),
            qPrintable(QLatin1String(kKinds[static_cast<std::size_t>(death.kind)])
                + QStringLiteral(": ") + death.wrong));
    }
    QVERIFY(!many || again * 50 <= deaths.size());
}

void TestGuardian::whoWakesUpSendsNothingAndIsDisarmed()
{
    HeardBoard board;
    const Instant began = SteadyClock::now();
    Program program({kGuarded, board.port(), QStringLiteral("drive")}, {kNoScreen});
    const auto start = board.heard(kStartWords, began, began + kLong);
    QVERIFY(start);
    program.signal(SIGSTOP);
    const Instant frozen = SteadyClock::now();
    const auto stop = board.heard(kStop, frozen, frozen + 10s);
    QVERIFY(stop);
    // In the midst of it.
    board.waitUntil(*stop + 500ms);
    program.signal(SIGCONT);
    QVERIFY(program.says("taken over\n"));
    QVERIFY(program.said().contains("disarmed\n"));
    QVERIFY2(!program.said().contains("closed"), program.said().constData());
    QVERIFY(program.says("taken over\nopen\n"));
    QVERIFY(!board.heard(kStartWords, frozen, SteadyClock::now() + 1s));
    QCOMPARE(program.said().count("armed\n"), 2); // once, and not any more
    program.signal(SIGKILL);
    (void)program.wait();
    QVERIFY(board.freeUntil(SteadyClock::now() + 10s));
    QVERIFY(!board.motorRuns());
}

void TestGuardian::nothingIsSentWhenNothingWasDriven()
{
    HeardBoard board;
    Program program({kGuarded, board.port(), QStringLiteral("idle")}, {kNoScreen});
    QVERIFY(program.says("armed\n"));
    const Instant killed = SteadyClock::now();
    program.signal(SIGKILL);
    (void)program.wait();
    QVERIFY(board.freeUntil(SteadyClock::now() + 10s));
    QVERIFY(!board.heard(kStop, killed, SteadyClock::now() + 300ms));
}

void TestGuardian::whatWasLeftRunningGoesOn_data()
{
    QTest::addColumn<QString>("act");
    QTest::newRow("a person leaves it running") << QStringLiteral("leave");
    QTest::newRow("capture --keep-running, killed") << QStringLiteral("capture");
    QTest::newRow("start") << QStringLiteral("start");
}

void TestGuardian::whatWasLeftRunningGoesOn()
{
    QFETCH(const QString, act);
    HeardBoard board;
    const Instant began = SteadyClock::now();
    const QStringList line = act == QLatin1String("leave")
        ? QStringList{kGuarded, board.port(), act}
        : act == QLatin1String("start") ? QStringList{kCli, QStringLiteral("--patience"),
              QStringLiteral("500"), QStringLiteral("--port"), board.port(), act}
                                        : captureLine(board, "--keep-running");
    Program program(line, {kNoScreen});
    QVERIFY(board.heard(kStartWords, began, began + kLong));
    if (act == QLatin1String("capture")) {
        board.waitUntil(SteadyClock::now() + 500ms);
        program.signal(SIGKILL);
        (void)program.wait();
    } else {
        QCOMPARE(program.wait(), 0);
    }
    QVERIFY(board.freeUntil(SteadyClock::now() + 10s));
    QVERIFY(!board.heard(kStop, began, SteadyClock::now() + 300ms));
    QVERIFY(board.motorRuns());
}

void TestGuardian::theGuardianIsGoneBehindANormalEnd()
{
    HeardBoard board;
    Program program({kGuarded, board.port(), QStringLiteral("leave")}, {kNoScreen});
    QCOMPARE(program.wait(), 0);
    const auto guardians = [&board] {
        int count = 0;
        for (const QString &pid :
            QDir(QStringLiteral("/proc")).entryList({QStringLiteral("[0-9]*")}, QDir::Dirs)) {
            const QDir files(QStringLiteral("/proc/%1/fd").arg(pid));
            const auto entries =
                files.entryInfoList(QDir::Files | QDir::System | QDir::NoDotAndDotDot);
            count += pid.toLongLong() != QCoreApplication::applicationPid()
                    && std::any_of(entries.begin(), entries.end(),
                        [&](const QFileInfo &entry) {
                            return entry.symLinkTarget() == board.port();
                        })
                ? 1
                : 0;
        }
        return count;
    };
    QTRY_COMPARE(guardians(), 0);
}

QTEST_GUILESS_MAIN(TestGuardian)
#include "tst_guardian_posix.moc"

// A Stop through the session on boards whose motors run, while the port is lost, opened again, or its drive is still
// finding out what is there. Virtual time; the board outlives its port, as boards do.
#include "session/link/session.h"
#include "session/recording/tap.h"

#include "simulation/mcb/board.h"

#include <QtTest>

using namespace std::chrono_literals;
using drive::MotorState;
using drive::Protocol;
using session::Session;

namespace {

/// A port whose board goes on while it is closed.
class BoardPort : public session::Transport {
public:
    struct Line {
        std::unique_ptr<simulation::SimulatedBoard> board;
        BoardPort *open = nullptr;
        bool there = true; ///< the plug
        bool deaf = false; ///< the wire from the board is cut
        Bytes sent;
    };

    explicit BoardPort(Line &line)
        : m_line(line)
    {
    }
    ~BoardPort() override { BoardPort::close(); }

    session::PortError open(TimePoint) override
    {
        if (!m_line.there)
            return {session::PortProblem::NotFound, {}};
        m_line.open = this;
        (void)m_line.board->takeOutput(); // went into the void
        return {};
    }
    void close() override
    {
        if (m_line.open == this)
            m_line.open = nullptr;
    }
    void write(ByteView bytes, TimePoint now) override
    {
        m_line.sent.insert(m_line.sent.end(), bytes.begin(), bytes.end());
        m_line.board->receive(bytes, now);
    }
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint now) override
    {
        m_line.board->advance(now);
        const Bytes out = m_line.board->takeOutput();
        if (!out.empty() && !m_line.deaf)
            Q_EMIT received(QByteArray(
                reinterpret_cast<const char *>(out.data()), static_cast<qsizetype>(out.size())));
    }
    std::optional<TimePoint> nextWake() const override { return m_line.board->nextWake(); }
    bool real() const override { return true; }
    void unplug()
    {
        m_line.there = false;
        close();
        Q_EMIT failed({session::PortProblem::Unplugged, {}});
    }

private:
    Line &m_line;
};

struct PortWorld {
    TimePoint now{1000s};
    BoardPort::Line line;
    Session session;
    session::Endpoint endpoint;
    std::map<int, drive::MotorStatus> status;
    std::vector<drive::StopProgress> words;
    std::optional<drive::Identified> identified;
    QStringList wanted;
    bool idleWhenIdentified = false; ///< the last motor had been stopped before the board was known

    PortWorld(const char *profile, Protocol protocol, int motors)
        : session(parts(*this))
    {
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("bench");
        endpoint.protocol = protocol;
        endpoint.baud = QByteArray(profile).startsWith("mcsdk") ? 1843200 : 115200;
        simulation::BoardOptions options;
        if (protocol != Protocol::Mcb)
            options.profile = profile;
        options.baud = endpoint.baud;
        options.motors = motors;
        simulation::McbBoardOptions servo;
        servo.board = options;
        if (protocol == Protocol::Mcb)
            line.board = simulation::makeMcbBoard(servo);
        else
            line.board = simulation::makeBoard(options);
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                for (const drive::Event &event : batch->events)
                    accept(event);
                session.acknowledge();
            });
        QObject::connect(&session, &Session::stopsWanted, &session,
            [this](const QStringList &ports) { wanted = ports; });
    }

    static session::Parts parts(PortWorld &world)
    {
        session::Parts parts = session::realParts();
        parts.clock = parts.elapsed = [&world] { return world.now; };
        parts.attendance = session::Attendance::OwnThread;
        parts.transport = [&world](const session::Endpoint &) {
            return std::make_unique<BoardPort>(world.line);
        };
        return session::tapped(
            parts, std::make_shared<session::RecordingTap>(std::size_t{1} << 20));
    }
    void accept(const drive::Event &event)
    {
        if (const auto *motor = std::get_if<drive::MotorStatus>(&event))
            status[motor->motor] = *motor;
        else if (const auto *word = std::get_if<drive::StopProgress>(&event))
            words.push_back(*word);
        if (const auto *board = std::get_if<drive::Identified>(&event)) {
            identified = *board;
            idleWhenIdentified = idle(board->identity.motors);
        }
    }
    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        while (!condition() && now < end) {
            const auto next = session.nextStep();
            const TimePoint at = std::min(next.value_or(end), now + 1ms);
            now = std::min(std::max(at, now + 1us), end);
            line.board->advance(now);
            session.step(now);
        }
        return condition();
    }
    void run(Duration time)
    {
        (void)runUntil([] { return false; }, time);
    }
    bool idle(int motor, drive::StopWord word = drive::StopWord::DriveIdle) const
    {
        return std::any_of(words.begin(), words.end(),
            [&](const auto &one) { return one.motor == motor && one.word == word; });
    }
    bool startAll()
    {
        session.open(endpoint);
        if (!runUntil([&] { return identified.has_value(); }, 10s))
            return false;
        session.setArmed(true);
        session.submit({.id = 0, .what = drive::UserLimits{3000.0, 3.0}});
        for (int motor = 1; motor <= identified->identity.motors; ++motor) {
            session.submit({.id = 0, .what = drive::ExpertMode{motor}});
            session.submit({.id = 0, .what = drive::Command{drive::MotorAction::Start, motor}});
        }
        return runUntil(
            [&] {
                for (int motor = 1; motor <= identified->identity.motors; ++motor)
                    if (status[motor].state != MotorState::Running)
                        return false;
                return true;
            },
            10s);
    }
    void unplug()
    {
        line.open->unplug();
        words.clear();
        status.clear();
        identified.reset();
        line.sent.clear();
    }
    void plugIn()
    {
        line.there = true;
        (void)runUntil([&] { return line.open != nullptr; }, 1s);
    }
};

/// Firmware stays in its state STOP for 400 ms before it says IDLE.
constexpr Duration kStopsWithin = 600ms;

void boards()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<Protocol>("protocol");
    QTest::addColumn<int>("motors");
    QTest::newRow("newer") << QByteArray("mcsdk-6.4") << Protocol::Mcp << 2;
    QTest::newRow("older") << QByteArray("legacy") << Protocol::Fcp << 2;
    QTest::newRow("older, PowerPC") << QByteArray("powerpc") << Protocol::PowerPc << 2;
    QTest::newRow("SPI") << QByteArray("mcb") << Protocol::Mcb << 1;
    QTest::newRow("found out, newer") << QByteArray("mcsdk-6.4") << Protocol::Auto << 2;
    QTest::newRow("found out, older") << QByteArray("legacy") << Protocol::Auto << 2;
}

} // namespace

class TestStopAcrossPorts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStopThatTheUnplugCutOffIsCarriedOutFirst_data() { boards(); }
    void aStopThatTheUnplugCutOffIsCarriedOutFirst();
    void aStopWhileThePortIsGoneStopsWhatComesBack_data() { boards(); }
    void aStopWhileThePortIsGoneStopsWhatComesBack();
    void aStopWhileTheBoardIsBeingFoundOutStopsIt_data() { boards(); }
    void aStopWhileTheBoardIsBeingFoundOutStopsIt();
    void aServoThatWasLeftCyclingIsStopped_data();
    void aServoThatWasLeftCyclingIsStopped();
    void withTheWireFromTheBoardCutEveryMotorIsStopped_data() { boards(); }
    void withTheWireFromTheBoardCutEveryMotorIsStopped();
    void withoutAStopAReopenedPortSendsNone_data() { boards(); }
    void withoutAStopAReopenedPortSendsNone();
};

void TestStopAcrossPorts::aStopThatTheUnplugCutOffIsCarriedOutFirst()
{
    QFETCH(QByteArray, profile);
    QFETCH(Protocol, protocol);
    QFETCH(int, motors);
    PortWorld world(profile.constData(), protocol, motors);
    QVERIFY(world.startAll());
    world.session.stop();
    world.unplug(); // in the same moment
    QCOMPARE(world.wanted, QStringList{QStringLiteral("bench")});
    world.run(700ms);
    world.plugIn();
    const TimePoint back = world.now;
    QVERIFY(world.wanted.isEmpty()); // under way
    for (int motor = 1; motor <= motors; ++motor)
        QVERIFY(world.runUntil([&] { return world.idle(motor); }, 1s));
    QVERIFY2(
        world.now - back <= kStopsWithin, qPrintable(QString::number((world.now - back) / 1ms)));
    QVERIFY(world.runUntil([&] { return world.identified.has_value(); }, 10s));
    QVERIFY(world.idleWhenIdentified); // before all else
    world.run(100ms);
    world.unplug(); // and once is enough
    QVERIFY(world.wanted.isEmpty());
    world.plugIn();
    QVERIFY(world.runUntil([&] { return world.identified.has_value(); }, 10s));
    QVERIFY(world.words.empty());
}

void TestStopAcrossPorts::aStopWhileThePortIsGoneStopsWhatComesBack()
{
    QFETCH(QByteArray, profile);
    QFETCH(Protocol, protocol);
    QFETCH(int, motors);
    PortWorld world(profile.constData(), protocol, motors);
    QVERIFY(world.startAll());
    world.unplug();
    world.run(700ms);
    world.session.stop();
    world.run(300ms);
    world.plugIn();
    for (int motor = 1; motor <= motors; ++motor)
        QVERIFY(world.runUntil([&] { return world.idle(motor); }, 1s));
}

void TestStopAcrossPorts::aStopWhileTheBoardIsBeingFoundOutStopsIt()
{
    QFETCH(QByteArray, profile);
    QFETCH(Protocol, protocol);
    QFETCH(int, motors);
    for (const Duration after : {Duration(0s), Duration(3ms), Duration(40ms)}) {
        PortWorld world(profile.constData(), protocol, motors);
        QVERIFY(world.startAll());
        world.unplug();
        world.run(100ms);
        world.plugIn();
        world.run(after);
        if (world.identified)
            break; // quick boards
        world.session.stop();
        const TimePoint asked = world.now;
        for (int motor = 1; motor <= motors; ++motor)
            QVERIFY(world.runUntil([&] { return world.idle(motor); }, 2s));
        QVERIFY2(world.now - asked <= kStopsWithin + 100ms,
            qPrintable(QString::number((world.now - asked) / 1ms)));
    }
}

void TestStopAcrossPorts::aServoThatWasLeftCyclingIsStopped_data()
{
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("after");
    for (const int channels : {1, 4})
        for (const int after : {-1, 2, 50, 100, 400, 1000})
            QTest::addRow("%d signals, %d ms behind the port", channels, after)
                << channels << after;
}

/// By a drive that does not know its mapping: blind STOPs must leave the line to what finds out the length of its
/// frames.
void TestStopAcrossPorts::aServoThatWasLeftCyclingIsStopped()
{
    QFETCH(int, channels);
    QFETCH(int, after);
    PortWorld world("mcb", Protocol::Mcb, 1);
    QVERIFY(world.startAll());
    drive::Stream stream;
    for (const char *name : {"BUS_VOLTAGE", "I_A", "I_Q_MEAS", "SPEED_MEAS"})
        if (int(stream.fast.size()) < channels)
            stream.fast.push_back(*world.identified->catalog->resolve(name));
    world.session.submit({.id = 0, .what = stream});
    world.run(200ms);
    world.unplug();
    world.run(100ms);
    if (after < 0)
        world.session.stop();
    world.plugIn();
    if (after >= 0) {
        world.run(after * 1ms);
        world.session.stop();
    }
    QVERIFY(world.runUntil([&] { return world.idle(1); }, 1s));
    QVERIFY(!world.line.board->truth(1).driven);
}

void TestStopAcrossPorts::withTheWireFromTheBoardCutEveryMotorIsStopped()
{
    QFETCH(QByteArray, profile);
    QFETCH(Protocol, protocol);
    QFETCH(int, motors);
    PortWorld world(profile.constData(), protocol, motors);
    QVERIFY(world.startAll());
    world.session.stop();
    world.unplug(); // in the same moment
    world.run(700ms);
    world.line.deaf = true;
    world.plugIn();
    world.run(2s);
    for (int motor = 1; motor <= motors; ++motor)
        QVERIFY2(!world.line.board->truth(motor).driven, qPrintable(QString::number(motor)));
}

void TestStopAcrossPorts::withoutAStopAReopenedPortSendsNone()
{
    QFETCH(QByteArray, profile);
    QFETCH(Protocol, protocol);
    QFETCH(int, motors);
    PortWorld world(profile.constData(), protocol, motors);
    QVERIFY(world.startAll());
    world.unplug();
    world.run(100ms);
    world.plugIn();
    QVERIFY(world.runUntil([&] { return world.identified.has_value(); }, 10s));
    QVERIFY(world.runUntil([&] { return world.status.contains(1); }, 1s));
    QVERIFY(world.words.empty());
    QVERIFY(world.status[1].state == MotorState::Running);
}

QTEST_GUILESS_MAIN(TestStopAcrossPorts)
#include "tst_stop_across_ports.moc"

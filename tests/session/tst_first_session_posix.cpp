// The whole first session over a pseudo-terminal: QSerialPort on our side, the simulated board on the other, in real
// time; and the cable pulled in the middle of a packet.
#include "session/session.h"
#include "support/pseudo_terminal.h"

#include <QElapsedTimer>
#include <QSocketNotifier>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace std::chrono_literals;
using session::PortProblem;
using session::PortState;
using session::Session;

class TestFirstSession : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void connectStartStreamStop();
    void unpluggedInTheMiddleOfAPacketAndPluggedInAgain();
    void aSecondSessionIsRefusedAndTheFirstGoesOn();
};

namespace {

/// A simulated board behind a pseudo-terminal, run by this thread's event loop.
class BoardOnTerminal {
public:
    BoardOnTerminal()
        : m_board(simulation::makeBoard({}))
    {
        m_time.start();
        m_pump.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_pump, &QTimer::timeout, &m_pump, [this] { pump(); });
        m_pump.start(1);
        m_input = std::make_unique<QSocketNotifier>(m_terminal.master(), QSocketNotifier::Read);
        QObject::connect(m_input.get(), &QSocketNotifier::activated, &m_pump, [this] { pump(); });
    }

    const QString &path() const { return m_terminal.path(); }
    std::uint64_t sentBytes() const { return m_sent; }

    /// Pulls the cable while half of what is on its way has been sent.
    void unplugInTheMiddle() { m_unplugNext = true; }
    bool unplugged() const { return m_unplugged; }

private:
    TimePoint now() const { return TimePoint(Duration(m_time.nsecsElapsed())); }

    void pump()
    {
        if (m_unplugged)
            return;
        const Bytes in = m_terminal.read();
        if (!in.empty())
            m_board->receive(in, now());
        m_board->advance(now());
        Bytes out = m_board->takeOutput();
        if (m_unplugNext && out.size() > 1) {
            out.resize(out.size() / 2);
            m_terminal.write(out);
            m_input.reset();
            m_terminal.unplug();
            m_unplugged = true;
            return;
        }
        m_sent += out.size();
        if (!out.empty())
            m_terminal.write(out);
    }

    std::unique_ptr<simulation::SimulatedBoard> m_board;
    support::PseudoTerminal m_terminal;
    QElapsedTimer m_time;
    QTimer m_pump;
    std::unique_ptr<QSocketNotifier> m_input;
    std::uint64_t m_sent = 0;
    bool m_unplugNext = false;
    bool m_unplugged = false;
};

struct User {
    Session session;
    std::vector<std::pair<PortState, PortProblem>> ports;
    std::optional<drive::Identified> board;
    drive::MotorStatus status;
    drive::StopWord word = drive::StopWord::Requested;
    capture::Tick samples = 0, lost = 0;
    std::map<drive::WishId, drive::Outcome> ends;
    int batches = 0;

    User()
    {
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                ++batches;
                for (const drive::Event &event : batch->events)
                    take(event);
                session.acknowledge();
            });
        QObject::connect(&session, &Session::portChanged, &session,
            [this](PortState state, const session::PortError &why) {
                ports.emplace_back(state, why.problem);
            });
    }
    void take(const drive::Event &event)
    {
        if (const auto *identified = std::get_if<drive::Identified>(&event))
            board = *identified;
        else if (const auto *motor = std::get_if<drive::MotorStatus>(&event))
            status = *motor;
        else if (const auto *progress = std::get_if<drive::StopProgress>(&event))
            word = progress->word;
        else if (const auto *ended = std::get_if<drive::Ended>(&event))
            ends[ended->id] = ended->outcome;
        else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            samples += block->count;
            lost += block->lostTicks;
        }
    }
    void open(const QString &path)
    {
        session.open({session::Endpoint::Kind::Serial, path, 1843200, {}, true});
    }
    void streamOneSignal()
    {
        session.submit({.id = 9,
            .what = drive::Stream{.fast = {*board->catalog->resolve("I_A")},
                .fastEvery = 1,
                .slow = {},
                .slowEvery = 1}});
    }
};

} // namespace

void TestFirstSession::connectStartStreamStop()
{
    BoardOnTerminal board;
    User user;
    user.open(board.path());
    QTRY_VERIFY(user.board);
    user.streamOneSignal();
    QTRY_VERIFY(user.samples > 1000);
    user.session.setArmed(true);
    user.session.submit({.id = 1, .what = drive::Command{drive::MotorAction::Start, 1}});
    QTRY_COMPARE_WITH_TIMEOUT(user.status.state, drive::MotorState::Running, 20000);
    QCOMPARE(user.ends.at(1), drive::Outcome::Ok);
    user.session.stopFromAnyThread();
    QTRY_COMPARE_WITH_TIMEOUT(user.word, drive::StopWord::Standstill, 20000);
    QCOMPARE(user.status.state, drive::MotorState::Idle);
    user.session.close();
    QTRY_COMPARE(user.ports.back(), std::pair(PortState::Closed, PortProblem::None));
}

void TestFirstSession::unpluggedInTheMiddleOfAPacketAndPluggedInAgain()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("port"));
    User user;
    auto board = std::make_unique<BoardOnTerminal>();
    QVERIFY(QFile::link(board->path(), path));
    user.open(path);
    QTRY_VERIFY(user.board);
    user.streamOneSignal();
    QTRY_VERIFY(user.samples > 1000);
    user.session.submit({.id = 5, .what = drive::Read{{*user.board->catalog->resolve("STATUS")}}});
    board->unplugInTheMiddle();
    QTRY_VERIFY(board->unplugged());
    QTRY_COMPARE(user.ports.back(), std::pair(PortState::Closed, PortProblem::Unplugged));
    QTRY_VERIFY(user.ends.contains(5)); // whatever became of it: it ended
    QCOMPARE(user.ports.size(), 2U);

    QVERIFY(QFile::remove(path));
    board = std::make_unique<BoardOnTerminal>(); // plugged in again
    QVERIFY(QFile::link(board->path(), path));
    user.board.reset();
    user.samples = 0;
    QTRY_COMPARE(user.ports.back(), std::pair(PortState::Open, PortProblem::None));
    QTRY_VERIFY(user.board);
    QTRY_VERIFY(user.samples > 1000); // the stream was taken up again, nothing else
    QCOMPARE(user.status.state, drive::MotorState::Idle);
    QCOMPARE(user.ports.size(), 3U);
}

void TestFirstSession::aSecondSessionIsRefusedAndTheFirstGoesOn()
{
    BoardOnTerminal board;
    User first, second;
    first.open(board.path());
    QTRY_VERIFY(first.board);
    second.open(board.path());
    QCOMPARE(second.ports, (std::vector{std::pair(PortState::Closed, PortProblem::Busy)}));
    const int batches = first.batches;
    QTRY_VERIFY(first.batches > batches + 3);
}

QTEST_GUILESS_MAIN(TestFirstSession)
#include "tst_first_session_posix.moc"

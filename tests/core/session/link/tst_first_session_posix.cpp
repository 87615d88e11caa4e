// The whole first session over a pseudo-terminal: QSerialPort on our side, the simulated board on the other, in real
// time; and the cable pulled in the middle of a packet.
#include "session/link/session.h"
#include "support/board_on_terminal.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

using namespace std::chrono_literals;
using session::PortProblem;
using session::PortState;
using session::Session;
using support::BoardOnTerminal;

class TestFirstSessionByLine : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void connectStartStreamStop();
    void unpluggedInTheMiddleOfAPacketAndPluggedInAgain();
    void aSecondSessionIsRefusedAndTheFirstGoesOn();
};

namespace {

/// The test is its own interface, in the session's thread.
session::Parts attended()
{
    session::Parts parts = session::realParts();
    parts.attendance = session::Attendance::OwnThread;
    return parts;
}

struct User {
    Session session{attended()};
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
                    accept(event);
                session.acknowledge();
            });
        QObject::connect(&session, &Session::portChanged, &session,
            [this](PortState state, const session::PortError &why) {
                ports.emplace_back(state, why.problem);
            });
    }
    void accept(const drive::Event &event)
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

void TestFirstSessionByLine::connectStartStreamStop()
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
    QTRY_COMPARE_WITH_TIMEOUT(user.word, drive::StopWord::MayCoast, 20000);
    QCOMPARE(user.status.state, drive::MotorState::Idle);
    user.session.close();
    QTRY_COMPARE(user.ports.back(), std::pair(PortState::Closed, PortProblem::None));
}

void TestFirstSessionByLine::unpluggedInTheMiddleOfAPacketAndPluggedInAgain()
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

void TestFirstSessionByLine::aSecondSessionIsRefusedAndTheFirstGoesOn()
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

QTEST_GUILESS_MAIN(TestFirstSessionByLine)
#include "tst_first_session_posix.moc"

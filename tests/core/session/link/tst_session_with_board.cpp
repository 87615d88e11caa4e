// The session with the real drive and the simulated board, on virtual time and judged on the wire: what the user does
// first.
#include "session/link/session.h"
#include "support/judged_line.h"

#include <QtTest>

using namespace std::chrono_literals;
using drive::MotorState;
using session::Session;

class TestSessionWithBoard : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theBoardIsIdentifiedAndMetReadOnly();
    void fourSignalsAtTheControlRateLoseNothing();
    void theMotorStartsRampsAndStops();
    void nothingMovesBeforeArming();
    void aStalledReceiverGetsEverythingLaterOrSeesTheGap();
    void closingEndsTheStream();
};

namespace {

/// A session on virtual time; all events are kept in order.
struct BoardWorld {
    TimePoint now{1000s};
    support::JudgedWorld line{{}, drive::Protocol::Mcp, [this] { return now; }};
    Session session;
    std::vector<drive::Event> events;
    bool acknowledging = true;
    int unacknowledged = 0;
    std::vector<session::PortState> ports;

    BoardWorld()
        : session(line.parts())
    {
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                events.insert(events.end(), batch->events.begin(), batch->events.end());
                ++unacknowledged;
                if (acknowledging)
                    acknowledge();
            });
        QObject::connect(&session, &Session::portChanged, &session,
            [this](session::PortState state) { ports.push_back(state); });
    }

    void acknowledge()
    {
        while (unacknowledged > 0) {
            --unacknowledged;
            session.acknowledge();
        }
    }

    void run(Duration time)
    {
        const TimePoint end = now + time;
        for (auto next = session.nextStep(); next && *next <= end; next = session.nextStep()) {
            now = std::max(*next, now + 1us);
            session.step(now);
        }
        now = end;
        session.step(now);
    }

    template <class Event>
    std::vector<Event> all() const
    {
        std::vector<Event> found;
        for (const drive::Event &event : events) {
            if (const auto *match = std::get_if<Event>(&event))
                found.push_back(*match);
        }
        return found;
    }

    bool connect()
    {
        session.open({});
        run(2s);
        return !all<drive::Identified>().empty();
    }
    drive::Outcome outcomeOf(drive::WishId id) const
    {
        for (const drive::Ended &ended : all<drive::Ended>()) {
            if (ended.id == id)
                return ended.outcome;
        }
        return drive::Outcome::Unknown;
    }
    drive::MotorStatus status() const { return all<drive::MotorStatus>().back(); }
    drive::RegisterId id(const char *name) const
    {
        return *all<drive::Identified>().back().catalog->resolve(name);
    }
};

} // namespace

void TestSessionWithBoard::theBoardIsIdentifiedAndMetReadOnly()
{
    BoardWorld world;
    QVERIFY(world.connect());
    const drive::Identified board = world.all<drive::Identified>().back();
    QVERIFY(board.identity.knownFirmware);
    QCOMPARE(board.streaming.tickHz, 16000.0);
    QCOMPARE(world.status().state, MotorState::Idle);
    QCOMPARE(world.ports.size(), 1U);
}

void TestSessionWithBoard::fourSignalsAtTheControlRateLoseNothing()
{
    BoardWorld world;
    QVERIFY(world.connect());
    drive::Stream stream;
    for (const char *name : {"I_A", "I_B", "I_Q_MEAS", "STOPLL_ROT_SPEED"})
        stream.fast.push_back(world.id(name));
    world.session.submit({.id = 7, .what = stream});
    world.run(3s);
    QCOMPARE(world.outcomeOf(7), drive::Outcome::Ok);
    capture::Tick samples = 0, lost = 0;
    for (const capture::SampleBlock &block : world.all<capture::SampleBlock>()) {
        samples += block.count;
        lost += block.lostTicks;
    }
    QVERIFY2(samples > 44'000, qPrintable(QString::number(samples)));
    QCOMPARE(lost, 0);
}

void TestSessionWithBoard::theMotorStartsRampsAndStops()
{
    BoardWorld world;
    QVERIFY(world.connect());
    world.session.setArmed(true);
    world.session.submit({.id = 1, .what = drive::Command{drive::MotorAction::Start, 1}});
    world.run(4s);
    QCOMPARE(world.outcomeOf(1), drive::Outcome::Ok);
    QCOMPARE(world.status().state, MotorState::Running);
    world.session.submit({.id = 2, .what = drive::SpeedRamp{1, 1500, 500ms}});
    world.run(2s);
    QVERIFY2(std::abs(*world.status().speedRpm - 1500) < 50,
        qPrintable(QString::number(*world.status().speedRpm)));
    world.session.stopFromAnyThread();
    QCoreApplication::sendPostedEvents(&world.session);
    world.run(4s);
    const auto words = world.all<drive::StopProgress>();
    QCOMPARE(words.front().word, drive::StopWord::Requested);
    QCOMPARE(words.back().word, drive::StopWord::MayCoast);
    QCOMPARE(world.status().state, MotorState::Idle);
}

void TestSessionWithBoard::nothingMovesBeforeArming()
{
    BoardWorld world;
    QVERIFY(world.connect());
    world.session.submit({.id = 1, .what = drive::Command{drive::MotorAction::Start, 1}});
    world.run(1s);
    QCOMPARE(world.outcomeOf(1), drive::Outcome::NotSent);
    QCOMPARE(world.status().state, MotorState::Idle);
}

void TestSessionWithBoard::aStalledReceiverGetsEverythingLaterOrSeesTheGap()
{
    BoardWorld world;
    QVERIFY(world.connect());
    world.session.submit({.id = 7,
        .what =
            drive::Stream{.fast = {world.id("I_A")}, .fastEvery = 1, .slow = {}, .slowEvery = 1}});
    world.run(1s);
    world.acknowledging = false;
    const std::size_t before = world.events.size();
    world.run(10s);
    QVERIFY(world.unacknowledged <= 2);
    world.acknowledging = true;
    world.acknowledge();
    world.run(1s);
    QVERIFY(world.events.size() > before);
    capture::Tick next = 0;
    for (const capture::SampleBlock &block : world.all<capture::SampleBlock>()) {
        if (next != 0)
            QCOMPARE(block.firstTick, next + block.lostTicks);
        next = block.firstTick + block.count;
    }
}

void TestSessionWithBoard::closingEndsTheStream()
{
    BoardWorld world;
    QVERIFY(world.connect());
    world.session.submit({.id = 7,
        .what =
            drive::Stream{.fast = {world.id("I_A")}, .fastEvery = 1, .slow = {}, .slowEvery = 1}});
    world.run(1s);
    world.session.close();
    world.run(1s);
    QCOMPARE(world.ports.back(), session::PortState::Closed);
    QVERIFY(world.session.closed());
    QVERIFY(!world.session.nextStep());
    QCOMPARE(world.all<drive::LinkChanged>().back().state, drive::LinkState::Closed);
}

QTEST_GUILESS_MAIN(TestSessionWithBoard)
#include "tst_session_with_board.moc"

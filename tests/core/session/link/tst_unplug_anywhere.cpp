// The port vanishes at any byte of a session, while it reads and while it writes, and is there again: each wish ends
// once, nothing is armed, the motor is not started a second time, and the board is found again. Every 37th byte; with
// ROTORSCOPE_LONG=1 each of them.
#include "session/link/session.h"
#include "simulation/simulated_board.h"

#include <QtTest>

#include <map>

using namespace std::chrono_literals;
using session::PortError;
using session::PortProblem;
using session::Session;

class TestUnplugAnywhere : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anyByteCanBeTheLast_data();
    void anyByteCanBeTheLast();
};

namespace {

/// A cable between the session and a board: it breaks behind so many bytes of one direction, once.
struct Cable {
    std::unique_ptr<simulation::SimulatedBoard> board;
    bool writing = false; ///< which direction is counted
    std::uint64_t left = 0; ///< bytes until it breaks
    bool broken = false;
    int opened = 0;
    int starts = 0; ///< payloads that left the session whole or in part
};

class CableTransport final : public session::Transport {
public:
    explicit CableTransport(Cable &cable)
        : m_cable(cable)
    {
    }
    PortError open(TimePoint now) override
    {
        ++m_cable.opened;
        m_cable.board->advance(now);
        (void)m_cable.board->takeOutput(); // what came while it was unplugged
        return {};
    }
    void close() override { m_open = false; }
    void write(ByteView bytes, TimePoint now) override
    {
        const auto passed = m_cable.writing ? pass(bytes.size()) : bytes.size();
        const ByteView part = bytes.first(passed);
        // START_MOTOR of motor 1; a payload is a write of its own.
        constexpr std::uint8_t kStart = 0x19;
        m_cable.starts += bytes.size() == 2 && bytes[0] == kStart && bytes[1] == 0 ? 1 : 0;
        if (!part.empty())
            m_cable.board->receive(part, now);
        m_freeAt = now + wireTime(bytes.size(), 1843200);
        if (passed < bytes.size())
            vanish();
    }
    bool sent(TimePoint now) const override { return now >= m_freeAt; }
    void advance(TimePoint now) override
    {
        m_cable.board->advance(now);
        const Bytes bytes = m_cable.board->takeOutput();
        if (bytes.empty() || !m_open)
            return;
        const auto passed = m_cable.writing ? bytes.size() : pass(bytes.size());
        if (passed > 0)
            Q_EMIT received(QByteArray(
                reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(passed)));
        if (passed < bytes.size())
            vanish();
    }
    std::optional<TimePoint> nextWake() const override { return m_cable.board->nextWake(); }
    bool real() const override { return false; }

private:
    std::size_t pass(std::size_t bytes)
    {
        if (m_cable.broken)
            return bytes;
        const auto passed = static_cast<std::size_t>(std::min<std::uint64_t>(bytes, m_cable.left));
        m_cable.left -= passed;
        m_cable.broken = passed < bytes;
        return passed;
    }
    void vanish()
    {
        m_open = false;
        Q_EMIT failed({PortProblem::Unplugged, QStringLiteral("gone")});
    }

    Cable &m_cable;
    bool m_open = true;
    TimePoint m_freeAt{};
};

struct CableWorld {
    TimePoint now{1000s};
    Cable cable;
    std::map<drive::WishId, int> ended;
    bool running = false;
    drive::LinkState link = drive::LinkState::Closed;
    int identified = 0;
    std::shared_ptr<const catalog::Catalog> catalog;
    bool armed = false;
    Session session;

    CableWorld(bool writing, std::uint64_t left)
        : session(parts(*this))
    {
        simulation::BoardOptions options;
        options.hfHz = 2000.0; // the motor is not what is looked at
        cable.board = simulation::makeBoard(options);
        cable.writing = writing;
        cable.left = left;
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                for (const drive::Event &event : batch->events)
                    note(event);
                session.acknowledge();
            });
        QObject::connect(
            &session, &Session::armedChanged, &session, [this](bool on) { armed = on; });
    }
    static session::Parts parts(CableWorld &world)
    {
        session::Parts parts = session::realParts();
        parts.clock = [&world] { return world.now; };
        parts.transport = [&world](const session::Endpoint &) {
            return std::make_unique<CableTransport>(world.cable);
        };
        return parts;
    }
    static session::Endpoint serial()
    {
        return {session::Endpoint::Kind::Serial, QStringLiteral("cable"), 1'843'200, {}, true};
    }
    void note(const drive::Event &event)
    {
        if (const auto *end = std::get_if<drive::Ended>(&event)) {
            ++ended[end->id];
        } else if (const auto *who = std::get_if<drive::Identified>(&event)) {
            ++identified;
            catalog = who->catalog;
        } else if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
            running = status->state == drive::MotorState::Running;
        } else if (const auto *change = std::get_if<drive::LinkChanged>(&event)) {
            link = change->state;
        }
    }
    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        while (!condition()) {
            const auto next = session.nextStep();
            if (now >= end)
                return false;
            now = std::max(std::min(next.value_or(end), end), now + 1us);
            session.step(now);
        }
        return true;
    }
    /// Connect, arm, start, stream, write: what has bytes of every kind.
    void work()
    {
        session.open(serial());
        runUntil([this] { return identified > 0; }, 3s);
        brokenBeforeArming = cable.broken;
        session.setArmed(true);
        drive::WishId id = 0;
        const auto ask = [&](auto what) {
            session.submit({.id = ++id, .what = std::move(what)});
            runUntil([&] { return ended[id] > 0; }, 1s);
        };
        ask(drive::Command{drive::MotorAction::Start, 1});
        runUntil([this] { return running; }, 500ms);
        if (catalog != nullptr) {
            ask(drive::Stream{{*catalog->resolve("I_A")}, 1, {}, 1});
            ask(drive::Write{{{*catalog->resolve("SPEED_KP"), std::int64_t{3000}}}});
            ask(drive::Read{{*catalog->resolve("BUS_VOLTAGE"), *catalog->resolve("MOTOR_CONFIG")}});
        }
        asked = id;
    }
    drive::WishId asked = 0;
    bool brokenBeforeArming = false;
};

} // namespace

void TestUnplugAnywhere::anyByteCanBeTheLast_data()
{
    QTest::addColumn<bool>("writing");
    QTest::addRow("while it reads") << false;
    QTest::addRow("while it writes") << true;
}

void TestUnplugAnywhere::anyByteCanBeTheLast()
{
    QFETCH(bool, writing);
    const std::uint64_t step = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0 ? 1 : 37;
    const std::uint64_t bytes = writing ? 400 : 1500;
    int broke = 0;
    for (std::uint64_t at = 0; at < bytes; at += step) {
        const QByteArray place = "byte " + QByteArray::number(qulonglong(at));
        CableWorld world(writing, at);
        world.work();
        broke += world.cable.broken ? 1 : 0;
        if (!world.cable.broken)
            break; // the session had no more bytes
        QVERIFY2(world.runUntil(
                     [&] {
                         return world.link == drive::LinkState::Connected && world.cable.opened > 1
                             && world.identified > 0;
                     },
                     5s),
            place.constData());
        QVERIFY2(world.cable.starts <= 1, place.constData());
        for (drive::WishId id = 1; id <= world.asked; ++id)
            QVERIFY2(world.ended[id] == 1, place.constData());
        QVERIFY2(!world.armed || world.brokenBeforeArming, place.constData());
        QCOMPARE(world.cable.opened, 2);
    }
    QVERIFY2(broke > 5, "the cable never broke");
}

QTEST_GUILESS_MAIN(TestUnplugAnywhere)
#include "tst_unplug_anywhere.moc"

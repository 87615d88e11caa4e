// How often the thread of a link is woken beside a board that streams, and how often that board is asked: by the
// session with the real drive, on virtual time, for a port that is told of as a serial one.
#include "session/link/session.h"
#include "support/judged_line.h"

#include <QtTest>

#include <algorithm>

using namespace std::chrono_literals;
using session::Session;

class TestWakeUps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void besideAMotorAtRestTheLinkSleeps();
    void whoeverIsArmedIsShownAllAsEver();
};

namespace {

/// A serial port with a notifier that can be switched off (as in SerialTransport); what comes meanwhile waits in the
/// system.
class Port : public session::Transport {
public:
    explicit Port(std::unique_ptr<session::Transport> line)
        : m_line(std::move(line))
    {
        QObject::connect(m_line.get(), &Transport::received, this,
            [this](const QByteArray &bytes) { m_waiting += bytes; });
    }

    session::PortError open(TimePoint now) override { return m_line->open(now); }
    void close() override { m_line->close(); }
    void write(ByteView bytes, TimePoint now) override { m_line->write(bytes, now); }
    bool sent(TimePoint now) const override { return m_line->sent(now); }
    void advance(TimePoint now) override
    {
        if (m_listensAt && now >= *m_listensAt)
            listen();
    }
    std::optional<TimePoint> nextWake() const override { return m_listensAt; }
    void gather(Duration atMost, TimePoint now) override
    {
        if (atMost == Duration::zero())
            listen();
        else if (m_listensAt)
            m_listensAt = std::min(*m_listensAt, now + atMost);
        else if (m_read)
            m_listensAt = now + atMost;
    }
    bool real() const override { return true; }

    /// The line goes on while threads sleep.
    void bring(TimePoint now) { m_line->advance(now); }
    bool wakes() const { return !m_listensAt && !m_waiting.isEmpty(); }
    void read()
    {
        m_read = true;
        Q_EMIT received(std::exchange(m_waiting, {}));
    }

private:
    void listen()
    {
        if (std::exchange(m_listensAt, std::nullopt))
            m_read = false;
    }

    std::unique_ptr<session::Transport> m_line;
    QByteArray m_waiting;
    std::optional<TimePoint> m_listensAt;
    bool m_read = false;
};

/// A session that sleeps until its timer, its port or its window wakes it.
struct WakingWorld {
    TimePoint now{1000s};
    support::JudgedWorld line{{}, drive::Protocol::Mcp, [this] { return now; }};
    Port *port = nullptr;
    Session session;
    std::optional<drive::Identified> board;
    std::optional<drive::MotorStatus> status;
    int wakeUps = 0, readings = 0, statuses = 0;
    capture::Tick lost = 0;

    WakingWorld()
        : session(parts())
    {
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                for (const drive::Event &event : batch->events)
                    look(event);
                ++m_unacknowledged;
            });
    }

    session::Parts parts()
    {
        session::Parts parts = line.parts();
        parts.transport = [this, make = parts.transport](const session::Endpoint &endpoint) {
            auto made = std::make_unique<Port>(make(endpoint));
            port = made.get();
            return made;
        };
        return parts;
    }

    void look(const drive::Event &event)
    {
        if (const auto *identified = std::get_if<drive::Identified>(&event))
            board = *identified;
        if (const auto *read = std::get_if<drive::RegistersRead>(&event))
            readings += static_cast<int>(std::ranges::count(
                read->readings, board ? id("SPEED_RAMP") : 0, &drive::Reading::id));
        if (const auto *motor = std::get_if<drive::MotorStatus>(&event)) {
            status = *motor;
            ++statuses;
        }
        if (const auto *block = std::get_if<capture::SampleBlock>(&event))
            lost += block->lostTicks;
    }

    void run(Duration time)
    {
        constexpr Duration kTick = 1ms, kLeastBetweenWakes = 900us; // as Session has it
        for (const TimePoint end = now + time; now < end;) {
            const TimePoint timer =
                std::max(session.nextStep().value_or(end), m_woken + kLeastBetweenWakes);
            now = std::max(now, std::min({end, timer, m_brought + kTick}));
            if (now >= m_brought + kTick) {
                m_brought = now;
                port->bring(now);
            }
            bool awake = false;
            if (now >= timer) {
                awake = true;
                m_woken = now;
                session.step(now);
            }
            if (std::exchange(m_unacknowledged, 0) > 0) { // the window's thread has taken it in
                ++wakeUps;
                session.acknowledge();
            }
            if (port->wakes()) {
                awake = true;
                port->read();
            }
            wakeUps += awake ? 1 : 0;
        }
    }
    /// Four signals at the control rate, 70 % of the line, and what a window shows.
    bool connect()
    {
        session.open({});
        run(2s);
        if (!board || !status)
            return false;
        drive::Stream stream;
        for (const char *name : {"I_A", "I_B", "I_Q_MEAS", "STOPLL_ROT_SPEED"})
            stream.fast.push_back(id(name));
        drive::Watch watch{.registers = {}, .period = 100ms};
        for (const char *name :
            {"CONTROL_MODE", "SPEED_RAMP", "SPEED_REF", "SPEED_MEAS", "BUS_VOLTAGE", "I_Q_REF"})
            watch.registers.push_back(id(name));
        session.submit({.id = 0, .what = stream});
        session.submit({.id = 0, .what = watch});
        run(1s);
        return true;
    }
    drive::RegisterId id(const char *name) const { return *board->catalog->resolve(name); }

    struct Rates {
        double wakeUps, readings, statuses; ///< a second
    };
    Rates rates(Duration time = 10s)
    {
        wakeUps = readings = statuses = 0;
        run(time);
        const double seconds = toSeconds(time);
        return {wakeUps / seconds, readings / seconds, statuses / seconds};
    }

private:
    TimePoint m_brought{}, m_woken{};
    int m_unacknowledged = 0;
};

std::string textOf(const WakingWorld::Rates &rates)
{
    return "woken " + std::to_string(rates.wakeUps) + ", watched " + std::to_string(rates.readings)
        + ", states " + std::to_string(rates.statuses) + " times a second";
}

} // namespace

void TestWakeUps::besideAMotorAtRestTheLinkSleeps()
{
    WakingWorld world;
    QVERIFY(world.connect());
    const WakingWorld::Rates rates = world.rates();
    QVERIFY2(rates.wakeUps <= 140.0, textOf(rates).c_str());
    QVERIFY2(std::abs(rates.readings - 5.0) < 0.5, textOf(rates).c_str());
    QVERIFY2(rates.statuses >= 9.5, textOf(rates).c_str());
    QCOMPARE(world.lost, 0);
}

void TestWakeUps::whoeverIsArmedIsShownAllAsEver()
{
    WakingWorld world;
    QVERIFY(world.connect());
    world.session.setArmed(true);
    const WakingWorld::Rates armed = world.rates();
    QVERIFY2(armed.readings >= 9.5 && armed.statuses >= 9.5, textOf(armed).c_str());
    world.session.submit({.id = 1, .what = drive::Command{drive::MotorAction::Start, 1}});
    world.run(4s);
    QCOMPARE(world.status->state, drive::MotorState::Running);
    const WakingWorld::Rates driven = world.rates();
    QVERIFY2(driven.readings >= 9.5 && driven.statuses >= 9.5, textOf(driven).c_str());
    QCOMPARE(world.lost, 0);
}

QTEST_GUILESS_MAIN(TestWakeUps)
#include "tst_wake_ups.moc"

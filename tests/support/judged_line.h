// A line to a simulated board that the judge of the wire watches, for sessions. In a thread of their own: the window
// puts acts in from its thread, the line puts bytes and the board's truth in from the session's; time is the session's
// clock, which may be pushed ahead, and bounds are wide. On a test's own clock: what is asked of the drive are the
// acts, and bounds are those of a drive. The board lives on while its cable is out.
#pragma once

#include "drive/protocol_table.h"
#include "session/link/session.h"
#include "simulation/mcb/board.h"
#include "simulation/simulated_board.h"
#include "support/act_sink.h"
#include "support/board_history.h"
#include "support/judge_speaks.h"
#include "support/judged_drive.h"
#include "support/ms_rules.h"
#include "support/wire/fcp.h"
#include "support/wire/fcp_board.h"
#include "support/wire/mcb.h"
#include "support/wire/mcb_board.h"
#include "support/wire/mcp.h"
#include "support/wire/mcp_board.h"
#include "support/wire/wire_tape.h"

#include <QSemaphore>

#include <atomic>
#include <mutex>
#include <utility>

namespace support {

using namespace std::chrono_literals;

/// The thread takes no part in anything meanwhile, and leaves the computer to others.
inline void standStill(int ms) { QSemaphore().tryAcquire(1, ms); }

/// What the two threads share. A mutex is right here: the judge is no part of the product.
class JudgedWorld : public ActSink {
public:
    /// @param clock  of the test; none: the real one
    JudgedWorld(
        simulation::BoardOptions options, drive::Protocol protocol, session::Clock clock = {})
        : m_options(std::move(options))
        , m_protocol(protocol)
        , m_virtual(clock)
        , m_clock(clock ? std::move(clock) : session::realParts().clock)
    {
    }

    virtual ~JudgedWorld() { speak(m_judge, !verdictTaken); }
    JudgedWorld(const JudgedWorld &) = delete;
    JudgedWorld &operator=(const JudgedWorld &) = delete;

    // For the window's thread.
    bool verdictTaken = false; ///< the test says more than the judge
    std::atomic<bool> plugged = true;
    std::atomic<bool> cut = false; ///< nothing gets through
    std::atomic<bool> reset = false; ///< power cycle, once
    std::atomic<int> fault = -1; ///< fault bits to be present from now on
    std::atomic<bool> shortFault = false; ///< an overcurrent that is over at once, once
    /// The motor of the board that is met when the port is opened next; empty: the same board as before.
    void swapAtOpening(const std::string &motor)
    {
        const std::lock_guard lock(m_mutex);
        m_nextMotor = motor;
    }
    void jump(Duration time)
    {
        const std::lock_guard lock(m_mutex);
        m_troubled = now();
        m_offset += time.count();
        m_troubled = now();
    }
    /// The session's thread, once, as soon as it serves the line again.
    void freeze(int ms) { m_freeze_ms = ms; }
    /// The session's thread has not served the line for a while, because a test froze it or no core was free for it.
    bool frozen()
    {
        const std::lock_guard lock(m_mutex);
        return m_served && now() - *m_served > kFrozen;
    }
    /// The window's thread stood still until now.
    void stoodStill()
    {
        const std::lock_guard lock(m_mutex);
        m_troubled = now();
    }

    void act(judge::Act::Kind kind) override
    {
        const std::lock_guard lock(m_mutex);
        judge::Act act;
        act.kind = kind;
        act.at = now();
        m_judge.act(act);
    }
    void said(judge::Word word, int motor) override
    {
        const std::lock_guard lock(m_mutex);
        m_judge.said(word, motor, now());
    }
    void said(judge::LinkState link) override
    {
        const std::lock_guard lock(m_mutex);
        m_linkChanged = now();
        m_judge.said(link, now());
    }
    void saidIdentified(int motors) override
    {
        const std::lock_guard lock(m_mutex);
        m_judge.saidIdentified(motors, now());
    }
    std::string verdict()
    {
        const std::lock_guard lock(m_mutex);
        return m_judge.verdict();
    }
    /// What went over the line until the judge of the wire found something, or until now.
    std::string tape()
    {
        const std::lock_guard lock(m_mutex);
        return m_tapeOfFinding.empty() ? m_tape.text(now()) : m_tapeOfFinding;
    }
    /// What is written from now on is counted anew.
    void forgetWritten()
    {
        const std::lock_guard lock(m_mutex);
        m_judge.forgetWritten();
    }
    judge::MsRules::Counts counts()
    {
        const std::lock_guard lock(m_mutex);
        return m_judge.counts();
    }

    /// What the board did in the time before now, for a judge of what a screen says.
    BoardHistory::Span lately(int motor, Duration time)
    {
        const std::lock_guard lock(m_mutex);
        return m_history.span(motor, now() - time, now());
    }
    bool isDriven() ///< any motor, now
    {
        const std::lock_guard lock(m_mutex);
        return m_history.isDriven();
    }
    /// When a motor had a fault. @param again  also one that it still kept from before
    std::vector<TimePoint> faultTimes(int motor, bool again)
    {
        const std::lock_guard lock(m_mutex);
        std::vector<TimePoint> all;
        for (const BoardHistory::Fault &one : m_history.faults())
            if (one.motor == motor && (again || isTold(one)))
                all.push_back(one.at);
        return all;
    }
    /// When set-points left.
    std::vector<TimePoint> setPointTimes()
    {
        const std::lock_guard lock(m_mutex);
        return m_setPoints;
    }
    /// When the window was told last that the link changed: nothing came before.
    TimePoint linkChanged()
    {
        const std::lock_guard lock(m_mutex);
        return m_linkChanged;
    }
    /// How often the port was opened.
    int openings()
    {
        const std::lock_guard lock(m_mutex);
        return m_openings;
    }
    bool wasReset()
    {
        const std::lock_guard lock(m_mutex);
        return m_resets > 0;
    }
    /// When it was last: what it sent before is not known any more, long before the window is told.
    TimePoint resetAt()
    {
        const std::lock_guard lock(m_mutex);
        return m_resetAt;
    }
    std::vector<BoardHistory::Fault> faults()
    {
        const std::lock_guard lock(m_mutex);
        std::vector<BoardHistory::Fault> all;
        for (const BoardHistory::Fault &one : m_history.faults())
            if (isTold(one))
                all.push_back(one);
        return all;
    }
    /// What was kept already may be there again unseen; a servo tells the first fault that stopped it, until it is
    /// acknowledged.
    bool isTold(const BoardHistory::Fault &one) const
    {
        return one.kept && (one.alone || mcp() || older());
    }
    /// How long nothing has come from the board that the session could have heard.
    Duration silence()
    {
        const std::lock_guard lock(m_mutex);
        return now() - m_heardAt;
    }
    /// What an MCP board told, and which samples it sent: `look` must not take long.
    template <class Look>
    auto ofBoard(Look look) -> decltype(look(std::declval<const judge::McpBoard &>()))
    {
        const std::lock_guard lock(m_mutex);
        return look(std::as_const(m_says));
    }
    /// What the board gave for a register, the oldest first. @param id  with its motor
    std::deque<judge::GivenValues::Value> given(std::uint16_t id)
    {
        const std::lock_guard lock(m_mutex);
        return (mcp()     ? m_says.given()
                : older() ? m_olderSays.given()
                          : m_servoSays.given())
            .of(id);
    }
    bool mcp() const { return m_protocol == drive::Protocol::Mcp; }
    /// When the newest value of a register came, sent or given; empty: none did lately.
    std::optional<TimePoint> newestOf(std::uint16_t id)
    {
        std::optional<TimePoint> newest;
        if (mcp())
            newest = ofBoard([id](const judge::McpBoard &board) { return board.sampledAt(id); });
        if (const auto values = given(id); !values.empty())
            newest = std::max(newest.value_or(TimePoint{}), values.back().at);
        const std::lock_guard lock(m_mutex);
        if (newest) // what it sent before it began anew is not kept
            newest = std::max(*newest, m_resetAt);
        return newest;
    }
    bool older() const
    {
        return m_protocol == drive::Protocol::Fcp || m_protocol == drive::Protocol::PowerPc;
    }
    const simulation::BoardOptions &options() const { return m_options; }
    /// By which the clock may have gone apart from the board's samples since the port was opened.
    Duration drift()
    {
        const std::lock_guard lock(m_mutex);
        return m_drift;
    }
    /// Of current registers of 16 bits; 0: not known.
    double ampsPerDigit()
    {
        const std::lock_guard lock(m_mutex);
        return m_ampsPerDigit;
    }
    bool everHeard()
    {
        const std::lock_guard lock(m_mutex);
        return m_heardAt != TimePoint{};
    }
    /// Since the port was closed on purpose, not because the cable was gone.
    Duration sinceClosed()
    {
        const std::lock_guard lock(m_mutex);
        return now() - m_closedAt;
    }
    /// Since a thread stood still or the clock jumped: before that all is unknown.
    Duration sinceTrouble()
    {
        const std::lock_guard lock(m_mutex);
        return now() - m_troubled;
    }

    /// Ones for a session: the clock, the judged line, the product's own drives.
    session::Parts parts();

    TimePoint now() const { return m_clock() + Duration(m_offset); }

private:
    class Line;
    static constexpr std::uint16_t kOvercurrent = 0x0040;
    static constexpr Duration kShort = 5ms;
    static constexpr Duration kFrozen = 300ms; ///< it is served every 50 ms, mostly every one

    judge::Line lineOf() const
    {
        judge::Line line;
        const simulation::MotorTruth truth = m_board->truth(1);
        line.motors = m_options.motors;
        line.baud = m_options.baud;
        line.maxRpm = truth.maxRpm;
        line.maxAmps = m_protocol == drive::Protocol::Mcp ? truth.maxAmps : 0.0;
        line.answerWithin = m_protocol == drive::Protocol::Mcp ? 10s : 0s;
        line.startParts = line.referenceParts = m_protocol == drive::Protocol::Mcb ? 2 : 1;
        if (m_virtual)
            return line;
        // Two threads, a window and a busy computer are between an act and the line.
        line.grace = 300ms;
        line.fresh = 1500ms;
        line.firstStop = line.repeat = 1s;
        line.alarm = 3s;
        line.suspect = line.lost = {};
        line.asksFirst = true;
        line.startParts = line.referenceParts = 2;
        return line;
    }
    std::unique_ptr<judge::Decoder> decoder() const
    {
        if (m_protocol == drive::Protocol::Mcp)
            return std::make_unique<judge::WireMcp>(m_options.baud, m_board->truth(1).ampsPerDigit);
        if (m_protocol == drive::Protocol::Mcb)
            return std::make_unique<judge::WireMcb>();
        return std::make_unique<judge::WireFcp>();
    }
    void keepTape()
    {
        if (m_tapeOfFinding.empty() && !m_judge.verdict().empty())
            m_tapeOfFinding = m_tape.text(now());
    }
    void hear(ByteView bytes, TimePoint at, bool arrives)
    {
        m_tape.add(false, bytes, at, arrives);
        if (mcp())
            m_says.says(bytes, at, arrives);
        else if (older())
            m_olderSays.says(bytes, at, arrives);
        else
            m_servoSays.says(bytes, at, arrives);
    }
    void makeBoard()
    {
        if (m_protocol == drive::Protocol::Mcb) {
            simulation::McbBoardOptions servo;
            servo.board = m_options;
            m_board = simulation::makeMcbBoard(servo);
        } else {
            m_board = simulation::makeBoard(m_options);
        }
    }

    simulation::BoardOptions m_options;
    drive::Protocol m_protocol;
    bool m_virtual;
    std::atomic<int> m_freeze_ms = 0;
    session::Clock m_clock;
    std::atomic<Duration::rep> m_offset = 0;
    std::mutex m_mutex;
    judge::MsRules m_judge; ///< behind the mutex
    WireTape m_tape;
    std::string m_tapeOfFinding;
    std::unique_ptr<simulation::SimulatedBoard> m_board; ///< of the session's thread
    TimePoint m_boardTime{1s}, m_last{};
    std::optional<TimePoint> m_shortFaultEnds; ///< on the board's clock
    BoardHistory m_history; ///< behind the mutex, as the three
    TimePoint m_heardAt{}, m_troubled{}, m_closedAt{};
    std::optional<TimePoint> m_served; ///< when the open line was, at last
    judge::McpBoard m_says; ///< these, too
    judge::FcpBoard m_olderSays;
    judge::McbBoard m_servoSays;
    std::vector<TimePoint> m_setPoints;
    int m_resets = 0, m_openings = 0;
    TimePoint m_resetAt{}; ///< the last time
    TimePoint m_linkChanged{};
    Duration m_drift{};
    double m_ampsPerDigit = 0.0;
    std::string m_nextMotor;
    Bytes m_early; ///< what had left the board when it was reset; of the session's thread
};

/// The cable. Made anew with each opening of the port.
class JudgedWorld::Line : public session::Transport {
public:
    explicit Line(JudgedWorld &world)
        : m_world(world)
    {
    }
    ~Line() override { close(); }

    session::PortError open(TimePoint now) override
    {
        if (!m_world.plugged)
            return {session::PortProblem::NotFound, {}};
        const std::lock_guard lock(m_world.m_mutex);
        const bool other = !m_world.m_nextMotor.empty();
        if (other) {
            m_world.m_options.motor = std::exchange(m_world.m_nextMotor, {});
            m_world.m_says = {};
            m_world.m_olderSays = {};
            m_world.m_servoSays = {};
        }
        if (!m_world.m_board || other)
            m_world.makeBoard();
        m_world.m_last = now;
        m_world.m_served = now;
        ++m_world.m_openings;
        m_world.m_drift = {};
        m_world.m_says.forgetSamples(); // their times begin anew
        m_world.m_ampsPerDigit = m_world.m_board->truth(1).ampsPerDigit;
        m_open = true;
        if (!m_world.m_judge.watching() || other)
            m_world.m_judge.watch(m_world.decoder(), m_world.lineOf());
        judge::Act act;
        act.at = now;
        m_world.m_judge.act(act);
        return {};
    }
    void close() override
    {
        if (!std::exchange(m_open, false))
            return;
        const std::lock_guard lock(m_world.m_mutex);
        m_world.m_served.reset();
        m_world.m_closedAt = m_world.now();
        if (!m_world.m_virtual) // else the drive's disconnect() has told already
            m_world.m_judge.closes(m_world.now());
        judge::Act act;
        act.kind = judge::Act::Kind::Close;
        act.at = m_world.now();
        m_world.m_judge.act(act);
    }
    void write(ByteView bytes, TimePoint now) override
    {
        if (!m_open)
            return;
        {
            const std::lock_guard lock(m_world.m_mutex);
            const int before = m_world.m_judge.counts().setPoints;
            m_world.m_tape.add(true, bytes, now, !m_world.cut);
            m_world.m_judge.sent(bytes, now);
            m_world.keepTape();
            if (m_world.m_judge.counts().setPoints > before)
                m_world.m_setPoints.push_back(now);
        }
        moveOn(now);
        const bool cut = m_world.cut; // it may change meanwhile
        if (!cut)
            m_world.m_board->receive(bytes, m_world.m_boardTime);
        const std::lock_guard lock(m_world.m_mutex);
        if (m_world.mcp())
            m_world.m_says.asks(bytes, !cut);
        else if (m_world.older())
            m_world.m_olderSays.asks(bytes, !cut);
        else
            m_world.m_servoSays.asks(bytes, !cut);
    }
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint now) override
    {
        if (!m_open)
            return;
        if (!m_world.plugged) {
            m_open = false;
            {
                const std::lock_guard lock(m_world.m_mutex);
                m_world.m_served.reset();
                judge::Act act;
                act.kind = judge::Act::Kind::Unplugged;
                act.at = now;
                m_world.m_judge.act(act);
            }
            Q_EMIT failed({session::PortProblem::Unplugged, {}});
            return;
        }
        obey();
        moveOn(now);
        const bool cut = m_world.cut; // it may change meanwhile
        Bytes out = std::exchange(m_world.m_early, {});
        const Bytes later = m_world.m_board->takeOutput();
        {
            const std::lock_guard lock(m_world.m_mutex);
            m_world.hear(later, now, !cut);
            std::vector<judge::Motor> truth;
            std::vector<simulation::MotorTruth> motors;
            for (int motor = 1; motor <= m_world.m_options.motors; ++motor) {
                motors.push_back(m_world.m_board->truth(motor));
                const simulation::MotorTruth &is = motors.back();
                truth.push_back({is.driven, is.idle, is.rpm});
            }
            m_world.m_history.add(now, std::move(motors));
            out.insert(out.end(), later.begin(), later.end());
            if (!cut) {
                m_world.m_judge.heard(out, now);
                if (!out.empty())
                    m_world.m_heardAt = now;
            }
            m_world.m_judge.look(now, truth);
            m_world.keepTape();
        }
        if (!out.empty() && !cut)
            Q_EMIT received(QByteArray(
                reinterpret_cast<const char *>(out.data()), static_cast<qsizetype>(out.size())));
    }
    std::optional<TimePoint> nextWake() const override
    {
        if (!m_open)
            return std::nullopt;
        return m_world.m_last
            + std::clamp<Duration>(m_world.m_board->nextWake() - m_world.m_boardTime, 1ms, 50ms);
    }
    bool real() const override { return true; }

private:
    void moveOn(TimePoint now)
    {
        const Duration passed = std::max<Duration>(now - m_world.m_last, 0ns);
        const Duration lives = std::min<Duration>(passed, 100ms);
        m_world.m_boardTime += lives;
        m_world.m_last += passed;
        {
            const std::lock_guard lock(m_world.m_mutex);
            m_world.m_drift += passed - lives;
            m_world.m_served = m_world.m_last;
            if (passed > kFrozen)
                m_world.m_troubled = m_world.now();
        }
        m_world.m_board->advance(m_world.m_boardTime);
    }
    void obey()
    {
        if (m_world.reset.exchange(false)) {
            m_world.m_early = m_world.m_board->takeOutput();
            m_world.m_board->reset();
            const std::lock_guard lock(m_world.m_mutex);
            m_world.hear(m_world.m_early, m_world.now(), !m_world.cut);
            m_world.m_says.reset();
            m_world.m_olderSays.reset();
            m_world.m_servoSays.reset();
            m_world.m_drift = {};
            ++m_world.m_resets;
            m_world.m_resetAt = m_world.now();
        }
        if (const int fault = m_world.fault.exchange(-1); fault >= 0)
            m_world.m_board->setFaults(static_cast<std::uint16_t>(fault));
        if (m_world.shortFault.exchange(false)) {
            m_world.m_board->setFaults(kOvercurrent);
            m_world.m_shortFaultEnds = m_world.m_boardTime + kShort;
        }
        if (m_world.m_shortFaultEnds && m_world.m_boardTime >= *m_world.m_shortFaultEnds) {
            m_world.m_shortFaultEnds.reset();
            m_world.m_board->setFaults(0);
        }
        if (const int ms = m_world.m_freeze_ms.exchange(0); ms > 0)
            standStill(ms);
    }

    JudgedWorld &m_world;
    bool m_open = false;
};

inline session::Parts JudgedWorld::parts()
{
    session::Parts parts = session::realParts();
    parts.clock = [this] { return now(); };
    parts.elapsed = {};
    // Whatever is chosen in the window, the board speaks one language only.
    parts.drive = [this](const session::Endpoint &endpoint) {
        return drive::makeDrive({m_protocol, endpoint.baud, endpoint.patience});
    };
    if (m_virtual) {
        parts.attendance = session::Attendance::OwnThread;
        parts.drive = [this, make = parts.drive](const session::Endpoint &endpoint) {
            return std::make_unique<JudgedDrive>(make(endpoint), m_judge);
        };
    }
    parts.transport = [this](const session::Endpoint &) { return std::make_unique<Line>(*this); };
    return parts;
}

} // namespace support

// Every simulated board that a session opens in this process, with the judge of the wire between it and its line. Bytes
// and truth come from the session's thread, acts from the window's; time is the real clock, so bounds are wide. What is
// wrong fails the test that is running when this ends.
#pragma once

#include "drive/protocol_table.h"
#include "session/link/session.h"
#include "session/transports/simulator_transport.h"
#include "simulation/fcp/motor_board.h"
#include "simulation/simulated_board.h"
#include "support/judge_speaks.h"
#include "support/ms_rules.h"
#include "support/window_acts.h"
#include "support/wire/either.h"
#include "support/wire/mcb.h"

#include <functional>
#include <mutex>
#include <utility>

namespace support {

class JudgedBoards final : public ActSink {
public:
    JudgedBoards() = default;
    ~JudgedBoards()
    {
        for (const auto &judge : m_judges)
            speak(*judge, true);
    }
    JudgedBoards(const JudgedBoards &) = delete;
    JudgedBoards &operator=(const JudgedBoards &) = delete;

    session::Parts watch(session::Parts parts)
    {
        m_clock = parts.clock;
        parts.transport = [this, make = std::move(parts.transport)](
                              const session::Endpoint &endpoint) {
            if (endpoint.kind != session::Endpoint::Kind::Simulator)
                return make(endpoint);
            return std::unique_ptr<session::Transport>(
                std::make_unique<session::SimulatorTransport>(
                    [this, endpoint] { return std::make_unique<Board>(*this, endpoint); }));
        };
        return parts;
    }

    /// This rule is not judged here, of any board.
    void excuse(const std::string &rule, const std::string &reason)
    {
        const std::lock_guard lock(m_mutex);
        m_excused.emplace_back(rule, reason);
        if (m_judge)
            m_judge->excuse(rule, reason);
    }

    /// What a board sends in so long after its line was opened is lost: it boots, or a debugger holds it.
    std::chrono::milliseconds silentAtFirst{};

    /// What the first motor's firmware wants, at each look; in the session's thread, and set before it runs.
    std::function<void(TimePoint, const simulation::MotorTruth &)> truthOfFirst;

    void act(judge::Act::Kind kind) override
    {
        const std::lock_guard lock(m_mutex);
        if (m_judge)
            tell(kind);
    }
    void said(judge::Word word, int motor) override
    {
        const std::lock_guard lock(m_mutex);
        if (m_judge)
            m_judge->said(word, motor, m_clock());
    }
    void said(judge::LinkState link) override
    {
        const std::lock_guard lock(m_mutex);
        if (m_judge)
            m_judge->said(link, m_clock());
    }
    void saidIdentified(int motors) override
    {
        const std::lock_guard lock(m_mutex);
        if (m_judge)
            m_judge->saidIdentified(motors, m_clock());
    }

private:
    class Board;

    void tell(judge::Act::Kind kind)
    {
        judge::Act act;
        act.kind = kind;
        act.at = m_clock();
        m_judge->act(act);
    }
    session::Clock m_clock;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<judge::MsRules>> m_judges; ///< one a board; behind the mutex
    judge::MsRules *m_judge = nullptr; ///< of the board that is open, or was last
    std::vector<std::pair<std::string, std::string>> m_excused; ///< behind the mutex
};

/// Lives in the session's thread, from the opening of the line to its end.
class JudgedBoards::Board final : public simulation::ByteDevice {
public:
    Board(JudgedBoards &world, const session::Endpoint &endpoint)
        : m_world(world)
    {
        if (!endpoint.board.empty())
            m_options.profile = endpoint.board;
        m_options.motors = endpoint.boardMotors;
        m_options.baud = endpoint.baud;
        m_board = simulation::makeBoard(m_options);
        if (!m_board)
            return;
        if (m_world.silentAtFirst.count() > 0)
            m_board->mute(m_world.silentAtFirst);
        const std::lock_guard lock(m_world.m_mutex);
        m_world.m_judges.push_back(std::make_unique<judge::MsRules>());
        m_world.m_judge = m_world.m_judges.back().get();
        for (const auto &[rule, reason] : m_world.m_excused)
            m_world.m_judge->excuse(rule, reason);
        m_world.m_judge->watch(decoder(endpoint.protocol), line());
        m_world.tell(judge::Act::Kind::Open);
    }
    ~Board() override
    {
        const std::lock_guard lock(m_world.m_mutex);
        if (!m_world.m_judge || !m_board)
            return;
        m_world.m_judge->closes(m_world.m_clock());
        m_world.tell(judge::Act::Kind::Close);
    }

    void receive(ByteView bytes, TimePoint now) override
    {
        {
            const std::lock_guard lock(m_world.m_mutex);
            m_world.m_judge->sent(bytes, m_world.m_clock());
        }
        m_board->receive(bytes, now);
    }
    void advance(TimePoint now) override { m_board->advance(now); }
    Bytes takeOutput() override
    {
        Bytes out = m_board->takeOutput();
        const std::lock_guard lock(m_world.m_mutex);
        std::vector<judge::Motor> truth;
        for (int motor = 1; motor <= m_options.motors; ++motor) {
            const simulation::MotorTruth is = m_board->truth(motor);
            truth.push_back({is.driven, is.idle, is.rpm});
            if (motor == 1 && m_world.truthOfFirst)
                m_world.truthOfFirst(m_world.m_clock(), is);
        }
        m_world.m_judge->heard(out, m_world.m_clock());
        m_world.m_judge->look(m_world.m_clock(), truth);
        return out;
    }
    TimePoint nextWake() const override { return m_board->nextWake(); }

private:
    std::unique_ptr<judge::Decoder> decoder(drive::Protocol protocol) const
    {
        if (protocol == drive::Protocol::Mcb)
            return std::make_unique<judge::WireMcb>();
        // It may be asked in the words of another protocol first.
        if (simulation::isFcpProfile(m_options.profile) || m_world.silentAtFirst.count() > 0)
            return std::make_unique<judge::WireEither>();
        return std::make_unique<judge::WireMcp>(m_options.baud, m_board->truth(1).ampsPerDigit);
    }
    judge::Line line() const
    {
        using namespace std::chrono_literals;
        judge::Line line;
        const simulation::MotorTruth truth = m_board->truth(1);
        line.motors = m_options.motors;
        line.baud = m_options.baud;
        line.maxRpm = truth.maxRpm;
        // Two threads, a window and a busy computer are between an act and the line.
        line.grace = 1s;
        line.fresh = 5s;
        line.firstStop = line.repeat = 3s;
        line.alarm = 10s;
        line.suspect = line.lost = {};
        line.asksFirst = true;
        line.startParts = line.referenceParts = 2;
        return line;
    }

    JudgedBoards &m_world;
    simulation::BoardOptions m_options;
    std::unique_ptr<simulation::SimulatedBoard> m_board;
};

} // namespace support

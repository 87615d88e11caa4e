// A transport and a drive that do what a test says and remember what was done to them. Time is a
// number that the test moves.
#pragma once

#include "session/link/session.h"

#include <deque>
#include <functional>
#include <utility>
#include <vector>

namespace fakes {

using namespace std::chrono_literals;

inline Bytes bytes(std::initializer_list<std::uint8_t> list) { return list; }

class FakeTransport : public session::Transport {
public:
    struct Written {
        TimePoint at;
        Bytes bytes;
        bool operator==(const Written &) const = default;
    };
    struct Log {
        std::vector<Written> written;
        int opened = 0;
        int closed = 0;
        int discarded = 0;
        FakeTransport *alive = nullptr;
        session::PortError openResult; ///< what the next open() answers
        bool sent = true;
        Duration gathers{};
        std::function<void()> onWrite = {}, onAdvance = {};
    };

    explicit FakeTransport(Log &log)
        : m_log(log)
    {
        m_log.alive = this;
    }
    ~FakeTransport() override
    {
        if (m_log.alive == this)
            m_log.alive = nullptr;
    }

    session::PortError open(TimePoint) override
    {
        if (m_log.openResult.problem == session::PortProblem::None)
            ++m_log.opened;
        return m_log.openResult;
    }
    void close() override { ++m_log.closed; }
    void write(ByteView view, TimePoint now) override
    {
        if (m_log.onWrite)
            m_log.onWrite();
        m_log.written.push_back({now, Bytes(view.begin(), view.end())});
    }
    void discardOutput() override
    {
        ++m_log.discarded;
        m_log.sent = true;
    }
    bool sent(TimePoint) const override { return m_log.sent; }
    void gather(Duration atMost, TimePoint) override { m_log.gathers = atMost; }
    void advance(TimePoint) override
    {
        if (m_log.onAdvance)
            m_log.onAdvance();
    }
    std::optional<TimePoint> nextWake() const override { return {}; }
    bool real() const override { return false; }

    void hear(const QByteArray &data) { Q_EMIT received(data); }
    void fail() { Q_EMIT failed({session::PortProblem::Unplugged, QStringLiteral("gone")}); }

private:
    Log &m_log;
};

class FakeDrive : public drive::Drive {
public:
    struct Log {
        Bytes received;
        int stopsBeforeBytes = 0; ///< that came before the last ones
        std::vector<drive::Wish> wishes;
        std::vector<TimePoint> sentAt;
        std::vector<TimePoint> calledAt; ///< as bytes came, for a timeout, as bytes had left
        int connects = 0, disconnects = 0, stops = 0, doubts = 0, made = 0;
        std::vector<std::optional<drive::Protocol>> madeFor; ///< what was spoken there before
        FakeDrive *alive = nullptr;
        bool armedAtWish = false; ///< the last one
    };

    explicit FakeDrive(Log &log)
        : m_log(log)
    {
        ++m_log.made;
        m_log.alive = this;
    }
    ~FakeDrive() override
    {
        if (m_log.alive == this)
            m_log.alive = nullptr;
    }

    void connect(TimePoint) override { ++m_log.connects; }
    void disconnect(TimePoint) override
    {
        ++m_log.disconnects;
        if (farewell.empty())
            events.push_back(drive::LinkChanged{drive::LinkState::Closed, drive::LinkReason::None});
        else
            outputs.push_back({farewell, {}});
    }
    void receive(ByteView view, TimePoint now) override
    {
        m_log.calledAt.push_back(now);
        m_log.received.insert(m_log.received.end(), view.begin(), view.end());
        m_log.stopsBeforeBytes = m_log.stops;
    }
    void handleTimeout(TimePoint now) override
    {
        m_log.calledAt.push_back(now);
        if (timeout && *timeout <= now)
            timeout.reset();
    }
    void handleSent(TimePoint now) override
    {
        m_log.calledAt.push_back(now);
        m_log.sentAt.push_back(now);
    }
    std::vector<Output> takeOutput() override { return std::exchange(outputs, {}); }
    std::vector<drive::Event> takeEvents() override { return std::exchange(events, {}); }
    std::optional<TimePoint> nextTimeout() const override { return timeout; }
    void submit(drive::Wish wish, TimePoint) override
    {
        m_log.armedAtWish = m_armed;
        m_log.wishes.push_back(std::move(wish));
    }
    void stop(TimePoint) override
    {
        ++m_log.stops;
        m_armed = false;
        stopping = true;
    }
    bool stopOpen() const override { return stopping; }
    void arm() override { m_armed = true; }
    void disarm() override { m_armed = false; }
    bool armed() const override { return m_armed; }
    Duration gathersFor() const override { return gathers; }
    void remember(const drive::LineMemory &memory) override { known = memory; }
    drive::LineMemory memory() const override { return known; }
    std::vector<Output> stopScript() const override { return {{bytes({0x5A}), {}}}; }
    void doubt(TimePoint) override
    {
        ++m_log.doubts;
        m_armed = false;
    }

    std::vector<Output> outputs;
    std::vector<drive::Event> events;
    std::optional<TimePoint> timeout;
    drive::LineMemory known; ///< of the line
    Duration gathers{}; ///< it lets bytes wait so long
    bool stopping = false; ///< a stop is not confirmed
    Bytes farewell; ///< said at disconnect(), which then does not end by itself

private:
    Log &m_log;
    bool m_armed = false;
};

/// A session on virtual time with both fakes behind it.
struct Bench {
    TimePoint now{100s};
    FakeTransport::Log port;
    FakeDrive::Log board;
    session::Session session;
    std::vector<session::BatchPtr> batches;
    std::vector<std::pair<session::PortState, session::PortProblem>> ports;
    std::vector<bool> armed;
    std::vector<QStringList> wanted; ///< stops, at ports that are not open
    std::vector<session::Interruption> interruptions;
    Duration slept{}; ///< of the computer; `now` did not count it
    bool acknowledging = true;

    explicit Bench(session::Attendance attendance = session::Attendance::OwnThread,
        std::shared_ptr<session::Guardian> guardian = {})
        : session({.clock = [this] { return now; },
            .transport =
                [this](const session::Endpoint &) { return std::make_unique<FakeTransport>(port); },
            .drive =
                [this](const session::Endpoint &endpoint) {
                    board.madeFor.push_back(endpoint.spoken);
                    return std::make_unique<FakeDrive>(board);
                },
            .guardian = std::move(guardian),
            .elapsed = [this] { return now + slept; },
            .attendance = attendance})
    {
        using session::Session;
        QObject::connect(
            &session, &Session::batch, &session, [this](const session::BatchPtr &batch) {
                batches.push_back(batch);
                if (acknowledging)
                    session.acknowledge();
            });
        QObject::connect(&session, &Session::portChanged, &session,
            [this](session::PortState state, const session::PortError &why) {
                ports.emplace_back(state, why.problem);
            });
        QObject::connect(
            &session, &Session::armedChanged, &session, [this](bool on) { armed.push_back(on); });
        QObject::connect(&session, &Session::stopsWanted, &session,
            [this](const QStringList &places) { wanted.push_back(places); });
        QObject::connect(&session, &Session::interrupted, &session,
            [this](const session::Interruption &what) { interruptions.push_back(what); });
    }

    static session::Endpoint serial(const QString &path = QStringLiteral("bench"))
    {
        return {session::Endpoint::Kind::Serial, path, 1'000'000, {}, true};
    }
    FakeDrive &drive() { return *board.alive; }

    /// Moves to the next instant at which the session has something to do, `limit` at most.
    void runUntil(TimePoint limit)
    {
        while (true) {
            const auto next = session.nextStep();
            if (!next || *next > limit)
                break;
            now = std::max(now, *next);
            session.step(now);
        }
        now = limit;
        session.step(now);
    }
    void turn() { session.step(now); }

    template <class Event>
    std::vector<Event> told() const
    {
        std::vector<Event> found;
        for (const session::BatchPtr &batch : batches) {
            for (const drive::Event &event : batch->events) {
                if (const auto *match = std::get_if<Event>(&event))
                    found.push_back(*match);
            }
        }
        return found;
    }
};

} // namespace fakes

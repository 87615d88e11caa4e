// A Controller and a simulated board with a spoilable line between them, on virtual time: a failure is a seed.
#pragma once

#include "aspep/controller.h"
#include "simulation/simulated_board.h"
#include "support/judge_speaks.h"
#include "support/wire/mcp.h"

#include <deque>
#include <functional>
#include <random>

namespace support {

using namespace std::chrono_literals;

/// Chances a byte; lengths of what lasts.
struct SpoiltFaults {
    double flip = 0.0;
    double drop = 0.0;
    double duplicate = 0.0;
    double insert = 0.0;
    double stall = 0.0;
    double cut = 0.0;
    Duration stallTime = 100ms, cutTime = 100ms;
};

/// One direction. Bytes go in at a time and come out at the same or a later one, in order, perhaps spoilt.
class SpoiltLine {
public:
    SpoiltLine(SpoiltFaults faults, std::uint64_t seed)
        : m_faults(faults)
        , m_random(seed)
    {
    }
    void setFaults(const SpoiltFaults &faults) { m_faults = faults; }

    void put(ByteView bytes, TimePoint at)
    {
        Bytes out;
        for (const std::uint8_t byte : bytes)
            spoil(byte, at, out);
        if (!out.empty())
            m_queue.push_back({std::max(at, m_heldUntil), std::move(out)});
    }
    std::optional<TimePoint> next() const
    {
        return m_queue.empty() ? std::nullopt : std::optional(m_queue.front().at);
    }
    Bytes take(TimePoint now)
    {
        Bytes bytes;
        while (!m_queue.empty() && m_queue.front().at <= now) {
            bytes.insert(bytes.end(), m_queue.front().bytes.begin(), m_queue.front().bytes.end());
            m_queue.pop_front();
        }
        return bytes;
    }

private:
    struct Item {
        TimePoint at;
        Bytes bytes;
    };

    bool happens(double chance)
    {
        return chance > 0.0 && std::uniform_real_distribution(0.0, 1.0)(m_random) < chance;
    }

    void spoil(std::uint8_t byte, TimePoint at, Bytes &out)
    {
        if (happens(m_faults.cut))
            m_cutUntil = at + m_faults.cutTime;
        if (happens(m_faults.stall))
            m_heldUntil = std::max(m_heldUntil, at + m_faults.stallTime);
        if (at < m_cutUntil || happens(m_faults.drop))
            return;
        if (happens(m_faults.insert))
            out.push_back(static_cast<std::uint8_t>(m_random()));
        if (happens(m_faults.duplicate))
            out.push_back(byte);
        if (happens(m_faults.flip))
            byte = static_cast<std::uint8_t>(byte ^ 1U << (m_random() % 8));
        out.push_back(byte);
    }

    SpoiltFaults m_faults;
    std::mt19937_64 m_random;
    std::deque<Item> m_queue;
    TimePoint m_heldUntil{};
    TimePoint m_cutUntil{};
};

struct ControllerPair {
    using Tap = std::function<void(TimePoint, bool toBoard, ByteView)>;

    TimePoint now{};
    aspep::Controller controller;
    std::unique_ptr<simulation::SimulatedBoard> board;
    SpoiltLine toBoard, fromBoard;
    std::vector<aspep::Controller::Event> events;
    Tap tap; ///< sees what the Controller sends, and what it is given
    std::uint32_t baud = 1843200;

    explicit ControllerPair(
        simulation::BoardOptions options = {}, SpoiltFaults faults = {}, std::uint64_t seed = 1)
        : controller(config(options))
        , board(simulation::makeBoard(options))
        , toBoard(faults, seed)
        , fromBoard(faults, seed + 1)
        , baud(options.baud)
    {
        judge::Line line;
        line.baud = baud;
        line.suspect = line.lost = {}; // a Controller's word for a link is looked at by tests
        line.gap = 500us;
        line.answerWithin = 10s;
        judge.watch(std::make_unique<judge::WireMcp>(baud, 0.0), line);
    }
    ~ControllerPair() { speak(judge, true); }
    ControllerPair(const ControllerPair &) = delete;
    ControllerPair &operator=(const ControllerPair &) = delete;

    judge::MsRules judge; ///< of the wire: packets, their pauses, one in flight

    void setFaults(const SpoiltFaults &faults)
    {
        toBoard.setFaults(faults);
        fromBoard.setFaults(faults);
    }

    /// Lets the world go on until `end`; `each` is called after every step, and may talk to the Controller.
    void run(Duration duration, const std::function<void()> &each = {})
    {
        const TimePoint end = now + duration;
        while (now < end) {
            now = std::min(end, nextInstant());
            step();
            if (each)
                each();
            queueOutput();
        }
    }

    std::vector<aspep::Controller::Event> takeEvents() { return std::exchange(events, {}); }

private:
    struct Write {
        TimePoint at;
        Bytes bytes;
    };

    static aspep::Controller::Config config(const simulation::BoardOptions &options)
    {
        aspep::Controller::Config c;
        c.baud = options.baud;
        return c;
    }

    /// A host looks at its port about this often.
    static constexpr Duration kStep = 500us;

    TimePoint nextInstant() const
    {
        TimePoint next = now + kStep;
        const auto earlier = [&next](std::optional<TimePoint> at) {
            if (at)
                next = std::min(next, *at);
        };
        earlier(controller.nextTimeout());
        earlier(m_sentAt);
        earlier(toBoard.next());
        if (!m_writes.empty())
            earlier(m_writes.front().at);
        return std::max(next, now + 1us);
    }

    void step()
    {
        while (!m_writes.empty() && m_writes.front().at <= now) {
            if (tap)
                tap(now, true, m_writes.front().bytes);
            judge.sent(m_writes.front().bytes, now);
            toBoard.put(m_writes.front().bytes, now);
            m_writes.pop_front();
        }
        if (const Bytes bytes = toBoard.take(now); !bytes.empty())
            board->receive(bytes, now);
        board->advance(now);
        fromBoard.put(board->takeOutput(), now);
        if (m_sentAt && *m_sentAt <= now) {
            m_sentAt.reset();
            controller.handleSent(now);
        }
        if (const Bytes bytes = fromBoard.take(now); !bytes.empty()) {
            if (tap)
                tap(now, false, bytes);
            judge.heard(bytes, now);
            controller.receive(bytes, now);
        }
        if (const auto due = controller.nextTimeout(); due && *due <= now)
            controller.handleTimeout(now);
        for (auto &event : controller.takeEvents())
            events.push_back(std::move(event));
    }

    void queueOutput()
    {
        for (Output &output : controller.takeOutput()) {
            const TimePoint start = std::max(now, m_lineFree + output.gapBefore);
            m_lineFree = start + wireTime(output.bytes.size(), baud);
            m_writes.push_back({start, std::move(output.bytes)});
            m_sentAt = m_lineFree;
        }
    }

    std::deque<Write> m_writes;
    TimePoint m_lineFree{};
    std::optional<TimePoint> m_sentAt;
};

} // namespace support

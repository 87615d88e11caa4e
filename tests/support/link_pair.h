// A drive and a simulated board, joined by a line that can be spoilt, on a virtual clock. `now` moves only inside
// runFor() and runUntil(); the same seed gives the same run, byte for byte. The judge of the wire sits beside it: what
// it finds fails the test when the pair goes.
#pragma once

#include "drive/protocol_table.h"
#include "mcp/protocol.h"
#include "mcp/request.h"
#include "simulation/fcp/motor_board.h"
#include "simulation/simulated_board.h"
#include "support/judge_speaks.h"
#include "support/judged_drive.h"
#include "support/random.h"
#include "support/wire/fcp.h"
#include "support/wire/mcp.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace support {

using namespace std::chrono_literals;

/// Probabilities per byte, in each direction.
struct LineFaults {
    double flip = 0.0, drop = 0.0, duplicate = 0.0, insert = 0.0;
    double stall = 0.0;
    Duration stallTime = 20ms;
    /// That bytes are lost from here on, for at most burstMost of them: a reader that came late.
    double burst = 0.0;
    std::uint64_t burstMost = 6000, burstLeft = 0;
    bool cut = false; ///< nothing gets through
    /// One fault at the byte with this number, counted from the beginning of the run.
    enum class Once : std::uint8_t { None, Flip, Drop, Duplicate } once = Once::None;
    std::uint64_t onceAt = 0;
    std::uint64_t passed = 0; ///< bytes so far
};

class LinkPair {
public:
    explicit LinkPair(const simulation::BoardOptions &options = {}, std::uint64_t seed = 1)
        : baud(options.baud)
        , board(simulation::makeBoard(options))
        , m_random(seed)
        , m_motors(simulation::buildOf(options).motors)
    {
        if (simulation::isFcpProfile(options.profile)) {
            drive = std::make_unique<JudgedDrive>(drive::makeFcpDrive({.baud = baud}), judge);
            m_framesAreRequests = true;
            judge.watch(std::make_unique<judge::WireFcp>(), fcpLine());
            return;
        }
        drive = std::make_unique<JudgedDrive>(drive::makeMcpDrive({.baud = baud}), judge);
        judge.watch(
            std::make_unique<judge::WireMcp>(baud, board->truth(1).ampsPerDigit), mcpLine());
        if (!options.lies.empty())
            judge.line().motorsTold = 7; // the most that a board can tell
    }
    ~LinkPair()
    {
        if (QTest::currentTestFailed())
            lookOn();
        speak(judge, !verdictTaken);
    }
    LinkPair(const LinkPair &) = delete;
    LinkPair &operator=(const LinkPair &) = delete;

    judge::MsRules judge;
    bool verdictTaken = false; ///< the test has looked at it and says more
    std::uint32_t baud;
    TimePoint now{1s};
    std::unique_ptr<drive::Drive> drive;
    std::unique_ptr<simulation::SimulatedBoard> board;
    LineFaults toBoard, toDrive;

    // What the drive told, whole and by kind.
    std::vector<drive::Event> events;
    std::map<drive::WishId, std::vector<drive::Ended>> ended;
    drive::LinkState link = drive::LinkState::Closed;
    drive::LinkReason reason = drive::LinkReason::None;
    std::optional<drive::Identified> identified;
    std::map<int, drive::MotorStatus> status;
    std::map<drive::RegisterId, drive::Reading> values;
    std::vector<drive::StopProgress> stops;
    drive::LinkCounters counters;
    Bytes sent; ///< all that left the drive
    std::vector<Bytes> requests; ///< payloads that left the drive
    std::function<void(const drive::Event &)> onEvent;
    std::function<bool(const Bytes &)> loses; ///< outputs of the drive that never arrive

    template <class What>
    drive::WishId submit(What what)
    {
        const drive::WishId id = ++m_lastWish;
        drive->submit({id, std::move(what)}, now);
        exchange();
        return id;
    }

    void connect()
    {
        drive->connect(now);
        exchange();
    }

    void runFor(Duration time)
    {
        runUntil([] { return false; }, time);
    }

    /// @return whether it came true within `limit`
    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        exchange();
        while (!condition()) {
            if (now >= end)
                return false;
            step(end);
        }
        return true;
    }

    bool runUntilIdentified(Duration limit = 5s)
    {
        return runUntil(
            [&] { return identified.has_value() && identified->catalog != nullptr; }, limit);
    }
    bool runUntilEnded(drive::WishId id, Duration limit = 5s)
    {
        return runUntil([&] { return ended.contains(id); }, limit);
    }
    bool runUntilState(drive::MotorState state, Duration limit = 10s)
    {
        return runUntil([&] { return status.contains(1) && status.at(1).state == state; }, limit);
    }
    drive::Outcome outcome(drive::WishId id) const { return ended.at(id).front().outcome; }
    drive::RegisterId id(std::string_view name) const
    {
        return identified->catalog->resolve(name).value_or(0);
    }

    /// The program has no core for a while: nothing leaves, and what comes waits for it. The board lives on. A packet
    /// whose header has left is completed before: one that ends late is not what is looked for.
    void stall(Duration time)
    {
        runUntil([this] { return m_sending.empty(); }, 20ms);
        for (const TimePoint end = now + time; now < end;) {
            now = std::min(end, now + kGrain);
            board->advance(now);
            if (const Bytes bytes = board->takeOutput(); !bytes.empty())
                fly(m_toDrive, spoil(bytes, toDrive), toDrive);
            deliverToBoard();
            lookAtTruth();
        }
    }
    /// The judge allows for stalls so long.
    void expectStalls(Duration longest)
    {
        judge::Line &line = judge.line();
        line.firstStop += longest;
        line.repeat += longest;
        line.alarm += longest;
        line.suspect += longest;
        line.lost += longest;
        line.stall = longest;
    }

    /// Another drive on the same line, as after a port was opened again or the program had died.
    void replaceDrive(std::unique_ptr<drive::Drive> other)
    {
        judge::Act gone;
        gone.kind = judge::Act::Kind::Unplugged;
        gone.at = now;
        judge.act(gone);
        judge.said(judge::LinkState::Closed, now);
        m_sending.clear();
        m_payloadNext = false;
        drive = std::make_unique<JudgedDrive>(std::move(other), judge);
    }

    /// Lets the drive say what it wants to, after a direct call of one of its verbs.
    void exchange()
    {
        takeEvents();
        for (Output &output : drive->takeOutput()) {
            if (output.dropsEarlier)
                m_sending.clear();
            m_sending.push_back({std::move(output), judge.moment()});
        }
        takeEvents();
    }

private:
    struct Flying {
        TimePoint at;
        Bytes bytes;
    };
    static constexpr Duration kGrain = 250us; ///< how often the board's side is looked at

    judge::Line boardLine() const
    {
        judge::Line line;
        const simulation::MotorTruth truth = board->truth(1);
        line.motors = m_motors;
        line.baud = baud;
        line.maxRpm = truth.maxRpm;
        line.maxAmps = truth.maxAmps;
        line.ampsPerDigit = truth.ampsPerDigit;
        return line;
    }
    judge::Line fcpLine() const
    {
        judge::Line line = boardLine();
        line.maxAmps = line.ampsPerDigit = 0.0; // these boards do not tell them
        line.firstStop = 150ms;
        line.repeat = 250ms;
        line.lost = 6s;
        line.answerWithin = 900ms;
        return line;
    }
    judge::Line mcpLine() const
    {
        judge::Line line = boardLine();
        line.firstStop += 2 * wireTime(260, baud);
        line.repeat += 4 * wireTime(260, baud);
        line.gap = 500us;
        line.answerWithin = 10s;
        return line;
    }
    /// An assertion that fails ends a test before the judge has seen what comes of it.
    void lookOn()
    {
        onEvent = nullptr; // what they know has gone
        loses = nullptr;
        runFor(1500ms);
    }
    void lookAtTruth()
    {
        if (!judge.watching())
            return;
        m_truth.clear();
        for (int motor = 1; motor <= m_motors; ++motor) {
            const simulation::MotorTruth truth = board->truth(motor);
            m_truth.push_back({truth.driven, truth.idle, truth.rpm});
        }
        judge.look(now, m_truth);
    }

    void step(TimePoint end)
    {
        if (dynamic_cast<JudgedDrive *>(drive.get()) == nullptr)
            judge.watch(nullptr, {}); // the test has brought a drive of its own
        TimePoint next = std::min(end, now + kGrain);
        if (m_framesAreRequests) // whose board wakes for its bytes only
            next = std::min(next, std::max(board->nextWake(), now));
        if (const auto due = drive->nextTimeout())
            next = std::min(next, std::max(*due, now));
        if (!m_sending.empty())
            next = std::min(next, std::max(sendAt(), now));
        if (m_lineFreeAt > now)
            next = std::min(next, m_lineFreeAt);
        if (next == now)
            ++m_standing;
        else
            m_standing = 0;
        if (m_standing > 1000)
            qFatal("the drive wants to be called at once, for ever");
        now = next;
        sendDue();
        board->advance(now);
        if (const Bytes bytes = board->takeOutput(); !bytes.empty())
            fly(m_toDrive, spoil(bytes, toDrive), toDrive);
        deliver();
        if (const auto due = drive->nextTimeout(); due && *due <= now)
            drive->handleTimeout(now);
        exchange();
        lookAtTruth();
    }

    TimePoint sendAt() const { return m_lineFreeAt + m_sending.front().output.gapBefore; }

    void sendDue()
    {
        while (!m_sending.empty() && sendAt() <= now) {
            const auto [output, handed] = std::move(m_sending.front());
            m_sending.pop_front();
            judge.sent(output.bytes, now, handed);
            watch(output.bytes);
            m_lineFreeAt = now + wireTime(output.bytes.size(), baud);
            m_unsent = true;
            if (!loses || !loses(output.bytes))
                fly(m_toBoard, spoil(output.bytes, toBoard), toBoard);
        }
        if (m_unsent && m_sending.empty() && m_lineFreeAt <= now) {
            m_unsent = false;
            drive->handleSent(now);
        }
    }

    /// Splits what leaves into packets, knowing that each header and payload is an output of its own.
    void watch(const Bytes &bytes)
    {
        sent.insert(sent.end(), bytes.begin(), bytes.end());
        if (m_framesAreRequests)
            return requests.push_back(bytes);
        if (m_payloadNext)
            requests.push_back(bytes);
        m_payloadNext = !m_payloadNext && bytes.size() == 4 && (bytes[0] & 0xFU) == 9;
    }

    void fly(std::deque<Flying> &queue, Bytes bytes, const LineFaults &faults)
    {
        TimePoint at = now;
        if (m_random.chance(faults.stall * static_cast<double>(bytes.size())))
            at += faults.stallTime;
        if (!queue.empty())
            at = std::max(at, queue.back().at);
        if (!bytes.empty())
            queue.push_back({at, std::move(bytes)});
    }

    void deliverToBoard()
    {
        while (!m_toBoard.empty() && m_toBoard.front().at <= now) {
            board->receive(m_toBoard.front().bytes, now);
            m_toBoard.pop_front();
        }
    }

    void deliver()
    {
        deliverToBoard();
        while (!m_toDrive.empty() && m_toDrive.front().at <= now) {
            const Bytes bytes = std::move(m_toDrive.front().bytes);
            m_toDrive.pop_front();
            drive->receive(bytes, now);
            exchange();
        }
    }

    static Bytes spoilOnce(const Bytes &bytes, LineFaults &faults)
    {
        Bytes result;
        for (const std::uint8_t byte : bytes) {
            const auto once =
                faults.passed++ == faults.onceAt ? faults.once : LineFaults::Once::None;
            if (once != LineFaults::Once::Drop)
                result.push_back(once == LineFaults::Once::Flip
                        ? static_cast<std::uint8_t>(byte ^ 0x10U)
                        : byte);
            if (once == LineFaults::Once::Duplicate)
                result.push_back(byte);
        }
        return result;
    }

    Bytes spoil(const Bytes &given, LineFaults &faults)
    {
        const Bytes bytes = spoilOnce(given, faults);
        if (faults.cut)
            return {};
        if (faults.flip + faults.drop + faults.duplicate + faults.insert + faults.burst <= 0.0)
            return bytes;
        Bytes result;
        for (std::uint8_t byte : bytes) {
            if (faults.burst > 0.0 && faults.burstLeft == 0 && m_random.chance(faults.burst))
                faults.burstLeft = 1 + m_random.below(faults.burstMost);
            if (faults.burstLeft > 0) {
                --faults.burstLeft;
                continue;
            }
            if (m_random.chance(faults.drop))
                continue;
            if (m_random.chance(faults.flip))
                byte = static_cast<std::uint8_t>(byte ^ 1U << m_random.below(8));
            result.push_back(byte);
            if (m_random.chance(faults.duplicate))
                result.push_back(byte);
            if (m_random.chance(faults.insert))
                result.push_back(static_cast<std::uint8_t>(m_random.next()));
        }
        return result;
    }

    void takeEvents()
    {
        for (drive::Event &event : drive->takeEvents()) {
            note(event);
            if (onEvent)
                onEvent(event);
            if (!std::holds_alternative<capture::SampleBlock>(event))
                events.push_back(std::move(event));
        }
    }

    void note(const drive::Event &event)
    {
        if (const auto *change = std::get_if<drive::LinkChanged>(&event)) {
            link = change->state;
            reason = change->reason;
        } else if (const auto *found = std::get_if<drive::Identified>(&event)) {
            identified = *found;
        } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
            for (const drive::Reading &reading : read->readings)
                values[reading.id] = reading;
        } else if (const auto *end = std::get_if<drive::Ended>(&event)) {
            ended[end->id].push_back(*end);
        } else if (const auto *motor = std::get_if<drive::MotorStatus>(&event)) {
            status[motor->motor] = *motor;
        } else if (const auto *stop = std::get_if<drive::StopProgress>(&event)) {
            stops.push_back(*stop);
        } else if (const auto *count = std::get_if<drive::LinkCounters>(&event)) {
            counters = *count;
        }
    }

    Random m_random;
    int m_motors; ///< that the board has
    std::vector<judge::Motor> m_truth;
    struct Handed {
        Output output;
        std::uint64_t moment = 0;
    };
    std::deque<Handed> m_sending;
    std::deque<Flying> m_toBoard, m_toDrive;
    TimePoint m_lineFreeAt{};
    drive::WishId m_lastWish = 0;
    bool m_unsent = false;
    bool m_payloadNext = false;
    bool m_framesAreRequests = false; ///< of a protocol whose outputs are whole frames
    int m_standing = 0;
};

/// Connected, identified and, if wanted, armed.
struct Session : LinkPair {
    explicit Session(
        bool toArm = true, const simulation::BoardOptions &options = {}, std::uint64_t seed = 1)
        : LinkPair(options, seed)
    {
        connect();
        ready = runUntilIdentified();
        if (toArm)
            drive->arm();
    }
    bool ready = false;

    /// START and wait for RUN.
    bool startMotor()
    {
        submit(drive::Command{drive::MotorAction::Start, 1});
        return runUntilState(drive::MotorState::Running);
    }
    bool runAt(std::int32_t rpm)
    {
        if (!startMotor())
            return false;
        submit(drive::SpeedRamp{1, rpm, 500ms});
        return runUntil(
            [&] { return status[1].speedRpm && std::abs(*status[1].speedRpm - rpm) < 0.05 * rpm; },
            5s);
    }
    bool hasStopWord(drive::StopWord word) const
    {
        return std::any_of(stops.begin(), stops.end(),
            [&](const auto &progress) { return progress.word == word; });
    }
};

/// Command ids of the requests that left.
inline std::vector<std::uint16_t> commandsIn(const std::vector<Bytes> &requests)
{
    std::vector<std::uint16_t> commands;
    for (const Bytes &request : requests)
        if (const auto decoded = mcp::decodeRequest(request))
            commands.push_back(decoded->command);
    return commands;
}

inline std::size_t count(const std::vector<Bytes> &requests, mcp::CommandId command)
{
    const auto all = commandsIn(requests);
    return static_cast<std::size_t>(
        std::count(all.begin(), all.end(), static_cast<std::uint16_t>(command)));
}

/// Whether a request can change anything but what is streamed.
inline bool changesSomething(const Bytes &request)
{
    const auto decoded = mcp::decodeRequest(request);
    if (!decoded)
        return true;
    if (decoded->command == static_cast<std::uint16_t>(mcp::CommandId::GetRegister))
        return false;
    if (decoded->command != static_cast<std::uint16_t>(mcp::CommandId::SetRegister))
        return true;
    const auto list = mcp::decodeSetList(decoded->content);
    return std::any_of(list.writes.begin(), list.writes.end(), [](const auto &write) {
        return write.id.type() != 5 || write.id.element() < 20 || write.id.element() > 22;
    });
}

} // namespace support

// Reads a fuzzer's bytes as what the user, a line and a board do to a drive: wishes, stops, arming, line cuts, faults,
// resets and time, on a virtual clock. Whatever they do, the judge of the wire finds nothing, each wish ends once and
// within 30 s after the faults (a servo that does not answer is asked three times for half a second, register by
// register), output is bounded and time never stands still; anything else is a finding.
//
// First byte: bits 0 and 1 what is there at first (see Peer), bit 2 a second motor, bit 3 no wait for the
// identification, bit 4 never armed, bit 5 the line is silent at first, bit 6 the whole run is made twice.
// Then acts: a byte modulo kActs and the bytes that it takes. What is missing at the end is zero.
// ROTORSCOPE_TELL=1 prints what happens, to look into a finding.
// The board is a simulation::ByteDevice without a motor model, so that a run of seconds costs less than a millisecond.
#pragma once

#include "drive/drive.h"
#include "fuzz/script.h"
#include "simulation/device.h"
#include "support/judged_drive.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <deque>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <string>

namespace fuzz {

using namespace std::chrono_literals;

/// A board for fuzzing: what the user at the board could do to it, and when it has something to say.
class Peer : public simulation::ByteDevice {
public:
    virtual void reset() = 0;
    virtual void setFaults(std::uint16_t present) = 0;
    virtual std::vector<judge::Motor> truth() const = 0; ///< one a motor
};

struct Target {
    std::function<std::unique_ptr<drive::Drive>()> drive;
    std::function<std::unique_ptr<Peer>(unsigned which, int motors)> peer;
    std::function<std::unique_ptr<judge::Decoder>()> decoder; ///< of the judge
    judge::Line line; ///< but for its motors
    std::uint32_t baud = 1843200;
    bool exchanges = false; ///< SPI: as many bytes come in as go out, and at once
};

/// The bytes of a script; behind the end there are zeros.
class Script {
public:
    explicit Script(ByteView bytes)
        : m_bytes(bytes)
    {
    }
    bool over() const { return m_at >= m_bytes.size(); }
    std::uint8_t byte() { return over() ? std::uint8_t{0} : m_bytes[m_at++]; }
    int below(int bound) { return byte() % bound; }
    ByteView accept(std::size_t count)
    {
        const auto part = m_bytes.subspan(std::min(m_at, m_bytes.size()),
            std::min(count, m_bytes.size() - std::min(m_at, m_bytes.size())));
        m_at += part.size();
        return part;
    }

private:
    ByteView m_bytes;
    std::size_t m_at = 0;
};

/// One drive, one line and one board through a whole script.
inline std::string hexOf(ByteView bytes)
{
    std::string text;
    for (const std::uint8_t byte : bytes)
        (text += "0123456789abcdef"[byte >> 4]) += "0123456789abcdef"[byte & 15U];
    return text;
}

class DriveRun {
public:
    DriveRun(const Target &target, ByteView script)
        : m_target(target)
        , m_script(script)
    {
    }

    /// @return  a sum over all that left the drive and all that it told: the same script gives the same
    std::uint64_t run()
    {
        const std::uint8_t flags = m_script.byte();
        const int motors = flags & 0x04 ? 2 : 1;
        m_peer = m_target.peer(flags & 0x03U, motors);
        judge::Line line = m_target.line;
        line.motors = static_cast<int>(m_peer->truth().size());
        m_judge.watch(m_target.decoder(), line);
        m_drive = std::make_unique<support::JudgedDrive>(m_target.drive(), m_judge);
        m_cut[0] = m_cut[1] = flags & 0x20;
        m_drive->connect(m_now);
        drain();
        if (!(flags & 0x08))
            passUntil([this] { return m_catalog != nullptr; }, kToIdentify);
        if (!(flags & 0x10))
            arm();
        for (int acts = 0; acts < kMostActs && !m_script.over() && m_now < kLatest; ++acts)
            act();
        settle();
        m_judge.settle(m_now);
        hearVerdict();
        return m_sum;
    }

private:
    static constexpr int kActs = 28;
    static constexpr int kMostActs = 64;
    static constexpr Duration kToIdentify = 1500ms;
    static constexpr TimePoint kLatest{5s}; ///< then the acts end
    static constexpr Duration kToSettle = 60s, kToClose = 700ms;
    static constexpr std::size_t kMostOutput = 16384; ///< bytes of one turn
    static constexpr std::size_t kMostEvents = 2000; ///< of one turn
    static constexpr int kStepsAtOneInstant = 1000;

    struct OnceFault {
        int kind = 0; ///< 1 dropped, 2 flipped, 3 doubled, 4 inserted
        std::size_t after = 0;
        std::uint8_t value = 0;
    };

    // ---- time and the line

    void pass(Duration time)
    {
        passUntil([] { return false; }, time);
    }
    template <class Condition>
    void passUntil(Condition condition, Duration limit)
    {
        const TimePoint end = m_now + limit;
        int standing = 0;
        while (!condition() && m_now < end) {
            const TimePoint next = std::clamp(nextEvent(), m_now, end);
            standing = next == m_now ? standing + 1 : 0;
            if (standing + 1 == kStepsAtOneInstant)
                tell("  stands still: the board wakes in ", toSeconds(m_peer->nextWake() - m_now),
                    " s, the drive in ", toSeconds(m_drive->nextTimeout().value_or(end) - m_now),
                    " s, ", m_sending.size(), " to send");
            require(standing < kStepsAtOneInstant); // it asks to be called in a circle
            m_now = next;
            step();
        }
    }
    TimePoint nextEvent() const
    {
        TimePoint next = m_peer->nextWake();
        if (const auto due = m_drive->nextTimeout())
            next = std::min(next, *due);
        if (!m_sending.empty())
            next = std::min(next, m_lineFreeAt + m_sending.front().output.gapBefore);
        else if (m_unsent)
            next = std::min(next, m_lineFreeAt);
        if (m_stalled && !m_held.empty())
            next = std::min(next, *m_stalled);
        return next;
    }
    void step()
    {
        while (!m_sending.empty() && m_lineFreeAt + m_sending.front().output.gapBefore <= m_now) {
            const auto [output, moment] = std::move(m_sending.front());
            const Bytes &bytes = output.bytes;
            m_sending.pop_front();
            tell("  sends ", hexOf(bytes));
            m_judge.sent(bytes, m_now, moment);
            m_lineFreeAt = m_now + wireTime(bytes.size(), m_target.baud);
            m_unsent = true;
            cross(bytes);
        }
        if (m_unsent && m_sending.empty() && m_lineFreeAt <= m_now) {
            m_unsent = false;
            m_drive->handleSent(m_now);
            drain();
        }
        m_peer->advance(m_now);
        hear(m_peer->takeOutput());
        if (m_stalled && *m_stalled <= m_now) {
            m_stalled.reset();
            hear({});
        }
        if (const auto due = m_drive->nextTimeout(); due && *due <= m_now) {
            m_drive->handleTimeout(m_now);
            drain();
        }
        m_judge.look(m_now, m_peer->truth());
        hearVerdict();
    }
    void hearVerdict()
    {
        if (m_judge.violations().empty())
            return;
        tell("  violated: ", m_judge.verdict());
        require(false);
    }
    void cross(const Bytes &bytes)
    {
        Bytes arriving = spoil(bytes, 0);
        if (m_target.exchanges && m_cut[0])
            arriving.assign(bytes.size(), 0);
        if (!arriving.empty())
            m_peer->receive(arriving, m_now);
        if (!m_target.exchanges)
            return;
        Bytes answer = spoil(m_peer->takeOutput(), 1);
        if (m_cut[1])
            answer.assign(bytes.size(), 0);
        m_drive->receive(answer, m_now);
        drain();
    }
    void hear(Bytes bytes)
    {
        bytes = spoil(std::move(bytes), 1);
        m_held.insert(m_held.end(), bytes.begin(), bytes.end());
        if (m_stalled || m_held.empty())
            return;
        bytes.swap(m_held);
        m_held.clear();
        tell("  hears ", hexOf(bytes));
        m_drive->receive(bytes, m_now);
        drain();
    }
    /// @param way  0 to the board, 1 from it
    Bytes spoil(Bytes bytes, std::size_t way)
    {
        if (m_cut[way])
            return {};
        OnceFault &fault = m_faults[way];
        if (fault.kind == 0 || bytes.empty())
            return bytes;
        if (fault.after >= bytes.size()) {
            fault.after -= bytes.size();
            return bytes;
        }
        const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(fault.after);
        switch (fault.kind) {
        case 1:
            bytes.erase(at);
            break;
        case 2:
            *at = static_cast<std::uint8_t>(*at ^ 1U << fault.value % 8);
            break;
        case 3:
            bytes.insert(at, std::uint8_t{*at});
            break;
        default:
            bytes.insert(at, fault.value);
            break;
        }
        fault.kind = 0;
        return bytes;
    }

    // ---- what the drive does

    /// Takes what the drive wants to send and what it tells; each call of it is followed by this.
    void drain()
    {
        std::size_t bytes = 0, events = 0;
        for (int rounds = 0;; ++rounds) {
            require(rounds < kStepsAtOneInstant);
            for (const drive::Event &event : m_drive->takeEvents()) {
                require(++events < kMostEvents);
                note(event);
            }
            auto outputs = m_drive->takeOutput();
            if (outputs.empty())
                break;
            for (Output &output : outputs) {
                if (output.dropsEarlier)
                    m_sending.clear();
                bytes += output.bytes.size();
                require(bytes <= kMostOutput && output.gapBefore >= Duration{});
                for (const std::uint8_t byte : output.bytes)
                    add(byte);
                m_sending.push_back({std::move(output), m_judge.moment()});
            }
        }
    }
    void note(const drive::Event &event)
    {
        add(static_cast<std::uint8_t>(event.index()));
        if (const auto *ended = std::get_if<drive::Ended>(&event)) {
            add(static_cast<std::uint8_t>(ended->id));
            add(static_cast<std::uint8_t>(ended->outcome));
            tell("  ended ", ended->id, " outcome ", int(ended->outcome), ' ', ended->reason);
            const auto wish = m_open.find(ended->id);
            require(wish != m_open.end()); // none ends twice, none that was not asked for
            m_open.erase(wish);
        } else if (const auto *change = std::get_if<drive::LinkChanged>(&event)) {
            m_link = change->state;
            tell("  link ", int(m_link), " reason ", int(change->reason));
        } else if (const auto *who = std::get_if<drive::Identified>(&event)) {
            m_catalog = who->catalog;
            tell("  identified");
        } else if (const auto *began = std::get_if<drive::StreamStarted>(&event)) {
            m_layout = began->layout;
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            require(block->stream == m_layout.id && !m_layout.empty());
            require(block->fast.size() == m_layout.fast.size() * block->count);
            require(block->lostTicks >= 0);
            for (const auto &group : block->slow)
                require(group.values.size() == m_layout.slow.size());
        }
    }
    /// For people who look into a finding.
    template <class... What>
    void tell(const What &...what)
    {
        static const bool wanted = std::getenv("ROTORSCOPE_TELL") != nullptr;
        if (wanted)
            ((std::cerr << toSeconds(m_now - TimePoint{}) << ' ') << ... << what) << '\n';
    }
    void add(std::uint8_t byte) { m_sum = (m_sum ^ byte) * 0x100000001B3ULL; }

    // ---- what the user does

    template <class What>
    void ask(What what)
    {
        const drive::WishId id = ++m_lastWish;
        tell("wish ", id);
        m_open.insert(id);
        drive::Wish wish;
        wish.id = id;
        wish.what = std::move(what);
        m_drive->submit(std::move(wish), m_now);
        drain();
    }
    void arm()
    {
        m_drive->arm();
        drain();
    }
    void stop()
    {
        m_drive->stop(m_now);
        // A Stop goes on with what was to be closed.
        m_closed = m_closed && m_link == drive::LinkState::Closed;
        require(!m_drive->armed());
        drain();
    }
    void disarm()
    {
        m_drive->disarm();
        require(!m_drive->armed());
        drain();
    }

    drive::RegisterId someRegister()
    {
        const std::uint8_t which = m_script.byte();
        if (m_catalog == nullptr || m_catalog->registers().empty())
            return which * 0x49U;
        const auto &all = m_catalog->registers();
        const auto &info = all[(which + std::size_t{256} * (which % 2U)) % all.size()];
        return m_catalog->withMotor(info, 1 + which % 2);
    }
    drive::Value someValue()
    {
        const std::uint8_t what = m_script.byte();
        switch (what % 8) {
        case 0:
            return std::int64_t{what} / 8;
        case 1:
            return -std::int64_t{what};
        case 2:
            return std::numeric_limits<std::int64_t>::max() >> what % 64;
        case 3:
            return (what - 128) * 37.5;
        case 4:
            return std::array{std::numeric_limits<double>::quiet_NaN(),
                std::numeric_limits<double>::infinity(), -0.0, 1e300}[what / 8 % 4];
        case 5:
            return std::string(what / 8, 'x');
        case 6: {
            const ByteView raw = m_script.accept(what / 8);
            return Bytes(raw.begin(), raw.end());
        }
        default:
            return std::int64_t{1} << what / 8;
        }
    }
    std::vector<drive::RegisterId> registers()
    {
        std::vector<drive::RegisterId> list(static_cast<std::size_t>(m_script.below(5)));
        for (drive::RegisterId &id : list)
            id = someRegister();
        return list;
    }
    int motor() { return std::array{1, 1, 2, 1, 2, 1, 0, 3}[m_script.byte() % 8U]; }
    std::chrono::milliseconds milliseconds()
    {
        const int steps = m_script.byte();
        return std::chrono::milliseconds(steps * steps / 60); // up to 1.1 s
    }
    double number()
    {
        return (m_script.byte() - 128) * std::array{0.05, 1.0, 12.0, 400.0}[m_script.byte() % 4U];
    }

    void command(drive::MotorAction action) { ask(drive::Command{action, motor()}); }
    void write(int count)
    {
        drive::Write write;
        for (int i = 0; i < count; ++i) {
            const drive::RegisterId id = someRegister();
            write.writes.push_back({id, someValue()});
        }
        ask(std::move(write));
    }
    void act();
    void actOnLine(int which);
    void ramp(int which);

    // ---- the end

    /// Line and board are well from now on: the link comes about and every wish ends.
    void settle()
    {
        m_cut = {};
        m_faults = {};
        m_stalled.reset();
        if (m_closed) {
            pass(kToClose);
            require(m_open.empty());
            return;
        }
        passUntil([this] { return m_open.empty(); }, kToSettle);
        for (const drive::WishId wish : m_open)
            tell("  still open: ", wish);
        require(m_open.empty());
        m_drive->disconnect(m_now);
        drain();
        pass(kToClose);
        tell("  closed, link ", int(m_link));
        require(!m_drive->nextTimeout().has_value());
        require(m_link == drive::LinkState::Closed);
    }

    const Target &m_target;
    Script m_script;
    TimePoint m_now{1s};
    std::unique_ptr<Peer> m_peer;
    judge::MsRules m_judge;
    std::unique_ptr<drive::Drive> m_drive;

    struct Handed {
        Output output;
        std::uint64_t moment = 0; ///< of the judge
    };
    std::deque<Handed> m_sending;
    TimePoint m_lineFreeAt{};
    bool m_unsent = false;
    std::array<bool, 2> m_cut{};
    std::array<OnceFault, 2> m_faults{};
    std::optional<TimePoint> m_stalled; ///< until then nothing reaches the drive
    Bytes m_held;

    drive::WishId m_lastWish = 0;
    std::set<drive::WishId> m_open;
    std::shared_ptr<const catalog::Catalog> m_catalog;
    capture::StreamLayout m_layout;
    drive::LinkState m_link = drive::LinkState::Closed;
    bool m_closed = false;
    std::uint64_t m_sum = 0xCBF29CE484222325ULL;
};

inline void DriveRun::ramp(int which)
{
    const int motorNumber = motor();
    const double value = number();
    switch (which) {
    case 0:
        return ask(drive::SpeedRamp{motorNumber, static_cast<std::int32_t>(value), milliseconds()});
    case 1:
        return ask(drive::TorqueRamp{motorNumber, value, milliseconds()});
    case 2:
        return ask(drive::CurrentReference{motorNumber, value, number()});
    default:
        return ask(drive::PositionRamp{motorNumber, value, milliseconds()});
    }
}

inline void DriveRun::act()
{
    const int which = m_script.below(kActs);
    tell("act ", which, m_drive->armed() ? ", armed" : "");
    switch (which) {
    case 0:
        return pass(milliseconds());
    case 1:
        return pass(1ms * m_script.byte() / 8);
    case 2:
        return arm();
    case 3:
        return disarm();
    case 4:
        return stop();
    case 5:
        return command(drive::MotorAction::Start);
    case 6:
        return command(drive::MotorAction::StopMotor);
    case 7:
        return command(drive::MotorAction::StopRamp);
    case 8:
        return command(drive::MotorAction::AcknowledgeFaults);
    case 9:
    case 10:
    case 11:
    case 12:
        return ramp(which - 9);
    case 13:
    case 14:
        return write(which == 13 ? 1 : 3);
    case 15:
        return ask(drive::Read{registers()});
    case 16: {
        drive::Stream stream;
        stream.fast = registers();
        // Where signals travel with the exchanges these come as seldom, and all that is asked waits for them.
        stream.fastEvery = 1U + m_script.byte() % (m_target.exchanges ? 16U : 256U);
        stream.slow = registers();
        stream.slowEvery = m_script.byte();
        return ask(std::move(stream));
    }
    case 17:
        return ask(drive::Watch{registers(), milliseconds(), registers()});
    case 18: {
        const int kind = m_script.below(4);
        if (kind == 0)
            return ask(drive::UserLimits{std::abs(number()), std::abs(number())});
        if (kind == 1)
            return ask(drive::ExpertMode{motor()});
        if (kind == 2)
            return ask(drive::CurrentScale{motor(), number()});
        return ask(drive::CyclicSetPoints{m_script.byte() % 2 != 0});
    }
    default:
        return actOnLine(which - 19);
    }
}

inline void DriveRun::actOnLine(int which)
{
    switch (which) {
    case 0: {
        const std::uint8_t ways = m_script.byte();
        m_cut = {(ways & 1U) != 0, (ways & 2U) != 0};
        return;
    }
    case 1:
    case 2: {
        const int kind = 1 + m_script.below(4);
        const std::size_t after = m_script.byte();
        m_faults[static_cast<std::size_t>(which - 1)] = {kind, after, m_script.byte()};
        return;
    }
    case 3:
        m_stalled = m_now + milliseconds();
        return;
    case 4:
        return m_peer->reset();
    case 5:
        return m_peer->setFaults(static_cast<std::uint16_t>(m_script.byte()));
    case 6: { // any bytes, as if from the board
        const ByteView bytes = m_script.accept(m_script.byte() % 32U);
        if (!m_sending.empty())
            return; // the drive may take them for the answer to what the judge has not seen leave
        tell("  hears what nobody sent ", hexOf(bytes));
        if (!bytes.empty())
            m_drive->receive(bytes, m_now);
        return drain();
    }
    case 7: { // no calls for a while, as in a process that was stopped
        const Duration gap = milliseconds() * 2;
        if (m_drive->stopOpen() || !m_sending.empty())
            return; // what could not be sent meanwhile is not judged
        m_now += gap;
        m_drive->doubt(m_now);
        return drain();
    }
    default: // closed, and perhaps opened again
        m_drive->disconnect(m_now);
        drain();
        m_closed = m_script.byte() % 2 != 0;
        if (!m_closed || m_link == drive::LinkState::Closed) { // what has not left never does
            m_sending.clear();
            m_unsent = false;
            m_lineFreeAt = m_now;
        }
        if (!m_closed) {
            m_drive->connect(m_now);
            drain();
        }
    }
}

/// A line without a board.
class NobodyThere final : public Peer {
public:
    void receive(ByteView, TimePoint) override { }
    void advance(TimePoint) override { }
    Bytes takeOutput() override { return {}; }
    TimePoint nextWake() const override { return TimePoint::max(); }
    void reset() override { }
    void setFaults(std::uint16_t) override { }
    std::vector<judge::Motor> truth() const override { return {judge::Motor{}}; }
};

/// Plays one input; twice where it asks for it, which must come to the same.
inline void playDrive(const Target &target, ByteView script)
{
    if (script.empty())
        return;
    const std::uint64_t sum = DriveRun(target, script).run();
    if (script[0] & 0x40)
        require(DriveRun(target, script).run() == sum);
}

} // namespace fuzz

// An MCB drive object and a simulated drive with its motor, joined frame by frame on a virtual clock. `now` moves only
// inside runFor() and runUntil(); the same seed gives the same run.
#pragma once

#include "drive/protocol_table.h"
#include "mcb/master.h"
#include "simulation/mcb/board.h"
#include "support/judge_speaks.h"
#include "support/judged_drive.h"
#include "support/wire/mcb.h"

#include <QTest>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace support {

using namespace std::chrono_literals;

class McbPair {
public:
    /// @param stall  how long the program may have no core
    explicit McbPair(simulation::McbBoardOptions options = {}, Duration stall = {})
        : drive(std::make_unique<JudgedDrive>(drive::makeMcbDrive({}), judge))
        , board(simulation::makeMcbBoard(std::move(options)))
    {
        judge::Line line;
        const simulation::MotorTruth truth = board->truth(1);
        line.maxRpm = truth.maxRpm;
        line.firstStop = 150ms + stall;
        line.repeat = 250ms + stall;
        line.alarm += stall;
        line.stall = stall;
        line.startParts = line.referenceParts = 2;
        line.suspect = line.lost = {}; // an exchange always brings bytes
        judge.watch(std::make_unique<judge::WireMcb>(), line);
    }
    ~McbPair()
    {
        if (QTest::currentTestFailed()) { // before the judge has seen what comes of it
            onEvent = nullptr; // what they know has gone
            toBoard = toDrive = nullptr;
            runFor(1500ms);
        }
        speak(judge, !verdictTaken);
    }
    McbPair(const McbPair &) = delete;
    McbPair &operator=(const McbPair &) = delete;

    judge::MsRules judge; ///< of the wire; what it finds fails the test when the pair goes
    bool verdictTaken = false; ///< the test has looked at it and says more

    TimePoint now{1s};
    std::unique_ptr<drive::Drive> drive;
    std::unique_ptr<simulation::McbBoard> board;

    std::map<drive::WishId, std::vector<drive::Ended>> ended;
    std::vector<drive::MotionEntry> motions;
    drive::LinkState link = drive::LinkState::Closed;
    drive::LinkReason reason = drive::LinkReason::None;
    std::vector<drive::LinkReason> reasons;
    std::optional<drive::Identified> identified;
    int identifications = 0;
    std::optional<drive::MotorStatus> status;
    std::map<drive::RegisterId, drive::Reading> values;
    std::vector<drive::StopProgress> stops;
    drive::LinkCounters counters;
    std::optional<capture::StreamLayout> layout;
    std::vector<capture::SampleBlock> blocks;
    std::vector<mcb::Frame> writes; ///< that left the drive
    /// Where it wrote before it knew the drive; beside the way out of the cyclic state and the user's stop.
    std::optional<std::uint16_t> wroteUnidentified;
    bool stopped = false; ///< the user has stopped the motors once
    std::function<void(const drive::Event &)> onEvent;
    std::function<void(Bytes &)> toBoard, toDrive;
    Duration look = 1ms; ///< the board's motor moves on at least so often

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
    /// Another drive at the same servo, as after a port was opened again or the program had died.
    void replaceDrive(std::unique_ptr<drive::Drive> other)
    {
        judge::Act gone;
        gone.kind = judge::Act::Kind::Unplugged;
        gone.at = now;
        judge.act(gone);
        judge.said(judge::LinkState::Closed, now);
        drive = std::make_unique<JudgedDrive>(std::move(other), judge);
    }
    bool runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = now + limit;
        exchange();
        while (!condition()) {
            if (now >= end)
                return false;
            TimePoint next = now + look;
            if (const auto due = drive->nextTimeout())
                next = std::min(next, std::max(*due, now));
            now = std::min(next, end);
            board->advance(now);
            drive->handleTimeout(now);
            exchange();
            letJudgeLook();
        }
        return true;
    }
    /// The program has no core for a while; the servo lives on.
    void stall(Duration time)
    {
        for (const TimePoint end = now + time; now < end;) {
            now = std::min(now + look, end);
            board->advance(now);
            letJudgeLook();
        }
    }
    void runFor(Duration time)
    {
        runUntil([] { return false; }, time);
    }
    bool meet(Duration limit = 5s)
    {
        connect();
        return runUntil([&] { return identified.has_value() && status.has_value(); }, limit);
    }
    bool runUntilEnded(drive::WishId id, Duration limit = 5s)
    {
        return runUntil([&] { return ended.contains(id); }, limit);
    }
    template <class What>
    drive::Ended ask(What what, Duration limit = 5s)
    {
        const auto id = submit(std::move(what));
        return runUntilEnded(id, limit) ? ended.at(id).front()
                                        : drive::Ended{id, drive::Outcome::Unknown, "never", {}};
    }
    bool runUntilState(drive::MotorState state, Duration limit = 5s)
    {
        return runUntil([&] { return status && status->state == state; }, limit);
    }
    drive::RegisterId id(std::string_view name) const
    {
        return identified->catalog->resolve(name).value_or(0);
    }
    void exchange()
    {
        take();
        for (int round = 0; round < 2000; ++round) {
            const auto outputs = drive->takeOutput();
            if (outputs.empty())
                return;
            for (const Output &output : outputs) {
                note(output.bytes);
                judge.sent(output.bytes, now);
                Bytes out = output.bytes;
                if (toBoard)
                    toBoard(out);
                Bytes in = board->exchange(out, now);
                if (toDrive)
                    toDrive(in);
                drive->receive(in, now);
                take();
            }
        }
    }

private:
    void letJudgeLook()
    {
        const simulation::MotorTruth truth = board->truth(1);
        judge.look(now, {{truth.driven, truth.idle, truth.rpm}});
    }
    void note(const Bytes &bytes)
    {
        const auto frame = mcb::decodeFrame(bytes);
        if (!frame || frame->command != mcb::Command::Write)
            return;
        writes.push_back(*frame);
        const bool leaves =
            frame->address == mcb::kStateRegister && frame->config[0] == mcb::kConfigState;
        const bool isStop = frame->address == 0x010 && frame->config[0] == 0x06 && stopped;
        if (!m_known && !leaves && !isStop)
            wroteUnidentified = frame->address;
    }
    void take()
    {
        for (auto &event : drive->takeEvents()) {
            if (onEvent)
                onEvent(event);
            if (const auto *done = std::get_if<drive::Ended>(&event)) {
                ended[done->id].push_back(*done);
            } else if (const auto *changed = std::get_if<drive::LinkChanged>(&event)) {
                link = changed->state;
                reason = changed->reason;
                reasons.push_back(changed->reason);
                m_known = m_known && link != drive::LinkState::Lost
                    && changed->reason != drive::LinkReason::BoardReset;
            } else if (const auto *who = std::get_if<drive::Identified>(&event)) {
                identified = *who;
                ++identifications;
                m_known = true;
            } else if (const auto *motor = std::get_if<drive::MotorStatus>(&event)) {
                status = *motor;
            } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
                for (const auto &reading : read->readings)
                    values[reading.id] = reading;
            } else if (const auto *stop = std::get_if<drive::StopProgress>(&event)) {
                stops.push_back(*stop);
            } else if (const auto *count = std::get_if<drive::LinkCounters>(&event)) {
                counters = *count;
            } else if (const auto *begun = std::get_if<drive::StreamStarted>(&event)) {
                layout = begun->layout;
            } else if (const auto *motion = std::get_if<drive::MotionEntry>(&event)) {
                motions.push_back(*motion);
            } else if (auto *block = std::get_if<capture::SampleBlock>(&event)) {
                blocks.push_back(std::move(*block));
            }
        }
    }

    drive::WishId m_lastWish = 0;
    bool m_known = false;
};

} // namespace support

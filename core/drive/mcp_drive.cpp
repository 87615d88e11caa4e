// What is asked of an MCP drive: the verbs of Drive, and wishes turned into tasks.
#include "drive/mcp_drive.h"

#include "drive/mcp_machine.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr Duration kClosingTime = 500ms; ///< for the stop of the datalog when disconnecting

} // namespace

void McpDrive::connect(TimePoint now)
{
    cutAllWishes("connecting anew");
    m_mode = Mode::Open;
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = false;
    m_link.connect(now);
    tellLink();
    work(now);
}

void McpDrive::disconnect(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_stop.end();
    m_armed = false;
    m_mode = Mode::Closing;
    m_closeBy = now + kClosingTime;
    cutAllWishes("disconnected");
    m_watch.watch({}, now);
    if (m_stream.wanted() && connected() && m_board.identified)
        m_wishes.add(std::make_unique<StreamTask>(0, Stream{}, m_stream));
    work(now);
}

void McpDrive::receive(ByteView bytes, TimePoint now)
{
    m_link.receive(bytes, now);
    work(now);
}

void McpDrive::handleTimeout(TimePoint now)
{
    m_link.handleTimeout(now);
    m_stop.handleTimeout(now);
    m_stream.handleTimeout(now);
    work(now);
}

void McpDrive::handleSent(TimePoint now)
{
    m_link.handleSent(now);
    work(now);
}

std::optional<TimePoint> McpDrive::nextTimeout() const
{
    std::optional<TimePoint> due = m_link.nextTimeout();
    const auto consider = [&](std::optional<TimePoint> at) {
        if (at && (!due || *at < *due))
            due = at;
    };
    if (m_reconnectAt)
        consider(m_stop.active() ? std::max(*m_reconnectAt, m_stop.blindUntil()) : *m_reconnectAt);
    consider(m_stream.nextTimeout());
    if (m_mode == Mode::Closing)
        consider(m_closeBy);
    if (m_stop.active()) {
        consider(m_stop.nextAlarm());
        if (const auto next = m_stop.nextStop(connected(), m_workedAt))
            consider(m_stopUnderWay ? std::max(*next, m_stopSince + StopSequence::kRepeat) : *next);
    }
    // What is due already and was not sent waits for something else, which has its own timer.
    const auto considerLater = [&](std::optional<TimePoint> at) {
        if (at && *at > m_workedAt)
            consider(at);
    };
    if (linkIsFree() && m_mode == Mode::Open) {
        considerLater(m_vitals.due());
        considerLater(m_heartbeat.due());
        considerLater(m_watch.due());
        if (stopHoldsBack(m_workedAt))
            considerLater(m_stop.blindUntil());
    }
    return due;
}

void McpDrive::stop(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_armed = false;
    m_cutAfterAnswer = m_task != nullptr;
    m_wishes.cutAll("stopped", dynamic_cast<WishTask *>(m_task));
    m_stop.begin(m_board.motors, now);
    m_vitals.hurry(now);
    work(now);
}

void McpDrive::arm()
{
    if (m_mode != Mode::Open || !m_board.identified || !m_board.knownFirmware || m_lost)
        return;
    if (m_stop.exclusive())
        return; // first the stop that was asked for has to be confirmed
    m_stop.end();
    m_armed = true;
}

void McpDrive::disarm()
{
    m_armed = false;
    m_wishes.cutArmed("disarmed", dynamic_cast<WishTask *>(m_task));
    m_wishes.collect(m_events);
}

void McpDrive::cutAllWishes(const std::string &reason)
{
    m_wishes.cutAll(reason, nullptr);
    if (m_wishes.contains(m_task))
        m_task = &m_nobody;
    m_cutAfterAnswer = false;
    m_wishes.collect(m_events);
}

void McpDrive::endNow(WishId id, Outcome outcome, std::string reason)
{
    if (id != 0)
        m_events.emplace_back(Ended{id, outcome, std::move(reason), {}});
}

void McpDrive::submit(Wish wish, TimePoint now)
{
    std::unique_ptr<WishTask> task;
    if (const auto *watch = std::get_if<Watch>(&wish.what)) {
        m_watch.watch(*watch, now);
        endNow(wish.id, Outcome::Ok, {});
        return work(now);
    }
    if (m_mode != Mode::Open || m_lost)
        return endNow(wish.id, Outcome::NotSent, "not connected");
    if (const auto *read = std::get_if<Read>(&wish.what)) {
        task = std::make_unique<ReadTask>(wish.id, *read, m_board);
    } else if (const auto *stream = std::get_if<Stream>(&wish.what)) {
        task = std::make_unique<StreamTask>(wish.id, *stream, m_stream);
    } else if (!m_armed) {
        return endNow(
            wish.id, Outcome::NotSent, m_stop.active() ? "stopped; arm again first" : "not armed");
    } else if (const auto *write = std::get_if<Write>(&wish.what)) {
        m_wishes.supersede(*write);
        task = std::make_unique<WriteTask>(wish.id, *write, m_board);
    } else if (const auto *command = std::get_if<Command>(&wish.what)) {
        task = std::make_unique<CommandTask>(wish.id, *command, m_board);
    } else if (const auto *speed = std::get_if<SpeedRamp>(&wish.what)) {
        task = std::make_unique<SetPointTask>(wish.id, *speed, m_board);
    } else if (const auto *torque = std::get_if<TorqueRamp>(&wish.what)) {
        task = std::make_unique<SetPointTask>(wish.id, *torque, m_board);
    } else if (const auto *current = std::get_if<CurrentReference>(&wish.what)) {
        task = std::make_unique<SetPointTask>(wish.id, *current, m_board);
    }
    if (!m_wishes.add(std::move(task)))
        return endNow(wish.id, Outcome::NotSent, "too many wishes wait already");
    work(now);
}

std::unique_ptr<Drive> makeMcpDrive(const McpDriveConfig &config)
{
    return std::make_unique<McpDrive>(config);
}

} // namespace drive

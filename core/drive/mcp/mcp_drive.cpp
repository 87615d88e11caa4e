// What is asked of an MCP drive: the verbs of Drive, and wishes turned into tasks.
#include "drive/mcp/mcp_drive.h"

#include "drive/mcp/mcp_machine.h"
#include "drive/mcp/mcp_position.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr Duration kClosingTime = 500ms; ///< for the stop of the datalog when disconnecting

} // namespace

void McpDrive::connect(TimePoint now)
{
    cutAllWishes("connecting anew");
    m_task = nullptr; // what the link before still had under way is never answered
    m_stopUnderWay = false;
    m_mode = Mode::Open;
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = false;
    m_link.connect(now);
    tellLinkState();
    work(now);
}

void McpDrive::disconnect(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_workedAt = now;
    m_stop.end();
    setArmed(false);
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
            consider(m_stopUnderWay ? std::max(*next, m_stopSince + m_stop.turn()) : *next);
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

std::unique_ptr<WishTask> McpDrive::taskFor(const Wish &wish)
{
    if (const auto *read = std::get_if<Read>(&wish.what))
        return std::make_unique<ReadTask>(wish.id, *read, m_board);
    if (const auto *write = std::get_if<Write>(&wish.what))
        return std::make_unique<WriteTask>(wish.id, *write, m_board);
    if (const auto *command = std::get_if<Command>(&wish.what))
        return std::make_unique<CommandTask>(wish.id, *command, m_board);
    if (const auto *speed = std::get_if<SpeedRamp>(&wish.what))
        return std::make_unique<SetPointTask>(wish.id, *speed, m_board);
    if (const auto *torque = std::get_if<TorqueRamp>(&wish.what))
        return std::make_unique<SetPointTask>(wish.id, *torque, m_board);
    if (const auto *current = std::get_if<CurrentReference>(&wish.what))
        return std::make_unique<SetPointTask>(wish.id, *current, m_board);
    if (const auto *position = std::get_if<PositionRamp>(&wish.what))
        return std::make_unique<PositionTask>(wish.id, *position, m_board);
    if (const auto *cyclic = std::get_if<CyclicSetPoints>(&wish.what))
        return std::make_unique<RefusedTask>(wish.id,
            cyclic->on ? Permission::Armed : Permission::Always,
            m_board.reasonAgainst(Feature::CyclicSetPoints));
    return std::make_unique<StreamTask>(wish.id, std::get<Stream>(wish.what), m_stream);
}

std::unique_ptr<Drive> makeMcpDrive(const McpDriveConfig &config)
{
    return std::make_unique<McpDrive>(config);
}

} // namespace drive

// What is asked of an MCP drive: the verbs of Drive, and wishes turned into tasks.
#include "drive/mcp_drive.h"

#include "drive/mcp_machine.h"
#include "drive/mcp_motion.h"
#include "drive/mcp_position.h"

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
    m_workedAt = now;
    setArmed(false);
    m_cutAfterAnswer = m_task != nullptr;
    m_wishes.cutAll("stopped", dynamic_cast<WishTask *>(m_task));
    m_stopAsked = now;
    m_stopsSent.clear();
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
    setArmed(true);
}

void McpDrive::disarm()
{
    setArmed(false);
    m_wishes.cutArmed("disarmed", dynamic_cast<WishTask *>(m_task));
    m_wishes.collect(m_events, m_workedAt);
}

void McpDrive::cutAllWishes(const std::string &reason)
{
    m_wishes.cutAll(reason, nullptr);
    if (m_wishes.contains(m_task))
        m_task = &m_nobody;
    m_cutAfterAnswer = false;
    m_wishes.collect(m_events, m_workedAt);
}

void McpDrive::setArmed(bool armed)
{
    if (std::exchange(m_armed, armed) == armed)
        return;
    MotionRecord record;
    record.act = armed ? MotionAct::Arm : MotionAct::Disarm;
    record.asked = record.ended = m_workedAt;
    m_events.emplace_back(std::move(record));
}

void McpDrive::endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now)
{
    if (auto motion = motionOf(wish, m_board, now)) {
        motion->outcome = outcome;
        motion->reason = reason;
        m_events.emplace_back(std::move(*motion));
    }
    if (wish.id != 0)
        m_events.emplace_back(Ended{wish.id, outcome, std::move(reason), {}});
}

void McpDrive::takeLimits(const Wish &wish, const UserLimits &limits, TimePoint now)
{
    if (!isPlausible(limits))
        return endNow(wish, Outcome::Refused, "no limit is like that", now);
    m_board.user = limits;
    endNow(wish, Outcome::Ok, {}, now);
}

void McpDrive::takeExpert(const Wish &wish, const ExpertMode &expert, TimePoint now)
{
    if (!m_board.identified || !m_board.hasMotor(expert.motor))
        return endNow(wish, Outcome::Refused, "there is no such motor", now);
    if (gapsIn(m_board.limitsOf(expert.motor)).empty())
        return endNow(wish, Outcome::Refused, "every limit of this motor is known", now);
    m_board.expert.insert(expert.motor);
    endNow(wish, Outcome::Ok, {}, now);
}

bool McpDrive::takeAtOnce(const Wish &wish, TimePoint now)
{
    if (const auto *watch = std::get_if<Watch>(&wish.what)) {
        m_watch.watch(*watch, now);
        endNow(wish, Outcome::Ok, {}, now);
        work(now);
    } else if (const auto *limits = std::get_if<UserLimits>(&wish.what)) {
        takeLimits(wish, *limits, now);
    } else if (m_mode != Mode::Open || m_lost) {
        endNow(wish, Outcome::NotSent, "not connected", now);
    } else if (const auto *expert = std::get_if<ExpertMode>(&wish.what)) {
        takeExpert(wish, *expert, now);
    } else {
        return false;
    }
    return true;
}

std::unique_ptr<WishTask> McpDrive::taskFor(const Wish &wish) const
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
    return nullptr;
}

void McpDrive::submit(Wish wish, TimePoint now)
{
    if (takeAtOnce(wish, now))
        return;
    std::unique_ptr<WishTask> task;
    if (const auto *stream = std::get_if<Stream>(&wish.what))
        task = std::make_unique<StreamTask>(wish.id, *stream, m_stream);
    else
        task = taskFor(wish);
    if (task->permission() == Permission::Armed && !m_armed)
        return endNow(wish, Outcome::NotSent,
            m_stop.active() ? "stopped; arm again first" : "not armed", now);
    task->motion() = motionOf(wish, m_board, now);
    if (const auto *write = std::get_if<Write>(&wish.what))
        m_wishes.supersede(*write);
    if (!m_wishes.add(std::move(task)))
        return endNow(wish, Outcome::NotSent, "too many wishes wait already", now);
    work(now);
}

std::unique_ptr<Drive> makeMcpDrive(const McpDriveConfig &config)
{
    return std::make_unique<McpDrive>(config);
}

} // namespace drive

// What is asked of an MCB drive, and what its link tells.
#include "drive/mcb/mcb_drive.h"

#include "drive/mcb/mcb_catalog.h"
#include "drive/mcb/mcb_commands.h"
#include "drive/mcb/mcb_machine.h"
#include "drive/mcb/mcb_messages.h"
#include "drive/mcb/mcb_writes.h"
#include "mcb/dictionary.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr Duration kClosingTime =
    500ms; ///< for the way back to the config state when disconnecting

LinkReason reasonOf(mcb::Master::Cause cause)
{
    switch (cause) {
    case mcb::Master::Cause::NotReady:
        return LinkReason::NotReady;
    case mcb::Master::Cause::DeadLow:
    case mcb::Master::Cause::DeadHigh:
        return LinkReason::DeadLine;
    case mcb::Master::Cause::Garbage:
    case mcb::Master::Cause::Damaged:
        return LinkReason::OnlyGarbage;
    default:
        return LinkReason::NoAnswer;
    }
}

mcb::Master::Config linkConfig(const McbDriveConfig &config)
{
    mcb::Master::Config link;
    link.patience = config.patience;
    return link;
}

} // namespace

McbDrive::McbDrive(const McbDriveConfig &config)
    : WishDrive(m_board)
    , m_config(config)
    , m_link(linkConfig(config))
{
    m_board.motorsCounted = true; // one, always
    // What a stop needs before anything was told.
    for (const std::uint16_t address :
        {mcbreg::kControl, mcbreg::kStatus, mcbreg::kVelocityNow, mcbreg::kLastError})
        if (const mcb::Entry *entry = mcb::findEntry(address))
            m_board.infos[address] = entry->info;
    m_board.catalog = mcbCatalogOf(m_board.infos);
}

void McbDrive::connect(TimePoint now)
{
    cutAllWishes("connecting anew");
    m_mode = Mode::Open;
    m_lost.reset();
    m_reconnectAt.reset();
    m_task = nullptr;
    m_stopUnderWay = false;
    endSetPoints();
    m_link.connect(now);
    work(now);
}

void McbDrive::disconnect(TimePoint now)
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
    m_setPoints.end(); // frames hold what they carry until the drive has left the cyclic state
    if (m_stream.running() && connected())
        m_wishes.add(std::make_unique<McbStreamTask>(0, Stream{}, m_stream, m_setPoints));
    work(now);
}

void McbDrive::receive(ByteView bytes, TimePoint now)
{
    m_link.receive(bytes, now);
    work(now);
}

void McbDrive::handleReady(bool high, TimePoint now)
{
    m_link.setReady(high, now);
    work(now);
}

void McbDrive::handleTimeout(TimePoint now)
{
    m_link.handleTimeout(now);
    m_stop.handleTimeout(now);
    work(now);
}

std::optional<TimePoint> McbDrive::nextTimeout() const
{
    std::optional<TimePoint> due = m_link.nextTimeout();
    const auto consider = [&](std::optional<TimePoint> at) {
        if (at && (!due || *at < *due))
            due = at;
    };
    consider(m_reconnectAt);
    consider(m_stream.nextFlush());
    if (m_mode == Mode::Closing)
        consider(m_closeBy);
    // What is due already and was not sent waits for something else, which has its own timer.
    const auto considerLater = [&](std::optional<TimePoint> at) {
        if (at && *at > m_workedAt)
            consider(at);
    };
    if (m_stop.active()) {
        consider(m_stop.nextAlarm());
        if (const auto next = m_stop.nextStop(connected(), m_workedAt))
            considerLater(
                m_stopUnderWay ? std::max(*next, m_stopSince + StopSequence::kRepeat) : *next);
        if (m_stopWaits)
            considerLater(*m_stopWaits + StopSequence::kRepeat);
    }
    if (linkIsFree() && m_mode == Mode::Open) {
        considerLater(m_vitals.due());
        considerLater(m_watch.due());
        if (stopHoldsBack(m_workedAt))
            considerLater(m_stop.blindUntil());
    }
    return due;
}

std::unique_ptr<WishTask> McbDrive::taskFor(const Wish &wish)
{
    struct Make {
        WishId id;
        const McbBoard &board;
        McbStreamControl &stream;
        McbSetPoints &setPoints;
        using Made = std::unique_ptr<WishTask>;

        Made operator()(const Read &read) { return std::make_unique<McbReadTask>(id, read, board); }
        Made operator()(const Write &write)
        {
            return std::make_unique<McbWriteTask>(id, write, board);
        }
        Made operator()(const Command &command)
        {
            return std::make_unique<McbCommandTask>(id, command, board);
        }
        Made operator()(const SpeedRamp &ramp)
        {
            return std::make_unique<McbSpeedTask>(id, ramp, board);
        }
        Made operator()(const TorqueRamp &)
        {
            return std::make_unique<RefusedTask>(
                id, Permission::Armed, board.reasonAgainst(Feature::TorqueRamp));
        }
        Made operator()(const CurrentReference &reference)
        {
            return std::make_unique<McbCurrentTask>(id, reference, board);
        }
        Made operator()(const PositionRamp &ramp)
        {
            return std::make_unique<McbPositionTask>(id, ramp, board);
        }
        Made operator()(const Stream &wanted)
        {
            return std::make_unique<McbStreamTask>(id, wanted, stream, setPoints);
        }
        Made operator()(const CyclicSetPoints &wanted)
        {
            return std::make_unique<McbStreamTask>(id, wanted, stream, setPoints);
        }
        // Done at once, before a task is asked for.
        Made refused() const
        {
            return std::make_unique<RefusedTask>(id, Permission::Armed, "is no work");
        }
        Made operator()(const Watch &) const { return refused(); }
        Made operator()(const UserLimits &) const { return refused(); }
        Made operator()(const ExpertMode &) const { return refused(); }
        Made operator()(const CurrentScale &) const { return refused(); }
    };
    return std::visit(Make{wish.id, m_board, m_stream, m_setPoints}, wish.what);
}

void McbDrive::onLinkEvents(TimePoint now)
{
    for (const Link::Event &event : m_link.takeEvents())
        std::visit([&](const auto &what) { on(what, now); }, event);
}

void McbDrive::on(const Link::Done &event, TimePoint now)
{
    if (m_task == nullptr) {
        if (std::exchange(m_stopUnderWay, false) && event.end == Link::End::Ok)
            m_stop.stopAnswered(1, now);
        m_vitals.hurry(now);
        return;
    }
    const auto wanted = std::exchange(m_confirming, std::nullopt);
    const Link::Done done = wanted ? confirmed(event, *wanted) : event;
    if (done.end == Link::End::Ok || done.end == Link::End::Refused)
        takeAnswer(mcbAnswer(done), now);
    else
        m_task->takeNoResponse(
            done.end == Link::End::NotSent ? std::optional(false) : std::nullopt, now);
    bool changed = false;
    if (auto *write = dynamic_cast<McbWriteTask *>(m_task))
        changed = write->takeTypeChanged();
    else if (auto *stream = dynamic_cast<McbStreamTask *>(m_task))
        changed = stream->takeTypeChanged();
    afterTask(now);
    if (changed)
        m_identification.restart();
}

void McbDrive::beginAnew(TimePoint now)
{
    m_stream.ended();
    endSetPoints();
    m_faulty = false;
    m_identification.restart();
    m_vitals.restart(now);
    m_watch.restart(now);
}

void McbDrive::on(const Link::Met &, TimePoint now)
{
    m_lost.reset();
    m_reconnectAt.reset();
    beginAnew(now);
    tell(LinkState::Connected, LinkReason::None);
}

void McbDrive::on(const Link::Cycle &event, TimePoint)
{
    const std::uint64_t lost = m_link.stats().cyclesLost;
    m_stream.receive(event, lost - std::exchange(m_cyclesLost, lost));
}

void McbDrive::on(const Link::Searching &, TimePoint) { m_stream.interrupted(); }

void McbDrive::on(const Link::Back &event, TimePoint now)
{
    m_stream.interrupted();
    if (!event.afterReset)
        return;
    disarm();
    m_board.expert.clear();
    beginAnew(now);
    tell(LinkState::Connected, LinkReason::BoardReset);
}

void McbDrive::on(const Link::Lost &event, TimePoint now)
{
    const LinkReason reason = reasonOf(event.cause);
    if (!m_lost || reason != LinkReason::NoAnswer)
        m_lost = reason; // "no answer" while trying again is no news
    setArmed(false);
    cutAllWishes("link lost");
    m_task = nullptr;
    m_stopUnderWay = false;
    m_board.expert.clear();
    m_stream.ended();
    endSetPoints();
    m_reconnectAt = now + (m_stop.blind(now) ? StopSequence::kRepeat : m_config.reconnectEvery);
}

void McbDrive::onIdentified(TimePoint now)
{
    m_board.capabilities = mcbCapabilitiesOf(m_board);
    m_events.emplace_back(Identified{m_identification.identity(), m_board.catalog, m_board.limits,
        m_board.streaming, m_board.capabilities, mcb::kConfigFrameBytes, mcb::kConfigFrameBytes,
        mcb::kMostFrameBytes, mcbStateSteps()});
    m_vitals.hurry(now);
    if (m_stream.wanted() && !m_stream.running() && m_mode == Mode::Open)
        m_wishes.addFirst(
            std::make_unique<McbStreamTask>(0, m_stream.wish(), m_stream, m_setPoints));
}

std::unique_ptr<Drive> makeMcbDrive(const McbDriveConfig &config)
{
    return std::make_unique<McbDrive>(config);
}

} // namespace drive

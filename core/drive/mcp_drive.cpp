#include "drive/mcp_drive.h"

#include "aspep/controller.h"
#include "drive/mcp_commands.h"
#include "drive/mcp_identification.h"
#include "drive/mcp_polling.h"
#include "drive/mcp_stop.h"
#include "drive/mcp_stream.h"
#include "drive/mcp_vitals.h"
#include "drive/mcp_wishes.h"
#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;
using Link = aspep::Controller;

constexpr Duration kCountersEvery = 250ms;
constexpr Duration kClosingTime = 500ms; ///< for the stop of the datalog when disconnecting

Link::Config linkConfig(const McpDriveConfig &config)
{
    Link::Config link;
    link.baud = config.baud;
    link.payloadPause = config.payloadPause;
    return link;
}

LinkReason reasonOf(Link::LostReason reason)
{
    switch (reason) {
    case Link::LostReason::NoAnswer:
        return LinkReason::NoAnswer;
    case Link::LostReason::OnlyGarbage:
        return LinkReason::OnlyGarbage;
    case Link::LostReason::NoAgreement:
        return LinkReason::NoAgreement;
    case Link::LostReason::Silence:
        return LinkReason::Silence;
    case Link::LostReason::RecoveryFailed:
        break;
    }
    return LinkReason::RecoveryFailed;
}

/// Takes the answer that belongs to a wish which has ended meanwhile.
class NobodysTask : public Task {
public:
    std::optional<Bytes> nextRequest(TimePoint) override { return std::nullopt; }
    void takeResponse(ByteView, TimePoint) override { }
    void takeNoResponse(std::optional<bool>, TimePoint) override { }
};

class McpDrive : public Drive {
public:
    explicit McpDrive(const McpDriveConfig &config)
        : m_config(config)
        , m_link(linkConfig(config))
    {
        m_board.baud = config.baud;
    }

    void connect(TimePoint now) override;
    void disconnect(TimePoint now) override;
    void receive(ByteView bytes, TimePoint now) override;
    void handleTimeout(TimePoint now) override;
    void handleSent(TimePoint now) override;
    std::vector<Output> takeOutput() override { return m_link.takeOutput(); }
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const override;
    void submit(Wish wish, TimePoint now) override;
    void stop(TimePoint now) override;
    void arm() override;
    void disarm() override;
    bool armed() const override { return m_armed; }

private:
    /// What the owner wants of the link.
    enum class Mode : std::uint8_t { Closed, Open, Closing };

    // what the link tells
    void onLinkEvents(TimePoint now);
    void on(const Link::Connected &event, TimePoint now);
    void on(const Link::Lost &event, TimePoint now);
    void on(const Link::Response &event, TimePoint now);
    void on(const Link::NoResponse &event, TimePoint now);
    void on(const Link::Recovered &event, TimePoint now);
    void on(const Link::Suspect &, TimePoint) { m_suspect = true; }
    void on(const Link::Async &event, TimePoint now) { m_stream.receive(event.payload, now); }
    void afterTask(TimePoint now);
    void onIdentified(TimePoint now);

    // what goes out
    void work(TimePoint now);
    bool sendStop(TimePoint now);
    void sendNext(TimePoint now);
    bool sendIdentification(TimePoint now);
    bool give(Task &task, TimePoint now);
    bool stopHoldsBack(TimePoint now) const;
    bool linkIsFree() const { return m_link.canSend() && m_task == nullptr && !m_stopUnderWay; }
    void close(TimePoint now);

    // what is told
    void tellLink();
    void tell(LinkState state, LinkReason reason);
    void tellVitals();
    void tellCounters(TimePoint now);
    void collect();
    void cutAllWishes(const std::string &reason);
    void endNow(WishId id, Outcome outcome, std::string reason);
    bool connected() const { return m_link.state() == Link::State::Connected; }

    McpDriveConfig m_config;
    Link m_link;
    McpBoard m_board;
    Identification m_identification{m_board};
    VitalPoll m_vitals{m_board};
    WatchPoll m_watch{m_board};
    StreamControl m_stream{m_board};
    StopSequence m_stop;
    WishQueue m_wishes;

    Mode m_mode = Mode::Closed;
    NobodysTask m_nobody;
    Task *m_task = nullptr; ///< whose answer the link is waiting for
    int m_stopMotor = 0; ///< with a stop on its way: whose
    bool m_stopUnderWay =
        false; ///< handed to the link, not answered; may wait behind m_task's answer
    TimePoint m_stopSince;
    bool m_cutAfterAnswer = false;
    bool m_armed = false;
    bool m_suspect = false;
    bool m_resetSeen = false; ///< the connection under way follows a reset of the board
    LinkState m_toldState = LinkState::Closed;
    LinkReason m_toldReason = LinkReason::None;
    std::optional<LinkReason> m_lost; ///< since the link was lost, until it is there again
    std::optional<TimePoint> m_reconnectAt;
    TimePoint m_closeBy;
    TimePoint m_workedAt;
    TimePoint m_countersAt;
    LinkCounters m_counters;
    std::vector<Event> m_events;
};

// ---- verbs

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
        consider(
            m_stopUnderWay ? m_stopSince + StopSequence::kRepeat : m_stop.nextStop(connected()));
    }
    // What is due already and was not sent waits for something else, which has its own timer.
    const auto considerLater = [&](std::optional<TimePoint> at) {
        if (at && *at > m_workedAt)
            consider(at);
    };
    if (linkIsFree() && m_mode == Mode::Open) {
        considerLater(m_vitals.due());
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

// ---- what the link tells

void McpDrive::onLinkEvents(TimePoint now)
{
    for (const Link::Event &event : m_link.takeEvents())
        std::visit([&](const auto &what) { on(what, now); }, event);
}

void McpDrive::on(const Link::Connected &event, TimePoint now)
{
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = false;
    m_resetSeen = event.afterReset;
    if (event.afterReset)
        disarm();
    m_board.requestBytes = event.agreed.rxMax();
    m_board.responseBytes = event.agreed.txSyncMax();
    m_board.streamBytes = event.agreed.txAsyncMax();
    m_board.linkId = m_link.linkId();
    m_identification.restart();
    m_vitals.restart(now);
    m_watch.restart(now);
    m_stream.connected();
    tell(LinkState::Connected, event.afterReset ? LinkReason::BoardReset : LinkReason::None);
}

void McpDrive::on(const Link::Lost &event, TimePoint now)
{
    if (!m_lost || event.reason != Link::LostReason::NoAnswer)
        m_lost = reasonOf(event.reason); // "no answer" while trying again is no news
    m_armed = false;
    cutAllWishes("link lost");
    m_task = nullptr;
    m_stopUnderWay = false;
    m_suspect = false;
    m_reconnectAt = now + m_config.reconnectEvery;
}

void McpDrive::on(const Link::Recovered &, TimePoint)
{
    m_suspect = false;
    m_stream.connected();
}

void McpDrive::on(const Link::Response &event, TimePoint now)
{
    if (m_task != nullptr) {
        m_task->takeResponse(event.payload, now);
        afterTask(now);
    } else if (m_stopUnderWay) {
        m_stopUnderWay = false;
        const Bytes ok{static_cast<std::uint8_t>(mcp::Status::Ok)};
        if (event.payload == ok)
            m_stop.stopAnswered(m_stopMotor, now);
        m_vitals.hurry(now);
    }
}

void McpDrive::on(const Link::NoResponse &event, TimePoint now)
{
    if (m_task != nullptr) {
        m_task->takeNoResponse(event.executed, now);
        afterTask(now);
    } else {
        m_stopUnderWay = false;
    }
}

void McpDrive::afterTask(TimePoint now)
{
    auto *wish = dynamic_cast<WishTask *>(std::exchange(m_task, nullptr));
    const bool cut = std::exchange(m_cutAfterAnswer, false);
    if (wish == nullptr)
        return;
    if (cut)
        wish->cut("stopped");
    if (wish->finished() && wish->permission() == Permission::Armed)
        m_vitals.hurry(now); // whatever became of it, look at once
}

void McpDrive::onIdentified(TimePoint now)
{
    m_stream.restart(m_resetSeen);
    Identified event{m_identification.identity(), m_board.catalog, m_board.limits,
        m_board.streaming, m_board.capabilities, m_board.requestBytes, m_board.responseBytes,
        m_board.streamBytes};
    m_events.emplace_back(std::move(event));
    m_vitals.hurry(now); // now the speed can be read too
    if (m_stream.wanted() && m_mode == Mode::Open)
        m_wishes.addFirst(std::make_unique<StreamTask>(0, m_stream.wish(), m_stream));
}

// ---- what goes out

void McpDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    tellVitals();
    if (m_identification.takeNews())
        onIdentified(now);
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open && !m_stop.blind(now)) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    if (m_mode == Mode::Open && m_stop.active())
        sendStop(now);
    if (linkIsFree())
        sendNext(now);
    collect();
    if (m_mode == Mode::Closing)
        close(now);
    tellLink();
    tellCounters(now);
}

bool McpDrive::sendStop(TimePoint now)
{
    if (m_stopUnderWay && now < m_stopSince + StopSequence::kRepeat)
        return false;
    const auto motor = m_stop.stopDue(now, connected());
    if (!motor)
        return false;
    m_stopUnderWay = true;
    m_stopMotor = *motor;
    m_stopSince = now;
    m_stop.stopSent(*motor, now);
    const auto word =
        static_cast<unsigned>(mcp::CommandId::StopMotor) << 3 | static_cast<unsigned>(*motor);
    m_link.sendUrgent(ByteWriter().u16(word).take(), now);
    onLinkEvents(now);
    return true;
}

bool McpDrive::stopHoldsBack(TimePoint now) const
{
    return m_stop.exclusive() && (!m_stop.alarmed() || m_stop.blind(now));
}

void McpDrive::sendNext(TimePoint now)
{
    if (m_mode == Mode::Open && (sendIdentification(now) || give(m_vitals, now)))
        return;
    while (WishTask *wish = m_wishes.next(m_armed)) {
        if (give(*wish, now))
            return;
        if (!wish->finished())
            break; // waits for something else; nothing overtakes it
        m_wishes.collect(m_events);
    }
    if (m_mode == Mode::Open)
        give(m_watch, now);
}

/// Whether the link is not there for anything else now.
bool McpDrive::sendIdentification(TimePoint now)
{
    if (m_stop.active() && give(m_vitals, now))
        return true;
    if (stopHoldsBack(now))
        return true;
    using Phase = Identification::Phase;
    if (m_identification.phase() == Phase::States) {
        if (m_vitals.complete())
            m_identification.statesRead();
        else if (give(m_vitals, now))
            return true;
    }
    if (m_identification.phase() == Phase::Done)
        return false;
    give(m_identification, now);
    return true;
}

bool McpDrive::give(Task &task, TimePoint now)
{
    const auto request = task.nextRequest(now);
    if (!request)
        return false;
    m_task = &task;
    m_link.sendRequest(*request, now);
    return true;
}

void McpDrive::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false) != nullptr;
    if (busy && connected() && now < m_closeBy)
        return;
    cutAllWishes("disconnected");
    m_stream.close();
    m_link.reset();
    static_cast<void>(m_link.takeEvents());
    m_task = nullptr;
    m_stopUnderWay = false;
    m_stop.end();
    m_lost.reset();
    m_reconnectAt.reset();
    m_mode = Mode::Closed;
    collect();
}

// ---- wishes

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

// ---- what is told

void McpDrive::collect()
{
    m_wishes.collect(m_events);
    m_watch.setStreamLoad(m_stream.load());
    if (auto readings = m_watch.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    for (Event &event : m_stream.takeEvents())
        m_events.push_back(std::move(event));
    for (const StopProgress &progress : m_stop.takeProgress())
        m_events.emplace_back(progress);
}

void McpDrive::tellVitals()
{
    for (MotorStatus &status : m_vitals.takeStatuses()) {
        m_stop.takeStatus(status, m_vitals.askedAt());
        m_events.emplace_back(std::move(status));
    }
}

void McpDrive::tell(LinkState state, LinkReason reason)
{
    m_toldState = state;
    m_toldReason = reason;
    m_events.emplace_back(LinkChanged{state, reason});
}

void McpDrive::tellLink()
{
    LinkState state = LinkState::Connecting;
    LinkReason reason = LinkReason::None;
    if (m_mode == Mode::Closed) {
        state = LinkState::Closed;
    } else if (m_lost) {
        state = LinkState::Lost;
        reason = *m_lost;
    } else if (connected()) {
        state = m_suspect ? LinkState::Suspect : LinkState::Connected;
        reason = m_toldState == state ? m_toldReason : LinkReason::None;
    } else if (m_link.state() == Link::State::Recovering) {
        state = m_suspect ? LinkState::Suspect : LinkState::Recovering;
    }
    if (state != m_toldState || reason != m_toldReason)
        tell(state, reason);
}

void McpDrive::tellCounters(TimePoint now)
{
    if (now < m_countersAt)
        return;
    const Link::Stats &link = m_link.stats();
    LinkCounters counters;
    counters.bytesIn = link.bytesIn;
    counters.bytesOut = link.bytesOut;
    counters.packetsIn = link.packetsIn;
    counters.packetsOut = link.packetsOut;
    counters.badPackets = link.badHeaderCrc + link.unknownType + link.inconsistent + link.tooLong
        + link.badPayloadCrc + link.torn + link.unexpected;
    counters.nacks = link.nacks;
    counters.timeouts = link.timeouts;
    counters.recoveries = link.recoveries;
    counters.streamPackets = m_stream.packets();
    counters.streamLostTicks = m_stream.lostTicks();
    counters.streamSkipped = m_stream.skipped();
    if (counters == m_counters)
        return;
    m_counters = counters;
    m_countersAt = now + kCountersEvery;
    m_events.emplace_back(counters);
}

} // namespace

std::unique_ptr<Drive> makeMcpDrive(const McpDriveConfig &config)
{
    return std::make_unique<McpDrive>(config);
}

} // namespace drive

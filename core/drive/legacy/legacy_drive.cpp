#include "drive/legacy/legacy_drive.h"

#include "base/overloaded.h"
#include "drive/legacy/legacy_commands.h"
#include "drive/legacy/legacy_identification.h"
#include "drive/legacy/legacy_polling.h"
#include "drive/legacy/legacy_writes.h"
#include "drive/motion_of.h"
#include "drive/wish_drive.h"
#include "legacy/client.h"

#include <algorithm>

namespace drive {

namespace {

using Link = legacy::Client;

/// A stream cannot be had; stopping none is no failure.
class NoStreamTask : public WishTask {
public:
    NoStreamTask(WishId id, const Stream &stream, const LegacyFacts &board)
        : WishTask(id, Permission::Always)
        , m_stops(stream.fast.empty() && stream.slow.empty())
        , m_board(board)
    {
    }
    std::optional<Bytes> nextRequest(TimePoint) override
    {
        end(m_stops ? Outcome::Ok : Outcome::Refused,
            m_stops ? std::string() : m_board.reasonAgainst(Feature::Stream));
        return std::nullopt;
    }
    void takeResponse(ByteView, TimePoint) override { }
    void takeNoResponse(std::optional<bool>, TimePoint) override { }

private:
    bool m_stops;
    const LegacyFacts &m_board;
};

Bytes asBytes(const legacy::Reply &reply)
{
    Bytes bytes;
    if (const auto *ack = std::get_if<legacy::Ack>(&reply)) {
        bytes.push_back(legacy::kAckHeader);
        bytes.insert(bytes.end(), ack->data.begin(), ack->data.end());
    } else if (const auto *nack = std::get_if<legacy::Nack>(&reply)) {
        bytes.push_back(legacy::kNackHeader);
        if (nack->error)
            bytes.push_back(*nack->error);
    }
    return bytes;
}

/// The motion log has only what can change something.
bool changes(const legacy::Request &request)
{
    return !std::holds_alternative<legacy::GetRegister>(request.command)
        && !std::holds_alternative<legacy::GetRevUp>(request.command);
}

legacy::Request stopOf(int motor)
{
    return {static_cast<std::uint8_t>(motor),
        legacy::Execute{static_cast<std::uint8_t>(legacy::CommandId::StopMotor)}};
}

class LegacyDrive final : public WishDrive {
public:
    explicit LegacyDrive(const LegacyDriveConfig &config)
        : WishDrive(m_board)
        , m_config(config)
        , m_link({config.baud, config.patience})
        , m_identification(m_board, config.dialect)
    {
        constexpr double kBitsPerByte = 10.0;
        m_board.bytesPerSecond = config.baud / kBitsPerByte;
    }

    void connect(TimePoint now) override;
    void disconnect(TimePoint now) override;
    void receive(ByteView bytes, TimePoint now) override
    {
        m_link.receive(bytes, now);
        work(now);
    }
    void handleTimeout(TimePoint now) override
    {
        m_link.handleTimeout(now);
        m_stop.handleTimeout(now);
        work(now);
    }
    void handleSent(TimePoint now) override
    {
        m_link.handleSent(now);
        work(now);
    }
    std::vector<Output> takeOutput() override { return m_link.takeOutput(); }
    std::optional<TimePoint> nextTimeout() const override;
    std::vector<Output> stopScript() const override;

private:
    void work(TimePoint now) override;
    std::unique_ptr<WishTask> taskFor(const Wish &wish) override;
    std::string takeScale(const CurrentScale &scale, TimePoint now) override;
    void tellIdentified();
    void watch(const Watch &watch, TimePoint now) override { m_watch.watch(watch, now); }
    void lookAtOnce(TimePoint now) override { m_vitals.hurry(now); }

    void onLinkEvents(TimePoint now);
    void onConnected(const Link::Connected &event, TimePoint now);
    void onAnswer(const Link::Answer &event, TimePoint now);
    void onNoAnswer(const Link::NoAnswer &event, TimePoint now);
    void onRestarted(TimePoint now);
    void onLost(const Link::Lost &event, TimePoint now);
    void onIdentified(TimePoint now);

    bool linkIsFree() const { return m_link.canSend() && m_task == nullptr && !m_stopUnderWay; }
    bool sendStop(TimePoint now);
    TimePoint nextStopMayLeave() const;
    bool sendFirst(TimePoint now) override;
    bool give(Task &task, TimePoint now) override;
    void tellState();
    void countLink(TimePoint now);
    void collect();

    LegacyDriveConfig m_config;
    LegacyFacts m_board;
    Link m_link;
    LegacyIdentification m_identification;
    LegacyVitals m_vitals{m_board};
    LegacyWatch m_watch{m_board};

    std::uint8_t m_stopMotor = 0; ///< with a stop on its way: whose
    bool m_stopUnderWay = false;
    TimePoint m_stopSince;
    bool m_suspect = false;
    bool m_restarted = false; ///< the board said so; it is met anew
    bool m_reidentify = false;
    std::optional<TimePoint> m_reconnectAt;
};

void LegacyDrive::connect(TimePoint now)
{
    cutAllWishes("connecting anew");
    m_mode = Mode::Open;
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = m_stopUnderWay = false;
    m_task = nullptr;
    m_link.connect(now);
    tellState();
    work(now);
}

void LegacyDrive::disconnect(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_workedAt = now;
    m_stop.end();
    setArmed(false);
    cutAllWishes("disconnected");
    m_watch.watch({}, now);
    m_link.close();
    m_task = nullptr;
    m_stopUnderWay = false;
    m_lost.reset();
    m_reconnectAt.reset();
    m_mode = Mode::Closed;
    collect();
    tellState();
}

std::optional<TimePoint> LegacyDrive::nextTimeout() const
{
    std::optional<TimePoint> due = m_link.nextTimeout();
    const auto consider = [&](std::optional<TimePoint> at) {
        if (at && (!due || *at < *due))
            due = at;
    };
    // What is due already and was not sent waits for something else, which has its own timer.
    const auto considerLater = [&](std::optional<TimePoint> at) {
        if (at && *at > m_workedAt)
            consider(at);
    };
    if (m_mode != Mode::Open)
        return due;
    if (m_reconnectAt)
        consider(m_stop.active() ? std::max(*m_reconnectAt, m_stop.blindUntil()) : *m_reconnectAt);
    if (m_stop.active()) {
        consider(m_stop.nextAlarm());
        if (const auto next = m_stop.nextStop(m_link.connected(), m_workedAt))
            consider(std::max(*next, nextStopMayLeave()));
    }
    if (linkIsFree()) {
        considerLater(m_vitals.due());
        considerLater(m_watch.due());
        if (stopHoldsBack(m_workedAt))
            considerLater(m_stop.blindUntil());
    }
    return due;
}

std::unique_ptr<WishTask> LegacyDrive::taskFor(const Wish &wish)
{
    return std::visit(
        Overloaded{
            [&](const Read &read) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacyReadTask>(wish.id, read, m_board);
            },
            [&](const Write &write) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacyWriteTask>(wish.id, write, m_board);
            },
            [&](const Command &command) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacyCommandTask>(wish.id, command, m_board);
            },
            [&](const SpeedRamp &ramp) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacySetPointTask>(wish.id, ramp, m_board);
            },
            [&](const TorqueRamp &ramp) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacySetPointTask>(wish.id, ramp, m_board);
            },
            [&](const CurrentReference &reference) -> std::unique_ptr<WishTask> {
                return std::make_unique<LegacySetPointTask>(wish.id, reference, m_board);
            },
            [&](const PositionRamp &) -> std::unique_ptr<WishTask> {
                return std::make_unique<RefusedTask>(
                    wish.id, Permission::Armed, m_board.reasonAgainst(Feature::PositionRamp));
            },
            [&](const CyclicSetPoints &) -> std::unique_ptr<WishTask> {
                return std::make_unique<RefusedTask>(
                    wish.id, Permission::Always, m_board.reasonAgainst(Feature::CyclicSetPoints));
            },
            [&](const Stream &stream) -> std::unique_ptr<WishTask> {
                return std::make_unique<NoStreamTask>(wish.id, stream, m_board);
            },
            [&](const auto &) -> std::unique_ptr<WishTask> {
                return std::make_unique<RefusedTask>(wish.id, Permission::Always, "not here");
            },
        },
        wish.what);
}

void LegacyDrive::onLinkEvents(TimePoint now)
{
    for (const Link::Event &event : m_link.takeEvents()) {
        std::visit(Overloaded{
                       [&](const Link::Connected &what) { onConnected(what, now); },
                       [&](const Link::Answer &what) { onAnswer(what, now); },
                       [&](const Link::NoAnswer &what) { onNoAnswer(what, now); },
                       [&](const Link::Restarted &) { onRestarted(now); },
                       [&](const Link::Suspect &) { m_suspect = true; },
                       [&](const Link::Recovering &) {},
                       [&](const Link::Lost &what) { onLost(what, now); },
                   },
            event);
    }
}

void LegacyDrive::onConnected(const Link::Connected &event, TimePoint now)
{
    m_lost.reset();
    m_reconnectAt.reset();
    m_suspect = false;
    if (event.again && m_board.identified && !m_reidentify)
        return; // a recovery: the same board, in step again
    m_reidentify = false;
    m_identification.restart(event.board);
    m_vitals.restart(now);
    m_watch.restart(now);
    tell(LinkState::Connected,
        std::exchange(m_restarted, false) ? LinkReason::BoardReset : LinkReason::None);
}

void LegacyDrive::onAnswer(const Link::Answer &event, TimePoint now)
{
    m_suspect = false;
    const Bytes response = asBytes(event.reply);
    if (m_task != nullptr) {
        takeAnswer(response, now);
        afterTask(now);
    } else if (std::exchange(m_stopUnderWay, false)) {
        if (event.sure && ackData(response))
            m_stop.stopAnswered(m_stopMotor, now);
        m_vitals.hurry(now);
    }
}

void LegacyDrive::onNoAnswer(const Link::NoAnswer &event, TimePoint now)
{
    if (m_task == nullptr)
        return;
    m_task->takeNoResponse(event.executed, now);
    afterTask(now);
}

/// Whatever was known of it is void, and nobody has armed this board.
void LegacyDrive::onRestarted(TimePoint now)
{
    m_restarted = true;
    m_reidentify = true;
    setArmed(false);
    cutAllWishes("the board was reset");
    m_task = nullptr;
    m_stopUnderWay = false;
    m_link.connect(now);
}

void LegacyDrive::onLost(const Link::Lost &event, TimePoint now)
{
    const LinkReason reason = event.otherProtocol ? LinkReason::OtherProtocol
        : !event.connecting                       ? LinkReason::RecoveryFailed
        : event.heardBytes                        ? LinkReason::OnlyGarbage
                                                  : LinkReason::NoAnswer;
    if (!m_lost || reason != LinkReason::NoAnswer)
        m_lost = reason; // "no answer" while trying again is no news
    setArmed(false);
    cutAllWishes("link lost");
    m_task = nullptr;
    m_stopUnderWay = false;
    m_suspect = false;
    m_reidentify = true;
    m_reconnectAt = now + m_config.reconnectEvery;
}

void LegacyDrive::tellIdentified()
{
    m_events.emplace_back(Identified{m_identification.identity(), m_board.catalog, m_board.limits,
        m_board.streaming, m_board.capabilities, 0, 0, 0, legacyStateSteps()});
}

/// The board is told anew, so that nobody goes on with units of before; it is asked nothing.
std::string LegacyDrive::takeScale(const CurrentScale &scale, TimePoint)
{
    if (auto why = m_board.reasonAgainst(Feature::CurrentScale); !why.empty())
        return why;
    const double perDigit = scale.fullScaleAmps / kFullScaleDigits;
    if (perDigit == m_board.ampsPerDigit(scale.motor))
        return {};
    disarm();
    m_board.scales[static_cast<std::size_t>(scale.motor - 1)].ampsPerDigit = perDigit;
    m_board.catalog = std::make_shared<const catalog::Catalog>(
        m_board.catalog->registers(), m_board.motors, m_board.scales);
    m_identification.addCapabilities();
    tellIdentified();
    return {};
}

void LegacyDrive::onIdentified(TimePoint now)
{
    m_link.setDialect(m_board.dialect);
    tellIdentified();
    if (auto readings = m_identification.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    m_watch.restart(now);
    m_vitals.hurry(now);
}

void LegacyDrive::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    m_link.setDialect(m_board.dialect);
    takeStatuses(m_vitals.takeStatuses(), m_vitals.askedAt());
    if (m_identification.takeNews())
        onIdentified(now);
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open && !m_stop.blind(now)) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    m_link.setMotorDriven(m_vitals.motorDriven());
    if (followStop(now))
        sendStop(now);
    if (linkIsFree() && m_mode == Mode::Open)
        sendNext(m_vitals, m_watch, now);
    collect();
    tellState();
    countLink(now);
}

/// The same in both dialects. Fillers end a frame that firmware may still wait for: see legacy/client.h.
std::vector<Output> LegacyDrive::stopScript() const
{
    constexpr Duration kAnswerTime = std::chrono::milliseconds(10); // a frame before it is dropped
    constexpr int kFillers = 8;
    std::vector<Output> script;
    for (int motor = 1; motor <= m_board.motors; ++motor)
        script.push_back({legacy::encodeRequest(stopOf(motor)).value_or(Bytes()), kAnswerTime});
    for (int i = 0; i < kFillers; ++i)
        script.push_back({Bytes{0xFF}, i == 0 ? kAnswerTime : Link::kFillPause});
    return script;
}

/// A board that answers drops what comes meanwhile: blind STOPs of several motors, too, leave it time. They come close
/// together, so that the line has its rest behind them.
TimePoint LegacyDrive::nextStopMayLeave() const
{
    constexpr Duration kBetweenBlind = std::chrono::milliseconds(20);
    if (m_stopUnderWay)
        return m_stopSince + StopSequence::kRepeat;
    return m_link.canSend() ? TimePoint{} : m_stopSince + kBetweenBlind;
}

bool LegacyDrive::sendStop(TimePoint now)
{
    if (now < nextStopMayLeave())
        return false;
    const auto motor = m_stop.stopDue(now, m_link.connected());
    if (!motor)
        return false;
    const bool clean = m_link.canSend() || m_link.state() == Link::State::Waiting;
    m_stopMotor = static_cast<std::uint8_t>(*motor);
    m_stopSince = now;
    const legacy::Request request = stopOf(*motor);
    noteStop(*motor, legacy::encodeRequest(request).value_or(Bytes()), now);
    m_stopUnderWay = clean;
    m_link.sendUrgent(request, now);
    onLinkEvents(now);
    return true;
}

bool LegacyDrive::sendFirst(TimePoint now)
{
    if (m_identification.done())
        return false;
    give(m_identification, now);
    return true;
}

bool LegacyDrive::give(Task &task, TimePoint now)
{
    const auto frame = task.nextRequest(now);
    if (!frame)
        return false;
    // The frame is taken apart again so that the link knows what fits as an answer.
    legacy::Framer framer(legacy::Framer::Side::Board);
    legacy::Frame whole;
    ByteView bytes(*frame);
    if (framer.next(bytes, whole) != legacy::Framer::Step::Frame)
        return false;
    const auto request = legacy::decodeRequest(whole);
    if (!request)
        return false;
    m_task = &task;
    if (auto *wish = dynamic_cast<WishTask *>(&task);
        wish != nullptr && wish->motion() && changes(*request))
        noteSent(*wish->motion(), *frame);
    m_link.send(*request, now);
    return true;
}

void LegacyDrive::collect()
{
    if (auto readings = m_watch.takeReadings(); !readings.empty())
        m_events.emplace_back(RegistersRead{std::move(readings)});
    collectWishes();
}

void LegacyDrive::tellState()
{
    LinkState state = LinkState::Connecting;
    LinkReason reason = LinkReason::None;
    if (m_mode == Mode::Closed) {
        state = LinkState::Closed;
    } else if (m_lost) {
        state = LinkState::Lost;
        reason = *m_lost;
    } else if (m_link.connected()) {
        const bool recovering = m_link.state() == Link::State::Recovering;
        state = m_suspect ? LinkState::Suspect
            : recovering  ? LinkState::Recovering
                          : LinkState::Connected;
        reason = m_toldState == state ? m_toldReason : LinkReason::None;
    }
    tellLink(state, reason);
}

void LegacyDrive::countLink(TimePoint now)
{
    const Link::Stats &link = m_link.stats();
    LinkCounters counters;
    counters.bytesIn = link.bytesIn;
    counters.bytesOut = link.bytesOut;
    counters.packetsIn = link.framesIn;
    counters.packetsOut = link.framesOut;
    counters.badPackets = link.bad;
    counters.nacks = link.nacks;
    counters.timeouts = link.timeouts;
    counters.recoveries = link.recoveries;
    tellCounters(counters, now);
}

} // namespace

std::unique_ptr<Drive> makeLegacyDrive(const LegacyDriveConfig &config)
{
    return std::make_unique<LegacyDrive>(config);
}

} // namespace drive

// The class behind makeMcpDrive(): the link, the parts that want something of it, and who waits for
// which answer. Its members are spread over mcp_drive.cpp (what is asked of it), mcp_drive_link.cpp
// (what the link tells) and mcp_drive_work.cpp (what goes out, what is told).
#pragma once

#include "aspep/controller.h"
#include "drive/mcp_commands.h"
#include "drive/mcp_drive.h"
#include "drive/mcp_heartbeat.h"
#include "drive/mcp_identification.h"
#include "drive/mcp_polling.h"
#include "drive/mcp_stop.h"
#include "drive/mcp_stream.h"
#include "drive/mcp_vitals.h"
#include "drive/mcp_wishes.h"
#include "drive/motion_record.h"

#include <map>

namespace drive {

using Link = aspep::Controller;

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
    static Link::Config linkConfig(const McpDriveConfig &config)
    {
        Link::Config link;
        link.baud = config.baud;
        link.payloadPause = config.payloadPause;
        link.patience = config.patience;
        return link;
    }

    // what is asked of it
    void setArmed(bool armed);
    bool takeAtOnce(const Wish &wish, TimePoint now); ///< false: it takes a task
    void takeLimits(const Wish &wish, const UserLimits &limits, TimePoint now);
    void takeExpert(const Wish &wish, const ExpertMode &expert, TimePoint now);
    std::unique_ptr<WishTask> taskFor(const Wish &wish) const;

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
    void tellIdentity();

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
    void endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now);
    MotionRecord logged(const StopProgress &progress, MotionRecord record) const;
    bool connected() const { return m_link.state() == Link::State::Connected; }

    McpDriveConfig m_config;
    Link m_link;
    McpBoard m_board;
    Identification m_identification{m_board};
    VitalPoll m_vitals{m_board};
    Heartbeat m_heartbeat{m_board};
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
    TimePoint m_stopAsked; ///< by a person
    std::map<int, MotionRecord> m_stopsSent; ///< by motor: the STOPs since the log was last told
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

} // namespace drive

// The class behind makeMcpDrive(): the link, the parts that want something of it, and who waits for
// which answer. Its members are spread over mcp_drive.cpp (what is asked of it), mcp_drive_link.cpp
// (what the link tells) and mcp_drive_work.cpp (what goes out, what is told).
#pragma once

#include "aspep/controller.h"
#include "drive/mcp/mcp_commands.h"
#include "drive/mcp/mcp_drive.h"
#include "drive/mcp/mcp_heartbeat.h"
#include "drive/mcp/mcp_identification.h"
#include "drive/mcp/mcp_polling.h"
#include "drive/mcp/mcp_stream.h"
#include "drive/mcp/mcp_vitals.h"
#include "drive/mcp/mcp_writes.h"
#include "drive/wish_drive.h"

namespace drive {

using Link = aspep::Controller;

class McpDrive : public WishDrive {
public:
    explicit McpDrive(const McpDriveConfig &config)
        : WishDrive(m_board)
        , m_config(config)
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
    std::optional<TimePoint> nextTimeout() const override;
    std::vector<Output> stopScript() const override;

private:
    static Link::Config linkConfig(const McpDriveConfig &config)
    {
        Link::Config link;
        constexpr int kHastyOffers = 3; // a third of a second each at 115200 baud
        if (config.hasty)
            link.firstSilentOffers = kHastyOffers;
        link.baud = config.baud;
        link.payloadPause = config.payloadPause;
        link.patience = config.patience;
        return link;
    }

    // what is asked of it
    std::unique_ptr<WishTask> taskFor(const Wish &wish) override;
    void watch(const Watch &watch, TimePoint now) override { m_watch.watch(watch, now); }
    void lookAtOnce(TimePoint now) override { m_vitals.hurry(now); }

    // what the link tells
    void onLinkEvents(TimePoint now);
    void on(const Link::Connected &event, TimePoint now);
    void on(const Link::Lost &event, TimePoint now);
    void on(const Link::Response &event, TimePoint now);
    void on(const Link::NoResponse &event, TimePoint now);
    void on(const Link::Recovered &event, TimePoint now);
    void on(const Link::Suspect &, TimePoint) { m_suspect = true; }
    void on(const Link::Async &event, TimePoint now) { m_stream.receive(event.payload, now); }
    void onIdentified(TimePoint now);
    void tellIdentity();

    // what goes out
    void work(TimePoint now) override;
    bool sendStop(TimePoint now);
    bool sendFirst(TimePoint now) override;
    bool give(Task &task, TimePoint now) override;
    bool linkIsFree() const { return m_link.canSend() && m_task == nullptr && !m_stopUnderWay; }
    void close(TimePoint now);

    // what is told
    void tellLinkState();
    void tellLinkCounters(TimePoint now);
    void collect();
    bool connected() const { return m_link.state() == Link::State::Connected; }

    McpDriveConfig m_config;
    Link m_link;
    McpBoard m_board;
    Identification m_identification{m_board};
    VitalPoll m_vitals{m_board};
    Heartbeat m_heartbeat{m_board};
    WatchPoll m_watch{m_board};
    StreamControl m_stream{m_board};

    int m_stopMotor = 0; ///< with a stop on its way: whose
    bool m_stopUnderWay =
        false; ///< handed to the link, not answered; may wait behind m_task's answer
    TimePoint m_stopSince;
    bool m_suspect = false;
    bool m_resetSeen = false; ///< the connection under way follows a reset of the board
    std::optional<TimePoint> m_reconnectAt;
    TimePoint m_closeBy;
};

} // namespace drive

// The class behind makeMcbDrive(): the link, the parts that want something of it, and who waits for which answer.
#pragma once

#include "drive/mcb/mcb_drive.h"
#include "drive/mcb/mcb_identification.h"
#include "drive/mcb/mcb_stream.h"
#include "drive/mcb/mcb_vitals.h"
#include "drive/mcb/mcb_watch.h"
#include "drive/wish_drive.h"
#include "mcb/master.h"

namespace drive {

class McbDrive : public WishDrive {
public:
    explicit McbDrive(const McbDriveConfig &config);

    void connect(TimePoint now) override;
    void disconnect(TimePoint now) override;
    void receive(ByteView bytes, TimePoint now) override;
    void handleTimeout(TimePoint now) override;
    void handleSent(TimePoint) override { }
    void handleReady(bool high, TimePoint now) override;
    std::vector<Output> takeOutput() override { return m_link.takeOutput(); }
    std::optional<TimePoint> nextTimeout() const override;
    std::vector<Output> stopScript() const override;

private:
    using Link = mcb::Master;

    // what is asked of it
    std::unique_ptr<WishTask> taskFor(const Wish &wish) override;
    void watch(const Watch &watch, TimePoint now) override { m_watch.watch(watch, now); }
    void lookAtOnce(TimePoint now) override { m_vitals.hurry(now); }

    // what the link tells
    void onLinkEvents(TimePoint now);
    void on(const Link::Done &event, TimePoint now);
    void on(const Link::Met &event, TimePoint now);
    void on(const Link::Cycle &event, TimePoint now);
    void on(const Link::Searching &event, TimePoint now);
    void on(const Link::Back &event, TimePoint now);
    void on(const Link::Lost &event, TimePoint now);
    void beginAnew(TimePoint now);
    void onIdentified(TimePoint now);

    // what goes out
    void work(TimePoint now) override;
    bool sendStop(TimePoint now);
    bool sendFirst(TimePoint now) override;
    bool give(Task &task, TimePoint now) override;
    bool travels(const Link::Request &request) const;
    Bytes frameWith(const Link::Request &request) const;
    void sendInFrames(const Link::Request &request, TimePoint now);
    Link::Done confirmed(const Link::Done &read, const mcb::Words &wanted);
    void restSetPoints();
    void endSetPoints();
    bool linkIsFree() const { return m_link.canSend() && m_task == nullptr && !m_stopUnderWay; }
    void close(TimePoint now);

    // what is told
    void takeVitals();
    void tellLinkState();
    void tellLinkCounters(TimePoint now);
    void collect(TimePoint now);
    bool connected() const
    {
        return m_link.state() == Link::State::Config || m_link.state() == Link::State::Cyclic;
    }

    McbDriveConfig m_config;
    Link m_link;
    McbBoard m_board;
    McbIdentification m_identification{m_board};
    McbVitals m_vitals{m_board};
    McbWatch m_watch{m_board};
    McbStreamControl m_stream{m_board};
    McbSetPoints m_setPoints{m_board};
    /// Words of a set-point that travels and is being read back: the answer to its write.
    std::optional<mcb::Words> m_confirming;
    bool m_toldCyclic = false, m_faulty = false;

    bool m_stopUnderWay = false;
    TimePoint m_stopSince;
    std::optional<TimePoint>
        m_stopWaits; ///< since then, for the drive to be ready or frames to have their new length
    std::uint64_t m_cyclesLost = 0; ///< as last told by the link
    std::optional<TimePoint> m_reconnectAt;
    TimePoint m_closeBy;
};

} // namespace drive

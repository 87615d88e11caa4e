// The wrappers around a session's transport and drive that feed a SessionTap. They change nothing of what passes.
#include "session/recording/tap.h"

#include <QDateTime>

namespace session {

namespace {

using Direction = recorded::LinkBytes::Direction;

class TappedTransport : public Transport {
public:
    TappedTransport(std::unique_ptr<Transport> inner, std::shared_ptr<SessionTap> tap, Clock clock)
        : m_inner(std::move(inner))
        , m_tap(std::move(tap))
        , m_clock(std::move(clock))
    {
        connect(m_inner.get(), &Transport::received, this, [this](const QByteArray &bytes) {
            m_tap->onLink(Direction::Received,
                {reinterpret_cast<const std::uint8_t *>(bytes.constData()),
                    static_cast<std::size_t>(bytes.size())},
                m_clock());
            Q_EMIT received(bytes);
        });
        connect(m_inner.get(), &Transport::failed, this, &Transport::failed);
        connect(m_inner.get(), &Transport::readyChanged, this, &Transport::readyChanged);
    }

    PortError open(TimePoint now) override { return m_inner->open(now); }
    void close() override { m_inner->close(); }
    void write(ByteView bytes, TimePoint now) override
    {
        m_tap->onLink(Direction::Sent, bytes, now);
        m_inner->write(bytes, now);
    }
    void discardOutput() override { m_inner->discardOutput(); }
    bool sent(TimePoint now) const override { return m_inner->sent(now); }
    void advance(TimePoint now) override { m_inner->advance(now); }
    std::optional<TimePoint> nextWake() const override { return m_inner->nextWake(); }
    void gather(Duration atMost, TimePoint now) override { m_inner->gather(atMost, now); }
    bool real() const override { return m_inner->real(); }
    int descriptor() const override { return m_inner->descriptor(); }

private:
    std::unique_ptr<Transport> m_inner;
    std::shared_ptr<SessionTap> m_tap;
    Clock m_clock;
};

class TappedDrive : public drive::Drive {
public:
    TappedDrive(std::unique_ptr<Drive> inner, std::shared_ptr<SessionTap> tap)
        : m_inner(std::move(inner))
        , m_tap(std::move(tap))
    {
    }

    void connect(TimePoint now) override { at(now).connect(now); }
    void disconnect(TimePoint now) override { at(now).disconnect(now); }
    void receive(ByteView bytes, TimePoint now) override { at(now).receive(bytes, now); }
    void handleTimeout(TimePoint now) override { at(now).handleTimeout(now); }
    void handleSent(TimePoint now) override { at(now).handleSent(now); }
    void handleReady(bool high, TimePoint now) override { at(now).handleReady(high, now); }
    std::vector<Output> takeOutput() override { return m_inner->takeOutput(); }
    std::vector<drive::Event> takeEvents() override
    {
        std::vector<drive::Event> events = m_inner->takeEvents();
        for (const drive::Event &event : events)
            m_tap->onEvent(event, m_now);
        return events;
    }
    std::optional<TimePoint> nextTimeout() const override { return m_inner->nextTimeout(); }
    void submit(drive::Wish wish, TimePoint now) override
    {
        m_tap->onWish(wish, now);
        at(now).submit(std::move(wish), now);
    }
    void stop(TimePoint now) override
    {
        at(now).stop(now); // before anything else
        m_tap->onStop(now);
    }
    std::vector<Output> stopScript() const override { return m_inner->stopScript(); }
    bool stopOpen() const override { return m_inner->stopOpen(); }
    void arm() override { m_inner->arm(); }
    void disarm() override { m_inner->disarm(); }
    bool armed() const override { return m_inner->armed(); }
    Duration gathersFor() const override { return m_inner->gathersFor(); }
    void doubt(TimePoint now) override { at(now).doubt(now); }
    void remember(const drive::LineMemory &memory) override { m_inner->remember(memory); }
    drive::LineMemory memory() const override { return m_inner->memory(); }

private:
    Drive &at(TimePoint now)
    {
        m_now = now;
        return *m_inner;
    }

    std::unique_ptr<Drive> m_inner;
    std::shared_ptr<SessionTap> m_tap;
    TimePoint m_now{}; ///< of the last call: events come of it
};

} // namespace

Parts listened(const Parts &parts, const std::shared_ptr<SessionTap> &tap)
{
    Parts result = parts;
    result.transport = [parts, tap](const Endpoint &endpoint) -> std::unique_ptr<Transport> {
        auto inner = parts.transport(endpoint);
        if (!inner)
            return nullptr;
        return std::make_unique<TappedTransport>(std::move(inner), tap, parts.clock);
    };
    result.drive = [parts, tap](const Endpoint &endpoint) -> std::unique_ptr<drive::Drive> {
        return std::make_unique<TappedDrive>(parts.drive(endpoint), tap);
    };
    return result;
}

Parts tapped(const Parts &parts, const std::shared_ptr<RecordingTap> &tap)
{
    const auto sinceStart =
        std::chrono::floor<std::chrono::seconds>(parts.clock().time_since_epoch());
    tap->setStartSeconds(QDateTime::currentSecsSinceEpoch() - sinceStart.count());
    return listened(parts, tap);
}

} // namespace session

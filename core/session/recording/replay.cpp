#include "session/recording/replay.h"

#include "session/transports/recording_transport.h"

#include <QFileInfo>

namespace session {

namespace {

/// The drive and what watches over it live equally long.
class WatchedReplay : public recorded::ReplayDrive {
public:
    explicit WatchedReplay(std::shared_ptr<Replay> replay)
        : ReplayDrive(replay.get())
        , m_replay(std::move(replay))
    {
    }

private:
    std::shared_ptr<Replay> m_replay;
};

} // namespace

void Replay::begin(const QString &path)
{
    m_untaken = 0;
    m_seek = kNowhere;
    m_state = {};
    m_state.path = path;
    m_bytes = static_cast<double>(std::max<qint64>(1, QFileInfo(path).size()));
}

std::optional<std::uint64_t> Replay::takeSeek()
{
    const double fraction = m_seek.exchange(kNowhere);
    return fraction < 0.0
        ? std::nullopt
        : std::optional(static_cast<std::uint64_t>(std::min(fraction, 1.0) * m_bytes));
}

void Replay::told(recorded::Nanos at, const recorded::Entry &entry)
{
    Q_EMIT happened({capture::toSeconds(at), entry});
}

void Replay::progressed(const recorded::ReplayProgress &progress)
{
    m_state.seconds = capture::toSeconds(progress.position);
    m_state.fraction = progress.ended ? 1.0 : static_cast<double>(progress.bytes) / m_bytes;
    m_state.damagedPlaces = progress.damagedPlaces;
    m_state.ended = progress.ended;
    Q_EMIT advanced(m_state);
}

bool isReplay(const Endpoint &endpoint)
{
    return endpoint.kind == Endpoint::Kind::Trace && isRecordingFile(endpoint.path);
}

Parts replaying(const Parts &parts, const std::shared_ptr<Replay> &replay)
{
    Parts result = parts;
    result.drive = [parts, replay](const Endpoint &endpoint) -> std::unique_ptr<drive::Drive> {
        if (!isReplay(endpoint))
            return parts.drive(endpoint);
        replay->begin(endpoint.path);
        return std::make_unique<WatchedReplay>(replay);
    };
    return result;
}

} // namespace session

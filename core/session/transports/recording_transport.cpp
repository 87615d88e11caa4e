#include "session/transports/recording_transport.h"

#include <algorithm>

namespace session {

namespace {
constexpr qint64 kMostBytes = 1 << 24;
} // namespace

bool isRecordingFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.read(4) == QByteArray("\x0a\x0d\x0d\x0a", 4);
}

PortError RecordingTransport::open(TimePoint)
{
    if (m_file.open(QIODevice::ReadOnly))
        return {};
    return {
        m_file.exists() ? PortProblem::NoPermission : PortProblem::NotFound, m_file.errorString()};
}

void RecordingTransport::close()
{
    m_file.close();
    m_wanted = 0;
}

void RecordingTransport::write(ByteView bytes, TimePoint now)
{
    ByteReader reader(bytes);
    const std::uint32_t wanted = reader.u32();
    if (!reader.ok())
        return;
    const std::uint64_t place = reader.u64();
    if (reader.ok() && !m_file.seek(static_cast<qint64>(place)))
        return Q_EMIT failed({PortProblem::BadFile, m_file.errorString()});
    m_wanted = std::min<qint64>(wanted, kMostBytes);
    m_due = now;
}

void RecordingTransport::advance(TimePoint)
{
    if (m_wanted == 0)
        return;
    const QByteArray piece = m_file.read(std::exchange(m_wanted, 0));
    if (m_file.error() != QFileDevice::NoError)
        Q_EMIT failed({PortProblem::BadFile, m_file.errorString()});
    else
        Q_EMIT received(piece); // an empty one is the end
}

std::optional<TimePoint> RecordingTransport::nextWake() const
{
    return m_wanted == 0 ? std::nullopt : std::optional(m_due);
}

} // namespace session

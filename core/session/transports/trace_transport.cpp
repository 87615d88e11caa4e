#include "session/transports/trace_transport.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace session {

namespace {
constexpr qint64 kLongestLine = 1 << 20;
constexpr std::size_t kMostPackets = 10'000'000;
constexpr double kLatest_ms = 1e12;
} // namespace

Trace readTrace(const QString &path, const QString &direction)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {{},
            {file.exists() ? PortProblem::NoPermission : PortProblem::NotFound,
                file.errorString()}};
    Trace trace;
    while (!file.atEnd() && trace.packets.size() < kMostPackets) {
        const QJsonObject line = QJsonDocument::fromJson(file.readLine(kLongestLine)).object();
        if (line.value(QLatin1String("dir")).toString() != direction)
            continue;
        const double at_ms = line.value(QLatin1String("t_ms")).toDouble();
        if (!std::isfinite(at_ms) || at_ms < 0 || at_ms > kLatest_ms)
            continue;
        const QByteArray hex = line.value(QLatin1String("hex")).toString().toLatin1();
        trace.packets.push_back({fromSeconds(at_ms / 1e3), QByteArray::fromHex(hex)});
    }
    if (trace.packets.empty())
        return {{}, {PortProblem::BadFile, {}}};
    std::ranges::stable_sort(trace.packets, {}, &TracePacket::at);
    return trace;
}

TraceTransport::TraceTransport(const QString &path)
    : m_path(path)
{
}

PortError TraceTransport::open(TimePoint now)
{
    Trace trace = readTrace(m_path, QStringLiteral("P>C"));
    if (trace.error.problem != PortProblem::None)
        return trace.error;
    m_packets = std::move(trace.packets);
    m_next = 0;
    m_start = now;
    return {};
}

void TraceTransport::close()
{
    m_packets.clear();
    m_next = 0;
}

void TraceTransport::advance(TimePoint now)
{
    while (m_next < m_packets.size() && m_start + m_packets[m_next].at <= now)
        Q_EMIT received(m_packets[m_next++].bytes);
}

std::optional<TimePoint> TraceTransport::nextWake() const
{
    if (m_next >= m_packets.size())
        return std::nullopt;
    return m_start + m_packets[m_next].at;
}

} // namespace session

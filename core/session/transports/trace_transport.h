// TraceTransport: a recorded session played back at its own pace. Only what the board sent is
// played; what is written to it goes nowhere, ever.
//
// File: JSON Lines; objects with "dir" ("P>C": from the board), "hex" and "t_ms". Other lines are
// passed over.
#pragma once

#include "session/transports/transport.h"

#include <vector>

namespace session {

struct TracePacket {
    Duration at{}; ///< since the trace's beginning
    QByteArray bytes;
};

/// The packets of one direction, in order of time; a file without any is a problem.
/// @param direction  "P>C" or "C>P"
struct Trace {
    std::vector<TracePacket> packets;
    PortError error;
};
Trace readTrace(const QString &path, const QString &direction);

class TraceTransport : public Transport {
    Q_OBJECT
public:
    explicit TraceTransport(const QString &path);

    PortError open(TimePoint now) override;
    void close() override;
    void write(ByteView, TimePoint) override { }
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint now) override;
    std::optional<TimePoint> nextWake() const override;
    bool real() const override { return false; }

private:
    QString m_path;
    std::vector<TracePacket> m_packets;
    std::size_t m_next = 0;
    TimePoint m_start{};
};

} // namespace session

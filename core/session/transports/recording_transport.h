// RecordingTransport: the line of a ReplayDrive. It reads pieces of a recording as they are asked for, one each turn of
// the session, and writes nowhere.
#pragma once

#include "session/transports/transport.h"

#include <QFile>

namespace session {

class RecordingTransport : public Transport {
    Q_OBJECT
public:
    explicit RecordingTransport(const QString &path)
        : m_file(path)
    {
    }

    PortError open(TimePoint now) override;
    void close() override;
    /// A request: how many bytes, four bytes little-endian; eight more are the place in the file to go to first.
    /// Answered at the next advance().
    void write(ByteView bytes, TimePoint now) override;
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint now) override;
    std::optional<TimePoint> nextWake() const override;
    bool real() const override { return false; }

private:
    QFile m_file;
    qint64 m_wanted = 0; ///< bytes; 0: none
    TimePoint m_due{};
};

/// The file begins as a recording does.
bool isRecordingFile(const QString &path);

} // namespace session

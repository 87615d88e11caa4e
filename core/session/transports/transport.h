// A line to a board: bytes out, bytes in, and one error that ends it. Lives in the session's thread
// and has no timer and no clock of its own: the session calls advance() at nextWake().
#pragma once

#include "base/bytes.h"
#include "base/time.h"
#include "session/transports/endpoint.h"

#include <QObject>

#include <memory>
#include <optional>

namespace session {

class Transport : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Opens the line; a problem is returned, not signalled.
    virtual PortError open(TimePoint now) = 0;
    /// Closes it; harmless if it is closed. Nothing is signalled afterwards.
    virtual void close() = 0;
    /// Hands bytes to the line at once (no buffering on our side beyond this one call's bytes).
    virtual void write(ByteView bytes, TimePoint now) = 0;
    /// Drops what was written and has not left the line; nothing where it leaves within write().
    virtual void discardOutput() { }
    /// True when all that was written has left the line, as far as can be known.
    virtual bool sent(TimePoint now) const = 0;
    /// Lets a simulated board or a recorded trace go on until `now`; nothing to do for a real port.
    virtual void advance(TimePoint now) = 0;
    virtual std::optional<TimePoint> nextWake() const = 0;
    /// What comes may be told so much later, in one piece; zero: at once. A line that cannot gather does not.
    virtual void gather(Duration atMost, TimePoint now);
    /// Only real hardware deserves a red frame.
    virtual bool real() const = 0;
    /// What a guardian can send to when this program is gone; -1: nothing.
    virtual int descriptor() const { return -1; }

Q_SIGNALS:
    void received(const QByteArray &bytes);
    void failed(const session::PortError &error); ///< once; the line is closed already
    void readyChanged(bool high); ///< an edge of the board's ready line, where there is one
};

inline void Transport::gather(Duration, TimePoint) { }

std::unique_ptr<Transport> makeTransport(const Endpoint &endpoint);

} // namespace session

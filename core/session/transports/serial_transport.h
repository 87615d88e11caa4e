// SerialTransport: a real serial port, 8 data bits, no parity, 1 stop bit, no flow control. It
// holds the port alone (PortLock), writes at once, and closes itself at the first error: an
// unplugged QSerialPort would otherwise report the same error some hundred thousand times a second.
#pragma once

#include "session/transports/port_lock.h"
#include "session/transports/transport.h"

#include <QPointer>
#include <QSerialPort>
#include <QSocketNotifier>
#include <QTimer>

namespace session {

class SerialTransport : public Transport {
    Q_OBJECT
public:
    SerialTransport(const QString &path, std::uint32_t baud);
    ~SerialTransport() override;

    PortError open(TimePoint now) override;
    void close() override;
    void write(ByteView bytes, TimePoint now) override;
    void discardOutput() override;
    bool sent(TimePoint now) const override;
    void advance(TimePoint now) override;
    std::optional<TimePoint> nextWake() const override;
    void gather(Duration atMost, TimePoint now) override;
    bool real() const override { return true; }
    int descriptor() const override { return m_lock.descriptor(); }

private:
    PortError openError(const QString &path);
    void onReadyRead();
    void listen();
    void onError(QSerialPort::SerialPortError error);
    void fail(const QString &detail);

    QString m_path;
    std::uint32_t m_baud;
    PortLock m_lock;
    std::unique_ptr<QSerialPort> m_port;
    QPointer<QSocketNotifier> m_notifier; ///< of the port; none where it is woken by other means
    std::optional<TimePoint> m_listensAt; ///< it is switched off until then
    bool m_read = false; ///< since it was switched on
    std::optional<TimePoint> m_nextCheck;
    bool m_heard = false; ///< something was read since the last check
    bool m_ignored = false; ///< bytes are waiting since an earlier check
    QTimer m_chance; ///< not active: the event loop has come round since m_ignored
};

} // namespace session

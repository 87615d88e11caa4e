#include "session/transports/serial_transport.h"

#include <QFileInfo>

#include <algorithm>

namespace session {

namespace {

/// QSerialPort can miss that a device is gone, or stop listening for good: so the port is looked
/// at, this often.
constexpr Duration kCheckEvery = std::chrono::milliseconds(100);

/// Names such as COM3 are no files; everything that is one is named by its real path.
QString realPath(const QString &path)
{
    const QString canonical = QFileInfo(path).canonicalFilePath();
    return canonical.isEmpty() ? path : canonical;
}

} // namespace

SerialTransport::SerialTransport(const QString &path, std::uint32_t baud)
    : m_path(path)
    , m_baud(baud)
{
    m_chance.setSingleShot(true);
}

SerialTransport::~SerialTransport() { close(); }

PortError SerialTransport::open(TimePoint now)
{
    close();
    const QString path = realPath(m_path);
    if (PortError error = m_lock.acquire(path); error.problem != PortProblem::None)
        return error;
    m_port = std::make_unique<QSerialPort>();
    m_port->setPortName(path);
    m_port->setBaudRate(static_cast<qint32>(m_baud), QSerialPort::AllDirections);
    if (!m_port->open(QIODevice::ReadWrite)) {
        PortError error = openError(path);
        close();
        return error;
    }
    m_port->setDataBits(QSerialPort::Data8);
    m_port->setParity(QSerialPort::NoParity);
    m_port->setStopBits(QSerialPort::OneStop);
    m_port->setFlowControl(QSerialPort::NoFlowControl);
    askForLowLatency(qintptr(m_port->handle()));
    connect(m_port.get(), &QSerialPort::readyRead, this, &SerialTransport::onReadyRead);
    connect(m_port.get(), &QSerialPort::errorOccurred, this, &SerialTransport::onError);
    const auto notifiers = m_port->findChildren<QSocketNotifier *>();
    const auto reads = std::ranges::find_if(
        notifiers, [](const QSocketNotifier *one) { return one->type() == QSocketNotifier::Read; });
    m_notifier = reads == notifiers.end() ? nullptr : *reads;
    m_listensAt.reset();
    m_nextCheck = now + kCheckEvery;
    m_heard = false;
    m_ignored = false;
    return {};
}

PortError SerialTransport::openError(const QString &path)
{
    m_lock.release(); // or the error would name this program as the holder
    switch (m_port->error()) {
    case QSerialPort::DeviceNotFoundError:
        return {PortProblem::NotFound, m_port->errorString()};
    case QSerialPort::PermissionError:
        // The device itself could be opened, so it is another program's lock file or claim.
        return {PortProblem::Busy, portHolder(path)};
    case QSerialPort::UnsupportedOperationError:
        return {PortProblem::BadSpeed, m_port->errorString()};
    default:
        return {PortProblem::Other, m_port->errorString()};
    }
}

/// The port may be the sender of the signal that led here: it is closed now and deleted when the
/// event loop is back.
void SerialTransport::close()
{
    if (m_port) {
        m_port->disconnect(this);
        if (m_port->isOpen())
            m_port->close();
        m_port.release()->deleteLater();
    }
    m_lock.release();
    m_nextCheck.reset();
    m_listensAt.reset();
}

void SerialTransport::write(ByteView bytes, TimePoint)
{
    if (!m_port)
        return;
    m_port->write(reinterpret_cast<const char *>(bytes.data()), static_cast<qint64>(bytes.size()));
    // Without this, bytes wait for the event loop, and a header can leave together with its
    // payload.
    if (m_port)
        m_port->flush();
}

void SerialTransport::discardOutput()
{
    if (m_port && m_port->isOpen())
        m_port->clear(QSerialPort::Output);
}

bool SerialTransport::sent(TimePoint) const
{
    if (!m_port)
        return true;
    return m_port->bytesToWrite() == 0 && !checkPort(qintptr(m_port->handle())).outputWaiting;
}

/// A board that streams sends something each millisecond, and each time this thread is woken for it.
void SerialTransport::gather(Duration atMost, TimePoint now)
{
    if (atMost == Duration::zero()) {
        listen();
    } else if (m_listensAt) {
        m_listensAt = std::min(*m_listensAt, now + atMost);
    } else if (m_notifier && m_port && m_read) {
        m_listensAt = now + atMost;
        m_notifier->setEnabled(false);
    }
}

void SerialTransport::listen()
{
    if (!std::exchange(m_listensAt, std::nullopt))
        return;
    m_read = false;
    if (m_notifier)
        m_notifier->setEnabled(true);
}

void SerialTransport::advance(TimePoint now)
{
    if (m_listensAt && now >= *m_listensAt)
        listen();
    if (!m_nextCheck || now < *m_nextCheck)
        return;
    m_nextCheck = now + kCheckEvery;
    const PortHealth health = checkPort(qintptr(m_port->handle()));
    // On a busy machine calls can come twice in a row, with no look at the port between them: that is no deaf port.
    const bool ignored = health.inputWaiting && m_ignored && !m_heard;
    const bool deaf = ignored && !m_chance.isActive();
    if (health.inputWaiting && !ignored)
        m_chance.start(0);
    m_ignored = health.inputWaiting;
    m_heard = false;
    if (health.hungUp || deaf)
        fail({});
}

std::optional<TimePoint> SerialTransport::nextWake() const
{
    return m_nextCheck && m_listensAt ? std::min(m_nextCheck, m_listensAt) : m_nextCheck;
}

void SerialTransport::onReadyRead()
{
    m_heard = m_read = true;
    const QByteArray bytes = m_port->readAll();
    if (!bytes.isEmpty())
        Q_EMIT received(bytes);
}

void SerialTransport::onError(QSerialPort::SerialPortError error)
{
    if (error == QSerialPort::NoError || error == QSerialPort::TimeoutError
        || error == QSerialPort::UnsupportedOperationError || !m_port)
        return;
    fail(m_port->errorString());
}

void SerialTransport::fail(const QString &detail)
{
    close();
    Q_EMIT failed({PortProblem::Unplugged, detail});
}

} // namespace session

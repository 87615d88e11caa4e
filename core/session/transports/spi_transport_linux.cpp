// spidev for the frames, libgpiod 1.6 for the ready line.
#include "session/transports/port_lock.h"
#include "session/transports/spi_transport.h"

#include <QSocketNotifier>
#include <QTimer>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <unistd.h>
#ifdef ROTORSCOPE_GPIOD
#include <gpiod.h>
#endif

namespace session {

namespace {

/// Clock high when idle, data taken on the falling edge.
constexpr std::uint32_t kMode = SPI_MODE_2;
constexpr std::uint8_t kWordBits = 8; ///< what every driver can do
/// Without a ready line: how long a drive may take before the next frame. No source says it.
constexpr std::chrono::milliseconds kWithoutLine{1};

PortError lastError(const char *what)
{
    return {problemOf(errno),
        QStringLiteral("%1: %2").arg(
            QLatin1String(what), QString::fromLocal8Bit(std::strerror(errno)))};
}

#ifdef ROTORSCOPE_GPIOD
/// The ready line by its edges; a level read right behind a frame may be wrong.
class ReadyLine {
public:
    ReadyLine() = default;
    ReadyLine(const ReadyLine &) = delete;
    ReadyLine &operator=(const ReadyLine &) = delete;
    ~ReadyLine()
    {
        if (m_chip != nullptr)
            gpiod_chip_close(m_chip); // releases the line too
    }

    PortError open(const QString &chip, unsigned line)
    {
        m_chip = gpiod_chip_open_lookup(chip.toLocal8Bit().constData());
        if (m_chip == nullptr)
            return lastError("ready line");
        m_line = gpiod_chip_get_line(m_chip, line);
        if (m_line == nullptr || gpiod_line_request_both_edges_events(m_line, "rotorscope") != 0)
            return lastError("ready line");
        return {};
    }
    int descriptor() const { return gpiod_line_event_get_fd(m_line); }
    bool high() const { return gpiod_line_get_value(m_line) == 1; }
    /// The next edge that waits: whether it rises; nothing if none does.
    std::optional<bool> takeEdge()
    {
        constexpr timespec kAtOnce{0, 0};
        gpiod_line_event event{};
        if (gpiod_line_event_wait(m_line, &kAtOnce) != 1
            || gpiod_line_event_read(m_line, &event) != 0)
            return std::nullopt;
        return event.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
    }

private:
    gpiod_chip *m_chip = nullptr;
    gpiod_line *m_line = nullptr;
};
#else
/// Built without libgpiod: a ready line that is asked for cannot be had.
class ReadyLine {
public:
    PortError open(const QString &, unsigned)
    {
        return {
            PortProblem::Other, QStringLiteral("this build has no libgpiod for the ready line")};
    }
    int descriptor() const { return -1; }
    bool high() const { return false; }
    std::optional<bool> takeEdge() { return std::nullopt; }
};
#endif

class SpiTransport final : public Transport {
public:
    SpiTransport(SpiPort port, std::uint32_t clockHz)
        : m_port(std::move(port))
        , m_clockHz(clockHz)
    {
        m_pause.setSingleShot(true);
        connect(&m_pause, &QTimer::timeout, this, [this] { Q_EMIT readyChanged(true); });
    }
    ~SpiTransport() override { close(); }

    PortError open(TimePoint now) override;
    void close() override;
    void write(ByteView bytes, TimePoint now) override;
    bool sent(TimePoint) const override { return true; } // a transfer ends before write() does
    void advance(TimePoint) override;
    std::optional<TimePoint> nextWake() const override { return std::nullopt; }
    bool real() const override { return true; }
    int descriptor() const override { return m_device; }

private:
    PortError configure();
    void takeEdges();
    void fail();

    SpiPort m_port;
    std::uint32_t m_clockHz;
    PortLock m_lock;
    int m_device = -1;
    std::unique_ptr<ReadyLine> m_line;
    std::unique_ptr<QSocketNotifier> m_edges;
    QTimer m_pause;
    bool m_first = true; ///< the level was not told yet
};

PortError SpiTransport::open(TimePoint)
{
    close();
    if (PortError error = m_lock.acquire(m_port.device); error.problem != PortProblem::None)
        return error;
    m_device = ::open(m_port.device.toLocal8Bit().constData(), O_RDWR | O_CLOEXEC);
    PortError error = m_device < 0 ? lastError("SPI device") : configure();
    if (error.problem == PortProblem::None && !m_port.chip.isEmpty()) {
        m_line = std::make_unique<ReadyLine>();
        error = m_line->open(m_port.chip, m_port.line);
    }
    if (error.problem != PortProblem::None) {
        close();
        return error;
    }
    if (m_line) {
        m_edges = std::make_unique<QSocketNotifier>(m_line->descriptor(), QSocketNotifier::Read);
        connect(m_edges.get(), &QSocketNotifier::activated, this, &SpiTransport::takeEdges);
    }
    m_first = true;
    return {};
}

PortError SpiTransport::configure()
{
    const std::uint32_t mode = kMode;
    const std::uint8_t bits = kWordBits;
    if (ioctl(m_device, SPI_IOC_WR_MODE32, &mode) < 0
        || ioctl(m_device, SPI_IOC_WR_BITS_PER_WORD, &bits) < 0
        || ioctl(m_device, SPI_IOC_WR_MAX_SPEED_HZ, &m_clockHz) < 0)
        return lastError("SPI settings");
    return {};
}

void SpiTransport::close()
{
    m_pause.stop();
    m_edges.reset();
    m_line.reset();
    if (m_device >= 0)
        ::close(m_device);
    m_device = -1;
    m_lock.release();
}

/// The level at the beginning; from then on edges tell.
void SpiTransport::advance(TimePoint)
{
    if (m_device < 0 || !std::exchange(m_first, false))
        return;
    Q_EMIT readyChanged(m_line ? m_line->high() : true);
}

void SpiTransport::takeEdges()
{
    while (m_line) {
        const auto rises = m_line->takeEdge();
        if (!rises)
            return;
        Q_EMIT readyChanged(*rises);
    }
}

void SpiTransport::write(ByteView bytes, TimePoint)
{
    if (m_device < 0 || bytes.empty())
        return;
    while (m_line && m_line->takeEdge()) { } // of before this frame
    Bytes received(bytes.size());
    spi_ioc_transfer transfer{};
    transfer.tx_buf = reinterpret_cast<std::uintptr_t>(bytes.data());
    transfer.rx_buf = reinterpret_cast<std::uintptr_t>(received.data());
    transfer.len = static_cast<std::uint32_t>(bytes.size());
    transfer.speed_hz = m_clockHz;
    transfer.bits_per_word = kWordBits;
    if (ioctl(m_device, SPI_IOC_MESSAGE(1), &transfer) < 0)
        return fail();
    if (!m_line)
        m_pause.start(kWithoutLine);
    Q_EMIT this->received(QByteArray(
        reinterpret_cast<const char *>(received.data()), static_cast<qsizetype>(received.size())));
}

/// Whatever the system calls it: the drive is lost, and the session tries to open the port again.
void SpiTransport::fail()
{
    const PortError error = lastError("SPI transfer");
    close();
    Q_EMIT failed({PortProblem::Unplugged, error.detail});
}

} // namespace

std::unique_ptr<Transport> makeSpiTransport(const QString &path, std::uint32_t clockHz)
{
    auto port = spiPortOf(path);
    if (!port)
        return nullptr;
    return std::make_unique<SpiTransport>(std::move(*port), clockHz);
}

} // namespace session

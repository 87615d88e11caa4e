#include "session/link/stop_page_posix.h"

#include "session/link/guardian.h"

#include <cerrno>
#include <ctime>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>
#ifdef __linux__
#include <linux/spi/spidev.h>
#endif

namespace session {

Nanoseconds monotonicNow()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * kSecond + time.tv_nsec;
}

void pauseFor(Nanoseconds time)
{
    timespec left{time / kSecond, time % kSecond};
    while (::nanosleep(&left, &left) != 0 && errno == EINTR) { }
}

namespace {

constexpr int kRoom_ms = 20; ///< for a line that takes no more bytes

StopScript copyOf(const StopPage &page)
{
    for (;;) {
        const std::uint32_t before = page.scripts.load(std::memory_order_acquire);
        const StopScript copy = page.script[before & 1U];
        std::atomic_thread_fence(std::memory_order_acquire);
        if (page.scripts.load(std::memory_order_relaxed) == before)
            return copy;
    }
}

void sendTo(int port, const std::uint8_t *bytes, std::size_t size)
{
#ifdef __linux__
    if (::isatty(port) == 0) { // an SPI bus: speed and mode are those of the device
        std::array<std::uint8_t, kMostBytes> answer{};
        spi_ioc_transfer transfer{};
        transfer.tx_buf = reinterpret_cast<std::uintptr_t>(bytes);
        transfer.rx_buf = reinterpret_cast<std::uintptr_t>(answer.data());
        transfer.len = static_cast<std::uint32_t>(size);
        ::ioctl(port, SPI_IOC_MESSAGE(1), &transfer);
        return;
    }
#endif
    while (size > 0) {
        const ssize_t count = ::write(port, bytes, size);
        if (count > 0) {
            bytes += count;
            size -= static_cast<std::size_t>(count);
            continue;
        }
        pollfd room{port, POLLOUT, {}};
        if (count == 0 || (errno != EAGAIN && errno != EINTR) || ::poll(&room, 1, kRoom_ms) <= 0)
            return; // the next repetition tries again
    }
}

} // namespace

void stopMotors(const StopPage &page, int port, int repetitions)
{
    const StopScript script = copyOf(page);
    ::tcflush(port, TCOFLUSH);
    for (int i = 0; i < repetitions; ++i) {
        const Nanoseconds next = monotonicNow() + Guardian::kRepeat / std::chrono::nanoseconds(1);
        const std::uint8_t *bytes = script.bytes.data();
        for (std::uint32_t part = 0; part < script.parts; ++part) {
            pauseFor(Nanoseconds{script.part[part].pause_us} * 1000);
            sendTo(port, bytes, script.part[part].size);
            bytes += script.part[part].size;
        }
        pauseFor(next - monotonicNow());
    }
}

} // namespace session

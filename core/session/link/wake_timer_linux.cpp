// By a timer of the kernel as a file descriptor.
#include "session/link/wake_timer.h"

#include <QSocketNotifier>

#include <algorithm>
#include <ctime>
#include <sys/timerfd.h>
#include <unistd.h>

namespace session {

namespace {

int openTimer() { return timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC); }

/// @param wait  zero: never
bool setTimer(int descriptor, Duration wait)
{
    using std::chrono::seconds;
    itimerspec when{};
    when.it_value.tv_sec = std::chrono::duration_cast<seconds>(wait).count();
    when.it_value.tv_nsec = (wait % seconds(1)).count();
    return timerfd_settime(descriptor, 0, &when, nullptr) == 0;
}

bool hasFired(int descriptor)
{
    quint64 times = 0;
    return ::read(descriptor, &times, sizeof times) == sizeof times;
}

} // namespace

TimePoint elapsedTime()
{
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now); // CLOCK_MONOTONIC stands still during a suspend
    return TimePoint(std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec));
}

WakeTimer::WakeTimer(QObject *parent)
    : QObject(parent)
    , m_coarse(this)
    , m_descriptor(openTimer())
{
    makeCoarse();
}

WakeTimer::~WakeTimer()
{
    delete m_notifier; // before what it looks at is closed
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

void WakeTimer::start(Duration wait)
{
    if (m_descriptor >= 0 && m_notifier == nullptr) { // not before it is known in which thread
        m_notifier = new QSocketNotifier(m_descriptor, QSocketNotifier::Read, this);
        connect(m_notifier, &QSocketNotifier::activated, this, [this] {
            if (hasFired(m_descriptor))
                Q_EMIT due();
        });
    }
    constexpr Duration kLeast{1};
    if (m_descriptor < 0 || !setTimer(m_descriptor, std::max(wait, kLeast)))
        startCoarse(wait);
}

void WakeTimer::stop()
{
    m_coarse.stop();
    if (m_descriptor >= 0)
        setTimer(m_descriptor, Duration::zero());
}

} // namespace session

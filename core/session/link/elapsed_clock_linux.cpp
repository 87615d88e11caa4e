#include "session/link/elapsed_clock.h"

#include <ctime>

namespace session {

TimePoint elapsedTime()
{
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now); // CLOCK_MONOTONIC stands still during a suspend
    return TimePoint(std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec));
}

} // namespace session

// Elsewhere the steady clock has to do; a sleep that it does not count is seen as soon as a timer comes late.
#include "session/link/elapsed_clock.h"

namespace session {

TimePoint elapsedTime()
{
    return TimePoint(
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

} // namespace session

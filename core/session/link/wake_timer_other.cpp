#include "session/link/wake_timer.h"

namespace session {

/// The steady clock has to do; a sleep that it does not count is seen as soon as a timer comes late.
TimePoint elapsedTime()
{
    return TimePoint(
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

WakeTimer::WakeTimer(QObject *parent)
    : QObject(parent)
    , m_coarse(this)
{
    makeCoarse();
}

WakeTimer::~WakeTimer() = default;

void WakeTimer::start(Duration wait) { startCoarse(wait); }

void WakeTimer::stop() { m_coarse.stop(); }

} // namespace session

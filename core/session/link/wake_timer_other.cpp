#include "session/link/wake_timer.h"

namespace session {

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

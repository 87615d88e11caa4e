#include "session/link/wake_timer.h"

#include <algorithm>

namespace session {

void WakeTimer::makeCoarse()
{
    m_coarse.setSingleShot(true);
    m_coarse.setTimerType(Qt::PreciseTimer);
    connect(&m_coarse, &QTimer::timeout, this, &WakeTimer::due);
}

void WakeTimer::startCoarse(Duration wait)
{
    using std::chrono::milliseconds;
    m_coarse.start(std::max(std::chrono::ceil<milliseconds>(wait), milliseconds(1)));
}

} // namespace session

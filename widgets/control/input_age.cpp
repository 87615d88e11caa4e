#include "widgets/control/input_age.h"

#include "drive/wish.h"

#include <algorithm>

namespace widgets {

void InputAge::lookForFreeze(TimePoint now)
{
    if (!m_beat || now - *m_beat <= drive::kWishExpiresAfter)
        return;
    m_freeze = now - *m_beat;
    m_punctual = 0;
}

void InputAge::beat(TimePoint now)
{
    const bool late = m_beat && now - *m_beat > drive::kWishExpiresAfter;
    lookForFreeze(now);
    m_beat = now;
    if (!late && ++m_punctual >= kPunctualBeats)
        m_freeze = {};
}

void InputAge::note(std::uint64_t stamp, TimePoint now)
{
    lookForFreeze(now);
    m_delay = std::max(m_freeze, stamp == 0 ? Duration::zero() : lateness(stamp, now));
}

Duration InputAge::lateness(std::uint64_t stamp, TimePoint now)
{
    // X11 counts in 32 bits, which are over after 49.7 days.
    const auto low = static_cast<std::uint32_t>(stamp);
    const auto step = static_cast<std::int32_t>(low - m_stamp.value_or(low));
    m_stamp = low;
    m_stampTime += std::chrono::milliseconds(step);
    const Duration distance = now.time_since_epoch() - m_stampTime;

    const Duration apart = distance - m_distance;
    if (m_agree == 0 || apart > kAgree || apart < -kAgree) {
        m_distance = distance;
        m_agreeSince = now;
        m_agree = 1;
    } else if (++m_agree >= kAgreements && now - m_agreeSince >= kAgreeFor) {
        m_least = m_distance;
    }
    if (!m_least)
        return Duration::zero();
    m_least = std::min(*m_least, distance); // the least delayed is the nearest to the truth
    return distance - *m_least;
}

} // namespace widgets

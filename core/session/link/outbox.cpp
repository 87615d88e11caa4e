#include "session/link/outbox.h"

#include <algorithm>
#include <utility>

namespace session {

namespace {
/// How soon to ask a port again that is slower than its baud rate.
constexpr Duration kAskAgainAfter = std::chrono::microseconds(500);
} // namespace

void Outbox::add(std::vector<Output> outputs)
{
    for (Output &output : outputs) {
        if (output.dropsEarlier) {
            m_waiting.clear();
            m_dropInPort = true;
        }
        if (!output.bytes.empty())
            m_waiting.push_back(std::move(output));
    }
}

void Outbox::pump(
    Transport &transport, const Clock &clock, const std::function<void(ByteView, TimePoint)> &told)
{
    TimePoint now = clock();
    m_askAgain.reset();
    if (std::exchange(m_dropInPort, false)) {
        transport.discardOutput();
        m_lineFree = std::min(m_lineFree, now);
    }
    while (!m_waiting.empty()) {
        const Duration gap = m_waiting.front().gapBefore;
        if (gap > Duration::zero() && m_lineFree > TimePoint{}) {
            if (now < m_lineFree + gap)
                return;
            if (!transport.sent(now)) {
                // The bytes before are still in the port: the rest begins when they have left.
                m_lineFree = now;
                m_askAgain = now + kAskAgainAfter;
                return;
            }
        }
        // Taken out first: a line that answers within write() can lead to an add() that drops what waits.
        const Bytes bytes = std::move(m_waiting.front().bytes);
        m_waiting.pop_front();
        told(bytes, now);
        transport.write(bytes, now);
        now = clock();
        m_lineFree = std::max(now, m_lineFree) + wireTime(bytes.size(), m_baud);
        m_unreported = true;
    }
}

bool Outbox::allSent(const Transport &transport, TimePoint now)
{
    if (!m_unreported || !m_waiting.empty() || now < m_lineFree)
        return false;
    if (!transport.sent(now)) {
        m_askAgain = now + kAskAgainAfter;
        return false;
    }
    m_unreported = false;
    return true;
}

std::optional<TimePoint> Outbox::nextDue(Duration patience) const
{
    if (m_askAgain)
        return m_askAgain;
    if (!m_waiting.empty())
        return m_lineFree + m_waiting.front().gapBefore;
    if (m_unreported)
        return m_lineFree + patience;
    return std::nullopt;
}

} // namespace session

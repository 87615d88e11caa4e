// What is offered to a Performer, and what was agreed on: values only, no times. Boards only ever shrink what is
// offered, and one that streams keeps to the sizes of its first agreement, whatever came after.
#pragma once

#include "aspep/framer.h"
#include "aspep/packet.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace aspep {

class Negotiation {
public:
    explicit Negotiation(const Beacon &maxima)
        : m_maxima(maxima)
    {
    }

    void remember(const Beacon &agreed)
    {
        if (m_concluded)
            return;
        m_agreed = agreed;
        m_remembered = true;
    }
    void startOver() { m_offer = m_maxima; }
    void offer(const Beacon &instead) { m_offer = instead; }
    /// What was offered is agreed on.
    void conclude()
    {
        m_agreed = m_offer;
        m_concluded = true;
        m_limits.response = std::max(m_limits.response, m_agreed.txSyncMax());
        m_limits.async = std::max(m_limits.async, m_agreed.txAsyncMax());
        m_limits.dataCrc = m_agreed.dataCrc;
    }

    bool concluded() const { return m_concluded; } ///< once at least
    const Beacon &agreed() const { return m_agreed; }
    std::optional<Beacon> known() const ///< what was agreed on, by this machine or before it
    {
        return m_concluded || m_remembered ? std::optional(m_agreed) : std::nullopt;
    }
    const Beacon &offered() const { return m_offer; }
    /// The offer as it goes out without an answer. A board that goes on with an agreement leaves the connection for any
    /// offer beyond it, and then swallows requests.
    const Beacon &blindOffer() const { return known() && m_offer == m_maxima ? m_agreed : m_offer; }
    /// A board can answer the offer with this: it takes the minimum of both sides.
    bool allows(const Beacon &answer) const
    {
        return answer.dataCrc <= m_offer.dataCrc && answer.rxUnits <= m_offer.rxUnits
            && answer.txSyncUnits <= m_offer.txSyncUnits
            && answer.txAsyncUnits <= m_offer.txAsyncUnits;
    }

    const Framer::Limits &limits() const { return m_limits; } ///< of all agreements
    std::size_t longestAsync() const { return m_concluded ? m_agreed.txAsyncMax() : kMaxPayload; }
    /// With a packet of the stream ahead of it.
    std::size_t longestReply() const
    {
        constexpr std::size_t kUsualAsync = 2048;
        constexpr std::size_t kUsualResponse = 256;
        return m_concluded ? m_limits.async + m_limits.response : kUsualAsync + kUsualResponse;
    }

private:
    Beacon m_maxima, m_offer, m_agreed;
    Framer::Limits m_limits{0, 0, false};
    bool m_concluded = false;
    bool m_remembered = false; ///< m_agreed was told by remember()
};

} // namespace aspep

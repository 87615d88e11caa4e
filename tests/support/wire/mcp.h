// Takes apart what goes to a board of MCP over ASPEP, by the text of the protocol alone: nothing of the product's codec
// is in here. Lengths and numbers: mcp-aspep, sections 1, 2.1 and 4.
#pragma once

#include "support/ms_rules.h"

namespace judge {

class WireMcp : public Decoder {
public:
    /// @param baud  the pause between header and payload is counted on the wire
    WireMcp(std::uint32_t baud, double ampsPerDigit)
        : m_baud(baud)
        , m_ampsPerDigit(ampsPerDigit)
    {
    }

    void reset() override;
    std::vector<Sent> sent(ByteView bytes, TimePoint at) override;
    bool heard(ByteView bytes) override;
    bool midPacket() const override { return m_wanted > 0 || !m_header.empty(); }
    std::optional<Duration> takeGap() override { return std::exchange(m_gap, std::nullopt); }

    /// The four bits over the other 28: x^4 + x^2 + x + 1, lowest nibble first.
    static unsigned checkOf(std::uint32_t header);

private:
    void header(std::vector<Sent> &all, TimePoint at);
    std::vector<Sent> request() const;
    std::vector<Sent> reads() const;
    std::vector<Sent> writes() const;
    Sent writeOf(std::uint16_t id, ByteView value) const;

    std::uint32_t m_baud;
    double m_ampsPerDigit;
    Bytes m_header, m_payload;
    std::size_t m_wanted = 0; ///< of the payload
    TimePoint m_headerEnd{};
    std::optional<Duration> m_gap;
    Bytes m_tail; ///< of what was heard: a header may be in two pieces
};

} // namespace judge

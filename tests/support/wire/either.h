// Takes apart what a drive sends that looks for the protocol of its board: a header of ASPEP is told from a frame of
// the older protocol by its length and its check bits, as a board would tell them.
#pragma once

#include "aspep/packet.h"
#include "support/wire/fcp.h"
#include "support/wire/mcp.h"

namespace judge {

class WireEither final : public Decoder {
public:
    void reset() override
    {
        m_newer.reset();
        m_older.reset();
    }
    std::vector<Sent> sent(ByteView bytes, TimePoint at) override
    {
        const bool header = bytes.size() == aspep::kHeaderSize && !m_older.midPacket()
            && aspep::decodeHeader({bytes[0], bytes[1], bytes[2], bytes[3]}).has_value();
        return m_newer.midPacket() || header ? m_newer.sent(bytes, at) : m_older.sent(bytes, at);
    }
    bool heard(ByteView bytes) override
    {
        const bool newer = m_newer.heard(bytes);
        return m_older.heard(bytes) || newer;
    }
    bool midPacket() const override { return m_newer.midPacket() || m_older.midPacket(); }

private:
    WireMcp m_newer{115200, 0.0};
    WireFcp m_older;
};

} // namespace judge

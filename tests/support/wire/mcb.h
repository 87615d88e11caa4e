// Takes apart frames of MCB, by the text of the protocol alone. Each output is one frame. Registers are numbered as
// address << 3 | 1: there is one motor.
#pragma once

#include "support/ms_rules.h"

#include <array>

namespace judge {

class WireMcb : public Decoder {
public:
    void reset() override { m_rx.clear(); }
    std::vector<Sent> sent(ByteView bytes, TimePoint at) override;
    bool heard(ByteView bytes) override { return !bytes.empty(); }
    bool midPacket() const override { return false; }

    static unsigned checkOf(ByteView bytes); ///< x^16 + x^12 + x^5 + 1, from 0

private:
    Sent write(unsigned address, const std::array<unsigned, 4> &words);

    bool m_continues = false; ///< a value in fragments is under way
    std::map<unsigned, unsigned>
        m_rx; ///< bytes of set-points that travel in each frame, by address
};

} // namespace judge

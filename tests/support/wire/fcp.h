// Takes apart what goes to a board of the older serial protocol, in both its dialects, by the text of the protocol
// alone. Frames and numbers: mcp-legacy, sections 1 to 3. Registers are numbered as number << 3 | motor.
#pragma once

#include "support/ms_rules.h"

namespace judge {

class WireFcp : public Decoder {
public:
    void reset() override { m_frame.clear(); }
    std::vector<Sent> sent(ByteView bytes, TimePoint at) override;
    bool heard(ByteView bytes) override { return !bytes.empty(); }
    bool midPacket() const override { return !m_frame.empty(); }

    /// For currents in physical units; 0: not known.
    void setScale(double ampsPerDigit) { m_ampsPerDigit = ampsPerDigit; }

private:
    std::vector<Sent> frame() const;
    Sent command(Sent one, unsigned number) const;
    Sent write(Sent one) const;

    Bytes m_frame;
    double m_ampsPerDigit = 0.0;
};

} // namespace judge

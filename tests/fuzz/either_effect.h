// What the outputs of a drive do that looks for the protocol of its board.
#pragma once

#include "fuzz/legacy_peer.h"
#include "fuzz/mcp_peer.h"

namespace fuzz {

/// It changes the language: a header of ASPEP is told from a frame of the older protocol by its CRC and length alone, as a
/// board would tell them.
class EitherEffect {
public:
    Effect operator()(ByteView output)
    {
        const bool header = output.size() == aspep::kHeaderSize
            && aspep::decodeHeader({output[0], output[1], output[2], output[3]}).has_value();
        if (m_payloadNext || header) {
            m_payloadNext = header && !m_payloadNext && (output[0] & 0x0FU) == 9;
            return m_newer(output);
        }
        return legacyEffect(output);
    }

private:
    McpEffects m_newer;
    bool m_payloadNext = false;
};

} // namespace fuzz

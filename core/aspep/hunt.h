// Where the packets of a stream begin again behind a lost or a spoilt byte. One header is no proof: its CRC-4 lets one
// noisy word in sixteen pass. Two async packets in a row are, that are as long and end as the stream's packets do (mark
// and id); a response or an answer of the dialogue may stand between them. What is proved is handed back whole, so that
// only the spoilt packet is lost.
#pragma once

#include "aspep/packet.h"
#include "base/bytes.h"

#include <array>
#include <cstdint>
#include <optional>

namespace aspep {

class Hunt {
public:
    /// Looks at a good packet in step: two alike in a row are what a stream looks like.
    void learn(const Data &data, ByteView payload);
    /// Out of step, with what was wrong. What ended the packet before may be the beginning of the next.
    void begin(ByteView wrong);
    /// Behind a packet without a payload nothing is to be gone back to.
    void passed() { m_tailSize = 0; }
    void end() { m_bytes.clear(); }

    /// Takes what came. @return  whether packets are proved: then take() has them, and all behind them
    bool proves(ByteView bytes, std::size_t longestResponse, std::size_t crcSize);
    Bytes take();
    /// Of what take() gave, how many bytes have been part of a packet already.
    std::size_t reused() const { return m_reused; }

private:
    /// Enough to go back for bytes that were lost, and no more than a header and a little.
    static constexpr std::size_t kTail = 8;
    /// Far more than two packets of a stream and what a board answers between them.
    static constexpr std::size_t kMost = 32768;
    using End = std::array<std::uint8_t, 2>;
    struct Look {
        std::uint16_t length = 0;
        End end{};
        bool operator==(const Look &) const = default;
    };
    enum class Verdict : std::uint8_t { No, Open, Proved };
    Verdict judge(std::size_t at, std::size_t longestResponse, std::size_t crcSize) const;
    bool fits(ByteView payload) const;

    std::optional<Look> m_last, m_stream; ///< of the last packet; what two in a row had
    std::array<std::uint8_t, kTail> m_tail{};
    std::size_t m_tailSize = 0;
    Bytes m_bytes;
    std::size_t m_old = 0; ///< bytes at the front that belonged to the packet before
    std::size_t m_reused = 0;
};

} // namespace aspep

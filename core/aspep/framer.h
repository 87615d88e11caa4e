// Bytes from a Performer to packets. In step until something is bad; then it says what was bad and
// discards all that follows, until the owner has brought the line to rest and calls
// resynchronise(), or two packets of the stream in a row prove where packets begin (hunt.h). It
// never believes a header alone: its CRC-4 lets one noisy word in sixteen pass, and a false length
// swallows what follows it.
#pragma once

#include "aspep/hunt.h"
#include "aspep/packet.h"

#include <cstdint>

namespace aspep {

class Framer {
public:
    /// What has been negotiated. Longer packets are refused before a byte of them is stored.
    struct Limits {
        std::size_t response = kMaxPayload;
        std::size_t async = kMaxPayload;
        bool dataCrc = false; ///< two bytes follow each payload
    };
    enum class Step : std::uint8_t {
        NeedBytes, ///< everything is consumed
        Packet, ///< one packet is in `packet`; there may be more
        BadHeaderCrc,
        UnknownType,
        Inconsistent,
        TooLong,
        BadPayloadCrc,
    };

    void setLimits(const Limits &limits) { m_limits = limits; }

    /// Consumes from the front of `bytes` up to the end of one packet, or all of it.
    /// Cost: the payload is copied once; no allocation if the same `packet` is brought each time.
    Step next(ByteView &bytes, Packet &packet);

    /// In step again: the next byte is the first of a header. A packet that was under way is
    /// dropped.
    void resynchronise();
    bool inStep() const { return m_inStep; }

    bool inPayload() const { return m_inStep && m_inPayload; } ///< behind a good header
    bool midPacket() const { return m_inStep && (m_headerSize > 0 || m_inPayload); }
    /// Bytes that the packet under way still needs; of a header that is not whole, those of the
    /// header.
    std::size_t missing() const;
    /// Out of step: what a line analyser that looks for headers in the discarded bytes would still wait
    /// for. Until it has come, or the line was silent for long, he takes our dialogue for a payload.
    std::size_t missingToScanner() const { return m_scanSkip; }
    std::uint64_t discardedBytes() const { return m_discarded; }

private:
    Step parse(ByteView &bytes, Packet &packet);
    void hunt(ByteView bytes);
    Step startPacket();
    Step finishPayload(Packet &packet);
    Step bad(Step what);
    bool acceptPayload(ByteView &bytes);
    bool tooLong(const Data &data) const;
    void scan(ByteView bytes);

    Limits m_limits;
    bool m_inStep = true;
    bool m_inPayload = false;
    bool m_crcFollows = false; ///< behind the payload under way
    HeaderBytes m_headerBytes{};
    std::size_t m_headerSize = 0;
    Header m_header;
    Bytes m_payload;
    std::size_t m_payloadSize = 0; ///< with its CRC
    std::uint64_t m_discarded = 0;
    Hunt m_hunt;
    Bytes m_proved; ///< what it gave back, to be parsed before what comes
    std::size_t m_provedAt = 0; ///< so far
    HeaderBytes m_scanWindow{};
    std::size_t m_scanSize = 0; ///< bytes in the window
    std::size_t m_scanSkip = 0; ///< bytes to the end of what looked like a packet
};

} // namespace aspep

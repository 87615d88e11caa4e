// Frames of the older serial protocol, and bytes to frames, for either end of the line.
//
// Wire layout: header | number of payload bytes, 0..127 | payload | checksum. The checksum adds the two bytes of the
// 16-bit sum of all that comes before it; a carry of that addition is lost.
// Source: firmware 5.4.3; the printed text allows 128 bytes, firmware drops such frames without an answer.
#pragma once

#include "base/bytes.h"
#include "fcp/protocol.h"

#include <array>

namespace fcp {

constexpr std::size_t kMaxPayload = 127;
constexpr std::size_t kFrameOverhead = 3; ///< header, length, checksum

struct Frame {
    std::uint8_t header = 0;
    Bytes payload;
    bool operator==(const Frame &) const = default;
};

/// Of header, length and payload. Exact for any length that a frame can have.
std::uint8_t checksumOf(ByteView bytes);

/// The bytes for the wire; empty if the payload is longer than kMaxPayload.
Bytes encodeFrame(std::uint8_t header, ByteView payload);

/// There is no start mark, so it never searches for one: bytes are taken in order. A caller that finds a bad frame
/// calls reset() when the line has been brought to rest.
class Framer {
public:
    /// What may stand in the first byte.
    enum class Side : std::uint8_t {
        Board, ///< any header: requests
        Client, ///< ACK, NACK and start notice only: answers
    };
    enum class Step : std::uint8_t {
        NeedBytes, ///< everything is consumed
        Frame, ///< one frame is in `frame`; there may be more
        BadChecksum, ///< the frame as it came is in `frame`
        TooLong, ///< the length byte is 128 or more; the next byte is taken for a header, as firmware does
        UnknownHeader, ///< Side::Client only; the byte was consumed
    };

    explicit Framer(Side side)
        : m_side(side)
    {
    }

    /// Consumes from the front of `bytes` up to the end of one frame, or all of it. Never stores more than a frame has.
    Step next(ByteView &bytes, Frame &frame);

    /// The next byte is a header. A frame that was under way is dropped.
    void reset() { m_size = 0; }
    bool midFrame() const { return m_size > 0; }
    /// Bytes that the frame under way still needs, as far as is known.
    std::size_t missing() const { return m_size == 0 ? 0 : wanted() - m_size; }
    /// Payload bytes of the frame under way that have come.
    ByteView partialPayload() const;

private:
    Step acceptByte(std::uint8_t byte, Frame &frame);
    std::size_t wanted() const; ///< bytes of the whole frame; two while the length is unknown

    Side m_side;
    std::array<std::uint8_t, kMaxPayload + kFrameOverhead> m_bytes{};
    std::size_t m_size = 0;
};

} // namespace fcp

// Bytes to frames, for either end of the line. There is no start mark, so it never searches for one: bytes are taken in
// order, and who finds something bad calls reset() when the line has been brought to rest.
#pragma once

#include "legacy/frame.h"
#include "legacy/protocol.h"

#include <array>

namespace legacy {

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
    void reset();
    bool midFrame() const { return m_size > 0; }
    /// Bytes that the frame under way still needs, as far as is known.
    std::size_t missing() const;
    /// Payload bytes of the frame under way that have come.
    ByteView partialPayload() const;

private:
    Step takeByte(std::uint8_t byte, Frame &frame);
    std::size_t wanted() const; ///< bytes of the whole frame; two while the length is unknown

    Side m_side;
    std::array<std::uint8_t, kMaxPayload + kFrameOverhead> m_bytes{};
    std::size_t m_size = 0;
};

} // namespace legacy

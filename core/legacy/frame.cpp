#include "legacy/frame.h"

#include <numeric>

namespace legacy {

std::uint8_t checksumOf(ByteView bytes)
{
    const unsigned sum = std::accumulate(bytes.begin(), bytes.end(), 0U);
    return static_cast<std::uint8_t>((sum >> 8) + (sum & 0xFFU));
}

Bytes encodeFrame(std::uint8_t header, ByteView payload)
{
    if (payload.size() > kMaxPayload)
        return {};
    Bytes frame;
    frame.reserve(payload.size() + kFrameOverhead);
    frame.push_back(header);
    frame.push_back(static_cast<std::uint8_t>(payload.size()));
    frame.insert(frame.end(), payload.begin(), payload.end());
    frame.push_back(checksumOf(frame));
    return frame;
}

} // namespace legacy

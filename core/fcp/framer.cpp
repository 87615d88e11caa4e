#include "fcp/framer.h"

#include <algorithm>
#include <numeric>

namespace fcp {

Framer::Step Framer::next(ByteView &bytes, Frame &frame)
{
    while (!bytes.empty()) {
        const std::uint8_t byte = bytes.front();
        bytes = bytes.subspan(1);
        if (const Step step = acceptByte(byte, frame); step != Step::NeedBytes)
            return step;
    }
    return Step::NeedBytes;
}

Framer::Step Framer::acceptByte(std::uint8_t byte, Frame &frame)
{
    if (m_size == 0 && m_side == Side::Client && byte != kAckHeader && byte != kNackHeader
        && byte != kStartNoticeHeader)
        return Step::UnknownHeader;
    m_bytes[m_size++] = byte;
    if (m_size == 2 && byte > kMaxPayload) {
        m_size = 0;
        return Step::TooLong;
    }
    if (m_size < 2 || m_size < wanted())
        return Step::NeedBytes;
    const ByteView whole = ByteView(m_bytes).first(m_size);
    const ByteView payload = whole.subspan(2, whole.size() - kFrameOverhead);
    frame.header = whole[0];
    frame.payload.assign(payload.begin(), payload.end());
    m_size = 0;
    return checksumOf(whole.first(whole.size() - 1)) == whole.back() ? Step::Frame
                                                                     : Step::BadChecksum;
}

std::size_t Framer::wanted() const { return m_size < 2 ? 2 : m_bytes[1] + kFrameOverhead; }

ByteView Framer::partialPayload() const
{
    if (m_size <= 2)
        return {};
    return ByteView(m_bytes).subspan(2, std::min<std::size_t>(m_size - 2, m_bytes[1]));
}

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

} // namespace fcp

// What a board says unasked after a start. The simulated boards never restart by themselves, so only tests write it.
#pragma once

#include "fcp/framer.h"
#include "fcp/reply.h"

namespace support {

/// @param notice  its version of the form "5.4.3"
inline Bytes startNotice(const fcp::StartNotice &notice)
{
    ByteWriter out;
    out.u32(notice.buildId);
    for (const std::size_t part : {0U, 2U, 4U})
        out.u8(static_cast<std::uint8_t>(notice.version.at(part)));
    out.u16(notice.controlBoard).u16(notice.powerBoard).u16(notice.powerBoard2);
    return fcp::encodeFrame(fcp::kStartNoticeHeader, out.take());
}

} // namespace support

// The receive buffer as the command code of the firmware sees it: nothing stops it from reading past the end of a
// request, where the bytes of earlier requests are. Past the buffer this reader finds zeros.
#pragma once

#include "base/bytes.h"

#include <algorithm>

namespace simulation {

class StaleBytes {
public:
    explicit StaleBytes(ByteView buffer)
        : m_buffer(buffer)
    {
    }

    std::uint8_t u8(std::size_t at) const { return at < m_buffer.size() ? m_buffer[at] : 0; }
    std::uint16_t u16(std::size_t at) const
    {
        return static_cast<std::uint16_t>(u8(at) | u8(at + 1) << 8);
    }
    std::uint32_t u32(std::size_t at) const { return u16(at) | std::uint32_t{u16(at + 2)} << 16; }
    std::int16_t s16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
    std::int32_t s32(std::size_t at) const { return static_cast<std::int32_t>(u32(at)); }
    StaleBytes from(std::size_t at) const
    {
        return StaleBytes(m_buffer.subspan(std::min(at, m_buffer.size())));
    }
    std::size_t size() const { return m_buffer.size(); }

private:
    ByteView m_buffer;
};

} // namespace simulation

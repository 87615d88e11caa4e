// Watched registers beside a stream: a round leaves the line the time that stream and commands need.
#pragma once

#include "drive/mcp/mcp_protocol.h"
#include "drive/register_watch.h"

namespace drive {

class McpWatch final : public RegisterWatch<McpProtocol> {
public:
    using RegisterWatch::RegisterWatch;

    /// Bytes a second that the stream takes of the line from the board; the rest is there to be used.
    void setStreamLoad(double bytesPerSecond) { m_streamLoad = bytesPerSecond; }

    void onResponse(const ByteView &response, TimePoint now) override;

private:
    Duration leastPeriod(TimePoint now) const override;

    std::size_t m_roundBytes = 0; ///< of the answers of the round
    TimePoint m_counted; ///< when that round began
    double m_streamLoad = 0.0;
};

} // namespace drive

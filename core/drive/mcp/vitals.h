// What is read over and over: state, faults and speed of every motor (which register holds the speed depends on the
// firmware's family), and the watched registers.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/register_watch.h"
#include "drive/vitals.h"

namespace drive {

class McpVitals final : public Vitals<McpProtocol> {
public:
    using Vitals::Vitals;

private:
    std::vector<RegisterId> idsToRead() override;
    std::optional<MotorStatus> statusOf(int motor) const override;
};

/// Watched registers beside a stream: a round leaves the line the time that stream and commands need.
class McpWatch final : public RegisterWatch<McpProtocol> {
public:
    using RegisterWatch::RegisterWatch;

    /// Bytes a second that the stream takes of the line from the board; the rest is there to be used.
    void setStreamLoad(double bytesPerSecond) { m_streamLoad = bytesPerSecond; }

    void onResponse(const McpAnswer &answer, TimePoint now) override;

private:
    Duration leastPeriod(TimePoint now) const override;

    std::size_t m_roundBytes = 0; ///< of the answers of the round
    TimePoint m_counted; ///< when that round began
    double m_streamLoad = 0.0;
};

} // namespace drive

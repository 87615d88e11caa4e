// A move of the shaft to an angle. Where the shaft is now is read first, because the speed on the way follows from it; then
// the raw register is set, which also makes the firmware control the position. Sent once.
#pragma once

#include "drive/mcp/mcp_limits.h"
#include "drive/mcp/mcp_protocol.h"
#include "drive/task.h"

namespace drive {

class PositionTask : public WishTask<McpProtocol> {
public:
    PositionTask(WishId id, const PositionRamp &ramp, const McpFacts &board);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const ByteView &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    std::string refuse() const;
    RawPosition wanted() const;
    void judge();

    const McpFacts &m_board;
    PositionRamp m_ramp;
    Reader<McpProtocol> m_reader{m_board};
    std::optional<double> m_position_rad;
    bool m_asked = false, m_judged = false;
};

} // namespace drive

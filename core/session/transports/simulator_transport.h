// SimulatorTransport: a simulated board in this process, behind the same face as a port. The
// board's time begins at 0 when the line is opened and follows the session's time, so it never asks
// a clock.
#pragma once

#include "session/transports/transport.h"
#include "simulation/device.h"

#include <functional>

namespace session {

class SimulatorTransport : public Transport {
    Q_OBJECT
public:
    using MakeBoard = std::function<std::unique_ptr<simulation::ByteDevice>()>;
    explicit SimulatorTransport(MakeBoard makeBoard);

    PortError open(TimePoint now) override;
    void close() override { m_board.reset(); }
    void write(ByteView bytes, TimePoint now) override;
    bool sent(TimePoint) const override { return true; }
    void advance(TimePoint now) override;
    std::optional<TimePoint> nextWake() const override;
    bool real() const override { return false; }

private:
    TimePoint boardTime(TimePoint now) const { return TimePoint{} + (now - m_start); }

    MakeBoard m_makeBoard;
    std::unique_ptr<simulation::ByteDevice> m_board;
    TimePoint m_start{}; ///< the session's time at which the board's time is 0
    TimePoint m_last{}; ///< session time of the last advance()
};

} // namespace session

// A static board of the older serial protocol as its line sees it: bytes at the pace of the baud rate both ways, half
// duplex, a timer over each frame. What it answers is the server's business.
// Source: firmware 5.4.3; while it sends, what comes in is lost.
#pragma once

#include "fcp/framer.h"
#include "simulation/fcp/server.h"
#include "simulation/simulated_board.h"

#include <deque>

namespace simulation {

class FcpBoard : public SimulatedBoard {
public:
    /// @param answerDelay  between the end of a request and the start of its answer
    /// @param machine  the motors behind it; outlives the board
    explicit FcpBoard(FcpRig rig, std::uint32_t baud = 115200, Duration answerDelay = {},
        FcpMachine *machine = nullptr);

    void receive(ByteView bytes, TimePoint now) override;
    void advance(TimePoint now) override;
    Bytes takeOutput() override;
    TimePoint nextWake() const override;

    void reset() override;
    void setFaults(std::uint16_t present) override;
    void mute(Duration time) override { m_muteUntil = m_now + time; }
    void corruptAfter(std::uint64_t bytes) override;
    void inject(ByteView bytes) override;
    void setLoadTorque(int, double) override { } ///< nothing turns
    MotorTruth truth(int motor) const override;
    std::string describe() const override;

    // What only a rig can be told.
    void setState(std::uint8_t state) { m_server.setState(state); }
    void setFlags(std::uint32_t flags) { m_server.setFaults(flags); }
    void executeBuffered() { m_server.executeBuffered(); }
    void expireFrame(); ///< the frame timer runs out now; nothing if no frame is under way
    void overrun() { breakOff(fcp::ErrorCode::Overrun); } ///< the UART lost a byte

    const FcpServer &server() const { return m_server; }
    static constexpr std::size_t kMaxQueued = 65536; ///< what exceeds it is lost

protected:
    /// What happens besides the line, up to that time.
    virtual void advanceMachine(TimePoint) { }

private:
    struct TimedByte {
        TimePoint end;
        std::uint8_t value = 0;
    };
    std::optional<TimePoint> nextEvent() const;
    void accept(const TimedByte &byte);
    void breakOff(fcp::ErrorCode error);
    void refuse(fcp::ErrorCode error, TimePoint at);
    void send(const Bytes &frame, TimePoint at);

    FcpRig m_rig; ///< as at power-on
    FcpMachine *m_machine;
    FcpServer m_server;
    fcp::Framer m_framer{fcp::Framer::Side::Board};
    fcp::Frame m_frame;
    std::uint32_t m_baud;
    Duration m_answerDelay;
    TimePoint m_now{};
    std::deque<TimedByte> m_incoming, m_outgoing;
    TimePoint m_lineBusyUntil{}; ///< of what comes in
    TimePoint m_sendingUntil{};
    std::optional<TimePoint> m_frameEnd; ///< when the timer over the frame under way runs out
    Bytes m_injected;
    TimePoint m_muteUntil{};
    std::optional<std::uint64_t> m_corruptAfter;
};

} // namespace simulation

// A simulated MCB drive with a motor: the slave, the servo behind it, and what both do wrong on purpose, as a stream of
// bytes on virtual time. The same object serves unit tests, `sim:mcb` in this process, and rotorscope-sim.
#pragma once

#include "simulation/mcb/faults.h"
#include "simulation/mcb/servo.h"
#include "simulation/mcb/slave.h"
#include "simulation/simulated_board.h"

namespace simulation {

inline constexpr std::string_view kServoProfile = "mcb"; ///< of makeBoard()

struct McbBoardOptions {
    /// Motor, plant, load, control rate and seed count; its motor is "servo24" unless it says one.
    BoardOptions board;
    ServoOptions servo;
    int replyDelay = 0; ///< IDLE frames before each answer
    std::vector<McbFaultChoice> faults;
};

class McbBoard final : public SimulatedBoard {
public:
    McbBoard(const McbBoardOptions &options, const PlantParameters &plant);

    /// One frame, as SPI has it; fewer bytes come back where the wire is torn.
    Bytes exchange(ByteView input, TimePoint now);
    std::size_t frameBytes() const { return m_slave.frameBytes(); }

    void receive(ByteView bytes, TimePoint now) override;
    void advance(TimePoint now) override;
    Bytes takeOutput() override { return m_framing.takeOutput(); }
    TimePoint nextWake() const override;

    void reset() override;
    void setFaults(std::uint16_t present) override;
    void mute(Duration time) override { m_muteUntil = m_now + time; }
    void corruptAfter(std::uint64_t bytes) override { m_corruptAfter = bytes; }
    void inject(ByteView bytes) override { m_injected.assign(bytes.begin(), bytes.end()); }
    void setLoadTorque(int motor, double nm) override;
    MotorTruth truth(int motor) const override;
    std::string describe() const override;

    Servo &servo() { return m_servo; }
    const McbSlave &slave() const { return m_slave; }

private:
    void damage(Bytes &output);

    McbBoardOptions m_options;
    Servo m_servo;
    McbSlave m_slave;
    McbSpoiler m_spoiler;
    McbFraming m_framing;
    Bytes m_injected;
    TimePoint m_now{}, m_muteUntil{};
    std::optional<std::uint64_t> m_corruptAfter;
};

/// nullptr if there is no such motor, or no machine can be so.
std::unique_ptr<McbBoard> makeMcbBoard(McbBoardOptions options);

} // namespace simulation

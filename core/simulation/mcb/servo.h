// What an MCB drive does with its registers: the state machine of control word and status word (DS402), modes,
// set-points, limits and gains, on the motor model and the firmware that the other simulated boards have. It is told
// the time and knows no frames.
//
//   SwitchOnDisabled -06-> Ready -07-> SwitchedOn -0F-> Enabled          (low byte of the control word)
//   any of them -bit 1 low-> SwitchOnDisabled;  Enabled -bit 2 low-> QuickStop -standing-> SwitchOnDisabled
//   any of them -fault-> Fault -bit 7 rises-> SwitchOnDisabled
// SwitchedOn lasts until the firmware's start is over: an encoder has to be aligned the first time.
//
// Source: "MCB protocol description" and the dictionary of Summit 1.12.0 for the registers; the codes of LAST_ERROR are
// those of CiA 402, where real drives have their own.
#pragma once

#include "base/time.h"
#include "simulation/axis.h"
#include "simulation/mcb/registers.h"
#include "simulation/simulated_board.h"

namespace simulation {

struct ServoOptions {
    bool newer = false; ///< the dictionary of newer firmware: gains are rx, phase voltages FLOAT
    mcb::TextOrder order = mcb::TextOrder::HighByteFirst;
};

class Servo final : public McbLife {
public:
    enum class State : std::uint8_t {
        SwitchOnDisabled,
        Ready,
        SwitchedOn,
        Enabled,
        QuickStop,
        Fault
    };

    Servo(const BoardOptions &options, const PlantParameters &plant, const ServoOptions &servo);

    /// The registers of the dictionary as after power-on.
    McbRig rig() const;
    /// The processor restarts; the rotor keeps turning.
    void restart();
    void advance(TimePoint now);

    void show(McbRegisters &registers) override;
    std::optional<mcb::ErrorCode> refusal(
        std::uint16_t address, mcb::WordView words) const override;
    void look(const McbRegisters &registers) override;

    State state() const { return m_state; }
    /// What its speed loop is asked for, rpm: nothing while it is not enabled, whatever the firmware keeps.
    int speedReference_rpm() const
    {
        return m_state == State::Enabled ? m_axis.firmware.speedReference_rpm() : 0;
    }
    Axis &axis() { return m_axis; }
    const Axis &axis() const { return m_axis; }
    bool resetWanted() const { return m_resetWanted; }

private:
    struct Wanted {
        std::uint16_t control = 0, mode = 3;
        float iq_a = 0, id_a = 0, velocity_rps = 0, maxAcceleration = 0, maxVelocity = 0;
        float currentLimit_a = 0, velocityLimit_rps = 0;
        std::int32_t position_cnt = 0;
        std::array<float, 9> gains{};
        bool operator==(const Wanted &) const = default;
    };

    void task();
    void obey(std::uint16_t control);
    void follow();
    void adoptGains();
    std::uint16_t statusWord() const;
    std::int32_t errorCode() const;
    double radPerCount() const;
    std::array<float, 9> gains() const;

    ServoOptions m_servo;
    Axis m_axis;
    double m_hfHz;
    State m_state = State::SwitchOnDisabled;
    Wanted m_wanted, m_followed;
    std::uint16_t m_lastControl = 0;
    bool m_following = false, m_resetWanted = false;
    std::int32_t m_lastError = 0;
    bool m_started = false;
    TimePoint m_begun{};
    std::uint64_t m_hfTicks = 0;
};

} // namespace simulation

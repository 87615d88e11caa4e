// The motor control firmware of the simulated board: its states, its current and speed loops, its faults, and the
// motor that it turns. It knows nothing of registers or packets; its two tasks are called at their rates.
//
//   Idle -start-> ChargeBootCap -> OffsetCalib -> Start (rev-up stages) -> SwitchOver -> Run
//   any of these -stop-> Stop -0.4 s-> Idle;  any -fault-> FaultNow -gone-> FaultOver -acknowledge-> Idle
//
// This first version controls with the motor's true angle: no observer that could lose it.
// Source: mcp-aspep facts 7 to 9; the session start_ramp_stop; gains after features 6.2 and 6.3.
#pragma once

#include "simulation/pmsm.h"
#include "simulation/signals.h"

#include <array>
#include <cstdint>

namespace simulation {

enum class MotorState : std::uint8_t {
    Idle = 0,
    Start = 4,
    Run = 6,
    Stop = 8,
    FaultNow = 10,
    FaultOver = 11,
    ChargeBootCap = 16,
    OffsetCalib = 17,
    SwitchOver = 19,
};

/// What the board's design fixes: how digits relate to amps and volts, what it allows.
struct Stage {
    double maxReadable_a = 60.175056458; ///< 32768 digits
    double nominal_v = 24.0; ///< of the bus
    double nominal_a = 5.0;
    int maxSpeed_rpm = 4000;

    double ampsPerDigit() const { return maxReadable_a / 32768.0; }
    double voltsPerDigit() const { return nominal_v / (1.7320508075688772 * 32767.0); }
};

struct RevUpStage {
    std::int32_t rpm;
    std::int16_t torque; ///< digits
    std::uint16_t ms;
};

class Firmware {
public:
    static constexpr int kMfHz = 1000;
    static constexpr std::size_t kRevUpStages = 5;
    struct SpeedRamp {
        std::int16_t rpm;
        std::uint16_t ms;
    };
    struct TorqueRamp {
        std::int16_t digits;
        std::uint16_t ms;
    };
    struct PositionRamp {
        float target_rad, duration_s;
    };

    Firmware(double hfHz, std::uint64_t seed);

    void hfTask(); ///< measures, controls the currents, moves the motor on by one period
    void mfTask(); ///< states, ramps, speed loop, faults; 1 kHz

    bool start(); ///< true if it was accepted: Idle and no fault
    void stop();
    void stopRamp();
    void acknowledgeFaults();
    void clearCurrentReferences();

    void rampSpeed(SpeedRamp ramp);
    void rampTorque(TorqueRamp ramp);
    void rampPosition(PositionRamp ramp) { m_lastPositionRamp = ramp; }
    void setCurrentReferences(std::int16_t iq, std::int16_t id);
    void setControlMode(std::uint8_t mode); ///< 3 speed, 4 torque; others are ignored
    void setRevUpStage(std::size_t index, RevUpStage stage) { m_revUp[index] = stage; }
    void setPresentFaults(std::uint16_t bits) { m_presentFaults = bits; }
    /// Stops the motor by itself when it is driven and not fed for that long; 0: never.
    void setWatchdog(int ms) { m_watchdog_ms = ms; }
    void feedWatchdog() { m_hungry_ms = 0; }
    /// The processor restarts; the rotor keeps turning.
    void restart();

    MotorState state() const { return m_state; }
    std::uint32_t faultFlags() const
    {
        return std::uint32_t{m_presentFaults} << 16 | m_occurredFaults;
    }
    std::uint8_t controlMode() const { return m_modeAsked; }
    SpeedRamp lastSpeedRamp() const { return m_lastSpeedRamp; }
    TorqueRamp lastTorqueRamp() const { return m_lastTorqueRamp; }
    PositionRamp lastPositionRamp() const { return m_lastPositionRamp; }
    const std::array<RevUpStage, kRevUpStages> &revUp() const { return m_revUp; }
    std::int32_t speed_rpm() const { return m_speed_rpm; } ///< in steps of 6
    std::int32_t speedReference_rpm() const;
    std::int16_t torqueReference() const;
    double power_w() const;
    double hfHz() const { return m_hfHz; }

    const Signals &variables() const { return m_signals; }
    Signals &variables()
    {
        return m_signals;
    } ///< for what others measure: the load of the processor
    Tuning &tuning() { return m_tuning; }
    Commissioning &commissioning() { return m_commissioning; }
    const Pmsm &motor() const { return m_motor; }
    const Stage &stage() const { return m_stage; }

private:
    enum class Mode : std::uint8_t { Speed, Torque };
    struct Ramp {
        double value = 0.0, target = 0.0;
        int ticksLeft = 0;
        void start(double to, int ticks);
        void step();
    };

    bool powered() const;
    bool driven() const; ///< started and neither stopping nor in a fault
    void lookAtWatchdog();
    void enter(MotorState state);
    void control();
    void measureAtRest();
    void publish();
    void updateFaults();
    void runStates();
    void startUp();
    void speedLoop();
    void beginRun();
    double noise(int most); ///< uniform whole digits, -most to most

    double m_hfHz;
    Stage m_stage;
    Pmsm m_motor;
    Signals m_signals;
    Tuning m_tuning;
    Commissioning m_commissioning;
    std::uint64_t m_random;

    MotorState m_state = MotorState::Idle;
    int m_ticksInState = 0;
    bool m_rest = true; ///< nothing but noise to be measured
    std::uint16_t m_presentFaults = 0, m_occurredFaults = 0;
    int m_watchdog_ms = 0, m_hungry_ms = 0;

    Mode m_mode = Mode::Speed; ///< in force
    std::uint8_t m_modeAsked = 3;
    SpeedRamp m_lastSpeedRamp{};
    TorqueRamp m_lastTorqueRamp{};
    PositionRamp m_lastPositionRamp{};
    Ramp m_speedRamp, m_torqueRamp; ///< rpm; digits
    double m_idReference = 0.0;
    std::array<RevUpStage, kRevUpStages> m_revUp{};
    std::size_t m_stageIndex = 0;
    int m_stageTicks = 0;
    double m_stageFrom_rpm = 0.0, m_forced_rpm = 0.0, m_currentLimit = 0.0;

    std::int32_t m_speed_rpm = 0;
    double m_filteredSpeed_dHz = 0.0; ///< 0.1 Hz
    double m_iqReference = 0.0, m_speedIntegral = 0.0, m_dIntegral = 0.0, m_qIntegral = 0.0;
    double m_vd = 0.0, m_vq = 0.0; ///< digits, applied in the next period
};

} // namespace simulation

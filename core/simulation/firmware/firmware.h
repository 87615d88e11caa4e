// The motor control firmware of the simulated board: its states, its two tasks, its faults. It reads the converters and
// timers of a plant and sets its bridge, and knows nothing else of it; it knows nothing of registers or packets.
//
//   Idle -start-> ChargeBootCap -> OffsetCalib -> Start (rev-up stages) -> SwitchOver -> Run      sensorless
//                                  OffsetCalib -> Alignment (once) -> Start -> Run                encoder
//                                  OffsetCalib -> Start -> Run                                    Hall, open loop
//   any of these -stop-> Stop -0.4 s-> Idle;  any -fault-> FaultNow -gone-> FaultOver -acknowledge-> Idle
//
// Call order: Plant::advance(), then hfTask(), every control period; mfTask() every millisecond between two of them.
// Source: mcp-aspep facts 7 to 9; features 6.2 to 6.8; the session start_ramp_stop.
#pragma once

#include "simulation/firmware/build.h"
#include "simulation/firmware/current_control.h"
#include "simulation/firmware/design.h"
#include "simulation/firmware/feed_forward.h"
#include "simulation/firmware/flux_weakening.h"
#include "simulation/firmware/position_control.h"
#include "simulation/firmware/sensors.h"
#include "simulation/firmware/speed_control.h"
#include "simulation/firmware/virtual_sensor.h"
#include "simulation/plant/plant.h"
#include "simulation/signals.h"

#include <array>
#include <cstdint>

namespace simulation {

class Firmware {
public:
    static constexpr int kMfHz = 1000;
    static constexpr std::size_t kRevUpStages = RevUp::kStages;
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

    Firmware(Plant &plant, const Build &build, const DriveDesign &design, double hfHz);

    void hfTask(); ///< measures, controls the currents, sets the bridge
    void mfTask(); ///< states, ramps, speed loop, faults; 1 kHz

    bool start(); ///< true if it was accepted: Idle and no fault
    void stop();
    void stopRamp();
    void acknowledgeFaults();
    void clearCurrentReferences();

    void rampSpeed(SpeedRamp ramp);
    void rampTorque(TorqueRamp ramp);
    /// To an angle of the shaft, in builds with position control and an encoder; else only kept.
    void rampPosition(PositionRamp ramp);
    void setCurrentReferences(std::int16_t iq, std::int16_t id);
    /// 3 speed, 4 torque; 1 and 2, open-loop voltage and current, in builds that have them; others are ignored.
    void setControlMode(std::uint8_t mode);
    void setRevUpStage(std::size_t index, StageDigits stage) { m_stages[index] = stage; }
    /// Faults that are injected, beside those that are measured.
    void setPresentFaults(std::uint16_t bits) { m_injectedFaults = bits; }
    /// Stops the motor by itself when it is driven and not fed for that long; 0: never.
    void setWatchdog(int ms) { m_watchdog_ms = ms; }
    void feedWatchdog() { m_hungry_ms = 0; }
    /// The processor restarts; the rotor keeps turning.
    void restart();

    MotorState state() const { return m_state; }
    /// What is present now in the high half, what has occurred in the low half.
    std::uint32_t faultFlags() const
    {
        return std::uint32_t{presentFaults()} << 16 | m_occurredFaults;
    }
    std::uint8_t controlMode() const { return m_modeAsked; }
    SpeedRamp lastSpeedRamp() const { return m_lastSpeedRamp; }
    TorqueRamp lastTorqueRamp() const { return m_lastTorqueRamp; }
    PositionRamp lastPositionRamp() const { return m_lastPositionRamp; }
    const std::array<StageDigits, kRevUpStages> &revUp() const { return m_stages; }
    std::int32_t speed_rpm() const { return 6 * m_speed_dHz; }
    std::int32_t speedReference_rpm() const { return 6 * m_speedControl.speedReference_dHz(); }
    std::int16_t torqueReference() const { return m_wanted.q; }
    double power_w() const { return static_cast<double>(m_signals.power_w); }
    double hfHz() const { return m_hfHz; }

    const Signals &variables() const { return m_signals; }
    /// For what others measure: the load of the processor.
    Signals &variables() { return m_signals; }
    Tuning &tuning() { return m_tuning; }
    const Tuning &tuning() const { return m_tuning; }
    Commissioning &commissioning() { return m_commissioning; }
    const Plant &plant() const { return m_plant; }
    const DriveDesign &design() const { return m_design; }
    const Stage &stage() const { return m_design.stage; }

private:
    static constexpr int kStopTicks = 400;

    /// Averages of the converters' readings without current.
    struct Offsets {
        std::int32_t a = 32768, b = 32768;
        std::int64_t sumA = 0, sumB = 0;
        int count = 0;
        void begin();
        void add(std::uint16_t readA, std::uint16_t readB);
        void end();
    };

    // firmware.cpp: commands and references
    bool driven() const; ///< started and neither stopping nor in a fault
    bool openLoop() const { return m_modeAsked == 1 || m_modeAsked == 2; }
    bool positions() const { return m_modeAsked == 7; }
    void beginMove();
    int direction() const;
    std::int32_t toSpeed_dHz(std::int16_t rpm) const;

    // states.cpp: the slow task
    void enter(MotorState state);
    void switchOff();
    void runStates();
    void leaveCalibration();
    void align();
    void startUp();
    void startOpenLoop();
    void believeObserver();
    void beginRun();
    void run();
    void forgetRotor();
    void measureSlowly();
    void updateFaults();
    void lookAtWatchdog();
    void fail(std::uint16_t bit);
    std::uint16_t presentFaults() const
    {
        return static_cast<std::uint16_t>(m_injectedFaults | m_protection.present());
    }

    // firmware_currents.cpp: the fast task
    bool powered() const; ///< the current loops run
    bool virtualAngle() const; ///< the frame is the forced one
    Ab readCurrents();
    CurrentControl::Frame frame() const;
    void control(Ab currents);
    void observe(AlphaBeta voltage);

    Plant &m_plant;
    Build m_build;
    DriveDesign m_design;
    double m_hfHz;
    Signals m_signals;
    Tuning m_tuning;
    Commissioning m_commissioning;

    Offsets m_offsets;
    CurrentControl m_currents;
    Sensors m_sensors;
    VirtualSensor m_virtual;
    FluxWeakening m_fluxWeakening;
    FeedForward m_feedForward; ///< nothing in builds without it
    SpeedControl m_speedControl;
    PositionControl m_positionControl;
    RevUp m_revUp;
    Ramp m_alignmentTorque; ///< in milliseconds
    Ramp m_switchOverTorque; ///< in control periods
    Protection m_protection;

    MotorState m_state = MotorState::Idle;
    int m_ticksInState = 0;
    bool m_bridgeOn = false;
    int m_offTicks = 0; ///< since the bridge was switched off, up to kStopTicks
    int m_bootPeriods = 0; ///< left of the first calibration
    std::uint16_t m_injectedFaults = 0, m_occurredFaults = 0;
    int m_watchdog_ms = 0, m_hungry_ms = 0;

    std::uint8_t m_modeAsked = 3;
    SpeedRamp m_lastSpeedRamp{};
    TorqueRamp m_lastTorqueRamp{};
    PositionRamp m_lastPositionRamp{};
    std::array<StageDigits, kRevUpStages> m_stages{};
    std::int16_t m_idWanted = 0;
    Qd m_wanted; ///< references before flux weakening
    Qd m_reference; ///< what the current loops follow
    std::int16_t m_speed_dHz = 0;
    double m_bus_v = 0.0, m_heatsink_c = 25.0, m_power_w = 0.0;
    std::uint16_t m_bus = 0; ///< digits of its converter
};

} // namespace simulation

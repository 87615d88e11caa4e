// The speed sensors of a build, all of them at once: each is fed in every control period and publishes what its
// registers show; one of them closes the loops. Facade over maths; it decides nothing.
#pragma once

#include "simulation/firmware/build.h"
#include "simulation/firmware/design.h"
#include "simulation/maths/encoder_sensor.h"
#include "simulation/maths/hall_sensor.h"
#include "simulation/maths/sensorless.h"
#include "simulation/plant/plant.h"

#include <optional>

namespace simulation {

class Sensors {
public:
    Sensors(const Build &build, const DriveDesign &design);

    // Every control period.
    /// Encoder and Hall, before the current loops.
    void senseRotor(const Plant &plant, Signals &out);
    void observe(const ObserverInput &input, const Tuning &tuning, Signals &out); ///< after them
    // Every millisecond.
    void average(Signals &out);

    void restart(); ///< with the processor: an alignment is forgotten
    void clearObservers();
    /// The rotor stands at electrical angle 0.
    void align();
    bool needsAlignment() const { return m_main == SpeedSensor::Encoder && !m_aligned; }
    /// The direction that the main sensor is told; 0: it finds out.
    void setDirection(int direction);
    bool converged(std::int16_t forced_dHz);

    // Of the main sensor.
    std::int16_t angle() const { return reading().angle; }
    /// Angle a control period.
    std::int16_t perPeriod() const { return reading().perPeriod; }
    std::int16_t speed_dHz() const { return reading().speed_dHz; }
    bool reliable() const { return reading().reliable; }
    bool seesRotorAtRest() const
    {
        return m_main == SpeedSensor::Encoder || m_main == SpeedSensor::Hall;
    }
    bool aligned() const { return m_aligned; }
    /// Of the shaft by the encoder, 1/65536 turn, 0 where it was aligned; 0 without one.
    std::int64_t position() const { return std::int64_t{m_turns} * 65536 + m_lastMechanical; }

private:
    struct Reading {
        std::int16_t angle = 0, perPeriod = 0, speed_dHz = 0;
        bool reliable = true;
    };
    Reading reading() const;

    SpeedSensor m_main;
    bool m_aligned = false;
    std::int32_t m_turns = 0; ///< of the shaft
    std::int16_t m_lastMechanical = 0;
    std::optional<EncoderSensor> m_encoder;
    std::optional<HallSensor> m_hall;
    std::optional<ObserverPll> m_pll;
    std::optional<ObserverCordic> m_cordic;
};

} // namespace simulation

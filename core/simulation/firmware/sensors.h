// The speed sensors of a build, all of them at once: each is fed in every control period and publishes what its
// registers show; one of them closes the loops. Facade over maths; it decides nothing.
#pragma once

#include "simulation/build.h"
#include "simulation/firmware/design.h"
#include "simulation/maths/sensorless.h"
#include "simulation/plant/plant.h"

#include <optional>

namespace simulation {

class Sensors {
public:
    Sensors(const Build &build, const DriveDesign &design, double hfHz);

    // Every control period.
    void senseRotor(
        const Plant &plant, Signals &out); ///< encoder and Hall, before the current loops
    void observe(const ObserverInput &input, const Tuning &tuning, Signals &out); ///< after them
    // Every millisecond.
    void average(Signals &out);

    void restart(); ///< with the processor
    void clearObservers();
    /// The direction that the main sensor is told; 0: it finds out.
    void setDirection(int direction);
    bool converged(std::int16_t forced_dHz);

    // Of the main sensor.
    std::int16_t angle() const;
    std::int16_t perPeriod() const; ///< angle a control period
    std::int16_t speed_dHz() const;
    bool reliable() const;
    bool hasObserver() const { return m_pll.has_value() || m_cordic.has_value(); }

private:
    SpeedSensor m_main;
    std::optional<ObserverPll> m_pll;
    std::optional<ObserverCordic> m_cordic;
};

} // namespace simulation

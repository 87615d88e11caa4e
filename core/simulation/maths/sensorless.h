// The two sensorless angles of the firmware, both on one StateObserver: a phase locked loop that follows the back-EMF,
// and its phase by CORDIC with limited acceleration. Rotor angle 0: back-EMF along alpha.
//
// Call order: step() every control period, after the current loops; mediumTask() at 1 kHz, then, while the rotor is
// forced, converged(). clear() when a rev-up stage begins that accelerates first. Source: features 6.6.
#pragma once

#include "simulation/maths/pi.h"
#include "simulation/maths/speed_estimate.h"
#include "simulation/maths/state_observer.h"

namespace simulation {

/// What both are made of.
class ObservedAngle {
public:
    void mediumTask() { m_speed.average(m_observer.bemf()); }
    bool converged(std::int16_t forced_dHz) { return m_speed.converged(forced_dHz); }
    void forceConvergence() { m_speed.forceConvergence(); }

    std::int16_t angle() const { return m_angle; }
    std::int16_t speed_dHz() const { return m_speed.speed_dHz(); }
    std::int16_t speed_dpp() const { return m_speed.speed_dpp(); } ///< averaged
    bool reliable() const { return m_speed.reliable(); }
    AlphaBeta estimatedCurrent() const { return m_observer.current(); }
    AlphaBeta estimatedBemf() const { return m_observer.bemf(); }
    const SpeedEstimate &speed() const { return m_speed; }
    SpeedEstimate &speed() { return m_speed; }

    /// 1 or -1 for the main sensor, which is told the direction; 0: the sign of the averaged speed.
    void setDirection(int direction) { m_direction = direction; }
    void setObserverGains(std::int16_t gain1, std::int16_t gain2)
    {
        m_observer.setGains(gain1, gain2);
    }

protected:
    ObservedAngle(const ObserverConstants &observer, const SpeedEstimateParameters &speed)
        : m_observer(observer)
        , m_speed(speed)
    {
    }

    void clear();

    StateObserver m_observer;
    SpeedEstimate m_speed;
    int m_direction = 0;
    std::int16_t m_angle = 0, m_instant_dpp = 0;
};

class ObserverPll : public ObservedAngle {
public:
    struct Parameters {
        ObserverConstants observer;
        SpeedEstimateParameters speed;
        Pi::Gains pll{638, 45, 14, 15};
    };

    explicit ObserverPll(const Parameters &parameters);

    /// The angle to use in the next control period. The PLL's PI works on the quadrature of the back-EMF of this period
    /// (bemf sin(true - estimated)) and its output is the electrical speed in 1/65536 turn a period.
    std::int16_t step(const ObserverInput &input);
    void clear();
    void setPllGains(Pi::Gains gains) { m_pll.follow(gains); }

private:
    Pi m_pll;
};

class ObserverCordic : public ObservedAngle {
public:
    struct Parameters {
        ObserverConstants observer;
        SpeedEstimateParameters speed; ///< with a threshold of 400 %
        /// Largest change of the electrical speed from one period to the next.
        std::int16_t maxAcceleration_dpp = 20;
    };

    explicit ObserverCordic(const Parameters &parameters);

    using ObservedAngle::clear;
    /// The angle of this period's back-EMF, as far as the acceleration limit lets it; against the direction it stands.
    std::int16_t step(const ObserverInput &input);

private:
    std::int16_t m_maxAcceleration_dpp;
};

} // namespace simulation

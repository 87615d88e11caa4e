// The observers see the same currents and voltages; which of them exist is a matter of the build.
#include "simulation/firmware/sensors.h"

namespace simulation {

Sensors::Sensors(const Build &build, const DriveDesign &design, double hfHz)
    : m_main(build.mainSensor)
{
    static_cast<void>(hfHz);
    if (build.observerPll || m_main == SpeedSensor::ObserverPll)
        m_pll.emplace(design.pll);
    if (build.observerCordic || m_main == SpeedSensor::ObserverCordic)
        m_cordic.emplace(design.cordic);
}

void Sensors::senseRotor(const Plant &, Signals &) { }

void Sensors::observe(const ObserverInput &input, const Tuning &t, Signals &out)
{
    if (m_pll) {
        m_pll->setObserverGains(t.pllC1, t.pllC2);
        m_pll->setPllGains({t.pllKp, t.pllKi, t.pllKpDiv, t.pllKiDiv});
        m_pll->step(input);
        out.pllAngle = m_pll->angle();
        out.pllBemfAlpha = m_pll->estimatedBemf().alpha;
        out.pllBemfBeta = m_pll->estimatedBemf().beta;
        out.pllIAlpha = m_pll->estimatedCurrent().alpha;
        out.pllIBeta = m_pll->estimatedCurrent().beta;
    }
    if (m_cordic) {
        m_cordic->setObserverGains(t.cordicC1, t.cordicC2);
        m_cordic->step(input);
        out.cordicAngle = m_cordic->angle();
        out.cordicBemfAlpha = m_cordic->estimatedBemf().alpha;
        out.cordicBemfBeta = m_cordic->estimatedBemf().beta;
        out.cordicIAlpha = m_cordic->estimatedCurrent().alpha;
        out.cordicIBeta = m_cordic->estimatedCurrent().beta;
    }
}

void Sensors::average(Signals &out)
{
    if (m_pll) {
        m_pll->mediumTask();
        out.pllSpeed = m_pll->speed_dHz();
        out.pllEstimatedBemf = m_pll->speed().expectedBemf();
        out.pllObservedBemf = m_pll->speed().observedBemf();
    }
    if (m_cordic) {
        m_cordic->mediumTask();
        out.cordicSpeed = m_cordic->speed_dHz();
        out.cordicEstimatedBemf = m_cordic->speed().expectedBemf();
        out.cordicObservedBemf = m_cordic->speed().observedBemf();
    }
}

void Sensors::restart() { clearObservers(); }

void Sensors::clearObservers()
{
    if (m_pll)
        m_pll->clear();
    if (m_cordic)
        m_cordic->clear();
}

void Sensors::setDirection(int direction)
{
    if (m_pll)
        m_pll->setDirection(m_main == SpeedSensor::ObserverPll ? direction : 0);
    if (m_cordic)
        m_cordic->setDirection(m_main == SpeedSensor::ObserverCordic ? direction : 0);
}

bool Sensors::converged(std::int16_t forced_dHz)
{
    if (m_main == SpeedSensor::ObserverCordic)
        return m_cordic->converged(forced_dHz);
    return m_main != SpeedSensor::ObserverPll || m_pll->converged(forced_dHz);
}

std::int16_t Sensors::angle() const
{
    return m_main == SpeedSensor::ObserverCordic ? m_cordic->angle() : m_pll->angle();
}

std::int16_t Sensors::perPeriod() const
{
    return m_main == SpeedSensor::ObserverCordic ? m_cordic->speed_dpp() : m_pll->speed_dpp();
}

std::int16_t Sensors::speed_dHz() const
{
    return m_main == SpeedSensor::ObserverCordic ? m_cordic->speed_dHz() : m_pll->speed_dHz();
}

bool Sensors::reliable() const
{
    return m_main == SpeedSensor::ObserverCordic ? m_cordic->reliable() : m_pll->reliable();
}

} // namespace simulation

// The observers see the same currents and voltages; which of them exist is a matter of the build.
#include "simulation/firmware/sensors.h"

#include <numbers>

namespace simulation {

namespace {

/// What turns the motor inside. Firmware of other families finds its angle in other ways that are not modelled: what
/// it shows comes from the observer.
SpeedSensor mainOf(const Build &build)
{
    switch (build.mainSensor) {
    case SpeedSensor::ObserverCordic:
    case SpeedSensor::Encoder:
    case SpeedSensor::Hall:
        return build.mainSensor;
    default:
        return SpeedSensor::ObserverPll;
    }
}

} // namespace

Sensors::Sensors(const Build &build, const DriveDesign &design)
    : m_main(mainOf(build))
{
    if (build.observerPll || m_main == SpeedSensor::ObserverPll)
        m_pll.emplace(design.pll);
    if (build.observerCordic || m_main == SpeedSensor::ObserverCordic)
        m_cordic.emplace(design.cordic);
    if (build.encoder || m_main == SpeedSensor::Encoder)
        m_encoder.emplace(design.encoder);
    if (build.hall || m_main == SpeedSensor::Hall)
        m_hall.emplace(design.hall);
}

void Sensors::senseRotor(const Plant &plant, Signals &out)
{
    if (m_encoder) {
        out.encoderAngle = m_encoder->step(plant.encoderCount());
        // The first turn of the shaft is the one in which it was aligned.
        const std::int16_t now = m_encoder->mechanicalAngle();
        if (now - m_lastMechanical > 0x8000)
            --m_turns;
        else if (m_lastMechanical - now > 0x8000)
            ++m_turns;
        m_lastMechanical = now;
    }
    if (m_hall) {
        const HallReading reading = plant.hall();
        out.hallAngle =
            m_hall->step({reading.code, reading.edges, reading.sinceEdge_s, reading.lastPeriod_s});
    }
}

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
    if (m_encoder) {
        m_encoder->mediumTask();
        out.encoderSpeed = m_encoder->speed_dHz();
        constexpr double kPerDigit = 2.0 * std::numbers::pi / 65536.0;
        out.position_rad = static_cast<float>(static_cast<double>(position()) * kPerDigit);
    }
    if (m_hall) {
        m_hall->mediumTask();
        out.hallSpeed = m_hall->speed_dHz();
    }
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

void Sensors::restart()
{
    m_aligned = false;
    m_turns = 0;
    m_lastMechanical = 0;
    if (m_encoder)
        m_encoder->clear();
    if (m_hall)
        m_hall->clear();
    clearObservers();
}

void Sensors::clearObservers()
{
    if (m_pll)
        m_pll->clear();
    if (m_cordic)
        m_cordic->clear();
}

void Sensors::align()
{
    m_aligned = true;
    if (!m_encoder)
        return;
    m_encoder->align(0);
    m_turns = 0;
    m_lastMechanical = m_encoder->mechanicalAngle();
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

Sensors::Reading Sensors::reading() const
{
    const auto of = [](const auto &sensor) {
        return Reading{sensor.angle(), sensor.speed_dpp(), sensor.speed_dHz(), sensor.reliable()};
    };
    switch (m_main) {
    case SpeedSensor::ObserverCordic:
        return of(*m_cordic);
    case SpeedSensor::Encoder:
        return of(*m_encoder);
    case SpeedSensor::Hall:
        return of(*m_hall);
    default:
        return of(*m_pll);
    }
}

} // namespace simulation

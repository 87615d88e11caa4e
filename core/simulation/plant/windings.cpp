// One step of the flux linkages, driven or left to diodes.
#include "simulation/plant/windings.h"

namespace simulation {

namespace {

double bend(const MotorParameters &motor)
{
    if (motor.saturation_a <= 0.0)
        return 0.0;
    const double knee_wb = motor.lq_h * motor.saturation_a;
    return 0.25 / 0.64 / (knee_wb * knee_wb);
}

} // namespace

Windings::Windings(const MotorParameters &motor)
    : m_rs20_ohm(motor.rs_ohm)
    , m_ld_h(motor.ld_h)
    , m_magnets_wb(motor.flux_wb)
    , m_perLd(1.0 / motor.ld_h)
    , m_perLq(1.0 / motor.lq_h)
    , m_bend(bend(motor))
    , m_torquePerFlux(1.5 * motor.polePairs)
    , m_winding_ohm(motor.rs_ohm)
    , m_total_ohm(motor.rs_ohm)
{
    open();
}

void Windings::prepare(double step_s, double temperature_c, double series_ohm)
{
    m_step_s = step_s;
    m_winding_ohm = resistanceAt(m_rs20_ohm, temperature_c);
    m_total_ohm = m_winding_ohm + series_ohm;
    m_halfDrop = 0.5 * step_s * m_total_ohm;
    m_perDPole = 1.0 / (1.0 + m_halfDrop * m_perLd);
}

void Windings::drive(Dq volts)
{
    const Dq before = m_current;
    // flux + halfDrop * i(flux) = known; linear in d, one step of Newton's from a very good guess in q
    const double knownD = m_flux.d + m_step_s * volts.d - m_halfDrop * before.d;
    m_flux.d = (knownD + m_halfDrop * m_perLd * m_magnets_wb) * m_perDPole;
    const double knownQ = m_flux.q + m_step_s * volts.q - m_halfDrop * before.q;
    const double guess = m_flux.q;
    m_flux.q = guess
        - (guess + m_halfDrop * qCurrent(guess) - knownQ)
            / (1.0 + m_halfDrop * perIncrementalLq(guess));
    m_current = {(m_flux.d - m_magnets_wb) * m_perLd, qCurrent(m_flux.q)};
    m_mean = {0.5 * (before.d + m_current.d), 0.5 * (before.q + m_current.q)};
}

Windings::Implied Windings::imply() const
{
    // (L + h R) i = L i(flux) + h v on each axis, with the inductance for small changes
    const double lq_h = 1.0 / perIncrementalLq(m_flux.q);
    const double perD = 1.0 / (m_ld_h + m_step_s * m_total_ohm);
    const double perQ = 1.0 / (lq_h + m_step_s * m_total_ohm);
    return {{(m_flux.d - m_magnets_wb) * perD, lq_h * qCurrent(m_flux.q) * perQ},
        {m_step_s * perD, m_step_s * perQ}};
}

void Windings::settle(Dq current)
{
    const double from_a = qCurrent(m_flux.q);
    m_flux.q += (current.q - from_a) / perIncrementalLq(m_flux.q);
    m_flux.d = m_magnets_wb + m_ld_h * current.d;
    m_current = {current.d, qCurrent(m_flux.q)};
    m_mean = m_current;
}

void Windings::open()
{
    m_flux = {m_magnets_wb, 0.0};
    m_current = {};
    m_mean = {};
}

double Windings::field_j() const
{
    const double x2 = m_flux.q * m_flux.q;
    const double q_j = 0.5 * x2 * m_perLq * (1.0 + 0.5 * m_bend * x2);
    return 1.5 * (0.5 * m_ld_h * m_current.d * m_current.d + q_j);
}

} // namespace simulation

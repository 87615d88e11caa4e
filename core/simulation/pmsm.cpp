// Euler steps of the motor's equations; the speed uses the currents of the same step.
#include "simulation/pmsm.h"

#include <cmath>
#include <numbers>

namespace simulation {

Pmsm::Pmsm(PmsmParameters parameters)
    : m_parameters(parameters)
{
}

double Pmsm::torque_nm() const
{
    const auto &p = m_parameters;
    return 1.5 * p.polePairs * (p.flux_wb + (p.ld_h - p.lq_h) * m_id_a) * m_iq_a;
}

void Pmsm::drive(double vd_v, double vq_v, double dt_s)
{
    const auto &p = m_parameters;
    const int steps = static_cast<int>(std::ceil(dt_s / kMaxStep_s));
    const double h_s = dt_s / steps;
    for (int i = 0; i < steps; ++i) {
        const double we = p.polePairs * m_speed_radps;
        const double did = (vd_v - p.rs_ohm * m_id_a + we * p.lq_h * m_iq_a) / p.ld_h;
        const double diq = (vq_v - p.rs_ohm * m_iq_a - we * (p.ld_h * m_id_a + p.flux_wb)) / p.lq_h;
        m_id_a += did * h_s;
        m_iq_a += diq * h_s;
        turn(torque_nm(), h_s);
    }
}

void Pmsm::coast(double dt_s)
{
    m_id_a = 0.0;
    m_iq_a = 0.0;
    if (m_speed_radps != 0.0)
        turn(0.0, dt_s);
}

void Pmsm::turn(double torque_nm, double dt_s)
{
    const auto &p = m_parameters;
    const double free_radps =
        m_speed_radps + (torque_nm - p.viscous_nms * m_speed_radps) / p.inertia_kgm2 * dt_s;
    // Dry friction can stop the rotor, never turn it.
    const double drop_radps = p.coulomb_nm / p.inertia_kgm2 * dt_s;
    m_speed_radps = std::abs(free_radps) <= drop_radps
        ? 0.0
        : free_radps - std::copysign(drop_radps, free_radps);
    m_angle_rad += p.polePairs * m_speed_radps * dt_s;
    constexpr double kTurn = 2.0 * std::numbers::pi;
    if (m_angle_rad >= kTurn || m_angle_rad < 0.0)
        m_angle_rad -= kTurn * std::floor(m_angle_rad / kTurn);
}

} // namespace simulation

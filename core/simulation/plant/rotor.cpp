// Torques into speed, speed into angle, with what each of them took or gave.
#include "simulation/plant/rotor.h"

#include <cmath>

namespace simulation {

Rotor::Rotor(const MotorParameters &motor, const LoadParameters &load)
    : m_inertia_kgm2(motor.inertia_kgm2)
    , m_perInertia(1.0 / motor.inertia_kgm2)
    , m_viscous_nms(motor.viscous_nms)
    , m_coulomb_nm(motor.coulomb_nm)
    , m_cogging_nm(motor.cogging_nm)
    , m_cogs(motor.coggingPerTurn)
    , m_load(load)
{
}

void Rotor::place(double angle_rad, double speed_radps)
{
    m_angle_rad = angle_rad;
    m_speed_radps = speed_radps;
    wrap();
    faceCogs();
}

void Rotor::wrap()
{
    if (!(m_angle_rad >= 0.0 && m_angle_rad < kTurn))
        m_angle_rad -= kTurn * std::floor(m_angle_rad / kTurn);
    if (m_angle_rad >= kTurn) // a tiny negative angle rounds up to a whole turn
        m_angle_rad = 0.0;
}

void Rotor::faceCogs()
{
    if (m_cogging_nm > 0.0)
        m_cog = Rotation::of(m_cogs * m_angle_rad);
}

double Rotor::drift(double step_s)
{
    const double by_rad = m_speed_radps * step_s;
    m_angle_rad += by_rad;
    if (m_cogging_nm > 0.0)
        m_cog = m_cog.then(Rotation::small(m_cogs * by_rad));
    return by_rad;
}

bool Rotor::stays() const
{
    return m_speed_radps == 0.0
        && std::abs(m_load.drive_nm - m_cogging_nm * m_cog.sine)
        <= m_coulomb_nm + std::abs(m_load.constant_nm);
}

void Rotor::kick(double torque_nm, double step_s)
{
    const double before = m_speed_radps;
    const double cogging_nm = m_cogging_nm * m_cog.sine;
    const double push = (torque_nm - cogging_nm + m_load.drive_nm) * step_s; // N m s, as all below
    const double fan = m_load.fan_nms2 * std::abs(before) * step_s * m_perInertia; // of the speed
    const double viscous = m_viscous_nms * step_s * m_perInertia;
    const double smooth = (before * m_inertia_kgm2 + push) / (1.0 + viscous + fan);
    const double brake_nm = std::abs(m_load.constant_nm);
    const double dry = step_s * (m_coulomb_nm + brake_nm);
    const double kept = std::abs(smooth) <= dry ? 0.0 : smooth - std::copysign(dry, smooth);
    m_speed_radps = kept * m_perInertia;

    const double mean = 0.5 * (before + m_speed_radps);
    if (mean == 0.0)
        return;
    m_work.mechanical_j += torque_nm * step_s * mean;
    m_work.driven_j += m_load.drive_nm * step_s * mean;
    // What the brakes took, shared out as they act.
    const double dryTook = smooth - kept;
    const double brakeShare = brake_nm > 0.0 ? brake_nm / (m_coulomb_nm + brake_nm) : 0.0;
    m_work.load_j += mean * (fan * smooth + brakeShare * dryTook);
    m_work.friction_j += mean * (viscous * smooth + (1.0 - brakeShare) * dryTook);
}

double Rotor::cogging_j() const
{
    return m_cogging_nm / m_cogs * (1.0 - std::cos(m_cogs * m_angle_rad));
}

} // namespace simulation

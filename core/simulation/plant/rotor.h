// The turning part: angle, speed, cogging, friction, load. It knows torque only, nothing electrical.
//
//   J w' = torque - cogging sin(n angle) + drive_nm - (viscous + fan |w|) w - (coulomb + |constant_nm|) sign(w)
// Dry friction and brake take speed away until there is none, and hold a resting rotor against anything smaller than
// they are: they never turn it. Viscous and fan torque are implicit, so no step can reverse the rotor by friction.
#pragma once

#include "simulation/plant/parameters.h"
#include "simulation/plant/rotation.h"

namespace simulation {

class Rotor {
public:
    Rotor(const MotorParameters &motor, const LoadParameters &load);

    void setLoad(const LoadParameters &load) { m_load = load; }
    const LoadParameters &load() const { return m_load; }
    void place(double angle_rad, double speed_radps);

    void wrap(); ///< the angle, between two periods
    void faceCogs(); ///< anew from the angle, so that no rounding adds up
    /// Half of a step: the angle moves on by the speed. Returns the mechanical angle it turned.
    double drift(double step_s);
    /// The other half: torques change the speed.
    void kick(double torque_nm, double step_s);
    /// True if a rotor that stands goes on to stand without current, for whatever time.
    bool stays() const;

    double angle_rad() const { return m_angle_rad; } ///< 0 to 2 pi between periods
    double speed_radps() const { return m_speed_radps; }
    struct Work {
        double mechanical_j = 0.0, friction_j = 0.0, load_j = 0.0, driven_j = 0.0;
    };
    const Work &work() const { return m_work; } ///< since the start
    double kinetic_j() const { return 0.5 * m_inertia_kgm2 * m_speed_radps * m_speed_radps; }
    double cogging_j() const;

private:
    double m_inertia_kgm2, m_perInertia, m_viscous_nms, m_coulomb_nm, m_cogging_nm;
    int m_cogs;
    LoadParameters m_load;
    double m_angle_rad = 0.0, m_speed_radps = 0.0;
    Rotation m_cog; ///< of cogs times the angle
    Work m_work;
};

} // namespace simulation

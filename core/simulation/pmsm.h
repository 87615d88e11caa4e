// A permanent magnet synchronous motor in rotor coordinates, with inertia and friction. It knows no controller.
//
//   vd = Rs id + Ld id' - we Lq iq            torque = 3/2 p (flux iq + (Ld - Lq) id iq)
//   vq = Rs iq + Lq iq' + we (Ld id + flux)   J w' = torque - viscous w - coulomb sign(w)
#pragma once

namespace simulation {

struct PmsmParameters {
    int polePairs = 4;
    double rs_ohm = 0.35; ///< a phase
    double ld_h = 0.6e-3;
    double lq_h = 0.6e-3;
    double flux_wb = 6.5e-3; ///< of the magnets, peak, a phase
    double inertia_kgm2 = 5e-5; ///< rotor and load
    double viscous_nms = 1.2e-4; ///< torque per rad/s
    double coulomb_nm = 0.025; ///< torque against any motion
};

class Pmsm {
public:
    explicit Pmsm(PmsmParameters parameters);

    /// Voltages in rotor coordinates for `dt_s`, in steps of kMaxStep_s or less.
    void drive(double vd_v, double vq_v, double dt_s);
    /// The bridge is open: currents decay at once, the rotor runs out.
    void coast(double dt_s);

    const PmsmParameters &parameters() const { return m_parameters; }
    double id_a() const { return m_id_a; }
    double iq_a() const { return m_iq_a; }
    double speed_radps() const { return m_speed_radps; } ///< mechanical
    double angle_rad() const { return m_angle_rad; } ///< electrical, 0 to 2 pi
    double torque_nm() const;
    bool atRest() const { return m_speed_radps == 0.0 && m_iq_a == 0.0 && m_id_a == 0.0; }

    static constexpr double kMaxStep_s = 25e-6;

private:
    void turn(double torque_nm, double dt_s);

    PmsmParameters m_parameters;
    double m_id_a = 0.0, m_iq_a = 0.0;
    double m_speed_radps = 0.0, m_angle_rad = 0.0;
};

} // namespace simulation

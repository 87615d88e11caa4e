// The windings of the motor in rotor coordinates: flux linkages as the state, currents as their functions. It knows
// neither what moves the rotor nor where the voltages come from.
//
//   flux_d = Ld id + flux of the magnets
//   flux_q = Lq iq;  saturating: iq = x/Lq (1 + k (x/(Lq Isat))^2), x = flux_q, k = 0.25/0.64
//            so that flux_q(Isat) = 0.8 Lq Isat
//   seen from phase coordinates: flux' = v - R i;  seen from the rotor the flux turns back by p w as well
//   Rs = Rs20 (1 + 0.00393 (T - 20 C))
// With flux as the state the rotation is exact and back-EMF needs no term of its own. R i uses the trapezoidal rule
// (bridge on) or the backward one (bridge off: diodes want a step that cannot overshoot).
#pragma once

#include "simulation/plant/parameters.h"
#include "simulation/plant/rotation.h"

namespace simulation {

class Windings {
public:
    explicit Windings(const MotorParameters &motor);

    /// Before the steps of a period: their length, and what is in series with each phase beside the winding.
    void prepare(double step_s, double temperature_c, double series_ohm);

    /// First part of a step: the rotor has turned on.
    void turn(Rotation by)
    {
        m_flux = m_flux.seenAfter(by);
        m_current = m_current.seenAfter(by);
    }
    /// Second part: `volts` over the windings and what is in series with them.
    void drive(Dq volts);

    /// Second part with diodes instead: after `imply` the current is free() + admittance * volts, for any volts.
    struct Implied {
        Dq free_a, admittance_s;
    };
    Implied imply() const;
    /// Takes the current that the diodes settled at.
    void settle(Dq current);
    /// No current flows and none will: the flux is that of the magnets.
    void open();

    Dq current() const { return m_current; }
    bool carriesCurrent() const { return m_current.d != 0.0 || m_current.q != 0.0; }
    /// Mean over the last step, in the coordinates of its end.
    Dq meanCurrent() const { return m_mean; }
    double torque_nm() const
    {
        return m_torquePerFlux * (m_flux.d * m_current.q - m_flux.q * m_current.d);
    }
    double magnetFlux_wb() const { return m_magnets_wb; }
    double resistance_ohm() const { return m_winding_ohm; } ///< as warm as it is, of a phase
    double field_j() const;

    static double resistanceAt(double rs20_ohm, double temperature_c)
    {
        return rs20_ohm * (1.0 + 0.00393 * (temperature_c - 20.0));
    }

private:
    double qCurrent(double flux_wb) const
    {
        return flux_wb * m_perLq * (1.0 + m_bend * flux_wb * flux_wb);
    }
    double perIncrementalLq(double flux_wb) const
    {
        return m_perLq * (1.0 + 3.0 * m_bend * flux_wb * flux_wb);
    }

    double m_rs20_ohm, m_ld_h, m_magnets_wb;
    double m_perLd, m_perLq;
    double m_bend; ///< 1/Wb^2
    double m_torquePerFlux;
    double m_step_s = 0.0, m_winding_ohm, m_total_ohm;
    double m_halfDrop = 0.0, m_perDPole = 1.0; ///< of the trapezoidal rule
    Dq m_flux, m_current, m_mean;
};

} // namespace simulation

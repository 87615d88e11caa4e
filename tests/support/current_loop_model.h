// What the current loop of a simulated board does, by its exact linear model: windings in the rotor's coordinates over
// a period with its voltage held, the firmware's PIs, and the back-EMF that follows the torque. No dead time, noise or
// digit is in it.
#pragma once

#include "simulation/firmware/design.h"
#include "support/axis_bench.h"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace support {

class CurrentLoopModel {
public:
    using Complex = std::complex<double>;

    /// Both axes alike: Ld is Lq.
    CurrentLoopModel(const simulation::PlantParameters &plant, double hz, double rpm)
        : m_period_s(1.0 / hz)
    {
        constexpr double kColdest_c = 20.0, kCopper = 0.00393;
        const simulation::MotorParameters &motor = plant.motor;
        const double speed = rpm * 2.0 * std::numbers::pi / 60.0 * motor.polePairs;
        const double warm = 1.0 + kCopper * (plant.inverter.ambient_c - kColdest_c);
        const Complex z(
            motor.rs_ohm * warm + plant.inverter.switchResistance_ohm, speed * motor.lq_h);
        m_pole = std::exp(-z / motor.lq_h * m_period_s);
        m_gain = (1.0 - m_pole) / z;
        const simulation::DriveDesign design = usualDesign(plant, hz);
        const auto gain = [&](double numerator, int exponent) {
            return std::ldexp(numerator, -exponent) * design.stage.voltsPerDigit()
                / design.stage.ampsPerDigit();
        };
        m_kp = gain(design.tuning.qKp, design.tuning.qKpDiv);
        m_ki = gain(design.tuning.qKi, design.tuning.qKiDiv);
        const double emf = motor.polePairs * motor.flux_wb;
        m_emf = 1.5 * emf * emf / motor.inertia_kgm2 * m_period_s;
    }

    /// Iq by its reference.
    Complex at(double hz) const
    {
        const Complex z = std::polar(1.0, 2.0 * std::numbers::pi * hz * m_period_s);
        const Complex regulator = m_kp + m_ki * z / (z - 1.0);
        const Complex fedBack = regulator + m_emf / (z - 1.0); // of q
        // z i = A i + B v, with complex numbers of the rotor's plane as matrices
        const Matrix pole = matrixOf(m_pole), gain = matrixOf(m_gain);
        const Matrix left{z - pole[0] + gain[0] * fedBack, -pole[1] + gain[1] * regulator,
            -pole[2] + gain[2] * fedBack, z - pole[3] + gain[3] * regulator};
        const Complex q = gain[0] * regulator, d = gain[2] * regulator;
        return (q * left[3] - d * left[1]) / (left[0] * left[3] - left[1] * left[2]);
    }

    /// Iq after a step of its reference by 1, sample by sample.
    std::vector<double> step(std::size_t samples) const
    {
        std::vector<double> q;
        Complex current = 0.0, integral = 0.0;
        double emf = 0.0;
        for (std::size_t i = 0; i < samples; ++i) {
            q.push_back(current.real());
            const Complex error = 1.0 - current;
            integral += m_ki * error;
            emf += m_emf * current.real();
            current = m_pole * current + m_gain * (m_kp * error + integral - emf);
        }
        return q;
    }

private:
    using Matrix = std::array<Complex, 4>;
    static Matrix matrixOf(Complex value)
    {
        return {value.real(), -value.imag(), value.imag(), value.real()};
    }

    double m_period_s;
    Complex m_pole, m_gain;
    double m_kp = 0.0, m_ki = 0.0; ///< V/A
    double m_emf = 0.0; ///< V/A and period
};

} // namespace support

// The proportional-integral controller of every loop: numerators over powers of two, a 32-bit integral, limits.
// It has no idea of time: the gains hold the period. Source: features 6.2; mcp-aspep section 9 for the limits.
#pragma once

#include "simulation/maths/fixed_point.h"

namespace simulation {

/// out = (kp * e >> kpShift) + (integral >> kiShift), integral += ki * e, in this order and with these cuts:
/// - kp * e and ki * e and the sum saturate to 32 bits; shifts are arithmetic (towards minus infinity);
/// - ki = 0 clears the integral;
/// - the integral is then cut to its limits;
/// - an output beyond its limit is cut, and what was cut off is taken from the integral as it is, unshifted: held at
///   the limit, the integral discharges.
class Pi {
public:
    struct Gains {
        std::int16_t kp = 0, ki = 0;
        int kpShift = 0, kiShift = 0; ///< exponents of two, cut to 0..31
    };
    struct Limits {
        std::int32_t lower = -kDigitsMax, upper = kDigitsMax;
    };

    Pi() = default;
    /// Output within -32767..32767 and the integral within those times 2^kiShift, until set otherwise.
    explicit Pi(Gains gains);

    std::int16_t step(std::int32_t error);
    void clear() { m_integral = 0; }

    std::int16_t kp() const { return m_gains.kp; }
    std::int16_t ki() const { return m_gains.ki; }
    int kpShift() const { return m_gains.kpShift; }
    int kiShift() const { return m_gains.kiShift; }
    std::int32_t integral() const { return m_integral; }

    void setKpShift(int shift);
    /// Also sets the limits of the integral to -32767 and 32767 times 2^shift (cut to 32 bits), whatever they were:
    /// so does the firmware when KI_DIV is written.
    void setKiShift(int shift);
    /// As setKiShift, but only if it differs: for an owner that copies its registers every period.
    void follow(Gains gains);
    void setIntegral(std::int32_t integral) { m_integral = integral; }
    /// In force at the next step.
    void setIntegralLimits(Limits limits) { m_integralLimits = limits; }
    /// Cut to 16 bits.
    void setOutputLimits(Limits limits);

private:
    Gains m_gains;
    std::int32_t m_integral = 0;
    Limits m_integralLimits, m_outputLimits;
};

} // namespace simulation

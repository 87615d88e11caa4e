// The fast half of the firmware: what a control period measures, the current loops, what it publishes.
// Rotor coordinates as in ST's library: with positive speed I_B follows I_A by 120 degrees.
#include "simulation/firmware/firmware.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

constexpr double kRoot3 = 1.7320508075688772;

std::int16_t digits(double value)
{
    return static_cast<std::int16_t>(std::lrint(std::clamp(value, -32768.0, 32767.0)));
}

struct Stationary {
    double alpha, beta;
};

Stationary fromRotor(double q, double d, double cosine, double sine)
{
    return {q * cosine + d * sine, d * cosine - q * sine};
}

} // namespace

double Firmware::noise(int most)
{
    m_random ^= m_random << 13;
    m_random ^= m_random >> 7;
    m_random ^= m_random << 17;
    const std::uint64_t span = 2 * static_cast<std::uint64_t>(most) + 1;
    return static_cast<double>((m_random >> 33) % span) - most;
}

void Firmware::hfTask()
{
    if (m_rest && !powered()) {
        measureAtRest();
        return;
    }
    if (powered()) {
        const double volts = m_stage.voltsPerDigit();
        m_motor.drive(m_vd * volts, m_vq * volts, 1.0 / m_hfHz);
    } else {
        m_motor.coast(1.0 / m_hfHz);
    }
    publish();
    if (powered())
        control();
}

void Firmware::measureAtRest()
{
    Signals quiet;
    quiet.pllAngle = m_signals.pllAngle;
    quiet.hallAngle = m_signals.hallAngle;
    quiet.busVoltage_v = m_signals.busVoltage_v;
    quiet.temperature_c = m_signals.temperature_c;
    m_signals = quiet;
    m_signals.iA = digits(noise(4));
    m_signals.iB = digits(noise(4));
}

void Firmware::publish()
{
    const double angle_rad = m_motor.angle_rad();
    const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
    const double perAmp = 1.0 / m_stage.ampsPerDigit(), perVolt = 1.0 / m_stage.voltsPerDigit();
    const Stationary current =
        fromRotor(m_motor.iq_a() * perAmp, m_motor.id_a() * perAmp, cosine, sine);
    const double iA = current.alpha + noise(4);
    const double iB = (-current.alpha - kRoot3 * current.beta) / 2.0 + noise(4);
    const double alpha = iA, beta = -(2.0 * iB + iA) / kRoot3;

    Signals &s = m_signals;
    s.iA = digits(iA);
    s.iB = digits(iB);
    s.iAlpha = digits(alpha);
    s.iBeta = digits(beta);
    s.pllIAlpha = s.iAlpha;
    s.pllIBeta = s.iBeta;
    s.iQ = digits(alpha * cosine - beta * sine);
    s.iD = digits(alpha * sine + beta * cosine);
    s.iQRef = digits(m_iqReference);
    s.iDRef = digits(m_idReference);
    const Stationary voltage = fromRotor(m_vq, m_vd, cosine, sine);
    s.vQ = digits(m_vq);
    s.vD = digits(m_vd);
    s.vAlpha = digits(voltage.alpha);
    s.vBeta = digits(voltage.beta);
    const double bemf = m_motor.parameters().polePairs * m_motor.speed_radps()
        * m_motor.parameters().flux_wb * perVolt;
    s.pllBemfAlpha = digits(bemf * cosine);
    s.pllBemfBeta = digits(-bemf * sine);
    const auto turn = static_cast<std::int32_t>(angle_rad * (65536.0 / (2.0 * std::numbers::pi)));
    s.pllAngle = static_cast<std::int16_t>(static_cast<std::uint16_t>(turn));
    s.hallAngle = s.pllAngle;
    s.pllSpeed = digits(m_motor.speed_radps() * (10.0 / (2.0 * std::numbers::pi)));
    s.hallSpeed = s.pllSpeed;
    s.openLoopAngle = m_state == MotorState::Start ? s.pllAngle : std::int16_t{0};
}

void Firmware::control()
{
    constexpr double kLimit = 0.95 * 32767.0;
    const auto loop = [](double error, double &integral, double kp, double ki, double limit) {
        integral = std::clamp(integral + ki * error, -limit, limit);
        return std::clamp(kp * error + integral, -limit, limit);
    };
    const Tuning &t = m_tuning;
    m_vd = loop(m_idReference - m_signals.iD, m_dIntegral, scaledGain(t.dKp, t.dKpDiv),
        scaledGain(t.dKi, t.dKiDiv), kLimit);
    const double room = std::sqrt(std::max(0.0, kLimit * kLimit - m_vd * m_vd));
    m_vq = loop(m_iqReference - m_signals.iQ, m_qIntegral, scaledGain(t.qKp, t.qKpDiv),
        scaledGain(t.qKi, t.qKiDiv), room);
}

} // namespace simulation

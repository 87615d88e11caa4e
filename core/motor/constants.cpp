#include "motor/constants.h"

#include <cmath>
#include <numbers>

namespace motor {

namespace {

using std::numbers::pi, std::numbers::sqrt2, std::numbers::sqrt3;

constexpr double kRadpsPerKrpm = 1000.0 * kRadpsPerRpm;

bool within(double value, double least, double most)
{
    return std::isfinite(value) && value >= least && value <= most;
}

bool inductancePlausible(double inductance_h) { return within(inductance_h, 100e-9, 10.0); }

/// Where the voltage is used up: (Rs I + w flux)^2 + (w Lq I)^2 = Vmax^2, solved for w >= 0.
std::optional<double> baseSpeed(const MotorParameters &m, double bus_v)
{
    const double vmax = bus_v / sqrt3;
    const double drop = m.rs_ohm * m.nominalCurrent_a, reactance = m.lq_h * m.nominalCurrent_a;
    const double a = m.flux_wb * m.flux_wb + reactance * reactance;
    const double b = 2.0 * drop * m.flux_wb;
    const double c = drop * drop - vmax * vmax;
    if (c >= 0.0)
        return std::nullopt; // the resistance alone takes it all
    const double electrical_radps = (std::sqrt(b * b - 4.0 * a * c) - b) / (2.0 * a);
    return electrical_radps / m.polePairs / kRadpsPerRpm;
}

} // namespace

double fluxOfKe_wb(double ke_vrmsPerKrpm, double polePairs)
{
    return ke_vrmsPerKrpm * sqrt2 / sqrt3 / (polePairs * kRadpsPerKrpm);
}

double keOfFlux_vrmsPerKrpm(double flux_wb, double polePairs)
{
    return flux_wb * polePairs * kRadpsPerKrpm * sqrt3 / sqrt2;
}

double fluxOfKv_wb(double kv_rpmpv, double polePairs)
{
    return 1.0 / (sqrt3 * kRadpsPerRpm * kv_rpmpv * polePairs);
}

double kvOfFlux_rpmpv(double flux_wb, double polePairs)
{
    return 1.0 / (sqrt3 * kRadpsPerRpm * flux_wb * polePairs);
}

double ktOfFlux_nmpa(double flux_wb, double polePairs) { return 1.5 * polePairs * flux_wb; }

double fluxOfConfiguration_wb(double ratedFlux, double polePairs, bool perHertz)
{
    if (!known(ratedFlux) || !known(polePairs))
        return 0.0;
    return perHertz ? ratedFlux / (2.0 * pi) : fluxOfKe_wb(ratedFlux, polePairs);
}

double torque_nm(const MotorParameters &m, double iq_a, double id_a)
{
    return 1.5 * m.polePairs * (m.flux_wb + (m.ld_h - m.lq_h) * id_a) * iq_a;
}

MotorConstants motorConstants(const MotorParameters &m, double bus_v)
{
    MotorConstants constants;
    if (known(m.polePairs) && known(m.flux_wb)) {
        constants.kt_nmpa = ktOfFlux_nmpa(m.flux_wb, m.polePairs);
        constants.ke_vrmsPerKrpm = keOfFlux_vrmsPerKrpm(m.flux_wb, m.polePairs);
        constants.kv_rpmpv = kvOfFlux_rpmpv(m.flux_wb, m.polePairs);
    }
    if (known(m.rs_ohm) && known(m.lq_h))
        constants.timeConstantQ_s = m.lq_h / m.rs_ohm;
    if (known(m.rs_ohm) && known(m.ld_h))
        constants.timeConstantD_s = m.ld_h / m.rs_ohm;
    if (constants.kt_nmpa && constants.timeConstantQ_s && known(m.nominalCurrent_a) && known(bus_v))
        constants.baseSpeed_rpm = baseSpeed(m, bus_v);
    return constants;
}

std::vector<MotorWarning> checkMotor(const MotorParameters &m, const DriveLimits &drive)
{
    std::vector<MotorWarning> warnings;
    const auto warnIf = [&warnings](bool wrong, MotorWarning warning) {
        if (wrong)
            warnings.push_back(warning);
    };
    warnIf(!within(m.polePairs, 1.0, 50.0) || m.polePairs != std::nearbyint(m.polePairs),
        MotorWarning::PolePairsMissing);
    warnIf(!within(m.rs_ohm, 0.1e-3, 1e3), MotorWarning::ResistanceImplausible);
    warnIf(!inductancePlausible(m.lq_h) || !inductancePlausible(m.ld_h),
        MotorWarning::InductanceImplausible);
    warnIf(!within(m.flux_wb, 1e-6, 10.0), MotorWarning::FluxImplausible);
    warnIf(!within(m.nominalCurrent_a, 1e-3, 5e3), MotorWarning::NominalCurrentImplausible);
    constexpr double kRounding = 1.001; // single precision and a ratio of three digits
    warnIf(m.ld_h > m.lq_h * kRounding, MotorWarning::LdAboveLq);
    const MotorConstants constants = motorConstants(m, drive.bus_v);
    warnIf(constants.timeConstantQ_s && !within(*constants.timeConstantQ_s, 10e-6, 1.0),
        MotorWarning::TimeConstantImplausible);
    warnIf(known(drive.maxCurrent_a) && m.nominalCurrent_a > drive.maxCurrent_a,
        MotorWarning::NominalCurrentBeyondDrive);
    warnIf(constants.baseSpeed_rpm && drive.maxSpeed_rpm > *constants.baseSpeed_rpm,
        MotorWarning::SpeedBeyondBaseSpeed);
    return warnings;
}

} // namespace motor

// What no machine can be. Bounds are wide: they keep numbers finite, not designs sensible.
#include "simulation/plant/parameters.h"

#include <array>

namespace simulation {

namespace {

struct Bound {
    std::string_view name;
    double value, least, most;
};

template <std::size_t N>
std::string_view firstOutside(const std::array<Bound, N> &bounds)
{
    for (const Bound &b : bounds) {
        if (!(b.value >= b.least && b.value <= b.most)) // NaN is outside too
            return b.name;
    }
    return {};
}

std::string_view impossible(const MotorParameters &m)
{
    return firstOutside(std::array{
        Bound{"polePairs", static_cast<double>(m.polePairs), 1, 64},
        Bound{"rs_ohm", m.rs_ohm, 1e-4, 1e3},
        Bound{"ld_h", m.ld_h, 1e-6, 1.0},
        Bound{"lq_h", m.lq_h, 1e-6, 1.0},
        Bound{"flux_wb", m.flux_wb, 1e-6, 10.0},
        Bound{"saturation_a", m.saturation_a, 0.0, 1e5},
        Bound{"inertia_kgm2", m.inertia_kgm2, 1e-9, 100.0},
        Bound{"viscous_nms", m.viscous_nms, 0.0, 10.0},
        Bound{"coulomb_nm", m.coulomb_nm, 0.0, 1e3},
        Bound{"cogging_nm", m.cogging_nm, 0.0, 1e3},
        Bound{"coggingPerTurn", static_cast<double>(m.coggingPerTurn), 1, 1000},
        Bound{"nominal_a", m.nominal_a, 1e-3, 1e4},
        Bound{"maxSpeed_rpm", m.maxSpeed_rpm, 6.0, 32767.0},
        Bound{"copperMass_kg", m.copperMass_kg, 0.0, 1e3},
        Bound{"coolingTime_s", m.coolingTime_s, 0.0, 1e6},
    });
}

std::string_view impossible(const InverterParameters &i)
{
    return firstOutside(std::array{
        Bound{"supply_v", i.supply_v, 1.0, 1000.0},
        Bound{"supplyResistance_ohm", i.supplyResistance_ohm, 1e-4, 100.0},
        Bound{"busCapacitance_f", i.busCapacitance_f, 1e-6, 1.0},
        Bound{"bleeder_ohm", i.bleeder_ohm, 1.0, 1e9},
        Bound{"deadTime_s", i.deadTime_s, 0.0, 5e-6},
        Bound{"switchResistance_ohm", i.switchResistance_ohm, 0.0, 10.0},
        Bound{"diodeDrop_v", i.diodeDrop_v, 0.0, 5.0},
        Bound{"shunt_ohm", i.shunt_ohm, 1e-5, 10.0},
        Bound{"amplifierGain", i.amplifierGain, 0.1, 1e3},
        Bound{"converterReference_v", i.converterReference_v, 0.5, 10.0},
        Bound{"converterBits", static_cast<double>(i.converterBits), 8, 16},
        Bound{"offset_digits", i.offset_digits, -32768.0, 32767.0},
        Bound{"noise_digits", i.noise_digits, 0.0, 32767.0},
        Bound{"busRange_v", i.busRange_v, i.supply_v, 1e4},
        Bound{"busNoise_v", i.busNoise_v, 0.0, 1e3},
        Bound{"ambient_c", i.ambient_c, -60.0, 150.0},
        Bound{"heatsinkResistance_kpw", i.heatsinkResistance_kpw, 0.0, 1e3},
        Bound{"heatsinkCapacity_jpk", i.heatsinkCapacity_jpk, 0.0, 1e6},
        Bound{"heatsinkNoise_c", i.heatsinkNoise_c, 0.0, 50.0},
    });
}

} // namespace

std::string_view impossibleParameter(const PlantParameters &parameters)
{
    if (const auto name = impossible(parameters.motor); !name.empty())
        return name;
    if (const auto name = impossible(parameters.inverter); !name.empty())
        return name;
    const SensorParameters &s = parameters.sensors;
    const LoadParameters &l = parameters.load;
    return firstOutside(std::array{
        Bound{"encoderPulses", static_cast<double>(s.encoderPulses), 0, 16000},
        Bound{"hallPlacement_deg", s.hallPlacement_deg, -360.0, 360.0},
        Bound{"constant_nm", l.constant_nm, -1e3, 1e3},
        Bound{"fan_nms2", l.fan_nms2, 0.0, 1e3},
        Bound{"drive_nm", l.drive_nm, -1e3, 1e3},
    });
}

} // namespace simulation

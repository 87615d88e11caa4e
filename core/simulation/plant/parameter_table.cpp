// The rows, and what no machine can be. Bounds are wide: they keep numbers finite, not designs sensible.
#include "simulation/plant/parameter_table.h"

#include <array>

namespace simulation {

namespace {

template <auto Section, auto Member>
ParameterInfo::Slot at(PlantParameters &parameters)
{
    return &(parameters.*Section.*Member);
}

constexpr std::array kTable{
    ParameterInfo{"motor", "name", at<&PlantParameters::motor, &MotorParameters::name>, 0, 23,
        "as the board tells it"},
    ParameterInfo{"motor", "polePairs", at<&PlantParameters::motor, &MotorParameters::polePairs>, 1,
        64, "pole pairs"},
    ParameterInfo{"motor", "rs_ohm", at<&PlantParameters::motor, &MotorParameters::rs_ohm>, 1e-4,
        1e3, "of a phase, at 20 C"},
    ParameterInfo{"motor", "ld_h", at<&PlantParameters::motor, &MotorParameters::ld_h>, 1e-6, 1.0,
        "along the magnets"},
    ParameterInfo{"motor", "lq_h", at<&PlantParameters::motor, &MotorParameters::lq_h>, 1e-6, 1.0,
        "across them"},
    ParameterInfo{"motor", "flux_wb", at<&PlantParameters::motor, &MotorParameters::flux_wb>, 1e-6,
        10.0, "of the magnets, peak, a phase; V/(rad/s) electrical"},
    ParameterInfo{"motor", "saturation_a",
        at<&PlantParameters::motor, &MotorParameters::saturation_a>, 0.0, 1e5,
        "q current at which flux over current is 0.8 lq_h; 0: none"},
    ParameterInfo{"motor", "inertia_kgm2",
        at<&PlantParameters::motor, &MotorParameters::inertia_kgm2>, 1e-9, 100.0,
        "rotor and what is fixed to it"},
    ParameterInfo{"motor", "viscous_nms",
        at<&PlantParameters::motor, &MotorParameters::viscous_nms>, 0.0, 10.0, "torque per rad/s"},
    ParameterInfo{"motor", "coulomb_nm", at<&PlantParameters::motor, &MotorParameters::coulomb_nm>,
        0.0, 1e3, "dry friction"},
    ParameterInfo{"motor", "cogging_nm", at<&PlantParameters::motor, &MotorParameters::cogging_nm>,
        0.0, 1e3, "peak of the cogging torque"},
    ParameterInfo{"motor", "coggingPerTurn",
        at<&PlantParameters::motor, &MotorParameters::coggingPerTurn>, 1, 1000,
        "its periods in a mechanical turn"},
    ParameterInfo{"motor", "nominal_a", at<&PlantParameters::motor, &MotorParameters::nominal_a>,
        1e-3, 1e4, "nominal current, peak"},
    ParameterInfo{"motor", "maxSpeed_rpm",
        at<&PlantParameters::motor, &MotorParameters::maxSpeed_rpm>, 6.0, 32767.0,
        "highest speed the firmware is told to allow"},
    ParameterInfo{"motor", "copperMass_kg",
        at<&PlantParameters::motor, &MotorParameters::copperMass_kg>, 0.0, 1e3,
        "what heats up; 0: stays at the ambient temperature"},
    ParameterInfo{"motor", "coolingTime_s",
        at<&PlantParameters::motor, &MotorParameters::coolingTime_s>, 0.0, 1e6,
        "towards the ambient temperature; 0: never"},
    ParameterInfo{"sensors", "encoderPulses",
        at<&PlantParameters::sensors, &SensorParameters::encoderPulses>, 0, 16000,
        "lines of the encoder, counted four times each; 0: none"},
    ParameterInfo{"sensors", "hall", at<&PlantParameters::sensors, &SensorParameters::hall>, 0, 1,
        "whether there are Hall sensors"},
    ParameterInfo{"sensors", "hallPlacement_deg",
        at<&PlantParameters::sensors, &SensorParameters::hallPlacement_deg>, -360.0, 360.0,
        "electrical angle of the change from code 4 to 5"},
    ParameterInfo{"inverter", "supply_v",
        at<&PlantParameters::inverter, &InverterParameters::supply_v>, 1.0, 1000.0,
        "without load; also the nominal voltage"},
    ParameterInfo{"inverter", "supplyResistance_ohm",
        at<&PlantParameters::inverter, &InverterParameters::supplyResistance_ohm>, 1e-4, 100.0,
        "source and leads"},
    ParameterInfo{"inverter", "busCapacitance_f",
        at<&PlantParameters::inverter, &InverterParameters::busCapacitance_f>, 1e-6, 1.0,
        "of the bus"},
    ParameterInfo{"inverter", "bleeder_ohm",
        at<&PlantParameters::inverter, &InverterParameters::bleeder_ohm>, 1.0, 1e9,
        "what the board itself takes from the bus"},
    ParameterInfo{"inverter", "supplyAbsorbs",
        at<&PlantParameters::inverter, &InverterParameters::supplyAbsorbs>, 0, 1,
        "else what the motor returns stays in the capacitor"},
    ParameterInfo{"inverter", "deadTime_s",
        at<&PlantParameters::inverter, &InverterParameters::deadTime_s>, 0.0, 5e-6,
        "both switches of a leg open, twice a period"},
    ParameterInfo{"inverter", "switchResistance_ohm",
        at<&PlantParameters::inverter, &InverterParameters::switchResistance_ohm>, 0.0, 10.0,
        "of a closed switch, either direction"},
    ParameterInfo{"inverter", "diodeDrop_v",
        at<&PlantParameters::inverter, &InverterParameters::diodeDrop_v>, 0.0, 5.0,
        "of the diodes across the switches"},
    ParameterInfo{"inverter", "shunt_ohm",
        at<&PlantParameters::inverter, &InverterParameters::shunt_ohm>, 1e-5, 10.0,
        "of a current shunt"},
    ParameterInfo{"inverter", "amplifierGain",
        at<&PlantParameters::inverter, &InverterParameters::amplifierGain>, 0.1, 1e3,
        "behind the shunt"},
    ParameterInfo{"inverter", "converterReference_v",
        at<&PlantParameters::inverter, &InverterParameters::converterReference_v>, 0.5, 10.0,
        "full scale of all converters"},
    ParameterInfo{"inverter", "converterBits",
        at<&PlantParameters::inverter, &InverterParameters::converterBits>, 8, 16,
        "of the current converters; left-aligned to 16"},
    ParameterInfo{"inverter", "offset_digits",
        at<&PlantParameters::inverter, &InverterParameters::offset_digits>, -32768.0, 32767.0,
        "of the amplifiers"},
    ParameterInfo{"inverter", "noise_digits",
        at<&PlantParameters::inverter, &InverterParameters::noise_digits>, 0.0, 32767.0,
        "of the current readings, to either side"},
    ParameterInfo{"inverter", "busRange_v",
        at<&PlantParameters::inverter, &InverterParameters::busRange_v>, 1.0, 1e4,
        "bus voltage at full scale"},
    ParameterInfo{"inverter", "busNoise_v",
        at<&PlantParameters::inverter, &InverterParameters::busNoise_v>, 0.0, 1e3,
        "of the measured voltage, to either side"},
    ParameterInfo{"inverter", "ambient_c",
        at<&PlantParameters::inverter, &InverterParameters::ambient_c>, -60.0, 150.0,
        "ambient temperature"},
    ParameterInfo{"inverter", "heatsinkResistance_kpw",
        at<&PlantParameters::inverter, &InverterParameters::heatsinkResistance_kpw>, 1e-3, 1e3,
        "to the ambient, K/W"},
    ParameterInfo{"inverter", "heatsinkCapacity_jpk",
        at<&PlantParameters::inverter, &InverterParameters::heatsinkCapacity_jpk>, 0.0, 1e6,
        "J/K; 0: stays at the ambient temperature"},
    ParameterInfo{"inverter", "heatsinkNoise_c",
        at<&PlantParameters::inverter, &InverterParameters::heatsinkNoise_c>, 0.0, 50.0,
        "of the measured temperature, to either side"},
    ParameterInfo{"load", "constant_nm", at<&PlantParameters::load, &LoadParameters::constant_nm>,
        -1e3, 1e3, "of a friction brake"},
    ParameterInfo{"load", "fan_nms2", at<&PlantParameters::load, &LoadParameters::fan_nms2>, 0.0,
        1e3, "torque over the square of the speed in rad/s"},
    ParameterInfo{"load", "drive_nm", at<&PlantParameters::load, &LoadParameters::drive_nm>, -1e3,
        1e3, "of a machine that pushes, in the sense of its sign"},
};

double numberIn(const ParameterInfo::Slot &slot)
{
    if (const auto *real = std::get_if<double *>(&slot))
        return **real;
    if (const auto *whole = std::get_if<int *>(&slot))
        return **whole;
    if (const auto *text = std::get_if<std::string *>(&slot))
        return static_cast<double>((*text)->size());
    return *std::get<bool *>(slot) ? 1.0 : 0.0;
}

} // namespace

std::span<const ParameterInfo> parameterTable() { return kTable; }

bool withinBounds(const ParameterInfo &info, const PlantParameters &parameters)
{
    PlantParameters copy = parameters;
    const double value = numberIn(info.slot(copy));
    return value >= info.least && value <= info.most;
}

std::string_view impossibleParameter(const PlantParameters &parameters)
{
    for (const ParameterInfo &info : kTable) {
        if (!withinBounds(info, parameters))
            return info.name;
    }
    if (parameters.inverter.busRange_v < parameters.inverter.supply_v)
        return "busRange_v";
    return {};
}

} // namespace simulation

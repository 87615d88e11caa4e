// The rows, and what no machine can be. Bounds are wide: they keep numbers finite, not designs sensible.
#include "simulation/plant/parameter_table.h"

namespace simulation {

namespace {

template <auto Section, auto Member>
ParameterInfo::Slot at(PlantParameters &parameters)
{
    return &(parameters.*Section.*Member);
}

constexpr auto kMotor = &PlantParameters::motor;
constexpr auto kSensors = &PlantParameters::sensors;
constexpr auto kInverter = &PlantParameters::inverter;
constexpr auto kLoad = &PlantParameters::load;
using Motor = MotorParameters;
using Sensors = SensorParameters;
using Inverter = InverterParameters;
using Load = LoadParameters;

constexpr ParameterInfo kTable[] = {
    {"motor", "name", at<kMotor, &Motor::name>, 0, 23, "as the board tells it"},
    {"motor", "polePairs", at<kMotor, &Motor::polePairs>, 1, 64, "pole pairs"},
    {"motor", "rs_ohm", at<kMotor, &Motor::rs_ohm>, 1e-4, 1e3, "of a phase, at 20 C"},
    {"motor", "ld_h", at<kMotor, &Motor::ld_h>, 1e-6, 1.0, "along the magnets"},
    {"motor", "lq_h", at<kMotor, &Motor::lq_h>, 1e-6, 1.0, "across them"},
    {"motor", "flux_wb", at<kMotor, &Motor::flux_wb>, 1e-6, 10.0,
        "of the magnets, peak, a phase; V/(rad/s) electrical"},
    {"motor", "saturation_a", at<kMotor, &Motor::saturation_a>, 0.0, 1e5,
        "q current at which flux over current is 0.8 lq_h; 0: none"},
    {"motor", "inertia_kgm2", at<kMotor, &Motor::inertia_kgm2>, 1e-9, 100.0,
        "rotor and what is fixed to it"},
    {"motor", "viscous_nms", at<kMotor, &Motor::viscous_nms>, 0.0, 10.0, "torque per rad/s"},
    {"motor", "coulomb_nm", at<kMotor, &Motor::coulomb_nm>, 0.0, 1e3, "dry friction"},
    {"motor", "cogging_nm", at<kMotor, &Motor::cogging_nm>, 0.0, 1e3, "peak of the cogging torque"},
    {"motor", "coggingPerTurn", at<kMotor, &Motor::coggingPerTurn>, 1, 1000,
        "its periods in a mechanical turn"},
    {"motor", "nominal_a", at<kMotor, &Motor::nominal_a>, 1e-3, 1e4, "nominal current, peak"},
    {"motor", "maxSpeed_rpm", at<kMotor, &Motor::maxSpeed_rpm>, 6.0, 32767.0,
        "highest speed the firmware is told to allow"},
    {"motor", "copperMass_kg", at<kMotor, &Motor::copperMass_kg>, 0.0, 1e3,
        "what heats up; 0: stays at the ambient temperature"},
    {"motor", "coolingTime_s", at<kMotor, &Motor::coolingTime_s>, 0.0, 1e6,
        "towards the ambient temperature; 0: never"},
    {"sensors", "encoderPulses", at<kSensors, &Sensors::encoderPulses>, 0, 16000,
        "lines of the encoder, counted four times each; 0: none"},
    {"sensors", "hall", at<kSensors, &Sensors::hall>, 0, 1, "whether there are Hall sensors"},
    {"sensors", "hallPlacement_deg", at<kSensors, &Sensors::hallPlacement_deg>, -360.0, 360.0,
        "electrical angle of the change from code 4 to 5"},
    {"inverter", "supply_v", at<kInverter, &Inverter::supply_v>, 1.0, 1000.0,
        "without load; also the nominal voltage"},
    {"inverter", "supplyResistance_ohm", at<kInverter, &Inverter::supplyResistance_ohm>, 1e-4,
        100.0, "source and leads"},
    {"inverter", "busCapacitance_f", at<kInverter, &Inverter::busCapacitance_f>, 1e-6, 1.0,
        "of the bus"},
    {"inverter", "bleeder_ohm", at<kInverter, &Inverter::bleeder_ohm>, 1.0, 1e9,
        "what the board itself takes from the bus"},
    {"inverter", "supplyAbsorbs", at<kInverter, &Inverter::supplyAbsorbs>, 0, 1,
        "else what the motor returns stays in the capacitor"},
    {"inverter", "deadTime_s", at<kInverter, &Inverter::deadTime_s>, 0.0, 5e-6,
        "both switches of a leg open, twice a period"},
    {"inverter", "switchResistance_ohm", at<kInverter, &Inverter::switchResistance_ohm>, 0.0, 10.0,
        "of a closed switch, either direction"},
    {"inverter", "diodeDrop_v", at<kInverter, &Inverter::diodeDrop_v>, 0.0, 5.0,
        "of the diodes across the switches"},
    {"inverter", "shunt_ohm", at<kInverter, &Inverter::shunt_ohm>, 1e-5, 10.0,
        "of a current shunt"},
    {"inverter", "amplifierGain", at<kInverter, &Inverter::amplifierGain>, 0.1, 1e3,
        "behind the shunt"},
    {"inverter", "converterReference_v", at<kInverter, &Inverter::converterReference_v>, 0.5, 10.0,
        "full scale of all converters"},
    {"inverter", "converterBits", at<kInverter, &Inverter::converterBits>, 8, 16,
        "of the current converters; left-aligned to 16"},
    {"inverter", "offset_digits", at<kInverter, &Inverter::offset_digits>, -32768.0, 32767.0,
        "of the amplifiers"},
    {"inverter", "noise_digits", at<kInverter, &Inverter::noise_digits>, 0.0, 32767.0,
        "of the current readings, to either side"},
    {"inverter", "busRange_v", at<kInverter, &Inverter::busRange_v>, 1.0, 1e4,
        "bus voltage at full scale"},
    {"inverter", "busNoise_v", at<kInverter, &Inverter::busNoise_v>, 0.0, 1e3,
        "of the measured voltage, to either side"},
    {"inverter", "ambient_c", at<kInverter, &Inverter::ambient_c>, -60.0, 150.0,
        "ambient temperature"},
    {"inverter", "heatsinkResistance_kpw", at<kInverter, &Inverter::heatsinkResistance_kpw>, 1e-3,
        1e3, "to the ambient, K/W"},
    {"inverter", "heatsinkCapacity_jpk", at<kInverter, &Inverter::heatsinkCapacity_jpk>, 0.0, 1e6,
        "J/K; 0: stays at the ambient temperature"},
    {"inverter", "heatsinkNoise_c", at<kInverter, &Inverter::heatsinkNoise_c>, 0.0, 50.0,
        "of the measured temperature, to either side"},
    {"load", "constant_nm", at<kLoad, &Load::constant_nm>, -1e3, 1e3, "of a friction brake"},
    {"load", "fan_nms2", at<kLoad, &Load::fan_nms2>, 0.0, 1e3,
        "torque over the square of the speed in rad/s"},
    {"load", "drive_nm", at<kLoad, &Load::drive_nm>, -1e3, 1e3,
        "of a machine that pushes, in the sense of its sign"},
};

} // namespace

double numberAt(const ParameterInfo::Slot &slot)
{
    if (const auto *real = std::get_if<double *>(&slot))
        return **real;
    if (const auto *whole = std::get_if<int *>(&slot))
        return **whole;
    if (const auto *text = std::get_if<std::string *>(&slot))
        return static_cast<double>((*text)->size());
    return *std::get<bool *>(slot) ? 1.0 : 0.0;
}

std::span<const ParameterInfo> parameterTable() { return kTable; }

bool withinBounds(const ParameterInfo &info, const PlantParameters &parameters)
{
    PlantParameters copy = parameters;
    const double value = numberAt(info.slot(copy));
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

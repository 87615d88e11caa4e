// The builds of the profiles.
#include "simulation/firmware/build.h"

#include "simulation/plant/presets.h"

#include <array>

namespace simulation {

namespace {

/// The sensors of a motor come into the loop, the observer stays beside them to be compared.
void addSensors(Build &build, const PlantParameters &plant)
{
    if (plant.sensors.encoderPulses > 0) {
        build.encoder = true;
        build.mainSensor = SpeedSensor::Encoder;
        build.auxiliarySensor = SpeedSensor::ObserverPll;
    } else if (plant.sensors.hall) {
        build.hall = true;
        build.mainSensor = SpeedSensor::Hall;
        build.auxiliarySensor = SpeedSensor::ObserverPll;
    }
    constexpr double kSalient = 1.2; // Lq over Ld from which magnets are called buried
    if (plant.motor.lq_h > kSalient * plant.motor.ld_h)
        build.fluxWeakening = true;
}

/// Takes the observers out where something else closes the loops.
void leaveSensorAlone(Build &build)
{
    if (build.sensorless() || build.family != Family::Foc)
        return;
    build.observerPll = build.observerCordic = false;
    if (build.auxiliarySensor == SpeedSensor::ObserverPll
        || build.auxiliarySensor == SpeedSensor::ObserverCordic)
        build.auxiliarySensor = SpeedSensor::None;
}

} // namespace

Build buildFor(std::string_view profile, std::string_view preset)
{
    const PlantParameters *plant = preset.empty() ? nullptr : findPreset(preset);
    Build build = buildFor(profile, plant != nullptr ? *plant : presets().front().parameters);
    // The second sensorless motor compares the observers.
    if (preset == "prop12" && build.family == Family::Foc) {
        build.observerCordic = true;
        build.auxiliarySensor = SpeedSensor::ObserverCordic;
    }
    return build;
}

Build buildFor(std::string_view profile, const PlantParameters &plant)
{
    Build build;
    if (profile == "six-step") {
        build.family = Family::SixStep;
        build.mainSensor = SpeedSensor::None; // no number stands for sensing the back-EMF
        build.observerPll = false;
        build.bemfSensing = true;
    } else if (profile == "hso") {
        build.family = Family::Hso;
        build.mainSensor = SpeedSensor::Hso;
        build.observerPll = false;
    } else {
        addSensors(build, plant);
        if (profile == "mcsdk-6.2" && build.mainSensor == SpeedSensor::ObserverPll) {
            build.hall = true; // as recorded
            build.auxiliarySensor = SpeedSensor::Hall;
        }
    }
    return build;
}

std::span<const BuildOption> buildOptions()
{
    constexpr unsigned kFoc = BuildOption::kFoc, kSix = BuildOption::kSixStep,
                       kHso = BuildOption::kHso;
    using B = Build;
    static constexpr std::array kOptions{
        BuildOption{"cordic", &B::observerCordic, kFoc, "the observer with CORDIC, STOCORDIC_*"},
        BuildOption{"sensor-alone", &B::sensorAlone, kFoc,
            "no observer beside a motor's encoder or Hall sensors: no STOPLL_*, no rev-up"},
        BuildOption{"encoder", &B::encoder, kFoc, "an encoder of 1000 pulses, ENCODER_*"},
        BuildOption{"hall", &B::hall, kFoc, "Hall sensors, HALL_*"},
        BuildOption{"flux-weakening", &B::fluxWeakening, kFoc, "FLUXWK_*"},
        BuildOption{"feed-forward", &B::feedForward, kFoc, "FF_*"},
        BuildOption{"position", &B::positionControl, kFoc, "POSITION_*, with an encoder"},
        BuildOption{"open-loop", &B::openLoopDebug, kFoc | kSix, "open-loop modes, OPENLOOP_*"},
        BuildOption{"profiler", &B::profiler, kFoc | kHso, "SC_* (kept, does not run)"},
        BuildOption{"cpu-load", &B::cpuLoad, kFoc | kSix | kHso, "PERF_*"},
        BuildOption{"dac", &B::dac, kFoc | kSix | kHso, "DAC_OUT1 and DAC_OUT2"},
        BuildOption{"pfc", &B::pfc, kFoc | kSix, "PFC_*, which never work"},
        BuildOption{"ipd", &B::ipd, kSix, "initial position detection, IPD_* (kept)"},
        BuildOption{"current-monitor", &B::currentMonitor, kSix, "CURR_MONITOR* (kept)"},
        BuildOption{"zest", &B::zest, kHso, "the registers of ZeST (kept)"},
        BuildOption{"potentiometer", &B::potentiometer, kHso, "THROTTLE_* (at rest)"},
    };
    return kOptions;
}

void addOption(Build &build, const BuildOption &option)
{
    if (!option.fits(build.family))
        return;
    build.*option.member = true;
    if (option.member == &Build::sensorAlone)
        return leaveSensorAlone(build);
    if (build.zest)
        build.mainSensor = SpeedSensor::Zest;
    if (build.auxiliarySensor != SpeedSensor::None)
        return;
    const auto become = [&](bool Build::*member, SpeedSensor sensor) {
        if (option.member == member && build.mainSensor != sensor)
            build.auxiliarySensor = sensor;
    };
    become(&Build::observerCordic, SpeedSensor::ObserverCordic);
    become(&Build::encoder, SpeedSensor::Encoder);
    become(&Build::hall, SpeedSensor::Hall);
}

Build driveBehind(const Build &build)
{
    if (build.family == Family::Foc)
        return build;
    Build drive;
    drive.motors = build.motors;
    return drive;
}

} // namespace simulation

// What a firmware was built with: which sensors, options and registers its project switched on. It decides what exists;
// how the SDK of that time behaves is the profile's business (profile.h).
// Source: mcp-aspep facts 5, 7 and 8 (register families, FOCFW_CONFIG); the recorded builds.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace simulation {

struct PlantParameters;

/// Which register map and which datalog a board has.
enum class Family : std::uint8_t { Foc, SixStep, Hso };

/// Speed sensors as FOCFW_CONFIG numbers them.
enum class SpeedSensor : std::uint8_t {
    None = 0,
    ObserverPll = 1,
    ObserverCordic = 2,
    Encoder = 3,
    Hall = 4,
    Hso = 5,
    Zest = 6,
};

struct Build {
    Family family = Family::Foc;
    SpeedSensor mainSensor = SpeedSensor::ObserverPll; ///< closes the loops in RUN
    SpeedSensor auxiliarySensor = SpeedSensor::None; ///< runs beside it and can be looked at
    int motors = 1; ///< 1 or 2

    // What is compiled in; each has registers.
    bool observerPll = true;
    bool observerCordic = false;
    bool sensorAlone = false; ///< no observer beside an encoder or Hall sensors
    bool encoder = false;
    bool hall = false;
    bool fluxWeakening = false;
    bool feedForward = false;
    bool mtpa = false;
    bool positionControl = false;
    bool openLoopDebug = false; ///< CONTROL_MODE takes the open-loop modes, FOC_VQREF exists
    bool profiler = false; ///< SC_* and the bus thresholds
    bool cpuLoad = false; ///< PERF_*
    bool dac = false; ///< DAC_OUT*
    bool pfc = false; ///< PFC_*, which never work

    // Six-step only.
    bool bemfSensing = false; ///< sensorless by ADC: rev-up, BEMF_ADC_CONF
    bool ipd = false; ///< initial position detection
    bool currentMonitor = false;

    // HSO only.
    bool zest = false;
    bool potentiometer = false;

    constexpr bool sixStep() const { return family == Family::SixStep; }
    constexpr bool hso() const { return family == Family::Hso; }
    /// Starts with a rev-up: no sensor knows the angle at rest.
    constexpr bool sensorless() const
    {
        return mainSensor == SpeedSensor::ObserverPll || mainSensor == SpeedSensor::ObserverCordic
            || hso();
    }
    bool operator==(const Build &) const = default;
};

/// The build of a profile for a motor of the presets ("": the first): what its sensors and its saliency ask for.
/// Unknown names give the plain observer build.
Build buildFor(std::string_view profile, std::string_view preset);
Build buildFor(std::string_view profile, const PlantParameters &plant);

/// What can be switched on beside that; the names are for command lines.
struct BuildOption {
    static constexpr unsigned kFoc = 1, kSixStep = 2, kHso = 4;
    std::string_view name;
    bool Build::*member;
    unsigned families; ///< that know it: the bits above
    std::string_view help; ///< what it brings, without a full stop

    constexpr bool fits(Family family) const
    {
        return (families >> static_cast<unsigned>(family) & 1U) != 0;
    }
};
std::span<const BuildOption> buildOptions();
/// Switches one on that the family knows; a sensor becomes the auxiliary one if there is none.
void addOption(Build &build, const BuildOption &option);

/// The FOC build that turns the motor behind any family: six-step and HSO boards show its signals as their own.
Build driveBehind(const Build &build);

} // namespace simulation

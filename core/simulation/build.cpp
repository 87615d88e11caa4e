// The builds of the profiles.
#include "simulation/build.h"

namespace simulation {

Build buildFor(std::string_view profile, std::string_view)
{
    Build build;
    if (profile == "six-step") {
        build.family = Family::SixStep;
        build.observerPll = false;
        build.bemfSensing = true;
    } else if (profile == "hso") {
        build.family = Family::Hso;
        build.mainSensor = SpeedSensor::Hso;
        build.observerPll = false;
    } else if (profile == "mcsdk-6.2") { // as recorded
        build.hall = true;
        build.auxiliarySensor = SpeedSensor::Hall;
    }
    return build;
}

} // namespace simulation

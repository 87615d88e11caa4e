#include "motor/current_scale.h"

#include <cmath>

namespace motor {

double fullScaleCurrent_a(const CurrentSensing &sensing)
{
    if (!(sensing.shunt_ohm > 0.0) || !(sensing.gain > 0.0) || !(sensing.reference_v > 0.0))
        return 0.0;
    const double amps = sensing.reference_v / (2.0 * sensing.shunt_ohm * sensing.gain);
    return std::isfinite(amps) ? amps : 0.0;
}

} // namespace motor

// What a board says of its motor, as the plant of a gain plan.
#pragma once

#include "drive/motor_view.h"
#include "motor/gain_plan.h"

namespace drive {

motor::GainPlant gainPlant(const MotorFacts &facts);

} // namespace drive

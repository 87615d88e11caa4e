// What a board says of its motor, as the plant of a gain plan.
#pragma once

#include "analysis/gain_plan.h"
#include "drive/motor_view.h"

namespace tuning {

analysis::GainPlant gainPlant(const drive::MotorFacts &facts);

} // namespace tuning

// What a person is asked before a series of steps: the plan in words and as a picture, with the caps that the motor is held
// to.
#pragma once

#include "lab/experiment.h"
#include "widgets/base/confirmation.h"
#include "widgets/lab/plan_picture.h"

#include <optional>

namespace widgets {

/// Where the motor is before a series.
struct MotorBefore {
    bool runs = false;
    double rpm = 0.0; ///< its set-point; 0 where it rests
};

SpeedPlan speedPlan(const lab::Experiment &experiment, const MotorBefore &before);
/// @param experiment  of a lab::StepPlan
Confirmation stepQuestion(const lab::Experiment &experiment, const MotorBefore &before);

} // namespace widgets

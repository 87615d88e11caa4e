// What the user is asked before a motor moves by itself: what is to be done, in words and as a picture, with the caps
// that the motor is held to.
#pragma once

#include "lab/experiment.h"
#include "widgets/base/confirmation.h"
#include "widgets/lab/plan_picture.h"

#include <vector>

namespace widgets {

/// Where the motor is before.
struct MotorBefore {
    bool runs = false;
    double rpm = 0.0; ///< its set-point; 0 where it rests
};

/// With its unit.
QString rpmText(double rpm);
/// A few words: "Inertia and friction".
QString experimentName(const lab::Experiment &experiment);
/// How long it takes, with its start and its way back, as far as that can be known.
std::chrono::milliseconds usualLength(const lab::Experiment &experiment, const MotorBefore &before);

/// One experiment after the other.
SpeedPlan speedPlan(const std::vector<lab::Experiment> &experiments, const MotorBefore &before);
/// @param experiments  at least one, of one motor
Confirmation planQuestion(
    const std::vector<lab::Experiment> &experiments, const MotorBefore &before);

} // namespace widgets

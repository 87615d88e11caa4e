// Shows the questions of a MotionGate on top of a window.
#pragma once

#include "widgets/control/motion_gate.h"

class QWidget;

namespace widgets {

/// From now on every question of the gate is asked on top of `parent`, and goes when it is withdrawn.
void showMotionQuestions(MotionGate &gate, Device &device, QWidget *parent);

/// Asks, with a word to be typed, whether a motor may be moved although its board does not tell all limits.
void askForExpert(Device &device, int motor, QWidget *parent);

} // namespace widgets

// Shows the questions of a MotionGate on top of a window.
#pragma once

#include "widgets/motion_gate.h"

class QWidget;

namespace widgets {

/// From now on every question of the gate is asked on top of `parent`, and goes when it is withdrawn.
void showMotionQuestions(MotionGate &gate, QWidget *parent);

} // namespace widgets

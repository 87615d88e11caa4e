// Whether a motor can be asked to move now, and the reason if not: one rule for every panel that has such a button.
#pragma once

#include "widgets/base/device.h"

#include <QString>

namespace widgets {

struct MotionAllowed {
    bool yes = false;
    QString why; ///< if not, for a tool tip; plain text
};

/// Connected, and there is something that arming would allow.
MotionAllowed armAllowed(const Device &device);
/// Connected, available on this board, armed.
MotionAllowed motionAllowed(const Device &device, drive::Feature feature);
/// The same for the motor that is shown, in the state it is in.
MotionAllowed startAllowed(const Device &device);
MotionAllowed acknowledgeAllowed(const Device &device);

} // namespace widgets

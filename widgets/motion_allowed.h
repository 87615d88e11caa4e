// Whether a motor can be asked to move now, and the reason if not: one rule for every panel that has such a button.
#pragma once

#include "widgets/device.h"

#include <QString>

namespace widgets {

struct MotionAllowed {
    bool yes = false;
    QString why; ///< if not, for a tool tip; plain text
};

/// Connected, available on this board, armed.
MotionAllowed motionAllowed(const Device &device, drive::Feature feature);

} // namespace widgets

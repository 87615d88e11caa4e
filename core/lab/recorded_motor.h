// The motor of an experiment as its recording has it: the names of its signals and what its board tells of it, so that
// the file alone can be evaluated.
#pragma once

#include "lab/subject.h"
#include "recorded/entry.h"

#include <string>

namespace lab {

struct RecordedMotor {
    int motor = 0;
    /// Names of signals; empty: none.
    std::string reference, referenceD, current, currentD, voltage, voltageD, speed, speedReference,
        angle;
    double polePairs = 0.0;
    double nominalAmps = 0.0; ///< peak
    double torquePerAmp = 0.0; ///< Nm
    double saliency_h = 0.0; ///< Lq less Ld
    double speedStepRpm = 0.0;
};

void putMotor(recorded::Happening &into, const Subject &subject);
RecordedMotor recordedMotor(const recorded::Happening &from);

} // namespace lab

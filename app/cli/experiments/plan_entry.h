// A plan as the recording of its run has it, with what the board tells of the loop that it will be measured by.
#pragma once

#include "commands.h"
#include "lab/experiment.h"

namespace cli {

Outcome<record::Happening> entryOf(Desk &desk, const lab::Experiment &experiment);

/// What closes the speed loop; its gains are 0 where the board does not tell them.
Outcome<lab::SpeedRegulator> regulatorOf(Desk &desk, const lab::Subject &subject);

} // namespace cli

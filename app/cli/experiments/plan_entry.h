// A plan as the recording of its run has it, with what the board tells of the loop that it will be measured by.
#pragma once

#include "commands.h"
#include "lab/evaluation/speed_loop.h"
#include "lab/experiment.h"

namespace cli {

Outcome<recorded::Happening> entryOf(Desk &desk, const lab::Experiment &experiment);

/// What closes the speed loop; empty where the board does not tell its gains.
Outcome<std::optional<lab::SpeedLoop>> readSpeedLoop(Desk &desk, const lab::Subject &subject);

} // namespace cli

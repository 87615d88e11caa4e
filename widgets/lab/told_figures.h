// What an experiment found, where that is some numbers: for experiments without a table of their own.
#pragma once

#include "widgets/lab/experiment_bar.h"

namespace widgets {

/// Evaluates what was recorded, whatever that was, and tells each number with its interval, then what has to be known.
ExperimentBar::Evaluate tellsFigures();

} // namespace widgets

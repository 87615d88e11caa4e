// What an experiment says, as it is printed by its run and by every later evaluation of its recording: the same bytes.
#pragma once

#include "output.h"
#include "recording_work.h"

namespace cli {

/// Prints what the experiment in a recording says, and what has to be known of it on standard error.
/// @return  kDone; a failure if there is none in it, or no number came of it
Outcome<int> evaluate(const QString &path, Output &out);

} // namespace cli

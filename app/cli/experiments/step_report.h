// What a series of steps says, as it is printed by the run and by every later evaluation of its recording: the same bytes.
#pragma once

#include "lab/step_series.h"
#include "output.h"
#include "recording_work.h"

namespace cli {

/// The series in a recording; a failure if there is none in it.
Outcome<lab::StepSeries> seriesIn(const OpenedRecording &recording, const QString &path);

/// Prints it, and what has to be known of it on standard error.
/// @return  kDone; a failure if no number came of it
Outcome<int> report(const lab::StepSeries &series, Output &out);

} // namespace cli

// What an experiment says, as it is printed by its run and by every later evaluation of its recording: the same bytes.
#pragma once

#include "output.h"
#include "recording_work.h"

namespace cli {

/// Prints what the runs of a recording say, each as it did, and what has to be known of it on standard error. Where
/// there are several each has a line above it that tells which it is, or in JSON a line of its own, null where nothing
/// follows from it.
/// @param name  what sentences call the recording
/// @param number  of the only one that is meant, from 1; 0: all
/// @return  kDone; a failure if there is none, not of each a number came, or something is missing from the recording
Outcome<int> evaluate(const QString &path, const QString &name, Output &out, int number = 0);

} // namespace cli

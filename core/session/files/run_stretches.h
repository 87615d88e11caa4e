// A recording as runs of a run book: one for each stretch in which its gains stayed as they were, with its part of the
// recording and the registers that the recording has, with these gains. A stretch with several experiments is parted
// where each but the first begins; none is parted itself.
#pragma once

#include "session/files/run.h"

#include <functional>
#include <vector>

namespace session {

struct KeptStretches {
    std::vector<Run> runs;
    int leftOut = 0; ///< shorter than kLeastStretch_s, or more than kMostStretches
};
constexpr double kLeastStretch_s = 1.0;
constexpr std::size_t kMostStretches = 200;

/// What was kept until something went wrong stays.
/// @param proceed  as readRecording() has it; cancelled, nothing more is kept
/// @return  or why nothing was kept
Result<KeptStretches, QString> keepStretches(const QString &folder, const QString &recording,
    const std::function<bool(double)> &proceed = {});

} // namespace session

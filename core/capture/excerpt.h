// Excerpt: a stretch of a capture as a capture of its own, which stays when the other lets go of its samples.
#pragma once

#include "capture/capture.h"

namespace capture {

/// The samples in [from, to) of all channels that have any there, in their order. They have their names and units, not
/// their registers; gaps stay gaps. Cost: a search and 24 bytes a sample.
Capture excerptOf(const Capture &capture, Nanos from, Nanos to);

} // namespace capture

// Traces of another time, drawn paler behind those of now: a reference that was kept, or records shown before.
#pragma once

#include "capture/capture.h"

namespace widgets {

struct Ghost {
    capture::Snapshot kept; ///< nullptr: from the recording itself
    double shift = 0.0; ///< seconds to add to the picture's time to get the ghost's
    int alpha = 110; ///< of 255
};

} // namespace widgets

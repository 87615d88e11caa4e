// Traces of another time, drawn paler behind those of now: a reference that was kept, or records shown before.
#pragma once

#include "capture/capture.h"

namespace widgets {

/// Traces that a person keeps to compare with.
enum class Reference : std::uint8_t { A, B };

struct Ghost {
    capture::Snapshot kept; ///< nullptr: from the recording itself
    double shift = 0.0; ///< seconds to add to the picture's time to get the ghost's
    int alpha = 110; ///< of 255
    char mark = 0; ///< the letter of a reference, which is dashed; 0: an earlier record
};

} // namespace widgets

// Batch: what a session tells at one go. A complete value that may cross threads.
#pragma once

#include "drive/event.h"

#include <memory>
#include <vector>

namespace session {

/// What happened, in order.
struct Batch {
    std::vector<drive::Event> events;
    std::uint64_t droppedForDisplay =
        0; ///< samples since the session began that only the display did not get
};
using BatchPtr = std::shared_ptr<const Batch>;

} // namespace session

// Where the trigger stands in the picture: its levels on the trace that is watched, and its time.
#pragma once

#include "capture/channel.h"

#include <optional>
#include <vector>

namespace widgets {

struct TriggerMarks {
    capture::ChannelId source = 0;
    std::vector<double> levels; ///< in the source's unit; empty: no level is waited for
    std::optional<double> position; ///< seconds on the session's axis; empty: the picture rolls
    bool operator==(const TriggerMarks &) const = default;
};

} // namespace widgets

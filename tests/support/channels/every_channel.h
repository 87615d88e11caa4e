// All channels of a capture, as an export takes them.
#pragma once

#include "capture/capture.h"

#include <vector>

namespace support {

inline capture::Snapshot everyChannel(const capture::Capture &capture)
{
    std::vector<capture::ChannelId> ids;
    for (const capture::ChannelInfo &info : capture.channels())
        ids.push_back(info.id);
    return capture.snapshot(ids);
}

} // namespace support

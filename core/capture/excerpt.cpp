#include "capture/excerpt.h"

#include <algorithm>

namespace capture {

Capture excerptOf(const Capture &capture, Nanos from, Nanos to)
{
    Capture excerpt;
    for (const ChannelInfo &info : capture.channels()) {
        const Channel &channel = *capture.channel(info.id);
        const Index first = channel.atOrAfter(from), end = channel.atOrAfter(to);
        if (first >= end)
            continue;
        const ChannelId copy = excerpt.addImported(info.name, info.unit);
        for (Index at = first; at < end; ++at) {
            if (at > first && channel.holdUntil(at - 1) < channel.timeOf(at))
                excerpt.breakImported(copy);
            excerpt.appendImported(
                copy, channel.timeOf(at), channel.at(at), std::min(channel.holdUntil(at), to));
        }
    }
    return excerpt;
}

} // namespace capture

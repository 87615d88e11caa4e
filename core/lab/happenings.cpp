#include "lab/happenings.h"

namespace lab {

const capture::Channel *fastChannel(const capture::Capture &capture, const std::string &name)
{
    if (name.empty())
        return nullptr;
    for (const capture::ChannelInfo &info : capture.channels())
        if (info.name == name && info.kind == capture::ChannelInfo::Kind::Fast)
            return capture.channel(info.id);
    return nullptr;
}

} // namespace lab

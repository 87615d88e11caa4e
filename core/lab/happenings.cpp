#include "lab/happenings.h"

#include "lab/fields.h"

namespace lab {

bool endsLink(const record::Happening &what)
{
    const std::string state = what.name == "link" ? fieldOf(what, "state") : std::string();
    return state == "closed" || state == "lost";
}

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

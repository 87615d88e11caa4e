#include "lab/happenings.h"

#include "lab/experiment.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lab {

std::optional<double> numberOf(const recorded::Happening &happening, std::string_view key)
{
    constexpr double kMost = 1e9;
    const auto value = happening.number<double>(key);
    return value && std::isfinite(*value) && std::abs(*value) < kMost ? value : std::nullopt;
}

bool endsLink(const recorded::Happening &what)
{
    const std::string state = what.name == "link" ? what.field("state") : std::string();
    return state == "closed" || state == "lost";
}

Happenings carriedOut(const Happenings &all)
{
    const auto movedNothing = [](const recorded::Happening &what) {
        const std::string outcome = what.field("outcome");
        return outcome == "not sent" || outcome == "refused";
    };
    Happenings carried;
    std::map<std::string, bool> idle; // by wish: whether the next one of that number moved nothing
    for (auto at = all.rbegin(); at != all.rend(); ++at) {
        const recorded::Happening &what = at->second;
        const auto wish = idle.find(what.field("wish"));
        if (what.name == "ended")
            idle[what.field("wish")] = movedNothing(what);
        else if (wish != idle.end() ? wish->second : what.name == "motion" && movedNothing(what))
            continue;
        carried.push_back(*at);
    }
    std::reverse(carried.begin(), carried.end());
    return carried;
}

namespace {

/// @param unit  empty: any
const capture::Channel *channelOf(const capture::Capture &capture, const std::string &name,
    capture::ChannelInfo::Kind kind, std::string_view unit = {})
{
    if (name.empty())
        return nullptr;
    for (const capture::ChannelInfo &info : capture.channels())
        if (info.name == name && info.kind == kind && (unit.empty() || info.unit == unit))
            return capture.channel(info.id);
    return nullptr;
}

} // namespace

const capture::Channel *fastChannel(const capture::Capture &capture, const std::string &name)
{
    return channelOf(capture, name, capture::ChannelInfo::Kind::Fast);
}

const capture::Channel *polledChannel(
    const capture::Capture &capture, const std::string &name, std::string_view unit)
{
    using Kind = capture::ChannelInfo::Kind;
    // Of what comes with each exchange some may have been read besides, a few times a second.
    const capture::Channel *exchanged = channelOf(capture, name, Kind::Slow, unit);
    return exchanged != nullptr ? exchanged : channelOf(capture, name, Kind::Polled, unit);
}

bool drivesByTorque(const recorded::Happening &what)
{
    return what.name == "torque ramp" || what.name == "current reference";
}

bool setsSpeedAtOnce(const recorded::Happening &what)
{
    return what.name == "speed ramp" && numberOf(what, "ms") == 0.0;
}

std::optional<DrivenSpan> drivenSpan(int motor, Happenings::const_iterator at,
    Happenings::const_iterator end, Nanos last,
    const std::function<bool(const recorded::Happening &)> &drives)
{
    std::optional<DrivenSpan> span;
    for (; at != end; ++at) {
        const auto &[time, what] = *at;
        if (drives(what) && numberOf(what, "motor") == motor) {
            if (!span)
                span = DrivenSpan{time, last, false, {}};
        } else if (what.name == "speed ramp" || what.name == "command" || what.name == "stop"
            || endsLink(what)) {
            if (span)
                span->to = std::min(span->to, time);
        } else if (what.name == kEndEntry) {
            if (span) {
                span->to = std::min(span->to, time);
                span->over = true;
                span->reason =
                    what.field("outcome") == "complete" ? std::string() : what.field("reason");
            }
            break;
        }
    }
    return span;
}

void noteEnd(std::vector<std::string> &notes, bool over, const std::string &reason)
{
    if (!over)
        notes.emplace_back("the recording ends before the experiment does");
    else if (!reason.empty())
        notes.push_back("the run ended early: " + reason);
}

} // namespace lab

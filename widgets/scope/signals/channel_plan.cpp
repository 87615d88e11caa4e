#include "widgets/scope/signals/channel_plan.h"

#include <algorithm>
#include <bit>

namespace widgets {
namespace {

constexpr double kPacketOverhead = 10.0; // header, time stamp, mark
constexpr double kPacketsPerSecondAtLeast = 84.0; // a packet holds at most 12 ms
constexpr unsigned kSlowestFast = 256;
constexpr double kFastBytes = 2.0, kWidestBytes = 4.0;

bool streamable(const catalog::RegisterInfo *info)
{
    return info && info->streaming != catalog::Streaming::Polled;
}

bool inFrames(const drive::StreamLimits &limits) { return limits.frameOverhead > 0; }

/// Packets a second for so many bytes of samples: as large as allowed, but never older than a packet may get. Or a
/// frame every period.
double packetsPerSecond(double bytes, unsigned fastEvery, const drive::StreamLimits &limits)
{
    if (inFrames(limits))
        return limits.tickHz / std::max(1U, fastEvery);
    const double room = std::max(32.0, static_cast<double>(limits.maxPacket) - kPacketOverhead);
    return std::max(bytes / room, kPacketsPerSecondAtLeast);
}

double framed(double bytes, unsigned fastEvery, const drive::StreamLimits &limits)
{
    const double around =
        inFrames(limits) ? static_cast<double>(limits.frameOverhead) : kPacketOverhead;
    return bytes + around * packetsPerSecond(bytes, fastEvery, limits);
}

/// Of the link, for the stream. Where requests travel in its frames nothing has to be left for them.
double budgetOf(const drive::StreamLimits &limits)
{
    return limits.linkBytesPerSecond * (inFrames(limits) ? 1.0 : kStreamShare);
}

/// How many fast signals fit beside nothing else, at every control period.
unsigned fullRateSignals(const drive::StreamLimits &limits)
{
    const double each = inFrames(limits) ? kWidestBytes : kFastBytes;
    unsigned fit = 0;
    while (fit < limits.maxSignals
        && framed(each * (fit + 1) * limits.tickHz, 1, limits) <= budgetOf(limits))
        ++fit;
    return fit;
}

/// Without what frames them.
double sampleBytesPerSecond(
    const drive::Stream &stream, const catalog::Catalog &catalog, const drive::StreamLimits &limits)
{
    const double blockHz = limits.tickHz / std::max(1U, stream.fastEvery);
    const auto widthOf = [&catalog](catalog::RegisterId id) {
        const catalog::RegisterInfo *info = catalog.find(id);
        return info ? static_cast<double>(catalog::widthOf(info->type)) : kWidestBytes;
    };
    const unsigned slowEvery = inFrames(limits) ? 1 : std::max(1U, stream.slowEvery);
    double bytes = 0.0;
    for (const catalog::RegisterId id : stream.fast)
        bytes += blockHz * (inFrames(limits) ? widthOf(id) : kFastBytes);
    for (const catalog::RegisterId id : stream.slow)
        bytes += blockHz * widthOf(id) / slowEvery;
    return bytes;
}

} // namespace

double streamBytesPerSecond(
    const drive::Stream &stream, const catalog::Catalog &catalog, const drive::StreamLimits &limits)
{
    if (stream.fast.empty() && stream.slow.empty())
        return 0.0;
    return framed(sampleBytesPerSecond(stream, catalog, limits), stream.fastEvery, limits);
}

ChannelPlan planChannels(std::span<const WantedSignal> wanted, const catalog::Catalog &catalog,
    const drive::StreamLimits &limits, unsigned fastEvery)
{
    ChannelPlan plan;
    plan.stream.slowEvery = kSlowEvery;
    const bool streams = limits.tickHz > 0.0 && limits.maxSignals > 0;
    for (const WantedSignal &signal : wanted) {
        PlannedSignal planned{signal.id, signal.route, Detour::None};
        const std::size_t used = plan.stream.fast.size() + plan.stream.slow.size();
        if (signal.route != Route::Polled && (!streams || !streamable(catalog.find(signal.id))))
            planned = {signal.id, Route::Polled, Detour::NotStreamable};
        else if (signal.route != Route::Polled && used >= limits.maxSignals)
            planned = {signal.id, Route::Polled, Detour::TooManySignals};
        if (planned.route == Route::Fast)
            plan.stream.fast.push_back(signal.id);
        else if (planned.route == Route::Slow)
            plan.stream.slow.push_back(signal.id);
        else
            plan.polled.push_back(signal.id);
        plan.signalList.push_back(planned);
    }

    const double budget = budgetOf(limits);
    const auto need = [&] { return streamBytesPerSecond(plan.stream, catalog, limits); };
    plan.stream.fastEvery = std::clamp(fastEvery, 1U, kSlowestFast);
    plan.fullRateBytes = need();
    plan.fitAtFullRate = streams ? fullRateSignals(limits) : 0;
    if (limits.linkBytesPerSecond > 0.0) {
        while (need() > budget && plan.stream.fastEvery < kSlowestFast) {
            plan.stream.fastEvery =
                std::min(kSlowestFast, std::bit_ceil(plan.stream.fastEvery + 1));
            plan.rateLowered = true;
        }
        // A very slow link: the last ones are read one by one.
        while (need() > budget && !plan.stream.fast.empty()) {
            const catalog::RegisterId last = plan.stream.fast.back();
            plan.stream.fast.pop_back();
            plan.polled.push_back(last);
            for (PlannedSignal &planned : plan.signalList)
                if (planned.id == last)
                    planned = {last, Route::Polled, Detour::LinkFull};
        }
        plan.share = need() / limits.linkBytesPerSecond;
    }
    plan.bytesPerSecond = need();
    if (plan.bytesPerSecond > 0.0) {
        const double bytes = sampleBytesPerSecond(plan.stream, catalog, limits);
        plan.packetSeconds = 1.0 / packetsPerSecond(bytes, plan.stream.fastEvery, limits);
    }
    plan.fastHz = plan.stream.fast.empty() ? 0.0 : limits.tickHz / plan.stream.fastEvery;
    return plan;
}

} // namespace widgets

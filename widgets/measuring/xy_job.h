// One XY picture as a job for another thread: what is wanted, from a copy of the samples, and what came out.
#pragma once

#include "capture/capture.h"
#include "scope/xy.h"

namespace widgets {

struct XyWanted {
    capture::ChannelId x = 0;
    capture::ChannelId y = 0;
    /// X and y are the currents of phases A and B; wanted are alpha and beta, as the board counts them.
    bool clarke = false;
    capture::Nanos from = 0;
    capture::Nanos to = 0;
    std::uint64_t samples = 0; ///< of both in it: more of them are another picture
    std::size_t most = 20'000; ///< points
    bool operator==(const XyWanted &) const = default;
};

struct XyAnswer {
    XyWanted wanted;
    scope::XyTrace trace;
    bool cut = false; ///< only the newest kMostXySamples were read
};

inline constexpr std::uint64_t kMostXySamples = 1'000'000;

/// @param copy  the two channels, x first
XyAnswer computeXy(const capture::Snapshot &copy, const XyWanted &wanted);

} // namespace widgets

// The phase between two channels of the same frequency: that of their fundamentals, so that harmonics and noise hardly
// matter. Each may have its own ticks.
#pragma once

#include "capture/channel.h"
#include "scope/measurement.h"

namespace scope {

/// @return  degrees in (-180, 180] by which `second` is ahead of `first`
/// The frequency is that of `first` (measurer.h); whole periods of it are read with a Hann window. NoFullPeriod if
/// there are fewer than two, OtherFrequency if `second` has one that differs by more than 2 %, or has no part at it.
/// Error for sines: below 0.1 degree from 3 periods of 20 samples on; noise of 10 % of the amplitude adds less than
/// 0.5 degree at 1000 samples.
Measurement measurePhase(
    const capture::Channel &first, const capture::Channel &second, Nanos from, Nanos to);

} // namespace scope

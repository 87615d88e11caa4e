// Automatic measurements of one channel in a range of time. What several of them need is found once.
//
//   min, max, peak to peak, mean, rms   of all samples in the range; a gap only makes them partial
//   frequency, period   mean over the whole periods: upward crossings of the middle level, with 20 % hysteresis
//   duty                share of those periods above the middle level
//   cycle mean, rms     over those periods
//   rise, fall          10 to 90 % between base and top (edges.h), the first complete one
// With a step (StepSettings) rise, fall and all that is about steps follow step_response.h.
#pragma once

#include "scope/edges.h"
#include "scope/measurement.h"
#include "scope/step_response.h"

namespace scope {

class Measurer {
public:
    /// @param channel  outlives this, and does not change meanwhile
    /// @param step     if the range shows the answer to a step
    Measurer(const capture::Channel &channel, Nanos from, Nanos to,
        const std::optional<StepSettings> &step = std::nullopt);

    /// Anything but Phase, which needs two channels (phase.h).
    /// Cost: extremes read the envelope; everything else reads the samples, the first time it is asked for.
    Measurement measure(Quantity quantity);

private:
    void extremes(Measurement &result) const;
    void moments(Measurement &result, const SampleRange &range) const;
    void cycles(Measurement &result);
    void duty(Measurement &result);
    void transition(Measurement &result);
    std::optional<WhyNot> findPeriods();
    const std::optional<SignalLevels> &levels();

    SampleRange m_range;
    std::optional<StepResponse> m_step;
    bool m_levelsKnown = false;
    std::optional<SignalLevels> m_levels;
    bool m_crossingsKnown = false;
    Crossings m_crossings;
};

} // namespace scope

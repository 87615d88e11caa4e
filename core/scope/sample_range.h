// The samples of a channel in [from, to), read without copying them: extremes with their places, moments, and one
// visitor for everything else. Times inside are seconds since `from`.
#pragma once

#include "capture/channel.h"
#include "scope/trigger_condition.h"

namespace scope {

class SampleRange {
public:
    /// @param channel  outlives this, and does not change meanwhile
    SampleRange(const capture::Channel &channel, Nanos from, Nanos to);

    const capture::Channel &channel() const { return m_channel; }
    Nanos from() const { return m_from; }
    Nanos to() const { return m_to; }
    Index begin() const { return m_begin; }
    Index end() const { return m_end; }
    bool empty() const { return m_begin >= m_end; }
    Between between() const { return betweenSamples(m_channel.info()); }

    /// Something is missing between two of the samples.
    bool gapInside() const;

    struct Extremes {
        double min = 0.0; ///< in the channel's unit
        double max = 0.0;
        Index minAt = 0; ///< the first sample with that value
        Index maxAt = 0;
    };
    /// Exact. Not on an empty range. Cost: one read for 256 fast samples or 64 others.
    Extremes extremes() const;

    struct Moments {
        double mean = 0.0;
        double rms = 0.0;
        double deviation = 0.0; ///< rms of what is left without the mean
    };
    /// Fast samples weigh the same; a value that holds weighs as long as it holds inside the range, also one from
    /// before it. Nothing is assumed in gaps. Fast samples are summed as integers, so without rounding.
    /// nullopt if nothing is known anywhere in the range.
    std::optional<Moments> moments() const;

    /// Calls visit(seconds since from, value, joined) for every sample, oldest first; `joined` is false for the first
    /// one and behind each gap.
    template <class Visit>
    void visit(Visit visit) const;

    Nanos toNanos(double seconds) const { return m_from + capture::toNanos(seconds); }
    double secondsOf(Index index) const
    {
        return capture::toSeconds(m_channel.timeOf(index) - m_from);
    }

private:
    std::optional<Moments> fastMoments() const;
    std::optional<Moments> heldMoments() const;

    const capture::Channel &m_channel;
    Nanos m_from;
    Nanos m_to;
    Index m_begin;
    Index m_end;
};

template <class Visit>
void SampleRange::visit(Visit visit) const
{
    if (const capture::FastColumn *column = m_channel.fast()) {
        for (Index at = m_begin; at < m_end;) {
            const capture::Segment &segment = column->segments()[column->pieceOf(at)];
            const Index stop = std::min(m_end, segment.end());
            const double start = capture::toSeconds(segment.timeOf(at) - m_from);
            const double step = segment.stepNanos() / capture::kNanosPerSecond;
            const Index first = at;
            while (at < stop) {
                for (const std::int16_t code :
                    column->codes(at, static_cast<std::size_t>(stop - at))) {
                    const double seconds = start + static_cast<double>(at - first) * step;
                    visit(seconds, m_channel.toShown(code), at != first);
                    ++at;
                }
            }
        }
        return;
    }
    const capture::ValueColumn &column = *m_channel.values();
    for (Index at = m_begin; at < m_end;) {
        const capture::Run &run = column.runs()[column.pieceOf(at)];
        const Index stop = std::min(m_end, run.end());
        for (const Index first = at; at < stop; ++at)
            visit(secondsOf(at), m_channel.at(at), at != first);
    }
}

} // namespace scope

// Samples that are lost in the middle of an experiment, and the sentence that has to say so.
#pragma once

#include "base/text.h"
#include "support/lab_bench.h"

namespace lab {

class LostSamples {
public:
    /// @param bench  not begun yet. @param after  from now on until they are lost
    LostSamples(support::LabBench &bench, Duration after, Duration length)
        : m_from(bench.pair.now + after)
        , m_to(m_from + length)
    {
        bench.loses = [this, &bench](const recorded::Entry &entry) {
            const auto *layout = std::get_if<capture::StreamLayout>(&entry);
            if (layout != nullptr && !layout->empty())
                m_step_s = layout->fastStep / layout->tickHz;
            const auto *block = std::get_if<capture::SampleBlock>(&entry);
            const bool lost = block != nullptr && bench.pair.now >= m_from && bench.pair.now < m_to;
            m_lost_s += lost ? block->count * m_step_s : 0.0;
            return lost;
        };
    }
    LostSamples(const LostSamples &) = delete;
    LostSamples &operator=(const LostSamples &) = delete;

    bool saidIn(const std::vector<std::string> &notes) const
    {
        const std::string wanted = "samples of " + decimalText(m_lost_s, 2)
            + " s are missing in it: only what is without a gap counts";
        return m_lost_s > 0.0 && std::find(notes.begin(), notes.end(), wanted) != notes.end();
    }

private:
    TimePoint m_from, m_to;
    double m_step_s = 0.0;
    double m_lost_s = 0.0;
};

/// What is found of the bench's plan when 400 ms of its samples are lost. A failure as well where it does not come to
/// its end, or where the loss is not said.
/// @param after  from its beginning until then
template <class Evaluate>
auto foundWithAGap(support::LabBench &bench, Duration after, Evaluate evaluate)
    -> decltype(evaluate(bench.capture, bench.happenings))
{
    const LostSamples lost(bench, after, std::chrono::milliseconds(400));
    const Outcome outcome = bench.run();
    bench.loses = nullptr;
    if (outcome.end != End::Complete)
        return fail(support::outcomeText(outcome).toStdString());
    auto found = evaluate(bench.capture, bench.happenings);
    if (found && !lost.saidIn(found->notes))
        return fail(std::string("the loss is not said"));
    return found;
}

} // namespace lab

// Finds where a channel fulfils a trigger condition, in the order of time, and goes on where it stopped when more
// samples have arrived: the hits do not depend on how they arrived. It passes over blocks whose extremes show that
// nothing can happen in them. No clock, no records: acquisition.h makes those.
//
// Call order: next() until it finds nothing more; again when the channel has grown. One channel a search: if the
// channel is replaced (Capture::clear), make a new search.
#pragma once

#include "scope/trigger_condition.h"

#include <functional>
#include <limits>
#include <memory>

namespace scope {

struct TriggerHit {
    Nanos time = 0; ///< on the session's axis, between two samples if values are joined by lines
    Index sample = 0; ///< the one at or after `time` that decided it
    double fraction = 1.0; ///< where between the sample before (0) and that one (1)
    bool operator==(const TriggerHit &) const = default;
};

class TriggerSearch {
public:
    /// @param condition  one that check() finds nothing wrong with; an EventTrigger never hits
    /// @param from       the first sample to look at; nothing is known before it
    explicit TriggerSearch(TriggerCondition condition, Index from = 0);
    TriggerSearch(TriggerSearch &&) noexcept;
    TriggerSearch &operator=(TriggerSearch &&) noexcept;
    ~TriggerSearch();

    /// The next hit at or after `notBefore`; nullopt if there is none among the samples so far. Earlier ones are passed
    /// over and do not come again. Samples released before they were searched are a gap. Cost: one read for 256 samples
    /// where the value stays clear of the levels, else masks of sixteen samples, and a step for each sample that
    /// changes what is waited for.
    /// @param until  looks at no sample from there on
    std::optional<TriggerHit> next(const capture::Channel &channel, Nanos notBefore,
        Index until = std::numeric_limits<Index>::max());

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// The first place at or after `from` where a channel that is recorded fulfils a condition, as one search from the
/// beginning would find it. What was before counts for a million samples.
/// @param proceed  told 0..1 now and then; false ends the search without a hit
std::optional<TriggerHit> findTrigger(const capture::Channel &channel,
    const TriggerCondition &condition, Nanos from, const std::function<bool(double)> &proceed,
    Index atOnce = Index{1} << 20);

} // namespace scope

// The values of a channel that is computed from others by a formula, as they grow. The caller keeps them in a
// column like any other: drawn, measured, searched for triggers, and an input of further formulas.
//
// It has a value at each sample of its clock, the fastest kind among its inputs (the first of them; among values the
// one whose first samples are closest). The other inputs are worth what their sample before says (previous-sample
// hold). Where one of them is not known, or the result is no finite number, there is a gap; it also restarts the
// functions with a memory.
//
// Call order: update() whenever the inputs have grown, then results(). They do not depend on how often, as long as
// `until` keeps its word: no input will get a sample before it any more.
#pragma once

#include "capture/channel.h"
#include "scope/formula.h"

#include <limits>

namespace scope {

using capture::Index;
using capture::Nanos;

/// In order, in pieces without a gap between their values.
struct MathResults {
    struct Piece {
        std::size_t count = 0;
        Nanos holdUntil = 0; ///< of the last one, if nothing follows
        bool begins = true; ///< there is a gap before it
    };
    std::vector<Nanos> times;
    std::vector<double> values; ///< as many
    std::vector<Piece> pieces;
};

class MathChannel {
public:
    explicit MathChannel(Formula formula);

    const Formula &formula() const { return m_formula; }
    const MathResults &results() const { return m_results; } ///< of the last update()

    /// Computes what has become known.
    /// @param inputs  the channels of formula().used(), in that order; the same ones at each call
    /// @param until   nothing before it is missing any more; see settledUntil()
    /// @param most    instants at most, to come back later for the rest
    /// @return        true if there is a rest
    bool update(std::span<const capture::Channel *const> inputs, Nanos until,
        std::size_t most = std::numeric_limits<std::size_t>::max());

private:
    struct Input {
        Index next = 0; ///< first sample after the instant
        double value = 0.0;
        Nanos holdUntil = 0;
        bool wasLast = true; ///< nothing came after it yet
    };
    void chooseClock(std::span<const capture::Channel *const> inputs);
    bool readInputs(std::span<const capture::Channel *const> inputs, Nanos time);
    void put(Nanos time, double value, Nanos holdUntil, bool joined);
    void compute(std::span<const capture::Channel *const> inputs, const capture::Channel &clock);
    std::size_t together(std::span<const capture::Channel *const> inputs,
        const capture::Channel &clock, std::size_t most);
    void computeTogether(std::span<const capture::Channel *const> inputs,
        const capture::Segment &clock, std::size_t count);

    Formula m_formula;
    MathResults m_results;
    std::optional<std::size_t> m_clock;
    Index m_next = 0; ///< of the clock
    std::vector<Input> m_inputs;
    std::vector<double> m_values;
    bool m_joined = false; ///< the inputs at the next instant follow those at `m_before`
    bool m_begins = true; ///< the next result does not follow the last one
    Nanos m_before = 0;
};

/// Up to where all of these are complete, going by the samples alone. A register that is not asked for any more holds
/// it back: then `until` has to come from the caller. Nothing if there is no channel or one is empty.
std::optional<Nanos> settledUntil(std::span<const capture::Channel *const> channels);

} // namespace scope

// Measurements as a job that another thread may do: which rows of the table want what, in copies of their channels.
#pragma once

#include "capture/capture.h"
#include "scope/measurement.h"

#include <functional>
#include <optional>
#include <vector>

namespace widgets {

struct MeasureJob {
    struct Piece {
        std::uint64_t row = 0; ///< its id
        scope::Quantity quantity = scope::Quantity::Mean;
        /// Of the capture until detach(), then of `copies`.
        const capture::Channel *channel = nullptr;
        const capture::Channel *second = nullptr; ///< of a phase; none: there is nothing to measure
    };
    struct Result {
        std::uint64_t row = 0;
        scope::Measurement measured;
    };

    std::vector<Piece> pieces;
    capture::Nanos from = 0;
    capture::Nanos to = 0;
    std::optional<capture::Nanos> trigger; ///< a step is measured from there if it lies inside
    std::vector<capture::Snapshot> copies;

    void detach(const capture::Capture &capture); ///< to be done in another thread from now on
    /// @param goesOn  asked before each piece; no: what is left is not measured
    std::vector<Result> run(const std::function<bool()> &goesOn) const;
};

/// Samples that measuring it reads.
std::uint64_t samplesFor(scope::Quantity quantity, const capture::Channel &channel,
    capture::Nanos from, capture::Nanos to);

} // namespace widgets

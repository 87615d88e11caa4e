// Linear least squares of a few unknowns over many rows, with rows that stand apart left out. Pure.
//
// A column that is known with errors of its own would be told too small: the noise counts as if it had moved the motor.
// Another one that moves with it and has none of these errors, its instrument, takes its place on one side of the
// equations then.
//
// Errors are those of rows that hang together in clusters: what disturbs a motor lasts longer than from one row to the
// next, and rows that are not independent would promise too much. Source: C. Cameron and D. Miller, J. Human Resources
// 50 (2015).
#pragma once

#include "lab/maths/statistics.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace lab {

/// The most unknowns that a model here has.
inline constexpr std::size_t kMostUnknowns = 9;
using Row = std::array<double, kMostUnknowns>;

struct Rows {
    std::vector<Row> known;
    std::vector<double> wanted;
    std::vector<Row> instruments = {}; ///< for the same columns; empty: they are their own
    std::vector<std::size_t> cluster; ///< numbers from 0, rising
};

struct Fit {
    std::size_t unknowns = 0;
    Row values{};
    Row errors{}; ///< standard errors
    double residual = 0.0; ///< root mean square
    double rows = 0.0; ///< that count
    std::vector<bool> counts; ///< each row, whether it does
    std::size_t clusters = 0;
    Estimate estimate(std::size_t unknown) const; ///< with its 95 % interval
};

/// Solves wanted = known x unknowns. Rows further from it than four deviations count for nothing; this is decided anew
/// three times. Empty if the rows do not determine the unknowns, or are of fewer than three clusters.
/// @param columns  which places of a row are unknowns of the model; the others' values and errors are 0
std::optional<Fit> leastSquares(const Rows &rows, std::span<const std::size_t> columns);

/// Whether one of two models of the same rows explains them better than the other: Bayesian information criterion, over
/// the rows that count for both. Over other rows it says nothing: a model that leaves out more would be another one.
bool explainsBetter(const Rows &rows, const Fit &one, const Fit &other);

} // namespace lab

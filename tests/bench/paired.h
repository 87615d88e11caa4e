// Ratios that hold on a busy machine: two pieces of work back to back in the same iteration, in alternating order, by
// CPU time, and the median of the ratios of the pairs. Method and reasons: docs/performance.md.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench {

struct Pair {
    double ratio = 0.0; ///< median of b / a over the pairs
    double aSeconds = 0.0; ///< median
    double bSeconds = 0.0;
    double p10 = 0.0; ///< of the ratios
    double p90 = 0.0;
};

/// What was measured, and how far it was from the same each time.
struct Measured {
    double value = 0.0;
    std::optional<double> p10, p90;
    std::optional<double> ms, againstMs; ///< the two that a ratio is of, medians

    Measured(double one) // NOLINT(google-explicit-constructor) a figure that was taken once
        : value(one)
    {
    }
    /// Median of several.
    explicit Measured(const std::vector<double> &several);
    static Measured faster(const Pair &pair); ///< a is ours, b the partner
    static Measured cost(const Pair &pair); ///< b is ours, a the partner
};

/// One line of the table and of ratios.json.
struct Figure {
    std::string goal; ///< as in goals.h; a number alone ("P1"): a figure for which there is none
    std::string what;
    Measured measured;
    std::string against;
};

/// Adds a line; figures of one run are kept until writeFigures().
void report(Figure figure);

/// Says that a goal's figures cannot be taken here, and why: printed and written like a figure.
void leaveOut(const std::string &goal, const std::string &why);

/// Prints the table and writes the JSON file.
struct Verdict {
    bool written = false;
    std::vector<std::string> failing; ///< goals that a figure is far behind of
    std::vector<std::string> missing; ///< that have neither a figure nor a reason
};
Verdict writeFigures(const std::string &path);

/// Runs `a` and `b` once to warm up and then once each an iteration of `state`; publishes the counters ratio, p10,
/// p90, a_ms and b_ms. Each should take a millisecond or more: the clock counts microseconds.
/// @param before  called before each of them, outside of what is timed
Pair pairedRatio(benchmark::State &state, const std::function<void()> &a,
    const std::function<void()> &b, const std::function<void()> &before = {});

/// Seconds that all threads of this process have computed.
double cpuSeconds();

/// The value below which a share of them lies, 0 to 1.
double quantile(std::vector<double> values, double share);

/// Resident memory of this process, bytes; 0 where the system does not say.
double residentBytes();

/// Ends the run with a message: a figure whose results are wrong is worth nothing.
void require(bool holds, const char *what);

} // namespace bench

// Ratios that hold on a busy machine: two pieces of work back to back in the same iteration, in alternating order, by
// CPU time, and the median of the ratios of the pairs. Method and reasons: docs/performance.md.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace bench {

/// One line of the table and of ratios.json.
struct Figure {
    std::string id; ///< "P1"
    std::string what;
    double ratio = 0.0;
    std::string goal;
    std::string against;
};

/// Adds a line; figures of one run are kept until writeFigures().
void report(Figure figure);

/// Says that a figure cannot be taken here, and why: printed and written like a figure, but it counts as none.
void leaveOut(const std::string &id, const std::string &what, const std::string &why);

/// Those of `wanted` that have no figure.
std::vector<std::string> withoutFigure(const std::vector<std::string> &wanted);

/// Prints the table and writes the JSON file. False if the file could not be written.
bool writeFigures(const std::string &path);

struct Pair {
    double ratio = 0.0; ///< median of b / a over the pairs
    double aSeconds = 0.0; ///< median
    double bSeconds = 0.0;
};

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

// Runs all benchmarks, prints the table of ratios and leaves them in a JSON file. A run of everything in which one of
// the goals has no figure has failed, and leaves no file of an earlier run behind.
#include "bench/paired.h"
#include "widgets/window/application.h"

#include <cstdio>
#include <iostream>

namespace {

constexpr int kGoals = 14; ///< P1 to P14 of docs/performance.md

/// The goals without a figure. Nothing if only some benchmarks were asked for.
std::vector<std::string> missing(bool filtered)
{
    std::vector<std::string> goals;
    for (int number = 1; number <= kGoals && !filtered; ++number)
        goals.push_back("P" + std::to_string(number));
    return bench::withoutFigure(goals);
}

} // namespace

int main(int argc, char **argv)
{
    bool filtered = false;
    for (int i = 1; i < argc; ++i)
        filtered = filtered || std::string(argv[i]).starts_with("--benchmark_filter");
    widgets::Application app(argc, argv); // before the benchmarks: some of them draw
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    std::remove(ROTORSCOPE_RATIOS);
    benchmark::RunSpecifiedBenchmarks();
    if (!bench::writeFigures(ROTORSCOPE_RATIOS)) {
        std::cerr << "Cannot write " << ROTORSCOPE_RATIOS << '\n';
        return 1;
    }
    const auto without = missing(filtered);
    for (const std::string &goal : without)
        std::cerr << "No figure for " << goal << '\n';
    return without.empty() ? 0 : 1;
}

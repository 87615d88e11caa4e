// Runs all benchmarks, prints the table of figures and leaves them in a JSON file. A run in which a figure is far
// behind its goal, or a goal of a run of everything has no figure, has failed; it leaves no file of an earlier run
// behind.
#include "bench/paired.h"
#include "support/watchdog/beats.h"
#include "widgets/window/application.h"

#include <cstdio>
#include <iostream>

int main(int argc, char **argv)
{
    bool filtered = false;
    for (int i = 1; i < argc; ++i)
        filtered = filtered || std::string(argv[i]).starts_with("--benchmark_filter");
    // Before the benchmarks: some of them draw.
    support::Watched<widgets::Application> app(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    std::remove(ROTORSCOPE_RATIOS);
    benchmark::RunSpecifiedBenchmarks();
    const bench::Verdict verdict = bench::writeFigures(ROTORSCOPE_RATIOS);
    if (!verdict.written)
        std::cerr << "Cannot write " << ROTORSCOPE_RATIOS << '\n';
    for (const std::string &goal : verdict.failing)
        std::cerr << "More than half as much again behind its goal: " << goal << '\n';
    if (!filtered)
        for (const std::string &goal : verdict.missing)
            std::cerr << "No figure for " << goal << '\n';
    const bool whole = filtered || verdict.missing.empty();
    return verdict.written && verdict.failing.empty() && whole ? 0 : 1;
}

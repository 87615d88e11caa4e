// Runs all benchmarks, prints the table of ratios and leaves them in a JSON file.
#include "bench/paired.h"

#include <QApplication>

#include <iostream>

int main(int argc, char **argv)
{
    QApplication app(argc, argv); // before the benchmarks: some of them draw
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    if (!bench::writeFigures(ROTORSCOPE_RATIOS)) {
        std::cerr << "Cannot write " << ROTORSCOPE_RATIOS << '\n';
        return 1;
    }
    return 0;
}

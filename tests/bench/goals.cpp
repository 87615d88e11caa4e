#include "bench/goals.h"

#include <algorithm>
#include <array>

namespace bench {

namespace {
constexpr auto kAtMost = Goal::Sense::AtMost;
constexpr auto kAtLeast = Goal::Sense::AtLeast;
constexpr double kLoose = 1.5; ///< behind a goal, until a run fails

constexpr std::array kGoals{
    Goal{"N1 stall", kAtMost, 50.0, "ms of computing in the longest beat"},
    Goal{"N2 events", kAtMost, 0.2, "seconds"},
    Goal{"N2 growth", kAtMost, 2.2, "times the cost"},
    Goal{"N3 fully out", kAtLeast, 50.0, "times faster"},
    Goal{"N3 10000", kAtLeast, 3.0, "times faster"},
    Goal{"N3 3000", kAtLeast, 2.0, "times faster"},
    Goal{"N3 1000", kAtLeast, 1.3, "times faster"},
    Goal{"N4 10000000", kAtMost, 1.25, "times the cost"},
    Goal{"N4 72000000", kAtMost, 1.5, "times the cost"},
    Goal{"N5 frame", kAtMost, 1.5, "times the cost"},
    Goal{"N5 memory", kAtMost, 2.3, "bytes a sample"},
    Goal{"N6 math", kAtMost, 1.6, "times the cost"},
    Goal{"N6 frame", kAtMost, 1.0, "of 16.7 ms, the slowest in a hundred"},
    Goal{"N7 persistence", kAtMost, 2.0, "times the cost"},
    Goal{"N7 triggered", kAtMost, 2.0, "times the cost"},
    Goal{"N7 signals", kAtMost, 2.5, "times the cost"},
    Goal{"N7 gaps", kAtMost, 1.25, "times the cost"},
    Goal{"N8 4K", kAtMost, 4.4, "times the cost"},
    Goal{"N8 frame", kAtMost, 1.0, "of 16.7 ms, the slowest in a hundred"},
    Goal{"N8 240 Hz", kAtMost, 1.0, "of 4.1 ms, the slowest in a thousand"},
    Goal{"N9 rest", kAtMost, 8.0, "% of a core"},
    Goal{"N9 woken", kAtMost, 300.0, "wake-ups a second"},
    Goal{"N9 hidden", kAtMost, 3.0, "% of a core"},
    Goal{"N9 alone", kAtMost, 0.3, "% of a core"},
    Goal{"N10 recorder", kAtMost, 0.1, "% of a core"},
    Goal{"N11 worker", kAtMost, 1.25, "times as long"},
    Goal{"N11 window", kAtMost, 1.4, "times as long"},
    Goal{"N12 start", kAtMost, 0.2, "times the computing"},
    Goal{"N13 line", kAtMost, 10.0, "ns a sample"},
    Goal{"N14 to_chars", kAtLeast, 7.0, "times faster"},
    Goal{"N14 write", kAtMost, 2.5, "times the cost"},
    Goal{"N14 read", kAtLeast, 250.0, "MB a second"},
    Goal{"N14 MAT", kAtMost, 20.0, "seconds for 1e8 samples"},
    Goal{"N15 1e9", kAtMost, 0.3, "seconds"},
    Goal{"N15 1e10", kAtMost, 0.5, "seconds"},
    Goal{"N15 memory", kAtMost, 100.0, "MB"},
    Goal{"N17 edges", kAtMost, 1.0, "times the cost"},
    Goal{"N17 kinds", kAtMost, 1.0, "times the cost"},
    Goal{"I5 Welch", kAtMost, 0.4, "seconds"},
    Goal{"I5 identification", kAtMost, 50.0, "ms"},
    Goal{"P1 fully out", kAtLeast, 50.0, "times faster"},
    Goal{"P2 peaks", kAtMost, 0.0, "missed"},
    Goal{"P3 flat", kAtMost, 1.8, "times the cost"},
    Goal{"P3 ragged", kAtMost, 2.5, "times the cost"},
    Goal{"P4 ten minutes", kAtLeast, 80.0, "times faster"},
    Goal{"P4 hour", kAtMost, 1.5, "times the cost"},
    Goal{"P4 worst", kAtMost, 1.0, "of 16.7 ms, the slowest in a hundred"},
    Goal{"P5 core", kAtMost, 50.0, "% of a core"},
    Goal{"P5 frames", kAtLeast, 60.0, "a second"},
    Goal{"P5 lost", kAtMost, 0.0, "control periods lost"},
    Goal{"P6 memory", kAtMost, 2.3, "bytes a sample"},
    Goal{"P7 append", kAtMost, 2.0, "times the cost"},
    Goal{"P8 decode", kAtMost, 9.0, "times the cost"},
    Goal{"P9 framer", kAtLeast, 300.0, "times the speed of the line"},
    Goal{"P9 recovering", kAtLeast, 300.0, "times the speed of the line"},
    Goal{"P10 reads back", kAtMost, 0.0, "numbers that do not"},
    Goal{"P10 PlotJuggler", kAtLeast, 30.0, "times faster"},
    Goal{"P12 bytes", kAtMost, 2.1, "bytes a sample"},
    Goal{"P12 opening", kAtLeast, 1500.0, "times real time"},
    Goal{"P13 board", kAtLeast, 40.0, "virtual seconds a core second"},
    Goal{"P13 drive", kAtLeast, 40.0, "virtual seconds a core second"},
};
} // namespace

Goal::Verdict Goal::judge(double figure) const
{
    const bool most = sense == kAtMost;
    if (most ? figure <= value : figure >= value)
        return Verdict::Met;
    return (most ? figure <= value * kLoose : figure >= value / kLoose) ? Verdict::Missed
                                                                        : Verdict::Fails;
}

std::span<const Goal> goals() { return kGoals; }

const Goal *goalNamed(std::string_view name)
{
    const auto found = std::find_if(
        kGoals.begin(), kGoals.end(), [name](const Goal &goal) { return goal.name == name; });
    return found == kGoals.end() ? nullptr : &*found;
}

} // namespace bench

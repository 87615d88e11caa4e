// The goals of docs/performance.md as numbers, in one table. A figure that is more than half as much behind its goal
// again ends the run with 1: machines differ by less.
#pragma once

#include <span>
#include <string_view>

namespace bench {

struct Goal {
    std::string_view name; ///< its first word is the goal's number
    enum class Sense { AtMost, AtLeast } sense;
    double value;
    std::string_view unit; ///< of the figure, or what it counts

    enum class Verdict { Met, Missed, Fails };
    Verdict judge(double figure) const;
};

std::span<const Goal> goals();
const Goal *goalNamed(std::string_view name); ///< nullptr: there is none

} // namespace bench

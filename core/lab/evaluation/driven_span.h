// When a motor was driven by currents or torques in an experiment: from the first one to whatever came then.
#pragma once

#include "lab/happenings.h"

#include <optional>
#include <string>

namespace lab {

struct DrivenSpan {
    Nanos from = 0, to = 0;
    std::string reason; ///< why it ended early; empty: it did not, or nothing says so
};

/// @param at  behind the plan's entry
/// @param last  when nothing says that it ended
/// @return  empty if it was never driven so
std::optional<DrivenSpan> drivenSpan(
    int motor, Happenings::const_iterator at, Happenings::const_iterator end, Nanos last);

} // namespace lab

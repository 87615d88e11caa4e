#include "lab/evaluation/driven_span.h"

#include "lab/experiment.h"
#include "lab/fields.h"

#include <algorithm>

namespace lab {

std::optional<DrivenSpan> drivenSpan(
    int motor, Happenings::const_iterator at, Happenings::const_iterator end, Nanos last)
{
    std::optional<DrivenSpan> span;
    for (; at != end; ++at) {
        const auto &[time, what] = *at;
        const bool drives = what.name == "torque ramp" || what.name == "current reference";
        if (drives && numberOf(what, "motor") == motor) {
            if (!span)
                span = DrivenSpan{time, last, {}};
        } else if (what.name == "speed ramp" || what.name == "command" || what.name == "stop"
            || endsLink(what)) {
            if (span)
                span->to = std::min(span->to, time);
        } else if (what.name == kEndEntry) {
            if (span) {
                span->to = std::min(span->to, time);
                span->reason = fieldOf(what, "outcome") == "complete" ? std::string()
                                                                      : fieldOf(what, "reason");
            }
            break;
        }
    }
    return span;
}

} // namespace lab

// How an experiment ended.
#pragma once

#include "base/time.h"

#include <cstdint>
#include <string>

namespace lab {

enum class End : std::uint8_t {
    Complete,
    Refused, ///< the board or the drive did not do what was asked; nothing is left moving that stood before
    Aborted, ///< the envelope was broken, or the board reported a fault
    Interrupted, ///< somebody stopped, disarmed or took the motor over
    Lost, ///< the link or the port went
};

struct Outcome {
    End end = End::Complete;
    /// Why it ended, and what is not as it was before; without a full stop. Empty: nothing to say.
    std::string reason;
    TimePoint at{}; ///< when it ended; the session says it
    bool swings = false; ///< it ended before it began: the speed did not come to rest
    bool operator==(const Outcome &) const = default;
};

} // namespace lab

// What a value axis shows.
#pragma once

namespace widgets {

struct ValueRange {
    double from = 0.0, to = 1.0; ///< in the unit of its channels; from < to
    bool operator==(const ValueRange &) const = default;
};

} // namespace widgets

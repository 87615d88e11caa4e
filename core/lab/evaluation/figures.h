// What an experiment found, where that is some numbers: each is said once, for JSON, command line and window. A finding
// of such has `kKind`, its kind in JSON, and figuresOf(), in the order in which they are told.
#pragma once

#include "lab/maths/statistics.h"

namespace lab {

struct Figure {
    const char *key = ""; ///< in JSON
    const char *name = "", *unit = ""; ///< in words
    std::optional<Estimate> value; ///< empty: it is not known
};
using Figures = std::vector<Figure>;

template <class Found>
concept HasFigures = requires(const Found &found)
{
    figuresOf(found);
};

} // namespace lab

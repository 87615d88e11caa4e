// The colours the user may give a trace, as entries of a menu: a swatch, and the colour's name beside it, for the swatch alone
// says nothing to who sees fewer colours.
#pragma once

#include <functional>
#include <optional>

class QMenu;

namespace widgets {

/// @param chosen  slot of trace_colors.h that the user gave it; empty: given by itself
/// @param choose  told the new one; empty: by itself again
void fillColorMenu(QMenu &menu, std::optional<int> chosen, bool dark,
    const std::function<void(std::optional<int>)> &choose);

} // namespace widgets

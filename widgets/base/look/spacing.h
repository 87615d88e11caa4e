// The grid on which everything in the window stands: distances are whole or half steps of it.
#pragma once

namespace widgets {

constexpr int kGrid = 8; ///< pixels: between parts, and from an edge
constexpr int kHalfGrid = 4; ///< between what belongs together
constexpr int kFineGrid = 2; ///< between rows of a dense table
constexpr int kDialogEdge = 2 * kGrid; ///< around a dialog

} // namespace widgets

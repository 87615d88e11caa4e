// The grid on which everything in the window stands: distances are whole or half steps of it. And layouts that keep
// them.
#pragma once

#include <QMargins>

namespace widgets {

constexpr int kGrid = 8; ///< pixels: between parts, and from an edge
constexpr int kHalfGrid = 4; ///< between what belongs together
constexpr int kFineGrid = 2; ///< between rows of a dense table
constexpr int kDialogEdge = 2 * kGrid; ///< around a dialog

inline constexpr QMargins kToolEdges{kGrid, kHalfGrid, kGrid, kHalfGrid};
inline constexpr QMargins kDialogEdges{kDialogEdge, kDialogEdge, kDialogEdge, kDialogEdge};

/// @param edges  of the layout itself
/// @param gap    between its parts; -1: as the style has it
/// @return       the layout
template <class Layout>
Layout *edged(Layout *layout, const QMargins &edges, int gap = -1)
{
    layout->setContentsMargins(edges);
    layout->setSpacing(gap);
    return layout;
}

template <class Layout>
Layout *bare(Layout *layout, int gap = -1)
{
    return edged(layout, {}, gap);
}

/// @param across, down  between columns, and between rows
template <class Layout>
Layout *bare(Layout *layout, int across, int down)
{
    edged(layout, {}, across)->setVerticalSpacing(down);
    return layout;
}

/// What is beside a part stays where it is when the part is hidden.
template <class Part>
void keepPlace(Part &part)
{
    auto policy = part.sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    part.setSizePolicy(policy);
}

} // namespace widgets

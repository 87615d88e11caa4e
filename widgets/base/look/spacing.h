// The grid on which everything in the window stands: distances are whole or half steps of it. And layouts with the edges that
// most of them have.
#pragma once

namespace widgets {

constexpr int kGrid = 8; ///< pixels: between parts, and from an edge
constexpr int kHalfGrid = 4; ///< between what belongs together
constexpr int kFineGrid = 2; ///< between rows of a dense table
constexpr int kDialogEdge = 2 * kGrid; ///< around a dialog

/// A layout without edges of its own. @return  it
template <class Layout>
Layout *bare(Layout *layout)
{
    layout->setContentsMargins(0, 0, 0, 0);
    return layout;
}

/// @param gap  between its parts
template <class Layout>
Layout *bare(Layout *layout, int gap)
{
    layout->setSpacing(gap);
    return bare(layout);
}

/// @param across, down  between columns, and between rows
template <class Layout>
Layout *bare(Layout *layout, int across, int down)
{
    layout->setHorizontalSpacing(across);
    layout->setVerticalSpacing(down);
    return bare(layout);
}

/// A layout with the edges of a tool. @return  it
template <class Layout>
Layout *padded(Layout *layout)
{
    layout->setContentsMargins(kGrid, kHalfGrid, kGrid, kHalfGrid);
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

// Traces that are bands, many of them over each other, as one picture: every pixel is written once, whatever lies over
// it, so that the cost is that of the picture and not of what it covers. Knows no axes and no samples.
#pragma once

#include "widgets/scope/drawing/trace_image.h"

#include <optional>
#include <span>

namespace widgets {

struct Band {
    QRgb color; ///< opaque
    const PixelColumns *columns;
};

/// Paints bands so that none hides another: where several cover a pixel it has the colour of the one in whose slanting
/// stripe it lies, or of the first of them if that one is not there. Beyond 32 bands the last ones hide the others.
/// @param image  of 32 bits a pixel, as wide as the columns
/// @param stripeWidth  pixels, at least 1
/// @param first  number of the left column, from which stripes are counted: pictures of one axis have them where they
/// meet
/// @param ground  what pixels get that no band covers; empty: they stay as they are
void paintBands(QImage &image, std::span<const Band> bands, int stripeWidth, std::int64_t first,
    std::optional<QRgb> ground);

} // namespace widgets

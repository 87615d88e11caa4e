// Traces as pixels: fills whole rows of an image at once instead of drawing thousands of vertical lines, which makes
// the cost depend on the picture's size and not on how tall each line is. Knows no axes and no samples.
#pragma once

#include <QImage>

#include <cstdint>
#include <vector>

namespace widgets {

/// For each pixel column the rows from `top` to `bottom`, both included; nothing where top > bottom.
struct PixelColumns {
    std::vector<std::int16_t> top;
    std::vector<std::int16_t> bottom;

    explicit PixelColumns(int width = 0);
    int width() const { return static_cast<int>(top.size()); }
    bool emptyAt(int x) const { return top[std::size_t(x)] > bottom[std::size_t(x)]; }
    void set(int x, int from, int to); ///< bounded to what an image can have; from <= to
    void joinNeighbours(); ///< lets each filled column touch the filled one before it
    /// The same for a value that turns: together with `other`, which holds the far piece of columns in which it passed
    /// its end; what is further apart than `half` a turn is not joined.
    void joinTurning(PixelColumns &other, int half);
    void thicken(int rows); ///< at least `rows` high each
    PixelColumns takeThin(int rows); ///< moves the columns of at most `rows` into the result
    /// `on` of each `on` + `off` columns, the others empty
    PixelColumns dashed(int on, int off) const;
    int tallerThan(int rows) const; ///< how many columns are
    PixelColumns part(int from, int to) const; ///< columns [from, to) of it
};

/// Fills the columns with `color`; rows outside the image are left out.
/// @param image  Format_ARGB32_Premultiplied or Format_RGB32, at least columns.width() wide
void fillColumns(QImage &image, const PixelColumns &columns, QRgb color);

} // namespace widgets

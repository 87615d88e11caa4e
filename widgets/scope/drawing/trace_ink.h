// What traces are drawn with: pixels of an image on the screen, shapes in a picture that has no pixels (SVG, PDF, a
// printer). Knows no axes and no samples; everything is in the units of the picture's width and height.
#pragma once

#include "widgets/scope/drawing/trace_bands.h"

#include <QPainterPath>
#include <QSize>

#include <algorithm>

class QPainter;

namespace widgets {

class TraceInk {
public:
    TraceInk() = default;
    TraceInk(const TraceInk &) = delete;
    TraceInk &operator=(const TraceInk &) = delete;
    virtual ~TraceInk() = default;

    /// @param color  premultiplied, as in the image
    virtual void columns(const PixelColumns &columns, QRgb color) = 0;
    /// All bands of the picture, so that none hides another. Once, before lines and boxes.
    /// @param first  number of the left column, from which stripes are counted
    virtual void bands(std::span<const Band> bands, int stripeWidth, std::int64_t first) = 0;
    virtual void box(int left, int top, int width, int height, QRgb color) = 0;
};

class ImageInk : public TraceInk {
public:
    /// @param ground  what the bands leave where they are not; empty: what is there
    ImageInk(QImage &image, std::optional<QRgb> ground)
        : m_image(image)
        , m_ground(ground)
        , m_bits(image.bits())
        , m_stride(image.bytesPerLine())
    {
    }
    void columns(const PixelColumns &columns, QRgb color) override
    {
        fillColumns(m_image, columns, color);
    }
    void bands(std::span<const Band> bands, int stripeWidth, std::int64_t first) override
    {
        paintBands(m_image, bands, stripeWidth, first, m_ground);
    }
    void box(int left, int top, int width, int height, QRgb color) override
    {
        const int right = std::min(left + width, m_image.width());
        const int bottom = std::min(top + height, m_image.height());
        left = std::max(left, 0);
        for (int y = std::max(top, 0); y < bottom && left < right; ++y) {
            auto *row = reinterpret_cast<QRgb *>(m_bits + y * m_stride);
            std::fill(row + left, row + right, color);
        }
    }

private:
    QImage &m_image;
    std::optional<QRgb> m_ground;
    uchar *m_bits; ///< asked for once: there are thousands of boxes of few pixels
    qsizetype m_stride;
};

/// Draws with another ink, in dashes: `on` of each `on` + `off` columns of the picture.
class DashedInk : public TraceInk {
public:
    DashedInk(TraceInk &ink, int on, int off)
        : m_ink(ink)
        , m_on(on)
        , m_off(off)
    {
    }
    void columns(const PixelColumns &columns, QRgb color) override
    {
        m_ink.columns(columns.dashed(m_on, m_off), color);
    }
    void bands(std::span<const Band>, int, std::int64_t) override { } ///< nothing dashed has any
    void box(int left, int top, int width, int height, QRgb color) override;

private:
    TraceInk &m_ink;
    int m_on;
    int m_off;
};

/// One shape for each run of columns and each trace of steps, cut at the picture's edges: not every writer of vector
/// files can cut. Bands that share their place have upright stripes.
class ShapeInk : public TraceInk {
public:
    ShapeInk(QPainter &painter, QSize size)
        : m_painter(painter)
        , m_size(size)
    {
    }
    ~ShapeInk() override { flush(); }
    void columns(const PixelColumns &columns, QRgb color) override;
    void bands(std::span<const Band> bands, int stripeWidth, std::int64_t first) override;
    void box(int left, int top, int width, int height, QRgb color) override;
    void flush(); ///< draws the boxes that were gathered

private:
    void fill(const QPainterPath &path, QRgb color);

    QPainter &m_painter;
    QSize m_size;
    QPainterPath m_boxes;
    QRgb m_color = 0;
};

} // namespace widgets

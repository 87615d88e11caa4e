// What traces are drawn with: pixels of an image on the screen, shapes in a picture that has no pixels (SVG, PDF, a
// printer). Knows no axes and no samples; everything is in the units of the picture's width and height.
#pragma once

#include "widgets/scope/trace_image.h"

#include <QPainterPath>
#include <QSize>

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
    virtual void striped(const PixelColumns &columns, QRgb color, const Stripes &stripes) = 0;
    virtual void box(int left, int top, int width, int height, QRgb color) = 0;
};

class ImageInk : public TraceInk {
public:
    explicit ImageInk(QImage &image)
        : m_image(image)
    {
    }
    void columns(const PixelColumns &columns, QRgb color) override
    {
        fillColumns(m_image, columns, color);
    }
    void striped(const PixelColumns &columns, QRgb color, const Stripes &stripes) override
    {
        fillStriped(m_image, columns, color, stripes);
    }
    void box(int left, int top, int width, int height, QRgb color) override
    {
        fillBox(m_image, left, top, width, height, color);
    }

private:
    QImage &m_image;
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
    void striped(const PixelColumns &columns, QRgb color, const Stripes &stripes) override
    {
        m_ink.striped(columns.dashed(m_on, m_off), color, stripes);
    }
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
    void striped(const PixelColumns &columns, QRgb color, const Stripes &stripes) override;
    void box(int left, int top, int width, int height, QRgb color) override;
    void flush(); ///< draws the boxes that were gathered

private:
    void fill(const QPainterPath &path, QRgb color);

    QPainter &m_painter;
    QSize m_size;
    std::vector<std::pair<PixelColumns, QRgb>> m_bands; ///< until the last one that shares is known
    QPainterPath m_boxes;
    QRgb m_color = 0;
};

} // namespace widgets

#include "widgets/scope/drawing/trace_ink.h"

#include <QPainter>

#include <algorithm>

namespace widgets {
namespace {

/// The outline of neighbouring columns, as a staircase there and back.
void addRun(QPainterPath &path, const PixelColumns &columns, int from, int to, int height)
{
    const auto top = [&](int x) { return std::clamp<int>(columns.top[std::size_t(x)], 0, height); };
    const auto bottom = [&](int x) {
        return std::clamp<int>(columns.bottom[std::size_t(x)] + 1, 0, height);
    };
    path.moveTo(from, top(from));
    for (int x = from; x < to; ++x) {
        path.lineTo(x, top(x));
        path.lineTo(x + 1, top(x));
    }
    for (int x = to - 1; x >= from; --x) {
        path.lineTo(x + 1, bottom(x));
        path.lineTo(x, bottom(x));
    }
    path.closeSubpath();
}

QPainterPath pathOf(const PixelColumns &columns, QSize size)
{
    QPainterPath path;
    const int width = std::min(columns.width(), size.width());
    const auto visible = [&](int x) {
        return !columns.emptyAt(x) && columns.bottom[std::size_t(x)] >= 0
            && columns.top[std::size_t(x)] < size.height();
    };
    // Columns that touch are one shape; those that do not would be joined by a line that is not there.
    const auto touches = [&](int x) {
        const auto at = std::size_t(x);
        return visible(x) && columns.top[at] <= columns.bottom[at - 1] + 1
            && columns.top[at - 1] <= columns.bottom[at] + 1;
    };
    for (int x = 0; x < width;) {
        if (!visible(x)) {
            ++x;
            continue;
        }
        const int from = x++;
        while (x < width && touches(x))
            ++x;
        addRun(path, columns, from, x, size.height());
    }
    return path;
}

} // namespace

void ShapeInk::fill(const QPainterPath &path, QRgb color)
{
    if (!path.isEmpty())
        m_painter.fillPath(path, QColor::fromRgba(qUnpremultiply(color)));
}

void DashedInk::box(int left, int top, int width, int height, QRgb color)
{
    const int period = m_on + m_off;
    const int right = left + width;
    // Those of the dashes that the box touches; left of the picture there are none.
    for (int dash = std::max(left, 0) / period * period; dash < right; dash += period) {
        const int from = std::max(left, dash);
        const int to = std::min(right, dash + m_on);
        if (to > from)
            m_ink.box(from, top, to - from, height, color);
    }
}

void ShapeInk::columns(const PixelColumns &columns, QRgb color)
{
    flush();
    fill(pathOf(columns, m_size), color);
}

void ShapeInk::bands(std::span<const Band> bands, int stripeWidth, std::int64_t)
{
    flush();
    for (const Band &band : bands)
        fill(pathOf(*band.columns, m_size), band.color);
    // The last one hides the others where they share: they come through in stripes.
    const auto count = static_cast<int>(bands.size());
    for (int own = 0; own + 1 < count; ++own) {
        const PixelColumns &columns = *bands[std::size_t(own)].columns;
        PixelColumns part(columns.width());
        for (int x = 0; x < columns.width(); ++x)
            if (!columns.emptyAt(x) && x / stripeWidth % count == own)
                part.set(x, columns.top[std::size_t(x)], columns.bottom[std::size_t(x)]);
        fill(pathOf(part, m_size), bands[std::size_t(own)].color);
    }
}

void ShapeInk::box(int left, int top, int width, int height, QRgb color)
{
    if (color != m_color)
        flush();
    m_color = color;
    const QRect seen = QRect(left, top, width, height).intersected(QRect({}, m_size));
    if (!seen.isEmpty())
        m_boxes.addRect(seen);
}

void ShapeInk::flush()
{
    m_boxes.setFillRule(Qt::WindingFill); // boxes overlap where steps meet
    fill(m_boxes, m_color);
    m_boxes = QPainterPath();
}

} // namespace widgets

#include "widgets/scope/drawing/trace_image.h"

#include <algorithm>
#include <limits>
#include <utility>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace widgets {

namespace {
constexpr std::int16_t kNoTop = std::numeric_limits<std::int16_t>::max();
constexpr std::int16_t kNoBottom = std::numeric_limits<std::int16_t>::min();

std::int16_t bounded(int row) { return static_cast<std::int16_t>(std::clamp(row, -2, 32000)); }

/// Colours the pixels of one row whose column covers it.
void fillRow(QRgb *row, const PixelColumns &columns, std::int16_t y, std::size_t from,
    std::size_t to, QRgb color)
{
    std::size_t x = from;
#ifdef __SSE2__
    const __m128i here = _mm_set1_epi16(y);
    const __m128i paint = _mm_set1_epi32(static_cast<int>(color));
    for (; x + 8 <= to; x += 8) {
        const __m128i top = _mm_loadu_si128(reinterpret_cast<const __m128i *>(&columns.top[x]));
        const __m128i bottom =
            _mm_loadu_si128(reinterpret_cast<const __m128i *>(&columns.bottom[x]));
        const __m128i outside =
            _mm_or_si128(_mm_cmpgt_epi16(top, here), _mm_cmpgt_epi16(here, bottom));
        const int mask = _mm_movemask_epi8(outside);
        if (mask == 0xFFFF)
            continue;
        auto *pixels = reinterpret_cast<__m128i *>(row + x);
        if (mask == 0) {
            _mm_storeu_si128(pixels, paint);
            _mm_storeu_si128(pixels + 1, paint);
            continue;
        }
        const __m128i low = _mm_unpacklo_epi16(outside, outside);
        const __m128i high = _mm_unpackhi_epi16(outside, outside);
        _mm_storeu_si128(pixels,
            _mm_or_si128(
                _mm_and_si128(low, _mm_loadu_si128(pixels)), _mm_andnot_si128(low, paint)));
        _mm_storeu_si128(pixels + 1,
            _mm_or_si128(
                _mm_and_si128(high, _mm_loadu_si128(pixels + 1)), _mm_andnot_si128(high, paint)));
    }
#endif
    for (; x < to; ++x) {
        if (columns.top[x] <= y && y <= columns.bottom[x])
            row[x] = color;
    }
}
} // namespace

PixelColumns::PixelColumns(int width)
    : top(std::size_t(std::max(width, 0)), kNoTop)
    , bottom(std::size_t(std::max(width, 0)), kNoBottom)
{
}

void PixelColumns::set(int x, int from, int to)
{
    top[std::size_t(x)] = bounded(from);
    bottom[std::size_t(x)] = bounded(to);
}

void PixelColumns::joinNeighbours()
{
    // Against the columns as they were, or one step would smear on to the right.
    std::int16_t lastTop = kNoTop;
    std::int16_t lastBottom = kNoBottom;
    for (std::size_t x = 0; x < top.size(); ++x) {
        const std::int16_t ownTop = top[x];
        const std::int16_t ownBottom = bottom[x];
        if (ownTop <= ownBottom && lastTop <= lastBottom) {
            if (lastBottom < ownTop)
                top[x] = static_cast<std::int16_t>(lastBottom + 1);
            else if (lastTop > ownBottom)
                bottom[x] = static_cast<std::int16_t>(lastTop - 1);
        }
        lastTop = ownTop;
        lastBottom = ownBottom;
    }
}

void PixelColumns::joinTurning(PixelColumns &other, int half)
{
    struct Piece {
        std::int16_t top;
        std::int16_t bottom;
    };
    const auto pieceAt = [](const PixelColumns &of, std::size_t x) {
        return Piece{of.top[x], of.bottom[x]};
    };
    Piece before[2] = {{kNoTop, kNoBottom}, {kNoTop, kNoBottom}};
    for (std::size_t x = 0; x < top.size(); ++x) {
        const Piece now[2] = {pieceAt(*this, x), pieceAt(other, x)};
        for (const Piece &last : before) {
            for (int i = 0; i < 2; ++i) {
                if (last.top > last.bottom || now[i].top > now[i].bottom)
                    continue;
                PixelColumns &target = i == 0 ? *this : other;
                if (last.bottom < now[i].top && now[i].top - last.bottom <= half)
                    target.top[x] =
                        std::min(target.top[x], static_cast<std::int16_t>(last.bottom + 1));
                else if (last.top > now[i].bottom && last.top - now[i].bottom <= half)
                    target.bottom[x] =
                        std::max(target.bottom[x], static_cast<std::int16_t>(last.top - 1));
            }
        }
        before[0] = now[0];
        before[1] = now[1];
    }
}

void PixelColumns::thicken(int rows)
{
    for (std::size_t x = 0; x < top.size(); ++x) {
        const int missing = rows - (bottom[x] - top[x] + 1);
        if (top[x] <= bottom[x] && missing > 0) {
            top[x] = bounded(top[x] - missing / 2);
            bottom[x] = bounded(top[x] + rows - 1);
        }
    }
}

PixelColumns PixelColumns::takeThin(int rows)
{
    PixelColumns thin(width());
    for (std::size_t x = 0; x < top.size(); ++x) {
        if (bottom[x] - top[x] < rows && top[x] <= bottom[x]) {
            thin.top[x] = std::exchange(top[x], kNoTop);
            thin.bottom[x] = std::exchange(bottom[x], kNoBottom);
        }
    }
    return thin;
}

PixelColumns PixelColumns::dashed(int on, int off) const
{
    PixelColumns dashes(width());
    for (int x = 0; x < width(); ++x) {
        if (x % (on + off) < on) {
            dashes.top[std::size_t(x)] = top[std::size_t(x)];
            dashes.bottom[std::size_t(x)] = bottom[std::size_t(x)];
        }
    }
    return dashes;
}

int PixelColumns::tallerThan(int rows) const
{
    int count = 0;
    for (std::size_t x = 0; x < top.size(); ++x)
        count += bottom[x] - top[x] >= rows ? 1 : 0;
    return count;
}

PixelColumns PixelColumns::part(int from, int to) const
{
    PixelColumns columns;
    columns.top.assign(top.begin() + from, top.begin() + to);
    columns.bottom.assign(bottom.begin() + from, bottom.begin() + to);
    return columns;
}

void fillColumns(QImage &image, const PixelColumns &columns, QRgb color)
{
    // Tiles keep the columns' rows in the first-level cache and skip the rows a tile does not reach.
    constexpr std::size_t kTile = 256;
    const auto width = std::min(std::size_t(columns.width()), std::size_t(image.width()));
    const auto stride = image.bytesPerLine();
    uchar *bits = image.bits();
    for (std::size_t from = 0; from < width; from += kTile) {
        const std::size_t to = std::min(from + kTile, width);
        int first = kNoTop;
        int last = kNoBottom;
        for (std::size_t x = from; x < to; ++x) {
            first = std::min<int>(first, columns.top[x]);
            last = std::max<int>(last, columns.bottom[x]);
        }
        first = std::max(first, 0);
        last = std::min(last, image.height() - 1);
        for (int y = first; y <= last; ++y) {
            auto *row = reinterpret_cast<QRgb *>(bits + y * stride);
            fillRow(row, columns, static_cast<std::int16_t>(y), from, to, color);
        }
    }
}

} // namespace widgets

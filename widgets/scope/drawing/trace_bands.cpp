#include "widgets/scope/drawing/trace_bands.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace widgets {

namespace {

using Mask = std::uint32_t; ///< a bit a band
constexpr std::size_t kMostBands = 32;

Mask bitOf(std::size_t band) { return Mask{1} << band; }

/// Paints rows from top to bottom, each once: where bands begin and end in a column is listed by rows, so that what
/// covers the row is known without a look at all bands.
class Painter {
public:
    Painter(QImage &image, std::span<const Band> bands, int stripeWidth, std::int64_t first,
        std::optional<QRgb> ground)
        : m_bands(bands)
        , m_ground(ground)
        , m_turnsOf(std::size_t(image.height()), 0)
        , m_masks(std::size_t(image.width()), 0)
        , m_firsts(m_masks.size(), ground.value_or(0))
    {
        const auto stripe = std::size_t(std::max(stripeWidth, 1));
        m_period = stripe * bands.size();
        const auto period = static_cast<std::int64_t>(m_period);
        m_left = static_cast<std::size_t>((first % period + period) % period);
        for (std::size_t place = 0; place < m_period + m_masks.size(); ++place) {
            const std::size_t owner = place % m_period / stripe;
            m_owners.push_back(bitOf(owner));
            m_stripes.push_back(bands[owner].color);
        }
        for (std::size_t b = 0; b < bands.size(); ++b)
            list(b);
    }

    void paintRow(QRgb *pixels, int y)
    {
        for (std::uint32_t i = m_turnsOf[std::size_t(y)]; i != 0; i = m_turns[i].next) {
            const std::size_t x = m_turns[i].column;
            const Mask mask = m_masks[x] ^= bitOf(m_turns[i].band);
            m_firsts[x] = mask != 0 ? m_bands[std::size_t(std::countr_zero(mask))].color
                                    : m_ground.value_or(0);
        }
        const std::size_t width = m_masks.size();
        const Mask *masks = m_masks.data();
        QRgb *firsts = m_firsts.data();
        if (!m_ground)
            for (std::size_t x = 0; x < width; ++x)
                firsts[x] = masks[x] == 0 ? pixels[x] : firsts[x];
        const std::size_t phase = (m_left + std::size_t(y)) % m_period;
        const Mask *owners = m_owners.data() + phase;
        const QRgb *stripes = m_stripes.data() + phase;
        // Without a branch: the compiler makes a wide loop of it.
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint32_t there = (masks[x] & owners[x]) != 0 ? ~std::uint32_t{0} : 0;
            pixels[x] = (there & stripes[x]) | (~there & firsts[x]);
        }
    }

private:
    /// A band begins or ends in a column.
    struct Turn {
        std::uint32_t next = 0; ///< of the same row; 0 for none
        std::uint16_t column = 0;
        std::uint16_t band = 0;
    };

    void list(std::size_t band)
    {
        const PixelColumns &columns = *m_bands[band].columns;
        for (std::size_t x = 0; x < m_masks.size(); ++x) {
            const int top = std::max<int>(columns.top[x], 0);
            const int bottom = columns.bottom[x];
            if (top > bottom)
                continue;
            for (const int y : {top, bottom + 1}) {
                if (std::size_t(y) >= m_turnsOf.size())
                    continue;
                std::uint32_t &first = m_turnsOf[std::size_t(y)];
                m_turns.push_back(
                    {first, static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(band)});
                first = static_cast<std::uint32_t>(m_turns.size() - 1);
            }
        }
    }

    std::span<const Band> m_bands;
    std::optional<QRgb> m_ground;
    std::size_t m_period;
    std::size_t m_left = 0; ///< where in a period the left column is
    // A period more than the row, so that they can be taken from any place in the first:
    std::vector<Mask> m_owners; ///< the band of each stripe, as a bit
    std::vector<QRgb> m_stripes; ///< and its colour
    std::vector<Turn> m_turns{1}; ///< the first stands for none
    std::vector<std::uint32_t> m_turnsOf; ///< for each row, its first
    // Of the row that is painted, a column each:
    std::vector<Mask> m_masks; ///< the bands that cover it
    std::vector<QRgb> m_firsts; ///< the colour of the first of them, else the ground
};

} // namespace

void paintBands(QImage &image, std::span<const Band> bands, int stripeWidth, std::int64_t first,
    std::optional<QRgb> ground)
{
    if (bands.empty() || bands.size() > kMostBands) {
        if (ground)
            image.fill(*ground);
        ground.reset();
        for (; bands.size() > kMostBands; bands = bands.subspan(1))
            fillColumns(image, *bands.front().columns, bands.front().color);
        if (bands.empty())
            return;
    }
    Painter painter(image, bands, stripeWidth, first, ground);
    const auto stride = image.bytesPerLine();
    uchar *bits = image.bits();
    for (int y = 0; y < image.height(); ++y)
        painter.paintRow(reinterpret_cast<QRgb *>(bits + y * stride), y);
}

} // namespace widgets

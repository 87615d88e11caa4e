#include "widgets/scope/drawing/trace_bands.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <unordered_map>

namespace widgets {

namespace {

using Mask = std::uint16_t; ///< a bit a band
constexpr std::size_t kMostBands = 16;
/// More meet thousands of sets where they are ragged, too many to be kept.
constexpr std::size_t kFewBands = 8;
/// A group is ragged if more than one in so many of its rows are covered in part.
constexpr int kRagged = 4;
constexpr std::size_t kGroup = 16; ///< columns that are decided together: a cache line of pixels

Mask bitOf(std::size_t band) { return static_cast<Mask>(1U << band); }
std::size_t firstOf(Mask mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }

/// What a set of bands looks like where all of it covers. The rows begin with the first stripe and are at least
/// two periods long, so that a period can be taken from any place in the first.
struct Look {
    std::vector<QRgb> pixels;
    /// All bits set where the stripe is that of one of them, else none.
    std::vector<std::uint32_t> owned;
};

class Looks {
public:
    Looks(std::span<const Band> bands, int stripeWidth, std::size_t width)
        : m_bands(bands)
        , m_stripe(std::size_t(std::max(stripeWidth, 1)))
        , m_period(m_stripe * bands.size())
        , m_length(m_period + std::max(width, m_period))
    {
    }
    std::size_t period() const { return m_period; }
    std::size_t stripe() const { return m_stripe; }
    /// For a column: two periods. Stays where it is; nullptr for none.
    const Look *of(Mask mask) { return of(mask, 2 * m_period); }
    /// For a row: long enough for one that begins anywhere in the first period.
    const Look *row(Mask mask) { return of(mask, m_length); }

private:
    /// Ragged traces meet hundreds of sets in columns, and few in rows: only those are made long.
    const Look *of(Mask mask, std::size_t length)
    {
        if (mask == 0)
            return nullptr;
        Look &look = m_known[mask];
        if (look.pixels.empty())
            fill(look, mask);
        repeat(look.pixels, length);
        repeat(look.owned, length);
        return &look;
    }

    void fill(Look &look, Mask mask) const
    {
        for (std::size_t owner = 0; owner < m_bands.size(); ++owner) {
            const bool there = (mask >> owner & 1) != 0;
            look.pixels.insert(
                look.pixels.end(), m_stripe, m_bands[there ? owner : firstOf(mask)].color);
            look.owned.insert(look.owned.end(), m_stripe, there ? ~std::uint32_t{0} : 0);
        }
    }

    void repeat(std::vector<std::uint32_t> &row, std::size_t length) const
    {
        row.reserve(length);
        while (row.size() < length) {
            const std::size_t part = std::min(m_period, length - row.size());
            const auto from = row.end() - static_cast<std::ptrdiff_t>(m_period);
            row.insert(row.end(), from, from + static_cast<std::ptrdiff_t>(part));
        }
    }

    std::span<const Band> m_bands;
    std::size_t m_stripe;
    std::size_t m_period;
    std::size_t m_length;
    std::unordered_map<Mask, Look> m_known;
};

/// The rows that a band covers in a group of columns: some of them, and all.
struct Reach {
    int some = 0, someEnd = 0;
    int all = 0, allEnd = 0; ///< nothing where all >= allEnd

    static Reach of(const PixelColumns &columns, std::size_t from, std::size_t to, int height)
    {
        std::int16_t highest = std::numeric_limits<std::int16_t>::max(), low = -1;
        std::int16_t lowest = std::numeric_limits<std::int16_t>::min();
        std::int16_t shallow = std::numeric_limits<std::int16_t>::max();
        for (std::size_t x = from; x < to; ++x) {
            highest = std::min(highest, columns.top[x]);
            low = std::max(low, columns.top[x]);
            lowest = std::max(lowest, columns.bottom[x]);
            shallow = std::min(shallow, columns.bottom[x]);
        }
        const auto row = [height](int value) { return std::clamp(value, 0, height); };
        return {row(highest), row(lowest + 1), row(low), row(shallow + 1)};
    }
    bool any() const { return some < someEnd; }
};

/// Rows of a group of columns in which the same bands cover all of it and the same bands a part.
struct Stretch {
    int end = 0; ///< row after the last
    Mask whole = 0;
    Mask part = 0;
    const Look *look = nullptr; ///< of `whole`; nullptr if that is none
    bool done = false; ///< painted already

    /// Both are of one look from side to side.
    bool isAs(const Stretch &other) const
    {
        return look == other.look && part == 0 && other.part == 0 && done == other.done;
    }
};

class Painter {
public:
    Painter(QImage &image, std::span<const Band> bands, int stripeWidth, std::int64_t first,
        std::optional<QRgb> ground)
        : m_image(image)
        , m_width(std::size_t(image.width()))
        , m_height(image.height())
        , m_bands(bands)
        , m_looks(bands, stripeWidth, std::size_t(image.width()))
        , m_ground(ground)
    {
        const auto period = static_cast<std::int64_t>(m_looks.period());
        m_left = static_cast<std::size_t>((first % period + period) % period);
        for (std::size_t b = 0; b < bands.size(); ++b)
            m_alone.push_back(m_looks.row(bitOf(b)));
        for (std::size_t x = 0; x < m_width; x += kGroup)
            decide(x);
    }

    void paintRow(QRgb *row, int y)
    {
        const std::size_t phase = (m_left + std::size_t(y)) % m_looks.period();
        for (std::size_t group = 0; group < m_at.size();) {
            const Stretch &here = at(group, y);
            const std::size_t x = group * kGroup;
            ++group;
            if (here.done)
                continue;
            if (here.part != 0) {
                paintPart(row + x, x, y, x + phase, here);
                continue;
            }
            // As far as the neighbours look the same, at once.
            while (group < m_at.size() && at(group, y).isAs(here))
                ++group;
            const std::size_t count = std::min(group * kGroup, m_width) - x;
            if (here.look != nullptr)
                std::memcpy(row + x, here.look->pixels.data() + x + phase, count * sizeof(QRgb));
            else if (m_ground)
                std::fill_n(row + x, count, *m_ground);
        }
    }

private:
    /// The stretch of a group that row `y` is in; rows are asked for from top to bottom.
    const Stretch &at(std::size_t group, int y)
    {
        while (y >= m_stretches[m_at[group]].end)
            ++m_at[group];
        return m_stretches[m_at[group]];
    }

    void decide(std::size_t x)
    {
        std::array<Reach, kMostBands> reaches;
        std::vector<int> &edges = m_edges;
        edges.assign({0, m_height});
        const std::size_t to = std::min(x + kGroup, m_width);
        for (std::size_t b = 0; b < m_bands.size(); ++b) {
            const Reach reach = reaches[b] = Reach::of(*m_bands[b].columns, x, to, m_height);
            if (reach.any())
                edges.insert(edges.end(), {reach.some, reach.someEnd, reach.all, reach.allEnd});
        }
        std::sort(edges.begin(), edges.end());
        m_at.push_back(m_stretches.size());
        int ragged = 0;
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            if (edges[i] == edges[i + 1])
                continue;
            Stretch stretch;
            stretch.end = edges[i + 1];
            for (std::size_t b = 0; b < m_bands.size(); ++b) {
                const Reach &reach = reaches[b];
                if (reach.all <= edges[i] && edges[i] < reach.allEnd)
                    stretch.whole |= bitOf(b);
                else if (reach.some <= edges[i] && edges[i] < reach.someEnd)
                    stretch.part |= bitOf(b);
            }
            ragged += stretch.part != 0 ? edges[i + 1] - edges[i] : 0;
            m_stretches.push_back(stretch);
        }
        // Columns that differ from their neighbours nearly everywhere are cheaper one by one; and
        // what is no whole group comes once a picture.
        if (ragged * kRagged > m_height || to - x < kGroup) {
            m_stretches.resize(m_at.back());
            m_stretches.push_back({m_height, 0, 0, nullptr, true});
            paintColumns(x, to);
        }
        for (std::size_t i = m_at.back(); i < m_stretches.size(); ++i)
            m_stretches[i].look = m_looks.row(m_stretches[i].whole);
    }

    /// A group column by column, which turns it on its side, and back into the picture.
    void paintColumns(std::size_t from, std::size_t to)
    {
        const auto height = std::size_t(m_height);
        m_tile.resize(kGroup * height);
        const auto stride = m_image.bytesPerLine();
        uchar *bits = m_image.bits();
        const auto forPixels = [&](auto use) {
            for (std::size_t y = 0; y < height; ++y) {
                auto *row = reinterpret_cast<QRgb *>(bits + static_cast<qsizetype>(y) * stride);
                for (std::size_t x = from; x < to; ++x)
                    use(row[x], m_tile[(x - from) * height + y]);
            }
        };
        if (!m_ground)
            forPixels([](QRgb pixel, QRgb &turned) { turned = pixel; });
        for (std::size_t x = from; x < to; ++x)
            paintColumn(x, &m_tile[(x - from) * height]);
        forPixels([](QRgb &pixel, QRgb turned) { pixel = turned; });
    }

    void paintColumn(std::size_t x, QRgb *pixels)
    {
        const std::size_t period = m_looks.period();
        for (int y = 0; y < m_height;) {
            Mask mask = 0;
            int end = m_height;
            for (std::size_t b = 0; b < m_bands.size(); ++b) {
                const int top = m_bands[b].columns->top[x];
                const int bottom = m_bands[b].columns->bottom[x];
                const bool here = top <= y && y <= bottom;
                mask = static_cast<Mask>(mask | (here ? bitOf(b) : 0));
                if (here)
                    end = std::min(end, bottom + 1);
                else if (top > y && top <= bottom)
                    end = std::min(end, top);
            }
            const auto rows = std::size_t(end - y);
            paintStripes(pixels, rows, mask, (m_left + x + std::size_t(y)) % period);
            pixels += rows;
            y = end;
        }
    }

    /// @param place  in a period
    void paintStripes(QRgb *pixels, std::size_t rows, Mask mask, std::size_t place)
    {
        if (mask == 0) {
            if (m_ground)
                std::fill_n(pixels, rows, *m_ground);
            return;
        }
        const std::size_t period = m_looks.period();
        if (m_bands.size() <= kFewBands) {
            const QRgb *stripes = &m_looks.of(mask)->pixels[place];
            for (std::size_t done = 0; done < rows; done += period)
                std::memcpy(pixels + done, stripes, std::min(period, rows - done) * sizeof(QRgb));
            return;
        }
        const QRgb first = m_bands[firstOf(mask)].color;
        std::size_t owner = place / m_looks.stripe();
        std::size_t left = m_looks.stripe() - place % m_looks.stripe(); // of its stripe
        for (std::size_t row = 0; row < std::min(rows, period);) {
            const QRgb color = (mask >> owner & 1) != 0 ? m_bands[owner].color : first;
            for (const std::size_t stop = std::min({row + left, rows, period}); row < stop; ++row)
                pixels[row] = color;
            left = m_looks.stripe();
            owner = owner + 1 == m_bands.size() ? 0 : owner + 1;
        }
        for (std::size_t done = period; done < rows; done += period)
            std::memcpy(pixels + done, pixels, std::min(period, rows - done) * sizeof(QRgb));
    }

    /// Some bands begin or end here. Plain loops without a branch: the compiler makes wide ones of them.
    void paintPart(QRgb *pixels, std::size_t x, int y, std::size_t place, const Stretch &here)
    {
        const std::size_t first = here.whole != 0 ? firstOf(here.whole) : kMostBands;
        Row row{};
        if (here.look != nullptr)
            row.fill(m_bands[first].color);
        else if (m_ground)
            row.fill(*m_ground);
        else
            std::memcpy(row.data(), pixels, sizeof(row));
        // From the last to the first: each hides those behind it.
        for (Mask left = here.part; left != 0;) {
            const auto b = static_cast<std::size_t>(std::bit_width(left)) - 1;
            left = static_cast<Mask>(left & ~bitOf(b));
            cover(b, x, y);
            if (b < first)
                blend(row, m_covers[b], m_bands[b].color);
        }
        if (here.look != nullptr) {
            const QRgb *looks = here.look->pixels.data() + place;
            const std::uint32_t *owned = here.look->owned.data() + place;
            for (std::size_t i = 0; i < kGroup; ++i)
                row[i] = (owned[i] & looks[i]) | (~owned[i] & row[i]);
        }
        for (Mask left = here.part; left != 0; left = static_cast<Mask>(left & (left - 1))) {
            const std::size_t b = firstOf(left);
            const std::uint32_t *owned = m_alone[b]->owned.data() + place;
            Row mine{};
            for (std::size_t i = 0; i < kGroup; ++i)
                mine[i] = m_covers[b][i] & owned[i];
            blend(row, mine, m_bands[b].color);
        }
        std::memcpy(pixels, row.data(), sizeof(row));
    }

    using Row = std::array<QRgb, kGroup>;

    /// All bits set where band `b` covers row `y`.
    void cover(std::size_t b, std::size_t x, int y)
    {
        const std::int16_t *top = &m_bands[b].columns->top[x];
        const std::int16_t *bottom = &m_bands[b].columns->bottom[x];
        const auto here = static_cast<std::int16_t>(y);
        std::array<std::int16_t, kGroup> covered{};
        for (std::size_t i = 0; i < kGroup; ++i)
            covered[i] = static_cast<std::int16_t>(-((top[i] <= here) & (here <= bottom[i])));
        for (std::size_t i = 0; i < kGroup; ++i)
            m_covers[b][i] = static_cast<std::uint32_t>(std::int32_t{covered[i]});
    }
    static void blend(Row &row, const Row &where, QRgb color)
    {
        for (std::size_t i = 0; i < kGroup; ++i)
            row[i] = (where[i] & color) | (~where[i] & row[i]);
    }

    QImage &m_image;
    std::size_t m_width;
    int m_height;
    std::span<const Band> m_bands;
    Looks m_looks;
    std::size_t m_left = 0; ///< where in a period the left column is
    std::vector<const Look *> m_alone; ///< of each band
    std::array<Row, kMostBands> m_covers{};
    std::optional<QRgb> m_ground;
    std::vector<QRgb> m_tile;
    std::vector<Stretch> m_stretches; ///< of the first group from top to bottom, then of the next
    std::vector<std::size_t> m_at; ///< for each group: which of them the row is in
    std::vector<int> m_edges; ///< kept: one allocation for all groups
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

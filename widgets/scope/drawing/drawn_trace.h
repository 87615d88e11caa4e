// DrawnTrace: what a picture shows of a trace, column by column, kept so that the next picture gathers only what is
// new. Includes the slow header: only for the scope's own files.
#pragma once

#include "widgets/scope/drawing/trace_image.h"
#include "widgets/scope/plot.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace widgets {

/// Where a value lies, in rows from the top of the picture.
struct Rows {
    double top;
    double perUnit;
    int of(double value) const
    {
        // Rounds down without a call, which std::floor() is on processors without SSE4.
        const double row = std::clamp((top - value) * perUnit, -4.0, 31000.0);
        return static_cast<int>(row + 4.0) - 4;
    }
};

/// Which time a picture shows, column by column on a grid of whole pixels. When a column begins depends on its number
/// alone: a picture that moved by whole columns has the same ones as before.
struct PictureView {
    double origin = 0.0; ///< seconds; column number 0 begins here
    double pixel = 0.0; ///< seconds; how long a column is
    std::int64_t first = 0; ///< number of the left column
    int width = 0; ///< device pixels
    int height = 0;
    int thickness = 1; ///< of a line, device pixels
    std::optional<QRgb> ground; ///< empty: what is there, which is not known
    int left = 0, right = 0; ///< columns of the whole picture that are beside these

    /// How far something that is drawn of a sample reaches into columns beside its own, at most.
    int reach() const { return 4 * thickness; }
    /// When column `x` begins, counted from the left one; seconds.
    double at(double x) const { return origin + (static_cast<double>(first) + x) * pixel; }
    double from() const { return at(0); }
    double to() const { return at(width); }
    capture::Slices slices() const { return {origin, pixel, first, std::size_t(width)}; }

    /// The column that a time is in, from the left one; bounded to what is drawn around the picture.
    int columnOf(double seconds) const
    {
        constexpr double kFar = 4e18;
        const double place = std::clamp((seconds - origin) / pixel, -kFar, kFar);
        auto number = static_cast<std::int64_t>(place);
        number -= static_cast<double>(number) > place ? 1 : 0;
        return static_cast<int>(
            std::clamp<std::int64_t>(number - first, -reach(), width + reach()));
    }
    /// Number of the column that begins next to a time.
    std::int64_t edgeNear(double seconds) const { return std::llround((seconds - origin) / pixel); }

    /// Columns of the two that have one number are the same.
    bool isOnGridOf(const PictureView &other) const
    {
        return origin == other.origin && pixel == other.pixel && width == other.width
            && height == other.height;
    }
    PictureView part(int begin, int end) const
    {
        PictureView some = *this;
        some.first += begin;
        some.width = end - begin;
        some.left += begin;
        some.right += width - end;
        return some;
    }
    Rows rows(const QCPAxis &axis) const
    {
        const QCPRange range = axis.range();
        return {range.upper, height / range.size()};
    }
};

/// A trace as pixels; of an angle the pieces beyond its end beside them, so that no stroke joins the two.
struct Strokes {
    PixelColumns columns;
    PixelColumns beyond; ///< no column where there is no such piece
};

/// Below this many samples a pixel column single samples can be told apart and are drawn as steps.
constexpr std::uint64_t kSamplesAColumn = 2;
/// Columns taller than this, in pixels, are part of a band rather than of a line.
constexpr int kBandHeight = 8;

/// Columns of a picture.
struct ColumnRange {
    int from, to;
};

struct DrawnTrace {
    /// @param view  the whole picture
    DrawnTrace(const PictureView &view, const Trace &shown, const capture::Channel &its);

    /// The first column in which it may look other than before, by the picture of now; its width or beyond if there is
    /// none.
    int changedFrom(const DrawnTrace &before, const PictureView &view) const;
    /// Gathers columns that are not known yet, and makes strokes of all.
    /// @param known  taken from a picture that was `by` columns to the left; nullptr: nothing
    void gather(const PictureView &view, std::span<const ColumnRange> unknown,
        std::vector<capture::MinMax> *known, int by);

    /// Where one is other than before, the trace is another one, or has lost samples.
    struct Look {
        capture::ChannelId id;
        int slot; ///< of its colour
        QCPRange values;
        bool steps;
        capture::Index begin; ///< of its samples
        bool operator==(const Look &) const = default;
    };
    const Trace *trace; ///< this and the channel: while the picture is made
    const capture::Channel *channel; ///< what the trace, or a ghost of it, has
    Look look;
    capture::Index end; ///< of the samples that there were
    capture::Nanos held; ///< until when the last of them was
    std::vector<capture::MinMax> extremes; ///< of each column; none of steps
    std::optional<float> middle; ///< of a turn that the picture is within
    Strokes strokes;
    bool band = false; ///< is not only lines with a few peaks
};

} // namespace widgets

#include "widgets/scope/drawing/drawn_trace.h"

#include "scope/unit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

namespace {
constexpr int kBandShare = 16; ///< of the picture that is a band at least, as one part in so many
/// An angle that passes its end in more than one of so many columns is a band.
constexpr int kTurnShare = 4;
constexpr std::size_t kSlices = 16; ///< of a column, to find where it does

/// Between the two ends of an angle, if the picture is within one turn: what goes beyond it counts turns, and jumps
/// where it jumps.
std::optional<float> middleOfTurn(const Trace &trace, std::span<const capture::MinMax> extremes)
{
    const double turn = scope::turnOf(trace.info.unit);
    if (!(turn > 0.0))
        return std::nullopt;
    capture::MinMax all;
    std::size_t turns = 0;
    for (const capture::MinMax &column : extremes) {
        all.include(column);
        turns += double(column.max) - double(column.min) > turn / 2 ? 1 : 0;
    }
    const double span = double(all.max) - double(all.min);
    constexpr double kInexact = 1.001;
    if (all.empty() || span <= turn / 2 || span > turn * kInexact
        || turns > extremes.size() / kTurnShare)
        return std::nullopt;
    // Rounded, so that it stays where it is while the ends move a little.
    const double piece = turn / 16;
    return static_cast<float>(std::round((double(all.min) + span / 2) / piece) * piece);
}

/// Where an angle passes its end, the two ends of that column instead of all between them.
void splitTurns(const PictureView &view, const Trace &trace, const capture::Channel &channel,
    std::span<const capture::MinMax> extremes, float middle, Strokes &strokes)
{
    const Rows rows = view.rows(*trace.valueAxis);
    const double turn = scope::turnOf(trace.info.unit);
    strokes.beyond = PixelColumns(view.width);
    for (int x = 0; x < view.width; ++x) {
        const capture::MinMax &column = extremes[std::size_t(x)];
        if (column.empty() || double(column.max) - double(column.min) <= turn / 2)
            continue;
        capture::MinMax high{column.max, column.max};
        capture::MinMax low{column.min, column.min};
        for (const capture::MinMax &slice : channel.columns(view.at(x), view.at(x + 1), kSlices)) {
            if (!slice.empty() && slice.min >= middle)
                high.include(slice);
            else if (!slice.empty() && slice.max < middle)
                low.include(slice);
        }
        strokes.columns.set(x, rows.of(double(high.max)), rows.of(double(high.min)));
        strokes.beyond.set(x, rows.of(double(low.max)), rows.of(double(low.min)));
    }
}

/// @param extremes  a column each
Strokes strokesFrom(const PictureView &view, const Trace &trace, const capture::Channel &channel,
    std::span<const capture::MinMax> extremes, std::optional<float> middle)
{
    const Rows rows = view.rows(*trace.valueAxis);
    Strokes strokes{PixelColumns(view.width), PixelColumns()};
    const bool held = trace.info.kind != capture::ChannelInfo::Kind::Fast;
    for (int x = 0; x < view.width; ++x) {
        const capture::MinMax &column = extremes[std::size_t(x)];
        if (!column.empty()) {
            strokes.columns.set(x, rows.of(double(column.max)), rows.of(double(column.min)));
        } else if (held) {
            // Irregular values: a column between two of them shows the one that still holds.
            if (const auto value = channel.valueAt(view.at(x + 0.5)))
                strokes.columns.set(x, rows.of(*value), rows.of(*value));
        }
    }
    if (middle) {
        splitTurns(view, trace, channel, extremes, *middle, strokes);
        const double turn = scope::turnOf(trace.info.unit);
        strokes.columns.joinTurning(strokes.beyond, static_cast<int>(turn / 2 * rows.perUnit));
    } else {
        strokes.columns.joinNeighbours();
    }
    strokes.columns.thicken(view.thickness);
    strokes.beyond.thicken(view.thickness);
    return strokes;
}
} // namespace

DrawnTrace::DrawnTrace(const PictureView &view, const Trace &shown, const capture::Channel &its)
    : trace(&shown)
    , channel(&its)
    , look{shown.channel, shown.colorSlot, shown.valueAxis->range(),
          its.countIn(view.from(), view.to()) <= kSamplesAColumn * std::uint64_t(view.width),
          its.begin()}
    , end(its.end())
    , held(its.holdUntil(its.end() - 1))
{
}

int DrawnTrace::changedFrom(const DrawnTrace &before, const PictureView &view) const
{
    if (end == before.end && held == before.held)
        return view.width + view.reach();
    // What was the last one may hold for another time now; of what came before it nothing changed.
    return view.columnOf(capture::toSeconds(channel->timeOf(before.end - 1)));
}

void DrawnTrace::gather(const PictureView &view, std::span<const ColumnRange> unknown,
    std::vector<capture::MinMax> *known, int by)
{
    if (look.steps) // of which nothing is kept
        return;
    if (known)
        extremes = std::move(*known);
    extremes.resize(std::size_t(view.width));
    if (by > 0)
        std::move(extremes.begin() + by, extremes.end(), extremes.begin());
    else if (by < 0)
        std::move_backward(extremes.begin(), extremes.end() + by, extremes.end());
    for (const ColumnRange &range : unknown) {
        const auto columns = channel->columns(view.part(range.from, range.to).slices());
        std::copy(columns.begin(), columns.end(), extremes.begin() + range.from);
    }
    middle = middleOfTurn(*trace, extremes);
    strokes = strokesFrom(view, *trace, *channel, extremes, middle);
    // A few peaks make no band: they stay whole, and leave the others' stripes as they are.
    band = strokes.columns.tallerThan(kBandHeight * view.thickness)
        >= std::max(1, view.width / kBandShare);
}

} // namespace widgets

#include "widgets/scope/drawing/waveform_plottable.h"

#include "scope/unit.h"
#include "widgets/base/axis_ticks.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/drawing/wide_registers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace widgets {

namespace {
/// Below this many samples a pixel column single samples can be told apart and are drawn as steps.
constexpr std::uint64_t kSamplesAColumn = 2;
/// Steps this wide, in pixels, get a dot at the sample.
constexpr double kDotSpacing = 8.0;
/// Columns taller than this, in pixels, are part of a band rather than of a line.
constexpr int kBandHeight = 8;
constexpr int kBandShare = 16; ///< of the picture that is a band at least, as one part in so many
constexpr int kStripeWidth = 3;
constexpr int kLongDash = 10; ///< pixels, of reference A
constexpr int kShortDash = 3; ///< of reference B
constexpr double kMarkPlace = 0.01; ///< of a reference's letter, as a share of the width
constexpr double kMarkNext = 0.03; ///< B is beside A
/// An angle that passes its end in more than one of so many columns is a band.
constexpr int kTurnShare = 4;
constexpr std::size_t kSlices = 16; ///< of a column, to find where it does
/// Columns a pixel in a picture without pixels.
constexpr int kShapeColumns = 4;
constexpr int kLabelGround = 215; ///< opacity: the trace below must not make a number hard to read

QColor shadeOfGaps(bool dark) { return dark ? QColor(255, 255, 255, 22) : QColor(0, 0, 0, 18); }

/// @param above  may be transparent
QRgb mixed(QRgb below, const QColor &above)
{
    const auto mix = [share = double(above.alphaF())](
                         int from, int to) { return qRound(from + share * (to - from)); };
    return qRgb(mix(qRed(below), above.red()), mix(qGreen(below), above.green()),
        mix(qBlue(below), above.blue()));
}

/// Those that were kept come before the earlier records.
std::size_t referenceCount(std::span<const Ghost> ghosts)
{
    const auto first = std::find_if(
        ghosts.begin(), ghosts.end(), [](const Ghost &ghost) { return ghost.mark == 0; });
    return static_cast<std::size_t>(first - ghosts.begin());
}

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
} // namespace

/// The pixels of the screen that a plot has. Where the scale is no whole number its edges lie within pixels: it has those that
/// are nearer, as whatever is painted beside it does, lest one row or column be nobody's.
struct WaveformPlottable::Place {
    double ratio = 1.0; ///< device pixels a pixel of the window
    QSize size; ///< device pixels
    QPointF beyond; ///< the first one's corner to the exact one, up to half a device pixel
};

struct WaveformPlottable::View {
    double from;
    double to;
    int width; ///< device pixels
    int height;
    int thickness; ///< of a line, device pixels
    std::optional<QRgb> ground; ///< empty: what is there, which is not known
    double perSecond() const { return width / (to - from); }
    Rows rows(const QCPAxis &axis) const
    {
        const QCPRange range = axis.range();
        return {range.upper, height / range.size()};
    }
};

WaveformPlottable::WaveformPlottable(const ScopePlot &plot, const capture::Capture &capture)
    : QCPAbstractPlottable(plot.timeAxis(), plot.axes.front().axis)
    , m_scopePlot(plot)
    , m_capture(capture)
{
}

void WaveformPlottable::draw(QCPPainter *painter)
{
    const QRect rect = m_scopePlot.rect->rect();
    if (rect.isEmpty())
        return;
    if (painter->modes().testFlag(QCPPainter::pmVectorized)) {
        shadeGaps([&](double left, double width) {
            painter->fillRect(
                QRectF(left, rect.top(), width, rect.height()), shadeOfGaps(m_scopePlot.dark));
        });
        drawShapes(painter);
        drawMarks(painter);
        drawLastValues(painter);
        return;
    }
    // Not antialiased, for which the library moves all by half a pixel, and an image by a whole one.
    painter->setAntialiasing(false);
    const Place place = placeOf(rect, *painter);
    if (const auto now = ranges(); m_image.size() != place.size || now != m_drawn) {
        paintImage(place);
        m_drawn = now;
    }
    // Pixel on pixel: an image of another ratio than 1 is scaled. The library's clip begins a row above the plot, and ends one
    // before its end.
    painter->save();
    painter->setClipping(false);
    painter->translate(rect.topLeft());
    painter->scale(1.0 / place.ratio, 1.0 / place.ratio);
    painter->drawImage(-place.beyond, m_image);
    painter->restore();
    painter->setAntialiasing(true);
    drawMarks(painter);
    drawLastValues(painter);
}

WaveformPlottable::Place WaveformPlottable::placeOf(const QRect &rect, const QPainter &painter)
{
    const QTransform toDevice = painter.deviceTransform();
    const QRectF exact = toDevice.mapRect(QRectF(rect));
    const QPoint first(qRound(exact.left()), qRound(exact.top()));
    const QSize size(qRound(exact.right()) - first.x(), qRound(exact.bottom()) - first.y());
    return {toDevice.m11(), size.expandedTo({1, 1}), exact.topLeft() - first};
}

std::vector<QCPRange> WaveformPlottable::ranges() const
{
    std::vector<QCPRange> all{keyAxis()->range()};
    for (const ValueAxis &axis : m_scopePlot.axes)
        all.push_back(axis.axis->range());
    return all;
}

void WaveformPlottable::paintImage(const Place &place)
{
    if (m_image.size() != place.size) // nothing shows through: it is copied, not blended
        m_image = QImage(place.size, QImage::Format_RGB32);
    const std::span<const Ghost> ghosts = m_scopePlot.ghosts;
    const std::span<const Ghost> references = ghosts.first(referenceCount(ghosts));
    clearWideRegisters();
    View view = viewOf(place.size, std::max(1, qRound(place.ratio)));
    view.ground = mParentPlot->palette().color(QPalette::Base).rgb();
    if (references.size() < ghosts.size())
        paintRecords(view);
    else if (!ghosts.empty())
        m_image.fill(*view.ground);
    ImageInk ink(m_image, ghosts.empty() ? view.ground : std::nullopt);
    drawGhosts(references, view, ink);
    drawTraces(view, ink);
    paintGround(*view.ground, place);
}

WaveformPlottable::View WaveformPlottable::viewOf(QSize size, int thickness) const
{
    const QCPRange range = keyAxis()->range();
    return {range.lower, range.upper, size.width(), size.height(), thickness, std::nullopt};
}

void WaveformPlottable::drawShapes(QCPPainter *painter) const
{
    const QRect rect = m_scopePlot.rect->rect();
    const QSize size = rect.size() * kShapeColumns;
    painter->save();
    painter->setAntialiasing(false);
    painter->translate(rect.topLeft());
    painter->scale(1.0 / kShapeColumns, 1.0 / kShapeColumns);
    {
        const View view = viewOf(size, kShapeColumns);
        ShapeInk ink(*painter, size);
        drawGhosts(m_scopePlot.ghosts, view, ink);
        drawTraces(view, ink);
    }
    painter->restore();
}

/// Grid and gaps, where no trace is.
void WaveformPlottable::paintGround(QRgb ground, const Place &place)
{
    const QRect rect = m_scopePlot.rect->rect();
    const auto column = [&](double x) {
        return qRound(place.beyond.x() + (x - rect.left()) * place.ratio);
    };
    const auto paint = [&](QRect box, QRgb from, QRgb to) {
        box &= m_image.rect();
        for (int y = box.top(); y <= box.bottom(); ++y) {
            auto *row = reinterpret_cast<QRgb *>(m_image.scanLine(y));
            std::replace(row + box.left(), row + box.right() + 1, from, to);
        }
    };
    QRgb grid = ground;
    for (const QCPAxis *axis : {keyAxis(), valueAxis()}) {
        if (!axis->grid()->visible())
            continue;
        grid = mixed(ground, axis->grid()->pen().color());
        for (const double tick : axis->tickVector()) {
            const int at = qRound(axis->coordToPixel(tick));
            paint(axis == keyAxis()
                    ? QRect(column(at), 0, 1, m_image.height())
                    : QRect(0, qRound(place.beyond.y() + (at - rect.top()) * place.ratio),
                        m_image.width(), 1),
                ground, grid);
        }
    }
    shadeGaps([&](double left, double width) {
        const int from = column(left), to = column(left + width);
        const QRect box(from, 0, std::max(1, to - from), m_image.height());
        paint(box, ground, mixed(ground, shadeOfGaps(m_scopePlot.dark)));
        if (grid != ground)
            paint(box, grid, mixed(grid, shadeOfGaps(m_scopePlot.dark)));
    });
}

void WaveformPlottable::shadeGaps(const std::function<void(double left, double width)> &shade) const
{
    const QCPRange range = keyAxis()->range();
    const double pixel = range.size() / std::max(1, m_scopePlot.rect->width());
    // A slow value is unknown for longer than the loss itself: where fast signals are shown, theirs are the gaps.
    using Kind = capture::ChannelInfo::Kind;
    Kind kind = Kind::Polled;
    for (const Trace &trace : m_scopePlot.traces)
        kind = std::min(kind, trace.info.kind);
    std::vector<capture::TimeSpan> gaps;
    const capture::Channel *before = nullptr;
    for (const Trace &trace : m_scopePlot.traces) {
        const capture::Channel *channel = m_capture.channel(trace.channel);
        if (!channel || trace.info.kind != kind || kind == Kind::Polled
            || (before && channel->sharesGapsWith(*before)))
            continue;
        before = channel;
        const auto own = channel->gaps(range.lower, range.upper, pixel);
        gaps.insert(gaps.end(), own.begin(), own.end());
    }
    std::sort(
        gaps.begin(), gaps.end(), [](const auto &a, const auto &b) { return a.from < b.from; });
    double shadedTo = range.lower;
    for (const capture::TimeSpan &gap : gaps) {
        // Signals of one stream share their gaps: each place is shaded once.
        const double from = std::max(gap.from, shadedTo);
        const double to = std::min(gap.to, range.upper);
        if (to > from) {
            const double left = keyAxis()->coordToPixel(from);
            const double width = std::max(1.0, keyAxis()->coordToPixel(to) - left);
            shade(left, width);
            shadedTo = to;
        }
    }
}

/// Bands first, in stripes where they overlap; lines over them, so that no band hides one.
void WaveformPlottable::drawTraces(const View &view, TraceInk &ink) const
{
    struct Dense {
        QRgb color;
        PixelColumns bands;
        PixelColumns lines;
    };
    std::vector<Dense> dense;
    std::vector<std::pair<const Trace *, const capture::Channel *>> sparse;
    for (const Trace &trace : m_scopePlot.traces) {
        const capture::Channel *channel = m_capture.channel(trace.channel);
        if (!channel || channel->empty() || !(view.to > view.from))
            continue;
        const std::uint64_t count = channel->countIn(view.from, view.to);
        if (count <= kSamplesAColumn * std::uint64_t(view.width)) {
            sparse.emplace_back(&trace, channel);
            continue;
        }
        Strokes strokes = strokesOf(view, trace, *channel);
        PixelColumns bands = std::move(strokes.columns);
        const int height = kBandHeight * view.thickness;
        // A few peaks make no band: they stay whole, and leave the others' stripes as they are.
        const bool peaks = bands.tallerThan(height) < view.width / kBandShare;
        PixelColumns lines =
            peaks ? std::exchange(bands, PixelColumns(view.width)) : bands.takeThin(height);
        const QRgb color = traceColor(trace.colorSlot, m_scopePlot.dark).rgba();
        dense.push_back({color, std::move(bands), std::move(lines)});
        if (strokes.beyond.width() > 0)
            dense.push_back({color, PixelColumns(), std::move(strokes.beyond)});
    }
    std::vector<Band> bands;
    for (const Dense &trace : dense) {
        if (!trace.bands.empty())
            bands.push_back({trace.color, &trace.bands});
    }
    ink.bands(bands, kStripeWidth * view.thickness);
    for (const Dense &trace : dense)
        ink.columns(trace.lines, trace.color);
    for (const auto &[trace, channel] : sparse)
        drawSteps(
            view, *trace, *channel, traceColor(trace->colorSlot, m_scopePlot.dark).rgba(), ink);
}

WaveformPlottable::GhostColor WaveformPlottable::colorsOf(
    const Ghost &ghost, const View &view) const
{
    return [this, ground = view.ground, alpha = ghost.alpha](std::size_t trace) {
        QColor color = traceColor(m_scopePlot.traces[trace].colorSlot, m_scopePlot.dark);
        color.setAlpha(alpha);
        return ground ? mixed(*ground, color) : qPremultiply(color.rgba());
    };
}

/// The earlier records, which are the last of the ghosts, on the image, which is ground elsewhere.
void WaveformPlottable::paintRecords(const View &view)
{
    const auto &traces = m_scopePlot.traces;
    RecordPicture::Look look{m_image.size(), view.to - view.from, {}};
    for (const Trace &trace : traces) {
        const QCPRange range = trace.valueAxis->range();
        look.traces.push_back({trace.channel, range.lower, range.upper});
    }
    std::vector<const Ghost *> oldestFirst;
    std::vector<RecordPicture::Record> records;
    std::vector<QRgb> colors;
    for (auto ghost = m_scopePlot.ghosts.rbegin();
         ghost != m_scopePlot.ghosts.rend() && ghost->mark == 0; ++ghost) {
        RecordPicture::Record record{view.from + ghost->shift, 0};
        const GhostColor color = colorsOf(*ghost, view);
        for (std::size_t i = 0; i < traces.size(); ++i) {
            if (const capture::Channel *channel = channelOf(*ghost, traces[i]))
                record.samples += channel->countIn(record.from, view.to + ghost->shift);
            colors.push_back(color(i));
        }
        oldestFirst.push_back(&*ghost);
        records.push_back(record);
    }
    const auto paint = [&](std::size_t record, TraceInk &ink, QRgb first) {
        drawGhost(*oldestFirst[record], view, ink,
            [first](std::size_t trace) { return first + static_cast<QRgb>(trace); });
    };
    m_records.update(look, std::move(records), paint);
    m_records.drawOn(m_image, colors, *view.ground);
}

/// The same traces of another time, paler and behind, older ones first; references dashed, so that they are not told by
/// their colour alone.
void WaveformPlottable::drawGhosts(
    std::span<const Ghost> ghosts, const View &view, TraceInk &ink) const
{
    for (std::size_t i = ghosts.size(); i-- > 0;) {
        const Ghost &ghost = ghosts[i];
        if (ghost.mark == 0) {
            drawGhost(ghost, view, ink, colorsOf(ghost, view));
            continue;
        }
        const int on = (ghost.mark == 'A' ? kLongDash : kShortDash) * view.thickness;
        DashedInk dashed(ink, on, on / 2 + view.thickness);
        drawGhost(ghost, view, dashed, colorsOf(ghost, view));
    }
}

void WaveformPlottable::drawGhost(
    const Ghost &ghost, const View &view, TraceInk &ink, const GhostColor &color) const
{
    View then = view;
    then.from += ghost.shift;
    then.to += ghost.shift;
    for (std::size_t i = 0; i < m_scopePlot.traces.size(); ++i) {
        const Trace &trace = m_scopePlot.traces[i];
        const capture::Channel *channel = channelOf(ghost, trace);
        if (!channel || channel->empty() || !(then.to > then.from))
            continue;
        const QRgb paint = color(i);
        if (channel->countIn(then.from, then.to) <= kSamplesAColumn * std::uint64_t(view.width)) {
            drawSteps(then, trace, *channel, paint, ink);
            continue;
        }
        const Strokes strokes = strokesOf(then, trace, *channel);
        ink.columns(strokes.columns, paint);
        if (strokes.beyond.width() > 0)
            ink.columns(strokes.beyond, paint);
    }
}

/// The letter of each reference at the left end of its traces.
void WaveformPlottable::drawMarks(QCPPainter *painter) const
{
    const QRectF area = m_scopePlot.rect->rect();
    const QCPRange range = keyAxis()->range();
    const QFontMetricsF metrics(painter->font());
    for (const Ghost &ghost : m_scopePlot.ghosts) {
        const double share = kMarkPlace + (ghost.mark == 'B' ? kMarkNext : 0.0);
        for (const Trace &trace : m_scopePlot.traces) {
            const capture::Channel *channel = ghost.mark != 0 ? channelOf(ghost, trace) : nullptr;
            if (!channel)
                continue;
            const auto value = channel->valueAt(range.lower + ghost.shift + share * range.size());
            const double y = value ? trace.valueAxis->coordToPixel(*value) : area.bottom() + 1;
            if (y < area.top() || y > area.bottom())
                continue;
            const QPointF place(
                area.left() + share * area.width(), std::max(y - 2, area.top() + metrics.ascent()));
            painter->setPen(traceColor(trace.colorSlot, m_scopePlot.dark));
            painter->drawText(place, QString(QLatin1Char(ghost.mark)));
        }
    }
}

/// What a ghost has of a trace's register; nullptr: nothing.
const capture::Channel *WaveformPlottable::channelOf(const Ghost &ghost, const Trace &trace) const
{
    if (!ghost.kept)
        return m_capture.channel(trace.channel);
    const capture::Channel *other = nullptr; // of a file, which may have it at another rate
    for (const capture::Channel &channel : *ghost.kept) {
        const capture::ChannelInfo &info = channel.info();
        if (info.registerId != trace.info.registerId)
            continue;
        if (info.kind == trace.info.kind)
            return &channel;
        if (info.unit == trace.info.unit)
            other = &channel;
    }
    return other;
}

WaveformPlottable::Strokes WaveformPlottable::strokesOf(
    const View &view, const Trace &trace, const capture::Channel &channel) const
{
    const Rows rows = view.rows(*trace.valueAxis);
    const auto extremes = channel.columns(view.from, view.to, std::size_t(view.width));
    Strokes strokes{PixelColumns(view.width), PixelColumns()};
    const bool held = trace.info.kind != capture::ChannelInfo::Kind::Fast;
    for (int x = 0; x < view.width; ++x) {
        const capture::MinMax &column = extremes[std::size_t(x)];
        if (!column.empty()) {
            strokes.columns.set(x, rows.of(double(column.max)), rows.of(double(column.min)));
        } else if (held) {
            // Irregular values: a column between two of them shows the one that still holds.
            if (const auto value = channel.valueAt(view.from + (x + 0.5) / view.perSecond()))
                strokes.columns.set(x, rows.of(*value), rows.of(*value));
        }
    }
    const double turn = scope::turnOf(trace.info.unit);
    if (turn > 0.0)
        splitTurns(view, trace, channel, extremes, strokes);
    if (strokes.beyond.width() > 0)
        strokes.columns.joinTurning(strokes.beyond, static_cast<int>(turn / 2 * rows.perUnit));
    else
        strokes.columns.joinNeighbours();
    strokes.columns.thicken(view.thickness);
    strokes.beyond.thicken(view.thickness);
    return strokes;
}

/// Where an angle passes its end, the two ends of that column instead of all between them. Only where the picture is within one turn: what goes
/// beyond it counts turns, and jumps where it jumps.
void WaveformPlottable::splitTurns(const View &view, const Trace &trace,
    const capture::Channel &channel, const std::vector<capture::MinMax> &extremes,
    Strokes &strokes) const
{
    const double turn = scope::turnOf(trace.info.unit);
    capture::MinMax all;
    int turns = 0;
    for (const capture::MinMax &column : extremes) {
        all.include(column);
        turns += double(column.max) - double(column.min) > turn / 2 ? 1 : 0;
    }
    const double span = double(all.max) - double(all.min);
    constexpr double kInexact = 1.001;
    if (all.empty() || span <= turn / 2 || span > turn * kInexact
        || turns > view.width / kTurnShare)
        return;
    const Rows rows = view.rows(*trace.valueAxis);
    const float middle = all.min + (all.max - all.min) / 2;
    strokes.beyond = PixelColumns(view.width);
    for (int x = 0; x < view.width; ++x) {
        const capture::MinMax &column = extremes[std::size_t(x)];
        if (column.empty() || double(column.max) - double(column.min) <= turn / 2)
            continue;
        capture::MinMax high{column.max, column.max};
        capture::MinMax low{column.min, column.min};
        const double from = view.from + x / view.perSecond();
        const double to = view.from + (x + 1) / view.perSecond();
        for (const capture::MinMax &slice : channel.columns(from, to, kSlices)) {
            if (!slice.empty() && slice.min >= middle)
                high.include(slice);
            else if (!slice.empty() && slice.max < middle)
                low.include(slice);
        }
        strokes.columns.set(x, rows.of(double(high.max)), rows.of(double(high.min)));
        strokes.beyond.set(x, rows.of(double(low.max)), rows.of(double(low.min)));
    }
}

void WaveformPlottable::drawSteps(const View &view, const Trace &trace,
    const capture::Channel &channel, QRgb color, TraceInk &ink) const
{
    const Rows rows = view.rows(*trace.valueAxis);
    const int line = view.thickness;
    const auto samples = channel.samples(
        view.from, view.to, std::size_t(kSamplesAColumn) * std::size_t(view.width) + 1);
    const double perSecond = view.perSecond();
    const auto xOf = [&](double time) {
        const double x = std::clamp((time - view.from) * perSecond, -10.0, view.width + 10.0);
        return static_cast<int>(x + 10.0) - 10; // rounds down, see Rows
    };
    const double halfTurn = scope::turnOf(trace.info.unit) / 2;
    int lastRow = 0;
    double lastValue = 0.0;
    bool joined = false; // to the sample before it, which may be left of the picture
    for (const capture::Sample &sample : samples) {
        const int left = xOf(sample.time);
        const int right = xOf(sample.holdUntil);
        const int row = rows.of(sample.value);
        const bool turned = halfTurn > 0.0 && std::abs(sample.value - lastValue) > halfTurn;
        const bool joins = joined && !sample.first && !turned;
        if (joins)
            ink.box(left, std::min(row, lastRow) - line / 2, line, std::abs(row - lastRow) + line,
                color);
        if (!joins || right - left > line) // else the stroke that joins them has covered it
            ink.box(left, row - line / 2, std::max(line, right - left), line, color);
        lastRow = row;
        lastValue = sample.value;
        joined = true;
        if ((sample.holdUntil - sample.time) * perSecond >= kDotSpacing * line)
            ink.box(left - line, row - line - line / 2, 3 * line, 3 * line, color);
    }
}

/// The last visible value of each trace at the right edge, in its colour, moved apart where they would overlap.
void WaveformPlottable::drawLastValues(QCPPainter *painter) const
{
    struct Label {
        double y;
        QString text;
        QColor color;
    };
    const QCPRange range = keyAxis()->range();
    const QRectF area = m_scopePlot.rect->rect();
    const QFontMetricsF metrics(painter->font());
    std::vector<Label> labels;
    for (const Trace &trace : m_scopePlot.traces) {
        const auto value = m_capture.valueAt(trace.channel, range.upper - range.size() * 1e-6);
        const auto last = m_capture.timeSpan(trace.channel);
        const bool ended =
            !isOld(trace, m_capture) && last && last->to < range.upper && last->to > range.lower;
        const auto shown = value ? value
            : ended              ? m_capture.lastValue(trace.channel)
                                 : std::nullopt;
        if (!shown)
            continue;
        const double step = readingStep(trace);
        const double y = trace.valueAxis->coordToPixel(*shown);
        labels.push_back({std::clamp(y, area.top() + metrics.height() + 1, area.bottom()),
            valueLabel(*shown, step, mParentPlot->locale()),
            traceColor(trace.colorSlot, m_scopePlot.dark)});
    }
    std::sort(
        labels.begin(), labels.end(), [](const Label &a, const Label &b) { return a.y > b.y; });
    double below = area.bottom() + metrics.height();
    for (Label &label : labels) {
        label.y = std::min(label.y, below - metrics.height());
        below = label.y;
    }
    // Those pushed out at the top come back down; what then has no room is not written.
    double above = area.top() + 1;
    for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
        label->y = std::max(label->y, above + metrics.height());
        above = label->y;
    }
    for (const Label &label : labels) {
        if (label.y > area.bottom() + 1)
            continue;
        const double left = area.right() - metrics.horizontalAdvance(label.text) - 4;
        // Above the trace's end, so that it stays visible.
        const QRectF box(
            left, label.y - metrics.height() - 1, area.right() - left, metrics.height());
        QColor ground = mParentPlot->palette().color(QPalette::Base);
        ground.setAlpha(kLabelGround);
        painter->fillRect(box, ground);
        painter->setPen(label.color);
        painter->drawText(box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, label.text);
    }
}

} // namespace widgets

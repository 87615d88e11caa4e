#include "widgets/scope/drawing/waveform_plottable.h"

#include "scope/unit.h"
#include "widgets/base/axis_ticks.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/drawing/wide_registers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace widgets {

namespace {
/// Steps this wide, in pixels, get a dot at the sample.
constexpr double kDotSpacing = 8.0;
constexpr int kStripeWidth = 3;
constexpr int kLongDash = 10; ///< pixels, of reference A
constexpr int kShortDash = 3; ///< of reference B
constexpr double kMarkPlace = 0.01; ///< of a reference's letter, as a share of the width
constexpr double kMarkNext = 0.03; ///< B is beside A
/// Columns a pixel in a picture without pixels.
constexpr int kShapeColumns = 4;
constexpr double kFar = 1e6; ///< pixels, beyond any screen
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

/// Adds what a channel has in a record, and where that ends, also just beyond the edge, where it is still seen.
void count(RecordPicture::Record &record, const capture::Channel &channel, const PictureView &view,
    double shift)
{
    record.samples += channel.countIn(record.from, view.to() + shift);
    const capture::Nanos end = capture::toNanos(view.at(view.width + view.reach()) + shift);
    const capture::Index next = channel.atOrAfter(end);
    if (next == channel.begin())
        return;
    if (const capture::Nanos held = channel.holdUntil(next - 1); held < end)
        record.ends += static_cast<std::uint64_t>(held);
}

/// Colours the pixels of a box that have another colour.
void recolor(QImage &image, QRect box, QRgb from, QRgb to)
{
    box &= image.rect();
    for (int y = box.top(); y <= box.bottom(); ++y) {
        auto *row = reinterpret_cast<QRgb *>(image.scanLine(y));
        std::replace(row + box.left(), row + box.right() + 1, from, to);
    }
}
} // namespace

/// The pixels of the screen that a plot has. Where the scale is no whole number its edges lie within pixels: it has
/// those that are nearer, as all that is painted beside it does, so that no row or column is left out.
struct WaveformPlottable::Place {
    double ratio = 1.0; ///< device pixels a pixel of the window
    QSize size; ///< device pixels
    QPointF beyond; ///< the first one's corner to the exact one, up to half a device pixel
};

/// Grid and gaps, where no trace is.
struct WaveformPlottable::Ground {
    static constexpr std::uint8_t kLine = 1, kGap = 2;
    QRgb color = 0, grid = 0;
    bool dark = false;
    std::vector<int> rows; ///< of the grid
    std::vector<std::uint8_t> columns; ///< what each of the picture's is part of

    /// @param at  where in the picture the image begins
    void paintOn(QImage &image, int at) const
    {
        for (const int row : rows)
            recolor(image, QRect(0, row, image.width(), 1), color, grid);
        for (int x = 0, next = 0; x < image.width(); x = next) {
            const std::uint8_t is = columns[std::size_t(at) + std::size_t(x)];
            while (next < image.width() && columns[std::size_t(at) + std::size_t(next)] == is)
                ++next;
            const QRect box(x, 0, next - x, image.height());
            if ((is & kLine) != 0)
                recolor(image, box, color, grid);
            if ((is & kGap) != 0)
                recolor(image, box, color, mixed(color, shadeOfGaps(dark)));
            if ((is & kGap) != 0 && grid != color)
                recolor(image, box, grid, mixed(grid, shadeOfGaps(dark)));
        }
    }
};

struct WaveformPlottable::Picture {
    PictureView view;
    double ratio = 0.0;
    std::vector<Ghost> ghosts;
    Ground ground;
    std::vector<DrawnTrace> traces;

    /// Nothing is other than it was before but where it begins, and that samples came.
    bool goesOn(const Picture &before) const
    {
        return ratio == before.ratio && ghosts == before.ghosts && view.isOnGridOf(before.view)
            && ground.color == before.ground.color && ground.grid == before.ground.grid
            && ground.dark == before.ground.dark && ground.rows == before.ground.rows
            && std::equal(traces.begin(), traces.end(), before.traces.begin(), before.traces.end(),
                [](const auto &a, const auto &b) { return a.look == b.look; });
    }
};

WaveformPlottable::WaveformPlottable(const ScopePlot &plot, const capture::Capture &capture)
    : QCPAbstractPlottable(plot.timeAxis(), plot.axes.front().axis)
    , m_scopePlot(plot)
    , m_capture(capture)
    , m_picture(std::make_unique<Picture>())
{
}

WaveformPlottable::~WaveformPlottable() = default;

void WaveformPlottable::renew()
{
    m_drawn.clear();
    // To the columns of the picture, which it is at most half of one away from: all that goes by the axis moves as the
    // traces do.
    const PictureView view = viewOf(m_image.size(), 1);
    if (view.width > 0 && view.from() != keyAxis()->range().lower)
        keyAxis()->setRange(view.from(), view.to());
}

void WaveformPlottable::draw(QCPPainter *painter)
{
    const QRect rect = m_scopePlot.rect->rect();
    if (rect.isEmpty())
        return;
    if (painter->modes().testFlag(QCPPainter::pmVectorized)) {
        for (const capture::TimeSpan &gap : gapsIn(keyAxis()->range(), rect.width())) {
            const double left = keyAxis()->coordToPixel(gap.from);
            const double width = std::max(1.0, keyAxis()->coordToPixel(gap.to) - left);
            painter->fillRect(
                QRectF(left, rect.top(), width, rect.height()), shadeOfGaps(m_scopePlot.dark));
        }
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
    // Pixel on pixel: an image of another ratio than 1 is scaled. The library's clip begins a row above the plot, and
    // ends one before its end.
    painter->save();
    painter->setClipping(false);
    painter->translate(rect.topLeft());
    painter->scale(1.0 / place.ratio, 1.0 / place.ratio);
    forParts({0, m_image.width()},
        [&](int at, QImage &part) { painter->drawImage(QPointF(at, 0) - place.beyond, part); });
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
    const std::span<const Ghost> ghosts = m_scopePlot.ghosts;
    const std::span<const Ghost> references = ghosts.first(referenceCount(ghosts));
    clearWideRegisters();
    PictureView view = viewOf(place.size, std::max(1, qRound(place.ratio)));
    view.ground = mParentPlot->palette().color(QPalette::Base).rgb();
    Picture now{view, place.ratio, m_scopePlot.ghosts, groundOf(view, place), tracesOf(view)};
    const Columns unknown = goOn(now);
    *m_picture = std::move(now);
    if (unknown.empty())
        return;
    if (references.size() < ghosts.size())
        paintRecords(view);
    else if (!ghosts.empty())
        m_image.fill(*view.ground);
    for (const ColumnRange &range : unknown)
        forParts(range, [&](int at, QImage &part) {
            const PictureView some = view.part(at, at + part.width());
            ImageInk ink(part, ghosts.empty() ? view.ground : std::nullopt);
            drawGhosts(references, some, ink);
            drawTraces(some, m_picture->traces, ink);
            m_picture->ground.paintOn(part, at);
        });
}

/// Makes a picture of the one before it, as far as that is still true.
/// @return  columns that have to be painted: what was not in it, what may have changed, and if it moved both ends,
///          which something reaches into from outside; all where the pictures differ in more than that, or where ghosts
///          are behind them, which are painted as a whole
WaveformPlottable::Columns WaveformPlottable::goOn(Picture &now)
{
    Picture &before = *m_picture;
    const PictureView &view = now.view;
    const std::int64_t moved = view.first - before.view.first;
    bool same = now.goesOn(before) && std::abs(moved) < view.width;
    const int by = same ? static_cast<int>(moved) : 0;
    const int left = by == 0 ? 0 : view.reach() + std::max(0, -by);
    int right = by == 0 ? view.width : view.width - view.reach() - std::max(0, by);
    for (std::size_t i = 0; same && i < now.traces.size(); ++i)
        right = std::min(right, now.traces[i].changedFrom(before.traces[i], view) - view.reach());
    same = same && left < right;
    const bool kept = same;
    const Columns all{{0, view.width}};
    Columns unknown = same ? Columns{{0, left}, {right, view.width}} : all;
    for (std::size_t i = 0; i < now.traces.size(); ++i) {
        DrawnTrace &drawn = now.traces[i];
        drawn.gather(view, unknown, kept ? &before.traces[i].extremes : nullptr, by);
        same =
            same && drawn.middle == before.traces[i].middle && drawn.band == before.traces[i].band;
    }
    // Lines of the grid are where the axis has its ticks, which is not on each pixel of a fine screen.
    for (int x = left; same && x < right; ++x) {
        const int then = x + by;
        if (now.ground.columns[std::size_t(x)] == before.ground.columns[std::size_t(then)])
            continue;
        if (unknown.back().to != x)
            unknown.push_back({x, x});
        ++unknown.back().to;
    }
    if (const QSize size(view.width, view.height); m_image.size() != size)
        m_image = QImage(size, QImage::Format_RGB32); // nothing shows through: it is copied
    std::erase_if(unknown, [](const ColumnRange &range) { return range.from == range.to; });
    same = same && (unknown.empty() || now.ghosts.empty());
    m_start = same ? (m_start + by + view.width) % view.width : 0;
    return same ? unknown : all;
}

/// What shows the columns of the picture, in at most two pieces: the image is a ring, which saves a copy.
void WaveformPlottable::forParts(
    ColumnRange columns, const std::function<void(int at, QImage &part)> &use)
{
    const int width = m_image.width();
    while (columns.from < columns.to) {
        const int place = (m_start + columns.from) % width;
        const int count = std::min(columns.to - columns.from, width - place);
        QImage part(m_image.bits() + std::size_t(place) * sizeof(QRgb), count, m_image.height(),
            m_image.bytesPerLine(), m_image.format());
        use(columns.from, part);
        columns.from += count;
    }
}

std::vector<DrawnTrace> WaveformPlottable::tracesOf(const PictureView &view) const
{
    std::vector<DrawnTrace> traces;
    for (const Trace &trace : m_scopePlot.traces) {
        const capture::Channel *channel = m_capture.channel(trace.channel);
        if (channel && !channel->empty() && view.to() > view.from())
            traces.emplace_back(view, trace, *channel);
    }
    return traces;
}

/// On the columns of the picture before, unless other times or sizes are wanted: then, and where there are ghosts,
/// which lie between them, the axis begins with a column.
PictureView WaveformPlottable::viewOf(QSize size, int thickness) const
{
    constexpr double kSame = 1e-3; // of a pixel; ends of the axis are sums of seconds
    const QCPRange range = keyAxis()->range();
    const PictureView &before = m_picture->view;
    const double pixel = range.size() / size.width();
    PictureView view{range.lower, pixel, 0, size.width(), size.height(), thickness, std::nullopt};
    if (m_scopePlot.ghosts.empty() && before.width == view.width
        && std::abs(pixel - before.pixel) * view.width < kSame * pixel) {
        view.origin = before.origin;
        view.pixel = before.pixel;
        view.first = before.edgeNear(range.lower);
    }
    return view;
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
        const PictureView view = viewOf(size, kShapeColumns);
        std::vector<DrawnTrace> traces = tracesOf(view);
        for (DrawnTrace &trace : traces)
            trace.gather(view, std::array{ColumnRange{0, view.width}}, nullptr, 0);
        ShapeInk ink(*painter, size);
        drawGhosts(m_scopePlot.ghosts, view, ink);
        drawTraces(view, traces, ink);
    }
    painter->restore();
}

WaveformPlottable::Ground WaveformPlottable::groundOf(
    const PictureView &view, const Place &place) const
{
    const QPoint corner = m_scopePlot.rect->rect().topLeft();
    Ground ground{*view.ground, *view.ground, m_scopePlot.dark, {},
        std::vector<std::uint8_t>(std::size_t(view.width))};
    const auto mark = [&](std::int64_t from, std::int64_t to, std::uint8_t what) {
        for (auto x = std::max<std::int64_t>(from, 0); x < std::min<std::int64_t>(to, view.width);
             ++x)
            ground.columns[std::size_t(x)] |= what;
    };
    for (const QCPAxis *axis : {keyAxis(), valueAxis()}) {
        if (!axis->grid()->visible())
            continue;
        ground.grid = mixed(*view.ground, axis->grid()->pen().color());
        for (const double tick : axis->tickVector()) {
            const double exact = axis->coordToPixel(tick);
            if (!(std::abs(exact) < kFar))
                continue;
            const int at = qRound(exact); // as the axis has it
            const int column = qRound(place.beyond.x() + (at - corner.x()) * place.ratio);
            if (axis == keyAxis())
                mark(column, column + 1, Ground::kLine);
            else
                ground.rows.push_back(qRound(place.beyond.y() + (at - corner.y()) * place.ratio));
        }
    }
    for (const capture::TimeSpan &gap :
        gapsIn({view.from(), view.to()}, view.width / place.ratio)) {
        const std::int64_t from = view.edgeNear(gap.from) - view.first;
        mark(from, std::max(from + view.thickness, view.edgeNear(gap.to) - view.first),
            Ground::kGap);
    }
    return ground;
}

/// Those that are wider than one of so many pixels, each place once.
std::vector<capture::TimeSpan> WaveformPlottable::gapsIn(const QCPRange &range, double pixels) const
{
    const double pixel = range.size() / std::max(1.0, pixels);
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
    std::vector<capture::TimeSpan> shaded;
    double shadedTo = range.lower;
    for (const capture::TimeSpan &gap : gaps) {
        // Signals of one stream share their gaps: each place is shaded once.
        const double from = std::max(gap.from, shadedTo);
        const double to = std::min(gap.to, range.upper);
        if (to > from) {
            shaded.push_back({from, to});
            shadedTo = to;
        }
    }
    return shaded;
}

/// Bands first, in stripes where they overlap; lines over them, so that no band hides one.
void WaveformPlottable::drawTraces(
    const PictureView &view, std::span<const DrawnTrace> traces, TraceInk &ink) const
{
    struct Dense {
        QRgb color;
        PixelColumns bands;
        PixelColumns lines;
    };
    const auto colorOf = [this](const DrawnTrace &drawn) {
        return traceColor(drawn.look.slot, m_scopePlot.dark).rgba();
    };
    const int end = view.left + view.width;
    std::vector<Dense> dense;
    for (const DrawnTrace &drawn : traces) {
        if (drawn.look.steps)
            continue;
        PixelColumns bands = drawn.strokes.columns.part(view.left, end);
        PixelColumns lines = drawn.band ? bands.takeThin(kBandHeight * view.thickness)
                                        : std::exchange(bands, PixelColumns());
        dense.push_back({colorOf(drawn), std::move(bands), std::move(lines)});
        if (drawn.strokes.beyond.width() > 0)
            dense.push_back(
                {colorOf(drawn), PixelColumns(), drawn.strokes.beyond.part(view.left, end)});
    }
    std::vector<Band> bands;
    for (const Dense &trace : dense) {
        if (trace.bands.width() > 0) // or it is none anywhere in the picture
            bands.push_back({trace.color, &trace.bands});
    }
    ink.bands(bands, kStripeWidth * view.thickness, view.first);
    for (const Dense &trace : dense)
        ink.columns(trace.lines, trace.color);
    for (const DrawnTrace &drawn : traces) {
        if (drawn.look.steps)
            drawSteps(view, *drawn.trace, *drawn.channel, colorOf(drawn), ink);
    }
}

WaveformPlottable::GhostColor WaveformPlottable::colorsOf(
    const Ghost &ghost, const PictureView &view) const
{
    return [this, ground = view.ground, alpha = ghost.alpha](std::size_t trace) {
        QColor color = traceColor(m_scopePlot.traces[trace].colorSlot, m_scopePlot.dark);
        color.setAlpha(alpha);
        return ground ? mixed(*ground, color) : qPremultiply(color.rgba());
    };
}

/// The earlier records, which are the last of the ghosts, on the image, which is ground elsewhere.
void WaveformPlottable::paintRecords(const PictureView &view)
{
    const auto &traces = m_scopePlot.traces;
    RecordPicture::Look look{m_image.size(), view.to() - view.from(), {}};
    for (const Trace &trace : traces) {
        const QCPRange range = trace.valueAxis->range();
        look.traces.push_back({trace.channel, range.lower, range.upper});
    }
    std::vector<const Ghost *> oldestFirst;
    std::vector<RecordPicture::Record> records;
    std::vector<QRgb> colors;
    for (auto ghost = m_scopePlot.ghosts.rbegin();
         ghost != m_scopePlot.ghosts.rend() && ghost->mark == 0; ++ghost) {
        RecordPicture::Record record{view.from() + ghost->shift, 0};
        const GhostColor color = colorsOf(*ghost, view);
        for (std::size_t i = 0; i < traces.size(); ++i) {
            if (const capture::Channel *channel = channelOf(*ghost, traces[i]))
                count(record, *channel, view, ghost->shift);
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
    std::span<const Ghost> ghosts, const PictureView &view, TraceInk &ink) const
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
    const Ghost &ghost, const PictureView &view, TraceInk &ink, const GhostColor &color) const
{
    PictureView then = view;
    then.origin += ghost.shift;
    for (std::size_t i = 0; i < m_scopePlot.traces.size(); ++i) {
        const Trace &trace = m_scopePlot.traces[i];
        const capture::Channel *channel = channelOf(ghost, trace);
        if (!channel || channel->empty() || !(then.to() > then.from()))
            continue;
        const QRgb paint = color(i);
        DrawnTrace drawn(then, trace, *channel);
        if (drawn.look.steps) {
            drawSteps(then, trace, *channel, paint, ink);
            continue;
        }
        drawn.gather(then, std::array{ColumnRange{0, then.width}}, nullptr, 0);
        ink.columns(drawn.strokes.columns, paint);
        if (drawn.strokes.beyond.width() > 0)
            ink.columns(drawn.strokes.beyond, paint);
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

void WaveformPlottable::drawSteps(const PictureView &view, const Trace &trace,
    const capture::Channel &channel, QRgb color, TraceInk &ink) const
{
    const Rows rows = view.rows(*trace.valueAxis);
    const int line = view.thickness;
    const double perSecond = 1.0 / view.pixel;
    const auto samples = channel.samples(view.at(-std::min(view.left, view.reach())),
        view.at(view.width + std::min(view.right, view.reach())),
        std::size_t(kSamplesAColumn) * std::size_t(view.left + view.width + view.right) + 1);
    const double halfTurn = scope::turnOf(trace.info.unit) / 2;
    int lastRow = 0;
    double lastValue = 0.0;
    bool joined = false; // to the sample before it, which may be left of the picture
    for (const capture::Sample &sample : samples) {
        const int left = view.columnOf(sample.time);
        const int right = view.columnOf(sample.holdUntil);
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

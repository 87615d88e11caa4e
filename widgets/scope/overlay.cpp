#include "widgets/scope/overlay.h"

#include "widgets/base/look/section_head.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/cursors.h"
#include "widgets/scope/events/log.h"
#include "widgets/scope/plot_stack.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kFlagRoom = 3; ///< pixels around a flag's letter
constexpr int kFlagsBeside = 40; ///< pixels of both flags, beside which the distance has to fit
constexpr double kDot = 3.0; ///< radius
constexpr double kTriggerMark = 6.0; ///< half the side of its marks

} // namespace

ScopeOverlay::ScopeOverlay(QCustomPlot &plot, const PlotStack &stack,
    const capture::Capture &capture, const Cursors &cursors, const EventLog &events)
    : QWidget(&plot)
    , m_stack(stack)
    , m_capture(capture)
    , m_cursors(cursors)
    , m_events(events)
{
    setObjectName(QStringLiteral("scopeOverlay"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setVisible(false);
    plot.installEventFilter(this);
    connect(&cursors, &Cursors::changed, this, &ScopeOverlay::follow);
    // Of what happens only markers are drawn here, and they are few: all that is in view is looked at for each.
    connect(&events, &QAbstractItemModel::rowsInserted, this,
        [this](const QModelIndex &, int first, int last) {
            const auto &all = m_events.events();
            if (std::any_of(all.begin() + first, all.begin() + last + 1,
                    [](const ScopeEvent &event) { return event.kind == EventKind::Marker; }))
                follow();
        });
    connect(&events, &QAbstractItemModel::rowsRemoved, this, &ScopeOverlay::follow);
    connect(&events, &QAbstractItemModel::dataChanged, this, &ScopeOverlay::follow);
    connect(&events, &QAbstractItemModel::modelReset, this, &ScopeOverlay::follow);
}

bool ScopeOverlay::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(parentWidget()->rect());
    return QWidget::eventFilter(watched, event);
}

void ScopeOverlay::follow()
{
    const QCPRange seen = m_stack.plot(0).timeAxis()->range();
    const EventLog::Range there = m_events.in(seen.lower, seen.upper);
    const auto &events = m_events.events();
    const bool marked = std::any_of(events.begin() + std::ptrdiff_t(there.first),
        events.begin() + std::ptrdiff_t(there.last),
        [](const ScopeEvent &event) { return event.kind == EventKind::Marker; });
    setVisible(m_cursors.visible() || marked || m_marks.position || !m_measure.empty());
    update();
}

QRect ScopeOverlay::area() const
{
    const QRect first = m_stack.plot(0).rect->rect();
    const QRect last = m_stack.plot(m_stack.count() - 1).rect->rect();
    return first.united(last);
}

/// A vertical line through each plot, but not through what stands between them: it would strike out what is written
/// there.
void ScopeOverlay::drawThrough(QPainter &painter, double x) const
{
    for (int i = 0; i < m_stack.count(); ++i) {
        const QRect plot = m_stack.plot(i).rect->rect();
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    }
}

double ScopeOverlay::xOf(double seconds) const
{
    return m_stack.plot(0).timeAxis()->coordToPixel(seconds);
}

void ScopeOverlay::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintOn(painter);
}

void ScopeOverlay::paintOn(QPainter &painter) const
{
    paintMarkers(painter);
    paintTrigger(painter);
    paintMeasure(painter);
    if (!m_cursors.visible())
        return;
    for (const CursorPair &pair : m_cursors.pairs()) {
        if (&pair != &m_cursors.pair())
            paintPair(painter, pair, false);
    }
    paintDistance(painter, m_cursors.pair());
    paintPair(painter, m_cursors.pair(), true);
}

/// A dotted line under each marker's flag in the lane.
void ScopeOverlay::paintMarkers(QPainter &painter) const
{
    const QRect box = area();
    const QCPRange seen = m_stack.plot(0).timeAxis()->range();
    const EventLog::Range there = m_events.in(seen.lower, seen.upper);
    painter.setPen(QPen(faded(palette().color(QPalette::Text), 150), 1, Qt::DotLine));
    for (std::size_t i = there.first; i < there.last; ++i) {
        const ScopeEvent &event = m_events.events()[i];
        if (event.kind != EventKind::Marker)
            continue;
        const double x = xOf(event.seconds);
        painter.drawLine(QPointF(x, 0), QPointF(x, box.bottom()));
    }
}

void ScopeOverlay::setMarks(const TriggerMarks &marks)
{
    m_marks = marks;
    follow();
}

/// A flag at the top where the trigger is, an arrow at the right edge for each level; hollow where it is out of sight.
void ScopeOverlay::paintTrigger(QPainter &painter) const
{
    if (!m_marks.position)
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect box = area();
    const QColor ink = palette().color(QPalette::Text);
    const double x = xOf(*m_marks.position);
    if (x >= box.left() - 1 && x <= box.right() + 1) {
        painter.setPen(QPen(faded(ink, 90), 1, Qt::DashDotLine));
        drawThrough(painter, x);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawPolygon(QPolygonF{{x - kTriggerMark, box.top() - 1.0},
            {x + kTriggerMark, box.top() - 1.0}, {x, box.top() + 1.4 * kTriggerMark}});
    }
    const int index = m_stack.plotOf(m_marks.source);
    const Trace *trace = m_stack.trace(m_marks.source);
    for (std::size_t i = 0; trace && i < m_marks.levels.size(); ++i) {
        const QRect plot = m_stack.plot(index).rect->rect();
        const double wanted = trace->valueAxis->coordToPixel(m_marks.levels[i]);
        const double y = std::clamp(wanted, double(plot.top()), double(plot.bottom()));
        const QColor color = traceColor(trace->colorSlot, m_stack.plot(index).dark);
        painter.setPen(QPen(faded(color, 110), 1, Qt::DashLine));
        if (y == wanted)
            painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(QPen(color, 1.5));
        painter.setBrush(y == wanted ? QBrush(color) : QBrush(Qt::NoBrush));
        const double tip = plot.right() + 1;
        painter.drawPolygon(QPolygonF{{tip, y}, {tip + 1.6 * kTriggerMark, y - kTriggerMark},
            {tip + 1.6 * kTriggerMark, y + kTriggerMark}});
    }
    painter.restore();
}

void ScopeOverlay::paintPair(QPainter &painter, const CursorPair &pair, bool current) const
{
    const QRect box = area();
    for (const CursorEnd end : {CursorEnd::A, CursorEnd::B}) {
        const double x = xOf(pair.at(end));
        if (x < box.left() || x > box.right() + 1)
            continue;
        // A is a whole line, B a dashed one: they can be told apart without their letters.
        QPen pen(faded(palette().color(QPalette::Text), current ? 255 : 110), 1);
        pen.setCosmetic(true);
        if (end == CursorEnd::B)
            pen.setDashPattern({6, 4});
        painter.setPen(pen);
        drawThrough(painter, x);
        if (current)
            paintDots(painter, pair.at(end));
        const QString letter = QString(QLatin1Char(end == CursorEnd::A ? 'A' : 'B'));
        const QString text = current ? letter : pair.name + QChar(QChar::Nbsp) + letter;
        paintFlag(painter, x, text, current, current && m_cursors.active() == end);
    }
}

void ScopeOverlay::paintFlag(
    QPainter &painter, double x, const QString &text, bool strong, bool active) const
{
    const QFont letters = strong ? inBold(font()) : font();
    painter.setFont(letters);
    const QFontMetricsF metrics(letters);
    const double width = metrics.horizontalAdvance(text) + 2.0 * kFlagRoom;
    const QRect box = area();
    // Inside the picture, on the line's right side where there is room.
    const double left = x + 1 + width <= box.right() ? x + 1 : x - width;
    const QRectF flag(left, box.bottom() - metrics.height(), width, metrics.height());
    const QPalette::ColorRole ground = active ? QPalette::Highlight : QPalette::Text;
    const QPalette::ColorRole ink = active ? QPalette::HighlightedText : QPalette::Base;
    painter.fillRect(flag, faded(palette().color(ground), strong ? 255 : 110));
    painter.setPen(palette().color(ink));
    painter.drawText(flag, Qt::AlignCenter | Qt::TextSingleLine, text);
}

/// A dot where a cursor meets each trace: on the value that is read out, so never on a slope between samples.
void ScopeOverlay::paintDots(QPainter &painter, double seconds) const
{
    const double x = xOf(seconds);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Base), 1));
    for (int i = 0; i < m_stack.count(); ++i) {
        const ScopePlot &plot = m_stack.plot(i);
        for (const Trace &trace : plot.traces) {
            const auto value = m_capture.valueAt(trace.channel, seconds);
            if (!value)
                continue;
            const double y = trace.valueAxis->coordToPixel(*value);
            if (y < plot.rect->top() || y > plot.rect->bottom())
                continue;
            painter.setBrush(traceColor(trace.colorSlot, plot.dark));
            painter.drawEllipse(QPointF(x, y), kDot, kDot);
        }
    }
    painter.restore();
}

void ScopeOverlay::paintDistance(QPainter &painter, const CursorPair &pair) const
{
    const QRect box = area();
    const double from = std::max(xOf(std::min(pair.a, pair.b)), double(box.left()));
    const double to = std::min(xOf(std::max(pair.a, pair.b)), double(box.right()));
    if (!(to > from))
        return;
    for (int i = 0; i < m_stack.count(); ++i) {
        const QRect plot = m_stack.plot(i).rect->rect();
        painter.fillRect(QRectF(from, plot.top(), to - from, plot.height()),
            faded(palette().color(QPalette::Text), 12));
    }
    const QFontMetricsF metrics(font());
    const auto widthOf = [&](const QString &text) {
        return metrics.horizontalAdvance(text) + 2.0 * kFlagRoom;
    };
    QString text = QStringLiteral("\u0394 ") + exactTime(pair.b - pair.a, locale());
    if (widthOf(text) + kFlagsBeside > to - from)
        return;
    const QString both = text + QStringLiteral(" \u00b7 ") + inverseTime(pair.b - pair.a, locale());
    if (widthOf(both) + kFlagsBeside <= to - from)
        text = both;
    const double width = widthOf(text);
    const QRectF place(
        (from + to - width) / 2, box.bottom() - metrics.height(), width, metrics.height());
    painter.fillRect(place, faded(palette().color(QPalette::Base), 200));
    painter.setFont(font());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(place, Qt::AlignCenter | Qt::TextSingleLine, text);
}

} // namespace widgets

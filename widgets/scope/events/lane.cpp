#include "widgets/scope/events/lane.h"

#include "widgets/base/device_text.h"
#include "widgets/base/reading_text.h"
#include "widgets/scope/events/icon.h"
#include "widgets/scope/view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
constexpr double kSign = 11.0; ///< side of a sign, pixels
constexpr double kRoom = 4.0;
constexpr int kNameRoom = 10; ///< pixels around the name
constexpr double kClose = 16.0; ///< nearer than this they are one
constexpr double kLeastText = 36.0;
constexpr std::size_t kMostLines = 12; ///< of a tool tip
} // namespace

EventLane::EventLane(ScopeView &scope, EventLog &log, QWidget *parent)
    : QWidget(parent)
    , m_scope(scope)
    , m_log(log)
{
    setObjectName(QStringLiteral("eventLane"));
    setAccessibleName(tr("Events"));
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const auto repaint = [this] { update(); };
    connect(&log, &EventLog::changed, this, repaint);
    connect(&scope, &ScopeView::drawn, this, repaint);
}

QSize EventLane::sizeHint() const { return {200, fontMetrics().height() + 6}; }

int EventLane::nameWidth() const
{
    return fontMetrics().horizontalAdvance(tr("Events")) + kNameRoom;
}

QRect EventLane::lane() const
{
    const QRect plot = m_scope.plotRect(0);
    return QRect(plot.left(), 0, plot.width(), height());
}

std::vector<EventLane::Cluster> EventLane::clusters() const
{
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    const EventLog::Range range = m_log.in(seen.from, seen.to);
    std::vector<Cluster> all;
    double last = -1e9;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const ScopeEvent &event = m_log.events()[i];
        const double x = m_scope.time().xOf(event.seconds);
        if (all.empty() || x - last >= kClose) {
            all.push_back({x, {i, i + 1}, event.kind});
            last = x;
        } else {
            all.back().range.last = i + 1;
            all.back().worst = std::max(all.back().worst, event.kind);
        }
    }
    return all;
}

QString EventLane::textOf(const Cluster &cluster) const
{
    QStringList lines;
    for (std::size_t i = cluster.range.first; i < cluster.range.last; ++i) {
        if (std::size_t(lines.size()) == kMostLines) {
            const auto more = static_cast<int>(cluster.range.last - i);
            lines.append(tr("and %n more", "events", more));
            break;
        }
        const ScopeEvent &event = m_log.events()[i];
        lines.append(tr("%1  %2: %3", "time, kind of event, what happened")
                         .arg(exactTime(event.seconds - m_scope.time().origin(), m_scope.locale()),
                             eventKindText(event.kind), event.text));
    }
    return lines.join(QLatin1Char('\n'));
}

const EventLane::Cluster *EventLane::at(const std::vector<Cluster> &all, double x) const
{
    for (const Cluster &cluster : all) {
        if (std::abs(cluster.x - x) <= kSign / 2 + 3)
            return &cluster;
    }
    return nullptr;
}

void EventLane::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paintOn(painter);
    if (!hasFocus())
        return;
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(lane().adjusted(0, 0, 0, -1));
}

void EventLane::paintOn(QPainter &painter) const
{
    painter.save();
    painter.setFont(font());
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QRect area = lane();
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    const QRectF name(2, 0, area.left() - 8, height());
    painter.drawText(name, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine,
        fontMetrics().elidedText(tr("Events"), Qt::ElideRight, int(name.width())));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.setClipRect(area.adjusted(-int(kSign), 0, int(kSign), 0));
    const std::vector<Cluster> all = clusters();
    for (std::size_t i = 0; i < all.size(); ++i)
        paintCluster(painter, all[i], i + 1 < all.size() ? all[i + 1].x : area.right() + kSign);
    painter.restore();
}

void EventLane::paintCluster(QPainter &painter, const Cluster &cluster, double end) const
{
    const QRectF sign(cluster.x - kSign / 2, (height() - kSign) / 2 - 0.5, kSign, kSign);
    const auto &events = m_log.events();
    const bool chosen = std::any_of(events.begin() + std::ptrdiff_t(cluster.range.first),
        events.begin() + std::ptrdiff_t(cluster.range.last),
        [this](const ScopeEvent &event) { return event.id == m_selected; });
    if (chosen && hasFocus()) {
        QColor ground = palette().color(QPalette::Highlight);
        ground.setAlpha(90);
        painter.fillRect(sign.adjusted(-3, -3, 3, 3), ground);
    }
    paintEventSign(painter, sign, cluster.worst, palette());
    const double left = sign.right() + kRoom;
    const double room = end - kSign / 2 - kRoom - left;
    const bool many = cluster.count() > 1;
    QString text = many ? QStringLiteral("\u00d7%1").arg(cluster.count())
                        : m_log.events()[cluster.range.first].text;
    if (room < kLeastText && !many)
        return;
    text = fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(std::max(room, 0.0)));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(left, 0, room, height()),
        Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, text);
}

bool EventLane::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const std::vector<Cluster> all = clusters();
    if (const Cluster *found = at(all, help->pos().x()))
        QToolTip::showText(help->globalPos(), plainToolTip(textOf(*found)), this);
    else
        QToolTip::showText(help->globalPos(),
            tr("What happened, on the clock of the traces. Double-click sets a marker."), this);
    return true;
}

void EventLane::keyPressEvent(QKeyEvent *event)
{
    if (event->modifiers() != Qt::NoModifier && event->modifiers() != Qt::KeypadModifier) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Left:
        step(-1);
        return;
    case Qt::Key_Right:
        step(1);
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (const ScopeEvent *chosen = m_log.find(m_selected);
            chosen && chosen->kind == EventKind::Marker)
            Q_EMIT noteWanted(m_selected);
        return;
    case Qt::Key_Delete:
        if (m_log.removeMarker(m_selected))
            m_selected = 0;
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

/// To the next event; from nowhere to the first one in view.
void EventLane::step(int direction)
{
    const auto &events = m_log.events();
    if (events.empty())
        return;
    const auto now = std::find_if(events.begin(), events.end(),
        [this](const ScopeEvent &event) { return event.id == m_selected; });
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    std::ptrdiff_t index = 0;
    if (now != events.end())
        index = now - events.begin() + direction;
    else if (direction > 0)
        index = std::ptrdiff_t(m_log.in(seen.from, seen.to).first);
    else
        index = std::ptrdiff_t(m_log.in(seen.from, seen.to).last) - 1;
    index = std::clamp<std::ptrdiff_t>(index, 0, std::ptrdiff_t(events.size()) - 1);
    select(events[std::size_t(index)].id);
}

void EventLane::select(quint32 id)
{
    m_selected = id;
    if (const ScopeEvent *chosen = m_log.find(id))
        Q_EMIT timeWanted(chosen->seconds);
    sayIt();
    update();
}

/// The words of the selected event, for eyes and for screen readers.
void EventLane::sayIt()
{
    const ScopeEvent *chosen = m_log.find(m_selected);
    if (!chosen)
        return;
    const EventLog::Range one = m_log.in(chosen->seconds, chosen->seconds);
    const QString text = textOf({0.0, one, chosen->kind});
    setAccessibleDescription(text);
    const QPoint place(static_cast<int>(m_scope.time().xOf(chosen->seconds)), height());
    QToolTip::showText(mapToGlobal(place), plainToolTip(text), this);
}

void EventLane::mousePressEvent(QMouseEvent *event)
{
    const std::vector<Cluster> all = clusters();
    const Cluster *found = at(all, event->position().x());
    setFocus(Qt::MouseFocusReason);
    if (!found)
        return;
    m_selected = m_log.events()[found->range.first].id;
    QToolTip::showText(event->globalPosition().toPoint(), plainToolTip(textOf(*found)), this);
    update();
}

void EventLane::mouseDoubleClickEvent(QMouseEvent *event)
{
    const std::vector<Cluster> all = clusters();
    const Cluster *found = at(all, event->position().x());
    if (!found) {
        const QRect area = lane();
        if (event->position().x() >= area.left() && event->position().x() <= area.right())
            Q_EMIT markerWanted(m_scope.time().timeAt(event->position().x()));
        return;
    }
    for (std::size_t i = found->range.first; i < found->range.last; ++i) {
        if (m_log.events()[i].kind == EventKind::Marker) {
            Q_EMIT noteWanted(m_log.events()[i].id);
            return;
        }
    }
}

void EventLane::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace widgets

#include "widgets/forms/rev_up_chart.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/value_text.h"
#include "widgets/forms/rev_up_start.h"
#include "widgets/forms/rev_up_table.h"

#include <QAccessible>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QLineSeries>
#include <QPainterPath>
#include <QValueAxis>

#include <cmath>
#include <limits>

namespace widgets {
namespace {

using motor::RevUp;
using motor::RevUpStage;
using Quantity = RevUpChart::Quantity;

constexpr double kReach = 14.0; ///< px from a point within which it is meant
constexpr double kDeadZone = 3.0; ///< px that a hand trembles
constexpr double kRadius = 5.0;
constexpr double kRoom = 1.15; ///< beside and above the curves: to drag into
constexpr double kGap = 4.0; ///< px beside words in the picture
constexpr double kMs = 1e3;

std::size_t at(Quantity quantity) { return static_cast<std::size_t>(quantity); }

QString amps(double value, int decimals)
{
    return numberText(value, decimals) + QStringLiteral("\u202fA");
}

void setRange(QValueAxis &axis, double from, double to, int steps)
{
    const double step = tickStep(to - from, steps);
    axis.setTickType(QValueAxis::TicksDynamic);
    axis.setTickAnchor(0.0);
    axis.setTickInterval(step);
    axis.setLabelFormat(
        QStringLiteral("%.%1f").arg(step < 1.0 ? int(std::ceil(-std::log10(step))) : 0));
    axis.setRange(from, to);
}

} // namespace

RevUpChart::RevUpChart(RevUpModel &model, QWidget *parent)
    : QChartView(parent)
    , m_model(model)
    , m_time(new QValueAxis(this))
    , m_axes{new QValueAxis(this), new QValueAxis(this)}
    , m_plan{}
    , m_measured{}
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setViewportUpdateMode(FullViewportUpdate); // the foreground is ours
    setAccessibleName(tr("Picture of the rev-up: speed and current over time"));
    chart()->legend()->hide();
    chart()->setMargins(QMargins(2, 6, 2, 2));
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    chart()->setLocalizeNumbers(true);
    chart()->setLocale(plainLocale());
    makeSeries();
    restyle();
    connect(&model, &RevUpModel::stagesChanged, this, &RevUpChart::showStages);
    showStages();
}

void RevUpChart::makeSeries()
{
    chart()->addAxis(m_time, Qt::AlignBottom);
    chart()->addAxis(m_axes[0], Qt::AlignLeft);
    chart()->addAxis(m_axes[1], Qt::AlignRight);
    for (auto *lines : {&m_plan, &m_measured}) {
        for (std::size_t i = 0; i < lines->size(); ++i) {
            auto *line = new QLineSeries(this);
            (*lines)[i] = line;
            chart()->addSeries(line);
            line->attachAxis(m_time);
            line->attachAxis(m_axes[i]);
        }
    }
}

QColor RevUpChart::colorOf(Quantity quantity) const
{
    const bool dark = palette().color(QPalette::Base).lightness() < 128;
    if (quantity == Quantity::Speed)
        return dark ? QColor(0x56, 0xb4, 0xe9) : QColor(0x00, 0x62, 0xa3);
    return dark ? QColor(0xf0, 0xa0, 0x40) : QColor(0xb3, 0x4a, 0x00);
}

void RevUpChart::restyle()
{
    const QColor base = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
    QColor grid = text;
    grid.setAlphaF(0.15F);
    chart()->setBackgroundBrush(base);
    chart()->setBackgroundPen(Qt::NoPen);
    setBackgroundBrush(base);
    for (QValueAxis *axis : {m_time, m_axes[0], m_axes[1]}) {
        axis->setLabelsFont(font());
        axis->setLabelsColor(text);
        axis->setTitleFont(font());
        axis->setTitleBrush(text);
        axis->setLinePen(QPen(text, 1));
        axis->setGridLinePen(QPen(grid, 1));
        axis->setGridLineVisible(axis != m_axes[1]);
    }
    for (const Quantity quantity : {Quantity::Speed, Quantity::Current}) {
        QColor wide = colorOf(quantity);
        wide.setAlphaF(0.6F);
        QPen plan(wide, 3);
        QPen measured(text, 1.2); // stands out where it lies on the plan
        if (quantity == Quantity::Current) {
            plan.setDashPattern({4, 2});
            measured.setDashPattern({5, 3});
        }
        m_plan[at(quantity)]->setPen(plan);
        m_measured[at(quantity)]->setPen(measured);
        m_axes[at(quantity)]->setTitleBrush(colorOf(quantity));
        m_axes[at(quantity)]->setLabelsColor(colorOf(quantity));
    }
}

double RevUpChart::beginOf(int stage) const
{
    const RevUp &stages = m_model.stages();
    double begin = 0.0;
    for (int i = 0; i < stage; ++i)
        begin += stages[static_cast<std::size_t>(i)].duration_ms / kMs;
    return begin;
}

QString RevUpChart::titleOf(Quantity quantity) const
{
    if (quantity == Quantity::Speed)
        return QStringLiteral("\u25cf ") + tr("Speed, rpm");
    return QStringLiteral("\u25a0 ")
        + (m_model.currentUnit().isEmpty() ? tr("%1, digits").arg(m_model.currentName())
                                           : tr("%1, A").arg(m_model.currentName()));
}

/// The titles at its sides are read whole, and below it there is room for the time and its title.
QSize RevUpChart::minimumSizeHint() const
{
    constexpr int kLeastWidth = 230, kAround = 40; // px; what the axes keep free
    const QFontMetrics metrics(font());
    return {kLeastWidth,
        std::max(metrics.horizontalAdvance(titleOf(Quantity::Speed)),
            metrics.horizontalAdvance(titleOf(Quantity::Current)))
            + 2 * metrics.height() + kAround};
}

QPointF RevUpChart::valueOf(const Point &point) const
{
    const RevUpStage &stage = m_model.stages()[static_cast<std::size_t>(point.stage)];
    return {beginOf(point.stage + 1),
        point.quantity == Quantity::Speed ? static_cast<double>(stage.speed_rpm)
                                          : stage.current_digits * m_model.shownPerDigit()};
}

void RevUpChart::showStages()
{
    if (!isVisible())
        return; // until it is
    const int used = m_model.used();
    chart()->setVisible(used > 0);
    for (const Quantity quantity : {Quantity::Speed, Quantity::Current}) {
        QList<QPointF> corners;
        if (used > 0)
            corners.append(QPointF(0.0, 0.0));
        for (int i = 0; i < used; ++i)
            corners.append(valueOf({i, quantity}));
        m_plan[at(quantity)]->replace(corners);
    }
    for (const Quantity quantity : {Quantity::Speed, Quantity::Current})
        if (const QString title = titleOf(quantity); title != m_axes[at(quantity)]->titleText()) {
            m_axes[at(quantity)]->setTitleText(title);
            updateGeometry(); // it may be longer
        }
    m_time->setTitleText(tr("Time, s"));
    if (m_drag && (!m_model.editable() || m_drag->point.stage >= used))
        m_drag.reset();
    if (m_selected && m_selected->stage >= used)
        select(std::nullopt);
    if (!m_drag)
        fit();
    Q_EMIT hintChanged();
}

void RevUpChart::fit()
{
    double end = 0.0;
    std::array<double, 2> least{}, most{};
    for (const auto *lines : {&m_plan, &m_measured}) {
        for (std::size_t i = 0; i < lines->size(); ++i) {
            double low = 0.0, high = 0.0;
            const auto points = (*lines)[i]->points();
            for (const QPointF &point : points) {
                end = std::max(end, point.x());
                low = std::min(low, point.y());
                high = std::max(high, point.y());
            }
            constexpr double kNoise = 0.05; // around zero: no reason for another side of the axis
            least[i] = std::min(least[i], -low < kNoise * high ? 0.0 : low);
            most[i] = std::max(most[i], high < kNoise * -low ? 0.0 : high);
        }
    }
    const auto &limits = m_model.facts().limits;
    if (most[0] >= -least[0])
        most[0] = std::max(most[0], limits.minimumSpeed_rpm);
    else
        least[0] = std::min(least[0], -limits.minimumSpeed_rpm);
    constexpr int kTimeSteps = 8, kValueSteps = 5;
    setRange(*m_time, 0.0, kRoom * std::max(end, 0.05), kTimeSteps);
    const std::array<double, 2> smallest{60.0, 20.0 * m_model.shownPerDigit()};
    for (std::size_t i = 0; i < most.size(); ++i) {
        if (most[i] - least[i] < smallest[i])
            most[i] = least[i] + smallest[i];
        const double room = (kRoom - 1.0) * (most[i] - least[i]);
        setRange(*m_axes[i], least[i] < 0.0 ? least[i] - room : 0.0,
            most[i] > 0.0 ? most[i] + room : 0.0, kValueSteps);
    }
    chart()->layout()->activate();
    viewport()->update();
}

QPointF RevUpChart::toView(const QPointF &value, Quantity quantity) const
{
    return chart()->mapToScene(chart()->mapToPosition(value, m_plan[at(quantity)]));
}

QPointF RevUpChart::toValue(const QPointF &position, Quantity quantity) const
{
    return chart()->mapToValue(chart()->mapFromScene(position), m_plan[at(quantity)]);
}

QPointF RevUpChart::handle(const Point &point) const
{
    return toView(valueOf(point), point.quantity);
}

QList<QPointF> RevUpChart::drawn(Quantity quantity) const { return m_plan[at(quantity)]->points(); }

QList<QPointF> RevUpChart::drawnMeasured(Quantity quantity) const
{
    return m_measured[at(quantity)]->points();
}

void RevUpChart::setMeasured(const MeasuredStart &start)
{
    m_measured[0]->replace(start.speed_rpm);
    QList<QPointF> current = start.current_a;
    if (m_model.currentUnit().isEmpty()) // another axis than amperes
        current.clear();
    m_measured[1]->replace(current);
    if (!m_drag)
        fit();
}

// Selecting and moving ------------------------------------------------------------------------------------------------

void RevUpChart::select(std::optional<Point> point)
{
    if (point == m_selected)
        return;
    m_selected = point;
    viewport()->update();
    Q_EMIT hintChanged();
    if (point)
        Q_EMIT stageSelected(point->stage);
    announce();
}

/// The selected point, to a screen reader.
void RevUpChart::announce()
{
    setAccessibleDescription(hint());
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

void RevUpChart::selectStage(int stage)
{
    if (stage < 0 || stage >= m_model.used())
        return select(std::nullopt);
    select(Point{stage, m_selected ? m_selected->quantity : Quantity::Speed});
}

QString RevUpChart::hint() const
{
    if (m_model.used() == 0)
        return {};
    if (!m_selected)
        return m_model.editable() ? tr("Drag a point, or select one with Page Up and Page Down and "
                                       "move it with the arrow keys.")
                                  : QString();
    const RevUpStage &stage = m_model.stages()[static_cast<std::size_t>(m_selected->stage)];
    const QString number = QString::number(m_selected->stage + 1),
                  time = numberText(beginOf(m_selected->stage + 1), 3),
                  lasts = QString::number(stage.duration_ms);
    if (m_selected->quantity == Quantity::Speed)
        return tr("Stage %1: %2\u202frpm at %3\u202fs (lasts %4\u202fms)")
            .arg(number, numberText(stage.speed_rpm, 0), time, lasts);
    const double shown = stage.current_digits * m_model.shownPerDigit();
    if (m_model.currentUnit().isEmpty())
        return tr("Stage %1: %2 %3 digits at %4\u202fs (lasts %5\u202fms)")
            .arg(number, m_model.currentName(), numberText(shown, 0), time, lasts);
    return tr("Stage %1: Iq %2 (%3 digits) at %4\u202fs (lasts %5\u202fms)")
        .arg(number, amps(shown, decimalsFor(m_model.shownPerDigit())),
            QString::number(stage.current_digits), time, lasts);
}

std::optional<RevUpChart::Point> RevUpChart::pointAt(const QPointF &position) const
{
    std::optional<Point> nearest;
    double least = kReach;
    for (int i = 0; i < m_model.used(); ++i) {
        for (const Quantity quantity : {Quantity::Speed, Quantity::Current}) {
            const Point point{i, quantity};
            double distance = QLineF(handle(point), position).length();
            if (m_selected == point)
                distance -= kRadius; // of points upon one another the selected one
            if (distance < least) {
                least = distance;
                nearest = point;
            }
        }
    }
    return nearest;
}

void RevUpChart::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const auto point = pointAt(event->position());
    select(point);
    if (!point || !m_model.editable())
        return;
    m_drag = Drag{*point, event->position(), handle(*point) - event->position(),
        m_model.stages()[static_cast<std::size_t>(point->stage)], beginOf(point->stage)};
}

void RevUpChart::mouseMoveEvent(QMouseEvent *event)
{
    if (m_drag && event->buttons().testFlag(Qt::LeftButton))
        return dragTo(event->position());
    viewport()->setCursor(
        m_model.editable() && pointAt(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
}

void RevUpChart::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    dragTo(event->position());
    m_drag.reset();
    fit();
}

/// A trembling hand moves a point along one axis only: each way counts once the pointer has gone that way for good.
void RevUpChart::dragTo(const QPointF &position)
{
    if (!m_drag)
        return;
    Drag &drag = *m_drag;
    const QPointF moved = position - drag.from;
    drag.sideways = drag.sideways || std::abs(moved.x()) > kDeadZone;
    drag.upright = drag.upright || std::abs(moved.y()) > kDeadZone;
    const double keep = std::numeric_limits<double>::quiet_NaN();
    const bool speed = drag.point.quantity == Quantity::Speed;
    const QPointF value = toValue(position + drag.offset, drag.point.quantity);
    // A stage with time keeps some: without it would not be a point of its own any more.
    const double ms = std::max(
        std::round((value.x() - drag.begins_s) * kMs), drag.before.duration_ms > 0 ? 1.0 : 0.0);
    const double y = speed ? value.y() : value.y() / m_model.shownPerDigit();
    const RevUpStage wanted = motor::fittedStage(drag.before, drag.upright && speed ? y : keep,
        drag.upright && !speed ? y : keep, drag.sideways ? ms : keep, m_model.bounds());
    if (wanted != m_model.stages()[static_cast<std::size_t>(drag.point.stage)])
        m_model.setStage(drag.point.stage, wanted);
}

/// Arrow keys: one quantum of the register, with Shift ten, with Ctrl and Shift a hundred.
bool RevUpChart::nudge(const QKeyEvent &key)
{
    const bool shift = key.modifiers().testFlag(Qt::ShiftModifier);
    const double steps = !shift                         ? 1.0
        : key.modifiers().testFlag(Qt::ControlModifier) ? 100.0
                                                        : 10.0;
    const int right = key.key() == Qt::Key_Right ? 1 : key.key() == Qt::Key_Left ? -1 : 0;
    const int up = key.key() == Qt::Key_Up ? 1 : key.key() == Qt::Key_Down ? -1 : 0;
    if (!m_selected || (right == 0 && up == 0))
        return false;
    const RevUpStage old = m_model.stages()[static_cast<std::size_t>(m_selected->stage)];
    const double keep = std::numeric_limits<double>::quiet_NaN();
    const bool speed = m_selected->quantity == Quantity::Speed;
    const double ms = std::max(old.duration_ms + right * steps, old.duration_ms > 0 ? 1.0 : 0.0);
    const motor::RevUpBounds bounds = m_model.bounds();
    const RevUpStage wanted = motor::fittedStage(old,
        up != 0 && speed ? old.speed_rpm + up * steps * bounds.speedStep_rpm : keep,
        up != 0 && !speed ? old.current_digits + up * steps : keep, right != 0 ? ms : keep, bounds);
    if (wanted != old)
        m_model.setStage(m_selected->stage, wanted);
    announce();
    return true;
}

void RevUpChart::keyPressEvent(QKeyEvent *event)
{
    const int used = m_model.used();
    const int now = m_selected ? m_selected->stage : -1;
    switch (event->key()) {
    case Qt::Key_PageDown:
        return selectStage(std::min(now + 1, used - 1));
    case Qt::Key_PageUp:
        return selectStage(now < 0 ? used - 1 : std::max(now - 1, 0));
    case Qt::Key_Home:
        return selectStage(0);
    case Qt::Key_End:
        return selectStage(used - 1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_selected)
            select(Point{m_selected->stage,
                m_selected->quantity == Quantity::Speed ? Quantity::Current : Quantity::Speed});
        return;
    case Qt::Key_Insert:
        return addWanted();
    case Qt::Key_Delete:
        return removeWanted();
    default:
        break;
    }
    if (!m_model.editable() || !nudge(*event))
        event->ignore();
}

bool RevUpChart::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        const bool own = key.key() == Qt::Key_Home || key.key() == Qt::Key_End
            || key.key() == Qt::Key_Insert || key.key() == Qt::Key_Delete;
        if (own && key.modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return QChartView::event(event);
}

/// The page that it is on scrolls.
void RevUpChart::wheelEvent(QWheelEvent *event) { event->ignore(); }

void RevUpChart::focusInEvent(QFocusEvent *event)
{
    QChartView::focusInEvent(event);
    if (!m_selected && event->reason() != Qt::MouseFocusReason)
        selectStage(0);
    viewport()->update();
}

void RevUpChart::focusOutEvent(QFocusEvent *event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

void RevUpChart::showEvent(QShowEvent *event)
{
    QChartView::showEvent(event);
    showStages();
}

void RevUpChart::changeEvent(QEvent *event)
{
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        restyle();
    if (event->type() == QEvent::FontChange)
        updateGeometry();
}

void RevUpChart::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    chart()->layout()->activate();
}

// Drawing -------------------------------------------------------------------------------------------------------------

void RevUpChart::drawForeground(QPainter *painter, const QRectF &)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(font());
    if (m_model.used() > 0) {
        drawLimit(*painter, Quantity::Speed, observerSpeed(), wordsOfObserver());
        drawLimit(*painter, Quantity::Current, currentLimit(), wordsOfCurrent());
        drawPoints(*painter);
        drawMistakes(*painter);
    }
    if (hasFocus()) {
        painter->setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(QRectF(viewport()->rect()).adjusted(1, 1, -1, -1));
    }
    painter->restore();
}

/// In the direction in which the plan turns; 0: not known.
double RevUpChart::observerSpeed() const
{
    const double least = m_model.facts().limits.minimumSpeed_rpm;
    return m_axes[0]->max() <= 0.0 ? -least : least;
}

/// In the axis' unit; 0: the axis has none.
double RevUpChart::currentLimit() const
{
    return m_model.currentUnit().isEmpty() ? 0.0
                                           : m_model.bounds().digits * m_model.shownPerDigit();
}

bool RevUpChart::inView(Quantity quantity, double value) const
{
    const QValueAxis &axis = *m_axes[at(quantity)];
    return value != 0.0 && value > axis.min() && value < axis.max();
}

/// Where the plan comes to that speed first, in the viewport; if it never does, the right edge of the picture.
double RevUpChart::reaches(double speed_rpm) const
{
    const QList<QPointF> corners = m_plan[at(Quantity::Speed)]->points();
    for (qsizetype i = 1; i < corners.size(); ++i) {
        const QPointF from = corners[i - 1], by = corners[i] - from;
        if (speed_rpm > 0.0 ? corners[i].y() < speed_rpm : corners[i].y() > speed_rpm)
            continue;
        const double share = by.y() != 0.0 ? (speed_rpm - from.y()) / by.y() : 0.0;
        return toView({from.x() + share * by.x(), speed_rpm}, Quantity::Speed).x();
    }
    return chart()->plotArea().right();
}

/// Clear of the plan: before it comes to that speed, or behind that and on the line's other side; in few words where
/// neither has room.
RevUpChart::Words RevUpChart::wordsOfObserver() const
{
    const double speed_rpm = observerSpeed();
    if (m_model.used() == 0 || !inView(Quantity::Speed, speed_rpm))
        return {};
    const QString few = numberText(std::abs(speed_rpm), 0) + QStringLiteral("\u202frpm");
    QString text = tr("observer sees from %1\u202frpm").arg(numberText(std::abs(speed_rpm), 0));
    const QRectF plot = chart()->plotArea();
    const QFontMetricsF metrics(font());
    const double reach = reaches(speed_rpm);
    const double before = reach - plot.left() - 2 * kGap, behind = plot.right() - reach - 2 * kGap;
    if (metrics.horizontalAdvance(text) > std::max(before, behind))
        text = few;
    const double width = metrics.horizontalAdvance(text), height = metrics.height();
    const bool left = width <= before || before >= behind;
    const double y = toView({0.0, speed_rpm}, Quantity::Speed).y();
    const bool above = left == (speed_rpm > 0.0);
    return {text,
        QRectF(left ? plot.left() + kGap : plot.right() - width - kGap,
            above ? y - kGap / 2 - height : y + kGap / 2, width, height)};
}

RevUpChart::Words RevUpChart::wordsOfCurrent() const
{
    if (!inView(Quantity::Current, currentLimit()))
        return {};
    const QString text = tr("limit %1").arg(amps(currentLimit(), 2));
    const QFontMetricsF metrics(font());
    const double width = metrics.horizontalAdvance(text);
    return {text,
        QRectF(chart()->plotArea().right() - width - kGap,
            toView({0.0, currentLimit()}, Quantity::Current).y() - kGap / 2 - metrics.height(),
            width, metrics.height())};
}

void RevUpChart::drawLimit(
    QPainter &painter, Quantity quantity, double value, const Words &words) const
{
    if (!inView(quantity, value))
        return;
    const QRectF plot = chart()->plotArea();
    const double y = toView({0.0, value}, quantity).y();
    painter.setPen(QPen(colorOf(quantity), 1, Qt::DotLine));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    QColor back = palette().color(QPalette::Base);
    back.setAlphaF(0.5F);
    painter.fillRect(words.place, back);
    painter.drawText(
        words.place.bottomLeft() - QPointF(0, QFontMetricsF(font()).descent()), words.text);
}

void RevUpChart::drawPoints(QPainter &painter) const
{
    const QColor base = palette().color(QPalette::Base);
    for (int i = 0; i < m_model.used(); ++i) {
        for (const Quantity quantity : {Quantity::Current, Quantity::Speed}) {
            const Point point{i, quantity};
            const QPointF centre = handle(point);
            const QRectF box(centre - QPointF(kRadius, kRadius), QSizeF(2 * kRadius, 2 * kRadius));
            const bool chosen = m_selected == point;
            painter.setPen(QPen(colorOf(quantity), 2));
            painter.setBrush(chosen ? colorOf(quantity) : base);
            quantity == Quantity::Speed ? painter.drawEllipse(box) : painter.drawRect(box);
            if (!chosen)
                continue;
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
            painter.drawEllipse(centre, kRadius + 4, kRadius + 4);
        }
    }
}

/// A triangle with a mark above the stage's point that has to change.
void RevUpChart::drawMistakes(QPainter &painter) const
{
    for (const auto &finding : m_model.findings()) {
        const int stage = static_cast<int>(finding.stage);
        if (stage >= m_model.used())
            continue;
        const bool current = finding.mistake == motor::RevUpMistake::TooMuchCurrent;
        const QPointF point = handle({stage, current ? Quantity::Current : Quantity::Speed});
        const double top = chart()->plotArea().top();
        const QPointF tip(point.x(), std::max(point.y() - 26.0, top));
        QPainterPath sign(tip);
        sign.lineTo(tip + QPointF(8, 14));
        sign.lineTo(tip + QPointF(-8, 14));
        sign.closeSubpath();
        painter.setPen(QPen(Qt::black, 1));
        painter.setBrush(QColor(0xff, 0xc1, 0x4d));
        painter.drawPath(sign);
        painter.setPen(QPen(Qt::black, 2));
        painter.drawLine(tip + QPointF(0, 5), tip + QPointF(0, 9));
        painter.drawPoint(tip + QPointF(0, 12));
    }
}

} // namespace widgets

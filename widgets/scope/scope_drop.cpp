// The scope as a place to drop registers on: reads the drag, marks where it would land, and says where it did.
#include "widgets/scope/scope_drop.h"

#include "widgets/base/register_texts.h"
#include "widgets/scope/plot_stack.h"
#include "widgets/scope/scope_view.h"

#include <QDropEvent>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMimeData>
#include <QRubberBand>

namespace widgets {

namespace {
constexpr int kMostRegisters = 64;
constexpr int kNewPlotStrip = 28; ///< pixels at the lower edge that stand for "a new plot"
} // namespace

QList<quint32> registersIn(const QMimeData &data)
{
    QList<quint32> ids;
    const QByteArray json = data.data(QString::fromLatin1(kRegisterMimeType));
    const QJsonArray array = QJsonDocument::fromJson(json).array();
    for (const auto &value : array) {
        const qint64 id = value.toInteger(-1);
        if (id >= 0 && id <= 0xFFFFFFFFLL && ids.size() < kMostRegisters)
            ids.append(static_cast<quint32>(id));
    }
    return ids;
}

int ScopeView::dropPlotAt(const QPoint &position) const
{
    if (channels().isEmpty())
        return 0;
    if (position.y() >= height() - kNewPlotStrip)
        return -1;
    return m_stack->plotAt(m_plot->mapFrom(this, position));
}

void ScopeView::highlightDrop(int plot)
{
    QRect mark(0, height() - kNewPlotStrip, width(), kNewPlotStrip);
    if (plot >= 0) {
        const QRect outer = m_stack->plot(plot).rect->outerRect();
        mark = QRect(m_plot->mapTo(this, outer.topLeft()), outer.size());
    }
    m_dropMark->setGeometry(mark);
    m_dropMark->show();
    m_dropMark->raise();
}

void ScopeView::hideDropMark() { m_dropMark->hide(); }

/// A trace's legend entry was let go there.
void ScopeView::dropTrace(capture::ChannelId channel, const QPoint &position)
{
    hideDropMark();
    if (!rect().contains(position))
        return;
    const int plot = dropPlotAt(position);
    moveChannel(channel, plot < 0 ? plotCount() : plot);
}

void ScopeView::dragEnterEvent(QDragEnterEvent *event)
{
    if (registersIn(*event->mimeData()).isEmpty())
        return;
    highlightDrop(dropPlotAt(event->position().toPoint()));
    event->acceptProposedAction();
}

void ScopeView::dragMoveEvent(QDragMoveEvent *event)
{
    highlightDrop(dropPlotAt(event->position().toPoint()));
    event->acceptProposedAction();
}

void ScopeView::dragLeaveEvent(QDragLeaveEvent *) { hideDropMark(); }

void ScopeView::dropEvent(QDropEvent *event)
{
    hideDropMark();
    const int plot = dropPlotAt(event->position().toPoint());
    const QList<quint32> ids = registersIn(*event->mimeData());
    event->acceptProposedAction();
    for (const quint32 id : ids)
        Q_EMIT registerDropped(id, plot);
}

} // namespace widgets

#include "widgets/scope/drop.h"

#include "widgets/base/register_texts.h"
#include "widgets/scope/plot_stack.h"

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

ScopeDrop::ScopeDrop(QWidget &view, QCustomPlot &plot, const PlotStack &stack)
    : QObject(&view)
    , m_view(view)
    , m_plot(plot)
    , m_stack(stack)
    , m_mark(new QRubberBand(QRubberBand::Rectangle, &view))
{
    view.setAcceptDrops(true);
    view.installEventFilter(this);
}

int ScopeDrop::plotAt(const QPoint &position) const
{
    if (m_stack.channels().empty())
        return 0;
    if (position.y() >= m_view.height() - kNewPlotStrip)
        return -1;
    return m_stack.plotAt(m_plot.mapFrom(&m_view, position));
}

void ScopeDrop::mark(int plot)
{
    QRect mark(0, m_view.height() - kNewPlotStrip, m_view.width(), kNewPlotStrip);
    if (plot >= 0) {
        const QRect outer = m_stack.plot(plot).rect->outerRect();
        mark = QRect(m_plot.mapTo(&m_view, outer.topLeft()), outer.size());
    }
    m_mark->setGeometry(mark);
    m_mark->show();
    m_mark->raise();
}

void ScopeDrop::hideMark() { m_mark->hide(); }

void ScopeDrop::markTrace(const QPoint &position) { mark(plotAt(position)); }

void ScopeDrop::dropTrace(capture::ChannelId channel, const QPoint &position)
{
    hideMark();
    if (!m_view.rect().contains(position))
        return;
    const int plot = plotAt(position);
    Q_EMIT traceDropped(channel, plot < 0 ? m_stack.count() : plot);
}

bool ScopeDrop::eventFilter(QObject *, QEvent *event)
{
    switch (event->type()) {
    case QEvent::DragEnter:
        if (registersIn(*static_cast<QDropEvent *>(event)->mimeData()).isEmpty())
            return true; // not accepted
        [[fallthrough]];
    case QEvent::DragMove: {
        auto *drag = static_cast<QDropEvent *>(event);
        mark(plotAt(drag->position().toPoint()));
        drag->acceptProposedAction();
        return true;
    }
    case QEvent::DragLeave:
        hideMark();
        return true;
    case QEvent::Drop:
        static_cast<QDropEvent *>(event)->acceptProposedAction();
        drop(*static_cast<QDropEvent *>(event));
        return true;
    default:
        return false;
    }
}

void ScopeDrop::drop(const QDropEvent &event)
{
    hideMark();
    const int plot = plotAt(event.position().toPoint());
    const QList<quint32> ids = registersIn(*event.mimeData());
    for (const quint32 id : ids)
        Q_EMIT registerDropped(id, plot);
}

} // namespace widgets

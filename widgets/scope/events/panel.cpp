#include "widgets/scope/events/panel.h"

#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/row_table.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/view.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kTimeWidth = 120;
constexpr int kKindWidth = 110;
constexpr int kGather_ms = 50; ///< a list that fills is painted no oftener

/// Markers only.
class MarkerFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        const QModelIndex index = sourceModel()->index(row, 0, parent);
        return index.data(EventLog::KindRole).toInt() == static_cast<int>(EventKind::Marker);
    }
};
} // namespace

EventPanel::EventPanel(ScopeView &scope, QWidget *parent)
    : Form(parent)
    , m_scope(scope)
    , m_markers(new MarkerFilter(this))
    , m_list(new RowList("eventList", tr("Events and markers"), &scope.events(), this))
    , m_onlyMarkers(named(new QCheckBox(tr("Markers on&ly"), this), "onlyMarkers"))
    , m_remove(nullptr)
{
    setObjectName(QStringLiteral("eventPanel"));
    // Its columns stay when the list is full.
    m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->header()->resizeSection(EventLog::TimeColumn, kTimeWidth);
    m_list->header()->resizeSection(EventLog::KindColumn, kKindWidth);
    m_list->setToolTip(
        tr("Enter shows an event on the scope, F2 edits a marker's note, Delete removes a marker"));
    m_list->installEventFilter(this);

    auto *add = named(new QPushButton(tr("Set a mar&ker"), this), "addMarker");
    m_remove = named(new QPushButton(tr("Delete m&arkers"), this), "deleteMarker");
    auto *copyIt = named(new QPushButton(tr("&Copy"), this), "copyEvents");
    auto *side = new QVBoxLayout;
    side->addWidget(m_onlyMarkers);
    side->addWidget(add);
    side->addWidget(m_remove);
    side->addWidget(copyIt);
    side->addStretch(1);
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(m_list, 1);
    layout->addLayout(side);

    connect(m_onlyMarkers, &QCheckBox::toggled, this, &EventPanel::showKinds);
    connect(add, &QPushButton::clicked, &scope, [&scope] { scope.cursorActions().setMarker(); });
    connect(m_remove, &QPushButton::clicked, this, &EventPanel::removeChosen);
    connect(copyIt, &QPushButton::clicked, this, &EventPanel::copyChosen);
    connect(m_list, &QTreeView::doubleClicked, this, &EventPanel::jump);
    // Like a log: what is new is seen as long as the end is in view.
    m_scroll.setSingleShot(true);
    m_scroll.setInterval(0);
    connect(&m_scroll, &QTimer::timeout, this, &EventPanel::scrollToEnd);
    m_paint.setSingleShot(true);
    m_paint.setInterval(kGather_ms);
    connect(&m_paint, &QTimer::timeout, this, [this] { m_list->setUpdatesEnabled(true); });
    connect(&scope.events(), &QAbstractItemModel::rowsInserted, this, [this] {
        follow();
        gather();
    });
    connect(&scope.events(), &QAbstractItemModel::modelReset, this, &EventPanel::follow);
    // Once the list knows it, too.
    connect(&scope.events(), &QAbstractItemModel::modelReset, this, &EventPanel::enableRemove,
        Qt::QueuedConnection);
    watchSelection();
}

void EventPanel::watchSelection()
{
    connect(m_list->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &EventPanel::enableRemove);
    enableRemove();
}

/// While a marker is among the chosen rows.
void EventPanel::enableRemove()
{
    bool any = false;
    for (const QItemSelectionRange &range : m_list->selectionModel()->selection())
        for (int row = range.top(); row <= range.bottom() && !any; ++row)
            any = range.model()->index(row, 0).data(EventLog::KindRole).toInt()
                == static_cast<int>(EventKind::Marker);
    m_remove->setEnabled(any);
}

/// All, or markers only. What filters looks at every row for each that comes, so it stands between for markers only.
void EventPanel::showKinds(bool onlyMarkers)
{
    const QItemSelectionModel *before = m_list->selectionModel();
    m_markers->setSourceModel(onlyMarkers ? &m_scope.events() : nullptr);
    if (onlyMarkers)
        m_list->setModel(m_markers);
    else
        m_list->setModel(&m_scope.events());
    delete before; // which a view leaves behind
    watchSelection();
}

/// Once for all that come together: to know where the end is, a list looks at all of its rows.
void EventPanel::follow()
{
    const QScrollBar *bar = m_list->verticalScrollBar();
    if (bar->value() == bar->maximum())
        m_scroll.start();
}

/// What comes together is painted together, which is most of what an event costs. Places of rows are right at any time.
void EventPanel::gather()
{
    if (m_paint.isActive())
        return;
    m_list->setUpdatesEnabled(false);
    m_paint.start();
}

void EventPanel::scrollToEnd()
{
    m_behind = !m_list->isVisible(); // a hidden one has no place to keep
    if (!m_behind)
        m_list->scrollToBottom();
}

void EventPanel::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    if (m_behind)
        m_scroll.start();
}

void EventPanel::focusFirst()
{
    m_list->setFocus(Qt::ShortcutFocusReason);
    if (!m_list->currentIndex().isValid() && m_list->model()->rowCount() > 0)
        m_list->setCurrentIndex(
            m_list->model()->index(m_list->model()->rowCount() - 1, EventLog::TextColumn));
}

void EventPanel::choose(quint32 id)
{
    for (int row = 0; row < m_list->model()->rowCount(); ++row) {
        const QModelIndex index = m_list->model()->index(row, EventLog::TextColumn);
        if (index.data(EventLog::IdRole).toUInt() == id)
            m_list->setCurrentIndex(index);
    }
}

void EventPanel::editNote(quint32 marker)
{
    choose(marker);
    m_list->setFocus(Qt::OtherFocusReason);
    m_list->edit(m_list->currentIndex());
}

void EventPanel::jump(const QModelIndex &index)
{
    if (index.isValid())
        m_scope.time().centerOn(index.data(EventLog::SecondsRole).toDouble());
}

void EventPanel::removeChosen()
{
    QList<quint32> ids;
    for (const QModelIndex &index : m_list->selectionModel()->selectedRows())
        ids.append(index.data(EventLog::IdRole).toUInt());
    for (const quint32 id : ids)
        m_scope.events().removeMarker(id);
}

/// The chosen lines, or all, with tabs between columns.
void EventPanel::copyChosen()
{
    QModelIndexList rows = m_list->selectionModel()->selectedRows();
    std::sort(rows.begin(), rows.end());
    if (rows.size() < 2) {
        rows.clear();
        for (int row = 0; row < m_list->model()->rowCount(); ++row)
            rows.append(m_list->model()->index(row, 0));
    }
    QString text;
    for (const QModelIndex &row : rows)
        text += rowText(row) + QLatin1Char('\n');
    QApplication::clipboard()->setText(text);
}

bool EventPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_list && event->type() == QEvent::ShortcutOverride
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_F2) {
        event->accept(); // the note, not a register's value
        return true;
    }
    if (watched != m_list || event->type() != QEvent::KeyPress)
        return Form::eventFilter(watched, event);
    switch (static_cast<QKeyEvent *>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        jump(m_list->currentIndex());
        return true;
    case Qt::Key_Delete:
        removeChosen();
        return true;
    case Qt::Key_F2: // whatever column is the current one
        m_list->setCurrentIndex(m_list->currentIndex().siblingAtColumn(EventLog::TextColumn));
        return false;
    default:
        return false;
    }
}

} // namespace widgets

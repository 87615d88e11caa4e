#include "widgets/scope/event_panel.h"

#include "widgets/scope/scope_view.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kTimeWidth = 120;
constexpr int kKindWidth = 110;

/// The events of one kind, or all.
class KindFilter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setOnly(std::optional<EventKind> kind)
    {
        m_only = kind;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override
    {
        const QModelIndex index = sourceModel()->index(row, 0, parent);
        return !m_only || index.data(EventLog::KindRole).toInt() == static_cast<int>(*m_only);
    }

private:
    std::optional<EventKind> m_only;
};
} // namespace

EventPanel::EventPanel(ScopeView &scope, QWidget *parent)
    : Form(parent)
    , m_scope(scope)
    , m_shown(new KindFilter(this))
    , m_list(new QTreeView(this))
    , m_onlyMarkers(new QCheckBox(tr("&Markers only"), this))
{
    setObjectName(QStringLiteral("eventPanel"));
    m_shown->setSourceModel(&scope.events());
    m_list->setObjectName(QStringLiteral("eventList"));
    m_list->setAccessibleName(tr("Events and markers"));
    m_list->setModel(m_shown);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setAlternatingRowColors(true);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->header()->resizeSection(EventLog::TimeColumn, kTimeWidth);
    m_list->header()->resizeSection(EventLog::KindColumn, kKindWidth);
    m_list->setToolTip(
        tr("Enter shows an event on the scope, F2 edits a marker's note, Delete removes a marker"));
    m_list->installEventFilter(this);
    m_onlyMarkers->setObjectName(QStringLiteral("onlyMarkers"));

    auto *add = new QPushButton(tr("&Set a marker"), this);
    add->setObjectName(QStringLiteral("addMarker"));
    auto *remove = new QPushButton(tr("&Delete markers"), this);
    remove->setObjectName(QStringLiteral("deleteMarker"));
    auto *copyIt = new QPushButton(tr("&Copy"), this);
    copyIt->setObjectName(QStringLiteral("copyEvents"));
    auto *side = new QVBoxLayout;
    side->addWidget(m_onlyMarkers);
    side->addWidget(add);
    side->addWidget(remove);
    side->addWidget(copyIt);
    side->addStretch(1);
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(m_list, 1);
    layout->addLayout(side);

    connect(m_onlyMarkers, &QCheckBox::toggled, this, [this](bool only) {
        static_cast<KindFilter *>(m_shown)->setOnly(
            only ? std::optional(EventKind::Marker) : std::nullopt);
    });
    connect(add, &QPushButton::clicked, &scope, [&scope] { scope.setMarker(); });
    connect(remove, &QPushButton::clicked, this, &EventPanel::removeChosen);
    connect(copyIt, &QPushButton::clicked, this, &EventPanel::copyChosen);
    connect(m_list, &QTreeView::doubleClicked, this, &EventPanel::jump);
    // Like a log: what is new is seen as long as nobody scrolls away from the end.
    connect(m_shown, &QAbstractItemModel::rowsInserted, m_list, [this] {
        const QScrollBar *bar = m_list->verticalScrollBar();
        if (bar->value() == bar->maximum())
            m_list->scrollToBottom();
    });
}

void EventPanel::focusFirst()
{
    m_list->setFocus(Qt::ShortcutFocusReason);
    if (!m_list->currentIndex().isValid() && m_shown->rowCount() > 0)
        m_list->setCurrentIndex(m_shown->index(m_shown->rowCount() - 1, EventLog::TextColumn));
}

void EventPanel::choose(quint32 id)
{
    for (int row = 0; row < m_shown->rowCount(); ++row) {
        const QModelIndex index = m_shown->index(row, EventLog::TextColumn);
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
        m_scope.centerOn(index.data(EventLog::SecondsRole).toDouble());
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
        for (int row = 0; row < m_shown->rowCount(); ++row)
            rows.append(m_shown->index(row, 0));
    }
    QString text;
    for (const QModelIndex &row : rows) {
        QStringList cells;
        for (int column = 0; column < EventLog::kColumns; ++column)
            cells.append(row.siblingAtColumn(column).data().toString());
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
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

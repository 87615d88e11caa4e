#include "widgets/register_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr int kSettleMs = 80;

} // namespace

RegisterPanel::RegisterPanel(RegisterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_proxy(new QSortFilterProxyModel(this))
    , m_search(new QLineEdit(this))
    , m_tree(new QTreeView(this))
{
    m_proxy->setSourceModel(&model);
    m_proxy->setRecursiveFilteringEnabled(true);
    m_proxy->setFilterRole(RegisterModel::SearchRole);
    m_proxy->setFilterCaseSensitivity(Qt::CaseInsensitive);

    m_search->setPlaceholderText(tr("Search registers (Ctrl+K)"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Search registers"));
    m_search->setObjectName(QStringLiteral("registerSearch"));
    m_search->installEventFilter(this);

    m_tree->setObjectName(QStringLiteral("registerTree"));
    m_tree->setAccessibleName(tr("Registers"));
    m_tree->setModel(m_proxy);
    m_tree->setUniformRowHeights(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setDragEnabled(true);
    m_tree->setDragDropMode(QAbstractItemView::DragOnly);
    m_tree->setIndentation(10);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->header()->setStretchLastSection(false);
    m_tree->header()->setSectionResizeMode(RegisterModel::NameColumn, QHeaderView::Stretch);
    m_tree->header()->resizeSection(RegisterModel::ValueColumn, 88);
    m_tree->header()->resizeSection(RegisterModel::RawColumn, 52);
    m_tree->header()->setMinimumSectionSize(40);
    m_tree->installEventFilter(this);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(6);
    layout->addWidget(m_search);
    layout->addWidget(m_tree);

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleMs);
    connect(&m_settled, &QTimer::timeout, this, &RegisterPanel::visibleRegistersChanged);
    const auto moved = [this] { m_settled.start(); };
    connect(m_tree->verticalScrollBar(), &QScrollBar::valueChanged, this, moved);
    connect(m_tree, &QTreeView::expanded, this, moved);
    connect(m_tree, &QTreeView::collapsed, this, moved);
    connect(m_search, &QLineEdit::textChanged, this, &RegisterPanel::search);
    connect(m_tree, &QTreeView::doubleClicked, this, [this] { chooseSelected(); });
    connect(m_tree, &QTreeView::customContextMenuRequested, this, &RegisterPanel::showMenu);
    connect(&model, &QAbstractItemModel::modelReset, this, &RegisterPanel::expandDefaults);
}

std::vector<catalog::RegisterId> RegisterPanel::visibleRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    if (!isVisible())
        return ids;
    const int bottom = m_tree->viewport()->height();
    for (QModelIndex index = m_tree->indexAt(QPoint(1, 1)); index.isValid();
         index = m_tree->indexBelow(index)) {
        if (m_tree->visualRect(index).top() > bottom)
            break;
        const QVariant id = index.siblingAtColumn(0).data(RegisterModel::IdRole);
        if (id.isValid() && std::find(ids.begin(), ids.end(), id.toUInt()) == ids.end())
            ids.push_back(id.toUInt());
    }
    return ids;
}

void RegisterPanel::focusSearch()
{
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
}

bool RegisterPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show
        || event->type() == QEvent::Hide)
        m_settled.start();
    if (event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (watched == m_tree && enter && key->modifiers() == Qt::NoModifier) {
            chooseSelected();
            return true;
        }
        if (watched == m_search && key->key() == Qt::Key_Down) {
            m_tree->setFocus(Qt::TabFocusReason);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void RegisterPanel::chooseSelected()
{
    QList<quint32> ids;
    for (const QModelIndex &index : m_tree->selectionModel()->selectedRows()) {
        const QVariant id = index.data(RegisterModel::IdRole);
        if (id.isValid() && !ids.contains(id.toUInt()))
            ids.append(id.toUInt());
    }
    if (!ids.isEmpty())
        Q_EMIT registersChosen(ids);
}

void RegisterPanel::showMenu(const QPoint &at)
{
    const QModelIndex index = m_tree->indexAt(at).siblingAtColumn(0);
    const QVariant id = index.data(RegisterModel::IdRole);
    if (!id.isValid())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("Add to scope")), &QAction::triggered, this,
        &RegisterPanel::chooseSelected);
    QAction *pin = menu->addAction(tr("Pinned", "menu entry of a register"));
    pin->setCheckable(true);
    pin->setChecked(index.data(RegisterModel::PinnedRole).toBool());
    connect(pin, &QAction::triggered, this, [this, id] { m_model.togglePinned(id.toUInt()); });
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

void RegisterPanel::search(const QString &text)
{
    m_proxy->setFilterFixedString(text.trimmed());
    if (text.trimmed().isEmpty())
        expandDefaults();
    else
        m_tree->expandAll();
    m_settled.start();
}

void RegisterPanel::expandDefaults()
{
    // What a person looks for first: the pinned ones, then the first groups as far as they fit.
    m_tree->collapseAll();
    for (int row = 0; row < std::min(2, m_proxy->rowCount()); ++row)
        m_tree->expand(m_proxy->index(row, 0));
    for (int row = 0; row < m_proxy->rowCount(); ++row)
        m_tree->setFirstColumnSpanned(row, {}, true);
    m_settled.start();
}

} // namespace widgets

#include "widgets/registers/panel.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/registers/delegate.h"
#include "widgets/registers/edit_bar.h"
#include "widgets/registers/write_question.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QVBoxLayout>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kSettleMs = 80;
constexpr int kDetailsFrom = 300; // pixels of height, so that the tree keeps most of them

struct Choice {
    const char *name;
    RegisterModel::Column column;
    int width;
};
constexpr Choice kChoices[] = {{"value", RegisterModel::ValueColumn, 88},
    {"raw", RegisterModel::RawColumn, 52}, {"hex", RegisterModel::HexColumn, 84},
    {"access", RegisterModel::AccessColumn, 56}, {"help", RegisterModel::HelpColumn, 220}};

constexpr int kLeastName = 120; ///< px of the column of names: BUS_VOLTAGE, indented

} // namespace

RegisterPanel::RegisterPanel(RegisterModel &model, RegisterEdits &edits, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_edits(edits)
    , m_proxy(new QSortFilterProxyModel(this))
    , m_search(named(new QLineEdit(this), "registerSearch", tr("Search registers")))
    , m_tree(named(new QTreeView(this), "registerTree", tr("Registers")))
    , m_details(wrappedLabel("registerDetails", this))
    , m_columnsMenu(new QMenu(tr("Register &columns"), this))
{
    m_proxy->setSourceModel(&model);
    m_proxy->setRecursiveFilteringEnabled(true);
    m_proxy->setFilterRole(RegisterModel::SearchRole);
    m_proxy->setFilterCaseSensitivity(Qt::CaseInsensitive);

    m_search->setPlaceholderText(tr("Search registers (Ctrl+K)"));
    m_search->setClearButtonEnabled(true);
    m_search->installEventFilter(this);
    makeTree();
    makeColumns();
    makeActions();
    // Before every edit bar: they show the actions as they are.
    connect(&edits, &RegisterEdits::changed, this, &RegisterPanel::updateEdits);

    auto *layout = edged(new QVBoxLayout(this), kToolEdges, kGrid);
    layout->addWidget(m_search);
    layout->addWidget(m_tree, 1);
    layout->addWidget(m_details);
    layout->addWidget(m_editBar = new EditBar(edits, model, m_actions.apply, m_actions.revert,
                          EditBar::Room::Narrow, this));

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleMs);
    connect(&m_settled, &QTimer::timeout, this, &RegisterPanel::visibleRegistersChanged);
    const auto moved = [this] { m_settled.start(); };
    connect(m_tree->verticalScrollBar(), &QScrollBar::valueChanged, this, moved);
    connect(m_tree, &QTreeView::expanded, this, moved);
    connect(m_tree, &QTreeView::collapsed, this, moved);
    connect(m_search, &QLineEdit::textChanged, this, &RegisterPanel::search);
    connect(m_tree, &QTreeView::doubleClicked, this, &RegisterPanel::activate);
    connect(m_tree, &QTreeView::customContextMenuRequested, this, &RegisterPanel::showMenu);
    connect(&model, &QAbstractItemModel::modelReset, this, &RegisterPanel::expandDefaults);
    const auto measure = [this] {
        m_leastName = leastName();
        showColumns();
    };
    connect(&model, &QAbstractItemModel::modelReset, this, measure);
    measure();
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &RegisterPanel::updateDetails);
    connect(&model, &QAbstractItemModel::modelReset, this, &RegisterPanel::updateDetails);
    connect(&edits, &RegisterEdits::asked, this,
        [this](const QList<WriteLine> &lines) { askBeforeWriting(window(), m_edits, lines); });
    updateEdits();
}

RegisterPanel::~RegisterPanel()
{
    delete m_tree; // an open editor hands its text over while it can still be taken
}

void RegisterPanel::makeTree()
{
    m_tree->setModel(m_proxy);
    m_tree->setUniformRowHeights(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    // F2 and a double click go through here.
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->setDragEnabled(true);
    m_tree->setDragDropMode(QAbstractItemView::DragOnly);
    m_tree->setIndentation(10);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->installEventFilter(this);
    auto *delegate = new RegisterDelegate(m_model, this);
    m_tree->setItemDelegate(delegate);
    connect(delegate, &RegisterDelegate::entryRefused, this, [this](const QString &sentence) {
        m_editBar->tell(
            tr("Not taken over: %1", "what is wrong with a typed value").arg(sentence), false);
    });
}

void RegisterPanel::makeColumns()
{
    QHeaderView *header = m_tree->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(RegisterModel::NameColumn, QHeaderView::Stretch);
    header->setMinimumSectionSize(40);
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QHeaderView::customContextMenuRequested, this,
        [this, header](const QPoint &at) { m_columnsMenu->popup(header->mapToGlobal(at)); });
    for (const Choice &choice : kChoices) {
        header->resizeSection(choice.column, choice.width);
        QAction *action =
            m_columnsMenu->addAction(m_model.headerData(choice.column, Qt::Horizontal).toString());
        action->setObjectName(QLatin1String(choice.name));
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, &RegisterPanel::showColumns);
    }
    setColumns({QStringLiteral("value"), QStringLiteral("raw")});

    m_details->setAccessibleName(tr("What the selected register is"));
    m_details->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_details->setFocusPolicy(Qt::NoFocus); // the flags above would take the focus on a click
    m_details->hide();
}

void RegisterPanel::setColumns(const QStringList &names)
{
    for (const Choice &choice : kChoices) {
        QAction *action = m_columnsMenu->findChild<QAction *>(QLatin1String(choice.name));
        action->setChecked(names.contains(QLatin1String(choice.name)));
    }
    showColumns();
}

/// Half of the names of this board are read whole.
int RegisterPanel::leastName() const
{
    std::vector<int> widths;
    for (const QString &name : namesIn(m_model))
        widths.push_back(m_tree->fontMetrics().horizontalAdvance(name));
    if (widths.empty())
        return kLeastName;
    const auto half = widths.begin() + std::ssize(widths) / 2;
    std::nth_element(widths.begin(), half, widths.end());
    return std::max(kLeastName, 2 * m_tree->indentation() + *half + kGrid);
}

/// The chosen ones; where they leave no room for names, without the raw numbers.
void RegisterPanel::showColumns()
{
    int room = m_tree->width() - m_tree->verticalScrollBar()->sizeHint().width();
    for (const Choice &choice : kChoices)
        room -= chosen(choice.name) ? choice.width : 0;
    for (const Choice &choice : kChoices) {
        const bool gives = choice.column == RegisterModel::RawColumn && room < m_leastName;
        m_tree->setColumnHidden(choice.column, !chosen(choice.name) || gives);
    }
}

bool RegisterPanel::chosen(const char *column) const
{
    return m_columnsMenu->findChild<QAction *>(QLatin1String(column))->isChecked();
}

QStringList RegisterPanel::columns() const
{
    QStringList names;
    for (const Choice &choice : kChoices)
        if (chosen(choice.name))
            names.append(QLatin1String(choice.name));
    return names;
}

/// What the selected register is, without a mouse that rests on it.
void RegisterPanel::updateDetails()
{
    const QVariant id = m_tree->currentIndex().siblingAtColumn(0).data(RegisterModel::IdRole);
    const QString sought = m_search->text().trimmed();
    const bool noHits = !sought.isEmpty() && m_proxy->rowCount() == 0;
    const QString text = noHits ? tr("No register has \"%1\" in its name or its help.").arg(sought)
        : id.isValid()          ? m_model.details(id.toUInt())
                                : QString();
    m_details->setText(text);
    m_details->setVisible(noHits || (!text.isEmpty() && height() >= kDetailsFrom));
    if (m_actions.pin != nullptr)
        m_actions.pin->setEnabled(id.isValid());
}

void RegisterPanel::togglePinned()
{
    const QVariant id = m_tree->currentIndex().siblingAtColumn(0).data(RegisterModel::IdRole);
    if (id.isValid())
        m_model.togglePinned(id.toUInt());
}

void RegisterPanel::makeActions()
{
    const auto make = [this](
                          const QString &text, const QKeySequence &keys, auto *target, auto slot) {
        auto *action = new QAction(text, this);
        action->setShortcut(keys);
        action->setAutoRepeat(false);
        connect(action, &QAction::triggered, target, slot);
        return action;
    };
    m_actions.undo =
        make(tr("&Undo the last write"), Qt::CTRL | Qt::Key_Z, &m_edits, &RegisterEdits::undo);
    m_actions.redo = make(
        tr("&Redo the write"), Qt::CTRL | Qt::SHIFT | Qt::Key_Z, &m_edits, &RegisterEdits::redo);
    m_actions.apply =
        make(tr("&Apply edits"), Qt::CTRL | Qt::SHIFT | Qt::Key_A, &m_edits, &RegisterEdits::apply);
    m_actions.revert = make(tr("Re&vert edits"), {}, &m_edits, &RegisterEdits::revert);
    m_actions.edit =
        make(tr("&Edit the register's value"), Qt::Key_F2, this, &RegisterPanel::editCurrent);
    m_actions.copy = make(tr("&Copy registers as text"), {}, this, &RegisterPanel::copySelected);
    m_actions.pin = make(tr("&Pin the register or let it go"), Qt::CTRL | Qt::Key_B, this,
        &RegisterPanel::togglePinned);
    m_actions.pin->setEnabled(false);
    const std::pair<QAction *, const char *> icons[] = {{m_actions.undo, "undo"},
        {m_actions.redo, "redo"}, {m_actions.apply, "apply"}, {m_actions.revert, "revert"},
        {m_actions.edit, "edit"}, {m_actions.copy, "copy"}, {m_actions.pin, "pin"}};
    for (const auto &[action, icon] : icons)
        setLineIcon(*action, icon);
}

void RegisterPanel::updateEdits()
{
    const auto show = [](QAction *action, const QString &hint, const QString &does) {
        action->setEnabled(hint.isEmpty());
        action->setToolTip(plainToolTip(hint.isEmpty() ? does : hint));
    };
    const auto &steps = m_edits.steps();
    show(m_actions.apply, m_edits.applyHint(),
        tr("Writes what was edited and reads it back (Ctrl+Shift+A)"));
    show(m_actions.undo, m_edits.undoHint(),
        tr("Writes the old value of: %1").arg(steps.undoText()));
    show(m_actions.redo, m_edits.redoHint(), tr("Writes again: %1").arg(steps.redoText()));
    show(m_actions.revert, m_model.hasEdits() ? QString() : tr("Nothing was edited."),
        tr("Forgets the edits that were not written"));
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
        || event->type() == QEvent::Hide) {
        m_settled.start();
        showColumns();
        updateDetails();
    }
    if (event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (watched == m_tree && enter && key->modifiers() == Qt::NoModifier) {
            activate(m_tree->currentIndex());
            return true;
        }
        if (watched == m_tree && key->matches(QKeySequence::Copy)) {
            copySelected();
            return true;
        }
        if (watched == m_search && key->key() == Qt::Key_Down) {
            m_tree->setFocus(Qt::TabFocusReason);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

std::vector<catalog::RegisterId> RegisterPanel::selected() const
{
    std::vector<catalog::RegisterId> ids;
    for (const QModelIndex &index : m_tree->selectionModel()->selectedRows()) {
        const QVariant id = index.data(RegisterModel::IdRole);
        if (id.isValid() && std::find(ids.begin(), ids.end(), id.toUInt()) == ids.end())
            ids.push_back(id.toUInt());
    }
    return ids;
}

/// A double click or Enter: edits a value that can be edited, puts a name on the scope.
void RegisterPanel::activate(const QModelIndex &index)
{
    if (index.column() != RegisterModel::NameColumn && index.flags().testFlag(Qt::ItemIsEditable))
        m_tree->edit(index);
    else
        chooseSelected();
}

void RegisterPanel::editCurrent()
{
    const QModelIndex current = m_tree->currentIndex();
    for (const int column :
        {current.column(), int(RegisterModel::ValueColumn), int(RegisterModel::RawColumn)}) {
        const QModelIndex cell = current.siblingAtColumn(column);
        if (!cell.flags().testFlag(Qt::ItemIsEditable))
            continue;
        m_tree->setCurrentIndex(cell);
        m_tree->edit(cell);
        return;
    }
}

void RegisterPanel::copySelected()
{
    QStringList lines;
    for (const catalog::RegisterId id : selected())
        lines.append(m_model.copyText(id));
    if (!lines.isEmpty())
        QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
}

void RegisterPanel::chooseSelected()
{
    QList<quint32> ids;
    for (const catalog::RegisterId id : selected())
        ids.append(id);
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
    if (index.siblingAtColumn(RegisterModel::RawColumn).flags().testFlag(Qt::ItemIsEditable))
        connect(menu->addAction(tr("Edit value")), &QAction::triggered, this,
            &RegisterPanel::editCurrent);
    connect(menu->addAction(tr("Copy")), &QAction::triggered, this, &RegisterPanel::copySelected);
    QAction *pin = menu->addAction(tr("Pinned", "menu entry of a register"));
    pin->setCheckable(true);
    pin->setChecked(index.data(RegisterModel::PinnedRole).toBool());
    connect(pin, &QAction::triggered, this, [this, id] { m_model.togglePinned(id.toUInt()); });
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

void RegisterPanel::search(const QString &text)
{
    // Every word has to be there, in whatever order.
    const QStringList words =
        text.split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
    QString pattern;
    for (const QString &word : words)
        pattern += QStringLiteral("(?=.*%1)").arg(QRegularExpression::escape(word));
    m_proxy->setFilterRegularExpression(QRegularExpression(pattern,
        QRegularExpression::CaseInsensitiveOption
            | QRegularExpression::DotMatchesEverythingOption));
    if (words.isEmpty()) {
        expandDefaults();
    } else {
        m_tree->expandAll();
        if (const QModelIndex best = bestHit(words.join(QLatin1Char('_'))); best.isValid())
            m_tree->setCurrentIndex(best);
    }
    updateDetails();
    m_settled.start();
}

/// The register of that name, else the first whose name begins with it, else the first; so that Down goes to it.
QModelIndex RegisterPanel::bestHit(const QString &name) const
{
    QModelIndex beginning, first;
    for (int group = 0; group < m_proxy->rowCount(); ++group) {
        const QModelIndex parent = m_proxy->index(group, 0);
        for (int row = 0; row < m_proxy->rowCount(parent); ++row) {
            const QModelIndex hit = m_proxy->index(row, 0, parent);
            const QString its = hit.data().toString();
            if (its.compare(name, Qt::CaseInsensitive) == 0)
                return hit;
            if (!beginning.isValid() && its.startsWith(name, Qt::CaseInsensitive))
                beginning = hit;
            if (!first.isValid())
                first = hit;
        }
    }
    return beginning.isValid() ? beginning : first;
}

void RegisterPanel::expandDefaults()
{
    // What the user looks for first: the pinned ones, then the first groups as far as they fit.
    m_tree->collapseAll();
    for (int row = 0; row < std::min(2, m_proxy->rowCount()); ++row)
        m_tree->expand(m_proxy->index(row, 0));
    for (int row = 0; row < m_proxy->rowCount(); ++row)
        m_tree->setFirstColumnSpanned(row, {}, true);
    m_settled.start();
}

} // namespace widgets

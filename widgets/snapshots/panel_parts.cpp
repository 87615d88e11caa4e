// What a SnapshotPanel is made of: its widgets, their keys and their texts.
#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/snapshots/panel.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr int kReportHeight = 96;

} // namespace

void SnapshotPanel::makeWidgets()
{
    makeTable();
    auto *layout = edged(new QVBoxLayout(this), kToolEdges, kGrid);
    layout->addWidget(makeSides());
    layout->addWidget(makeFilters());
    layout->addWidget(m_table, 1);
    m_report = named(new QPlainTextEdit(this), "snapshotReport", tr("What was restored"));
    m_report->setReadOnly(true);
    m_report->setTabChangesFocus(true);
    m_report->setMaximumHeight(kReportHeight);
    m_report->hide();
    layout->addWidget(m_report);
    m_footer = makeBottom();
}

void SnapshotPanel::makeSide(Side &side, const QString &name, const char *objectName)
{
    side.box = named(new QComboBox(this), objectName, tr("Snapshot %1", "A or B").arg(name));
    side.box->setPlaceholderText(tr("Choose a snapshot\u2026"));
    side.box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    side.box->setMinimumContentsLength(18);
    new WheelGuard(side.box);
    side.open = new QPushButton(tr("Open\u2026"), this);
    side.open->setObjectName(QLatin1String(objectName) + QStringLiteral("Open"));
    side.open->setAccessibleName(tr("Open a file as snapshot %1", "A or B").arg(name));
    connect(side.box, &QComboBox::activated, this,
        [this, &side](int index) { chooseSource(side, index); });
    connect(side.open, &QPushButton::clicked, this, [this, &side] { askFile(side); });
}

QWidget *SnapshotPanel::makeSides()
{
    auto *row = new QWidget(this);
    makeSide(m_a, tr("A", "the first of two snapshots"), "snapshotA");
    makeSide(m_b, tr("B", "the second of two snapshots"), "snapshotB");
    m_read = named(new QPushButton(tr("Read the b&oard"), row), "snapshotRead");
    m_read->setToolTip(plainToolTip(tr("Reads every register of the board again")));
    connect(m_read, &QPushButton::clicked, this, &SnapshotPanel::readBoard);
    auto *layout = bare(new QHBoxLayout(row));
    const auto label = [row](const QString &text, QComboBox *box) {
        auto *made = new QLabel(text, row);
        made->setBuddy(box);
        return made;
    };
    layout->addWidget(label(tr("A", "the first of two snapshots"), m_a.box));
    layout->addWidget(m_a.box, 1);
    layout->addWidget(m_a.open);
    layout->addSpacing(kGrid);
    layout->addWidget(label(tr("B", "the second of two snapshots"), m_b.box));
    layout->addWidget(m_b.box, 1);
    layout->addWidget(m_b.open);
    layout->addSpacing(kGrid);
    layout->addWidget(m_read);
    return row;
}

void SnapshotPanel::offerSave(QAction *save)
{
    auto *button = named(new QPushButton(tr("S&ave\u2026"), m_read->parentWidget()), "snapshotSave",
        tr("Save a snapshot"));
    const auto follow = [button, save] {
        button->setEnabled(save->isEnabled());
        button->setToolTip(save->toolTip());
    };
    connect(button, &QPushButton::clicked, save, &QAction::trigger);
    connect(save, &QAction::changed, button, follow);
    follow();
    m_read->parentWidget()->layout()->addWidget(button);
}

QWidget *SnapshotPanel::makeFilters()
{
    auto *row = new QWidget(this);
    m_search = named(new QLineEdit(row), "snapshotSearch", tr("Filter the differences"));
    m_search->setPlaceholderText(tr("Filter by name or group"));
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(260);
    m_all = named(new QCheckBox(tr("Meas&ured values, too"), row), "snapshotAll");
    m_summary = named(new QLabel(row), "snapshotSummary");
    m_summary->setTextFormat(Qt::PlainText);
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_proxy->setFilterFixedString(text.trimmed());
        updateTexts();
    });
    connect(m_all, &QCheckBox::toggled, this, &SnapshotPanel::compare);
    auto *layout = bare(new QHBoxLayout(row));
    layout->addWidget(m_search, 1);
    layout->addWidget(m_all);
    layout->addWidget(m_summary, 1, Qt::AlignRight);
    return row;
}

void SnapshotPanel::makeTable()
{
    m_proxy->setSourceModel(m_model);
    m_proxy->setFilterRole(SnapshotModel::SearchRole);
    m_proxy->setFilterKeyColumn(SnapshotModel::NameColumn);
    m_proxy->setFilterCaseSensitivity(Qt::CaseInsensitive);
    m_proxy->setSortRole(SnapshotModel::SortRole);
    m_table = named(new QTableView(this), "snapshotTable", tr("Differences"));
    m_table->setModel(m_proxy);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    m_table->setMinimumHeight(90);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(-1, Qt::AscendingOrder); // as the board's table has them
    QHeaderView *header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::Stretch);
    header->setSectionResizeMode(SnapshotModel::MotorColumn, QHeaderView::ResizeToContents);
    header->setSectionResizeMode(SnapshotModel::UnitColumn, QHeaderView::ResizeToContents);
    m_table->installEventFilter(this);
    connect(m_table, &QTableView::customContextMenuRequested, this, &SnapshotPanel::showMenu);
}

QWidget *SnapshotPanel::makeBottom()
{
    auto *row = new QWidget(this);
    m_told = wrappedLabel("snapshotTold", row);
    m_told->hide();
    m_otherHardware = named(new QCheckBox(row), "snapshotOtherHardware");
    m_otherHardware->hide();
    m_progress = new QProgressBar(row);
    m_progress->setAccessibleName(tr("Progress of reading"));
    m_progress->setMaximumWidth(160);
    m_cancel = named(new QPushButton(tr("Cancel"), row), "snapshotCancel");
    m_restore = named(new QPushButton(row), "snapshotRestore");
    connect(m_otherHardware, &QCheckBox::toggled, this, &SnapshotPanel::updateTexts);
    connect(m_cancel, &QPushButton::clicked, &m_reader, &SnapshotReader::cancel);
    connect(m_restore, &QPushButton::clicked, this, &SnapshotPanel::restore);
    auto *layout = bare(new QHBoxLayout(row));
    layout->addWidget(m_told, 1);
    layout->addStretch();
    layout->addWidget(m_otherHardware);
    layout->addWidget(m_progress);
    layout->addWidget(m_cancel);
    layout->addWidget(m_restore);
    return row;
}

void SnapshotPanel::updateTexts()
{
    const bool reading = m_reader.running();
    m_progress->setVisible(reading);
    m_cancel->setVisible(reading);
    m_read->setEnabled(!reading && m_device.answering());
    const int count = static_cast<int>(chosen().size());
    m_restore->setText(
        count > 0 ? tr("&Restore %n register(s) of A", nullptr, count) : tr("&Restore"));
    const QString hint = restoreHint();
    m_restore->setEnabled(hint.isEmpty());
    m_restore->setToolTip(plainToolTip(hint.isEmpty()
            ? tr("Writes what is checked and shown to the board and reads it back")
            : hint));
    const int differing = m_model->differing(), shown = m_proxy->rowCount();
    QString summary;
    if (!snapshotOf(m_a) || !snapshotOf(m_b))
        summary = reading ? tr("Reading the board\u2026") : hint;
    else if (differing == 0)
        summary = tr("No differences.");
    else
        summary = tr("%n register(s) differ", nullptr, differing);
    if (shown < differing)
        summary += tr(", %n of them shown", nullptr, shown);
    // Why what is chosen cannot be written is said where people look, too.
    if (count > 0 && !hint.isEmpty() && !reading)
        summary += QStringLiteral(" \u2013 ") + hint;
    m_summary->setText(summary);
}

bool SnapshotPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Copy)) {
            copy();
            return true;
        }
        if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
            toggleSelected();
            return true;
        }
    }
    return Form::eventFilter(watched, event);
}

QList<int> SnapshotPanel::selectedRows() const
{
    QList<int> rows;
    const QModelIndexList selected = m_table->selectionModel()->selectedRows();
    for (const QModelIndex &index : selected)
        rows.append(m_proxy->mapToSource(index).row());
    std::sort(rows.begin(), rows.end());
    return rows;
}

/// The selected rows, or all that are shown.
void SnapshotPanel::copy()
{
    QList<int> rows = selectedRows();
    for (int i = 0; rows.isEmpty() && i < m_proxy->rowCount(); ++i)
        rows.append(m_proxy->mapToSource(m_proxy->index(i, 0)).row());
    if (!rows.isEmpty())
        QGuiApplication::clipboard()->setText(m_model->copyText(rows));
}

void SnapshotPanel::toggleSelected()
{
    const QList<int> rows = selectedRows();
    const bool allChecked = std::all_of(rows.begin(), rows.end(), [this](int row) {
        const QVariant state =
            m_model->index(row, SnapshotModel::NameColumn).data(Qt::CheckStateRole);
        return !state.isValid() || state.toInt() == Qt::Checked;
    });
    m_model->choose(rows, !allChecked);
}

void SnapshotPanel::showMenu(const QPoint &at)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("Check the selected rows")), &QAction::triggered, this,
        [this] { m_model->choose(selectedRows(), true); });
    connect(menu->addAction(tr("Uncheck the selected rows")), &QAction::triggered, this,
        [this] { m_model->choose(selectedRows(), false); });
    connect(
        menu->addAction(tr("Select all")), &QAction::triggered, m_table, &QTableView::selectAll);
    menu->addSeparator();
    connect(menu->addAction(tr("Copy")), &QAction::triggered, this, &SnapshotPanel::copy);
    menu->popup(m_table->viewport()->mapToGlobal(at));
}

} // namespace widgets

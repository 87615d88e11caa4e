#include "widgets/scope/trigger/record_panel.h"

#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/trigger/record_table.h"
#include "widgets/scope/view.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace widgets {

namespace {
constexpr int kTimeWidth = 170;
constexpr int kAgeWidth = 100;
constexpr int kCauseWidth = 130;
} // namespace

RecordPanel::RecordPanel(TriggerControl &control, ScopeView &scope, QWidget *parent)
    : Form(parent)
    , m_control(control)
    , m_table(new RecordTable(control, this))
    , m_list(new RowList("recordList", tr("Records of the trigger"), m_table, this))
    , m_show(named(new QPushButton(tr("Sho&w"), this), "showRecord"))
    , m_persistence(named(new QSpinBox(this), "persistence"))
{
    setObjectName(QStringLiteral("recordPanel"));
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->header()->resizeSection(RecordTable::TimeColumn, kTimeWidth);
    m_list->header()->resizeSection(RecordTable::AgeColumn, kAgeWidth);
    m_list->header()->resizeSection(RecordTable::CauseColumn, kCauseWidth);
    m_list->setToolTip(tr("Enter shows a record, the tick keeps it, F2 gives it a label. "
                          "Page up and page down go through the records."));
    m_list->installEventFilter(this);

    m_persistence->setRange(0, ScopeGhosts::kMost);
    m_persistence->setSpecialValueText(tr("off"));
    m_persistence->setToolTip(tr(
        "So many earlier records stay paler behind the newest one, while the trigger is the same"));
    new WheelGuard(m_persistence);
    auto *clear =
        named(new QPushButton(tr("C&lear"), this), "clearPersistence", tr("Clear the persistence"));
    clear->setToolTip(tr("Takes the earlier records out of the picture; those to come stay again"));
    clear->setEnabled(false);
    auto *label = new QLabel(tr("&Persistence"), this);
    label->setBuddy(m_persistence);

    auto *side = new QVBoxLayout;
    side->addWidget(m_show);
    side->addWidget(makeReferences(scope));
    side->addWidget(label);
    auto *staying = new QHBoxLayout;
    staying->addWidget(m_persistence, 1);
    staying->addWidget(clear);
    side->addLayout(staying);
    side->addStretch(1);
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(m_list, 1);
    layout->addLayout(side);

    connect(m_list, &QTreeView::doubleClicked, this, &RecordPanel::showChosen);
    connect(m_show, &QPushButton::clicked, this, &RecordPanel::showChosen);
    connect(m_persistence, &QSpinBox::valueChanged, &control, &TriggerControl::setPersistence);
    connect(m_persistence, &QSpinBox::valueChanged, clear,
        [clear](int records) { clear->setEnabled(records > 0); });
    connect(clear, &QPushButton::clicked, &control, &TriggerControl::clearPersistence);
    connect(&control, &TriggerControl::stateChanged, this, &RecordPanel::followShown);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &RecordPanel::enableShow);
    enableShow();
}

void RecordPanel::enableShow() { m_show->setEnabled(m_list->currentIndex().isValid()); }

/// A row for each reference: keep the traces of the picture, let them go.
QWidget *RecordPanel::makeReferences(ScopeView &scope)
{
    auto *box = new QWidget(this);
    auto *grid = bare(new QGridLayout(box));
    const auto add = [&](Reference which, int row, const char *keepName, const char *dropName,
                         const QString &keepText, const QString &dropText, const QString &key) {
        auto *keep = new QPushButton(keepText, box);
        keep->setObjectName(QLatin1String(keepName));
        keep->setToolTip(
            tr("Keeps the traces of the picture dashed and paler behind those that come (%1)")
                .arg(key));
        auto *drop = named(new QPushButton(dropText, box), dropName);
        grid->addWidget(keep, row, 0);
        grid->addWidget(drop, row, 1);
        connect(
            keep, &QPushButton::clicked, &scope, [&scope, which] { scope.ghosts().keep(which); });
        connect(
            drop, &QPushButton::clicked, &scope, [&scope, which] { scope.ghosts().drop(which); });
        const auto enable = [&scope, drop, which] {
            drop->setEnabled(scope.ghosts().hasReference(which));
        };
        connect(&scope.ghosts(), &ScopeGhosts::referencesChanged, drop, enable);
        enable();
    };
    add(Reference::A, 0, "keepReference", "dropReference", tr("Keep as &reference A"),
        tr("Drop &A"), QStringLiteral("R"));
    add(Reference::B, 1, "keepReferenceB", "dropReferenceB", tr("Keep as reference &B"),
        tr("Dr&op B"), QStringLiteral("B"));
    return box;
}

void RecordPanel::showEvent(QShowEvent *event)
{
    Form::showEvent(event);
    refresh({});
}

void RecordPanel::focusFirst()
{
    refresh({});
    m_list->setFocus(Qt::ShortcutFocusReason);
}

void RecordPanel::refresh(Milliseconds)
{
    if (m_list->findChild<QLineEdit *>())
        return; // a label is being written
    const QModelIndex current = m_list->currentIndex();
    const auto id = current.data(RecordTable::IdRole).toUInt();
    m_table->refresh();
    const int row = current.isValid() ? m_table->rowOf(id) : -1;
    if (row >= 0 && m_list->currentIndex().row() != row)
        m_list->setCurrentIndex(m_table->index(row, RecordTable::TimeColumn));
    enableShow(); // a list that was filled anew does not tell that none is chosen
}

/// What was shown by other means, such as page up, is the chosen one.
void RecordPanel::followShown()
{
    const scope::Record *shown = m_control.shown();
    if (!isVisible() || !shown || m_control.trigger().state() != scope::AcquisitionState::Stop)
        return;
    refresh({});
    const int row = m_table->rowOf(shown->id);
    if (row >= 0 && row != m_list->currentIndex().row())
        m_list->setCurrentIndex(m_table->index(row, RecordTable::TimeColumn));
}

void RecordPanel::showChosen()
{
    const QModelIndex current = m_list->currentIndex();
    if (current.isValid())
        m_control.showRecord(current.data(RecordTable::IdRole).toUInt());
}

bool RecordPanel::eventFilter(QObject *watched, QEvent *event)
{
    const auto type = event->type();
    if (watched != m_list || (type != QEvent::KeyPress && type != QEvent::ShortcutOverride))
        return Form::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent *>(event)->key();
    if (type == QEvent::ShortcutOverride) {
        if (key == Qt::Key_F2)
            event->accept(); // the label, not a register's value
        return key == Qt::Key_F2;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        showChosen();
        return true;
    }
    if (key == Qt::Key_F2)
        m_list->setCurrentIndex(m_list->currentIndex().siblingAtColumn(RecordTable::LabelColumn));
    return false;
}

} // namespace widgets

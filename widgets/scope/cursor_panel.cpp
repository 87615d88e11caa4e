#include "widgets/scope/cursor_panel.h"

#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/cursor_table.h"
#include "widgets/scope/view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <initializer_list>
#include <utility>

namespace widgets {

namespace {
constexpr int kSideWidth = 150;
constexpr int kRowRoom = 3; ///< pixels above and below a line of the table, together
} // namespace

CursorPanel::CursorPanel(ScopeView &scope, const capture::Capture &capture, QWidget *parent)
    : QWidget(parent)
    , m_scope(scope)
    , m_model(new CursorTable(scope, capture, this))
    , m_pairs(named(new QComboBox(this), "cursorPair", tr("Pair of cursors")))
    , m_add(new QToolButton(this))
    , m_remove(new QToolButton(this))
    , m_copy(new QToolButton(this))
    , m_hide(new QToolButton(this))
    , m_distance(named(new QLabel(this), "cursorInverse"))
    , m_table(named(new QTableView(this), "cursorTable", tr("Values at the cursors")))
{
    setObjectName(QStringLiteral("cursorPanel"));
    m_table->setModel(m_model);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    // The arrows move it where there are more traces than fit; Tab goes on.
    m_table->setFocusPolicy(Qt::TabFocus);
    m_table->setTabKeyNavigation(false);
    m_table->setCornerButtonEnabled(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->viewport()->setBackgroundRole(QPalette::Window);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setHighlightSections(false);

    auto *layout = edged(new QHBoxLayout(this), {kGrid, kFineGrid, kGrid, kFineGrid}, kGrid);
    layout->addWidget(makeSide());
    layout->addWidget(m_table, 1);
    connect(&scope.cursors(), &Cursors::changed, this, &CursorPanel::follow);
    // Once there are too many traces it stays: the place must not come and go with the width of a number. While the
    // panel is being laid out the columns do not have their places yet: asked when that is over.
    m_look.setSingleShot(true);
    m_look.setInterval(0);
    connect(&m_look, &QTimer::timeout, this, [this] {
        if (m_table->horizontalScrollBar()->maximum() > 0 && !std::exchange(m_wide, true))
            fitHeight();
    });
    connect(m_table->horizontalScrollBar(), &QScrollBar::rangeChanged, this, [this](int, int most) {
        if (most > 0 && isVisible())
            m_look.start();
    });
    connect(&scope, &ScopeView::channelsChanged, this, [this] {
        m_wide = false;
        fitHeight();
    });
    fitHeight();
    follow();
}

QWidget *CursorPanel::makeSide()
{
    auto *side = new QWidget(this);
    side->setFixedWidth(kSideWidth);
    m_pairs->setEditable(true);
    m_pairs->setInsertPolicy(QComboBox::NoInsert);
    m_pairs->lineEdit()->setMaxLength(Cursors::kNameLength);
    m_pairs->setToolTip(tr("The pair that is read out; type to give it a name"));
    new WheelGuard(m_pairs);
    const auto button = [side](QToolButton *tool, const char *name, const char *icon,
                            const QString &says) {
        tool->setParent(side);
        named(tool, name, says)->setToolTip(says);
        setLineIcon(*tool, icon);
        tool->setAutoRaise(true);
    };
    button(m_add, "addCursorPair", "add", tr("Another pair of cursors"));
    button(m_remove, "removeCursorPair", "remove", tr("Remove this pair"));
    button(m_copy, "copyCursors", "copy", tr("Copy the values as text"));
    button(m_hide, "hideCursors", "close", tr("Hide the cursors (C)"));
    m_distance->setTextFormat(Qt::PlainText);
    m_distance->setTextInteractionFlags(Qt::TextSelectableByMouse);

    auto *buttons = bare(new QHBoxLayout, kFineGrid);
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    buttons->addWidget(m_copy);
    buttons->addStretch(1);
    buttons->addWidget(m_hide);
    auto *layout = bare(new QVBoxLayout(side), kFineGrid);
    layout->addWidget(m_pairs);
    layout->addLayout(buttons);
    layout->addWidget(m_distance);
    layout->addStretch(1);

    Cursors &cursors = m_scope.cursors();
    connect(m_pairs, &QComboBox::activated, &cursors, &Cursors::setCurrent);
    connect(m_pairs->lineEdit(), &QLineEdit::editingFinished, &cursors,
        [this, &cursors] { cursors.rename(m_pairs->currentText()); });
    connect(m_add, &QToolButton::clicked, &cursors, [this, &cursors] {
        const ScopeView::TimeRange seen = m_scope.visibleRange();
        const double span = seen.to - seen.from;
        cursors.addPair(seen.from + span * 0.4, seen.from + span * 0.6);
    });
    connect(m_remove, &QToolButton::clicked, &cursors, &Cursors::removeCurrent);
    connect(m_copy, &QToolButton::clicked, this, &CursorPanel::copy);
    connect(m_hide, &QToolButton::clicked, &m_scope.cursorActions(), &CursorActions::toggle);
    return side;
}

void CursorPanel::tabAfterScope()
{
    QWidget *before = &m_scope;
    for (QWidget *part = before->nextInFocusChain(); m_scope.isAncestorOf(part);
         part = part->nextInFocusChain()) {
        if (part->focusPolicy() & Qt::TabFocus)
            before = part;
    }
    for (QWidget *next :
        std::initializer_list<QWidget *>{m_pairs, m_add, m_remove, m_copy, m_hide, m_table})
        setTabOrder(std::exchange(before, next), next);
}

void CursorPanel::copy() { QApplication::clipboard()->setText(m_model->asText()); }

void CursorPanel::follow()
{
    const Cursors &cursors = m_scope.cursors();
    setVisible(cursors.visible());
    const auto &pairs = cursors.pairs();
    if (m_pairs->count() != int(pairs.size()) || m_pairs->currentIndex() != cursors.current()
        || m_pairs->itemText(cursors.current()) != cursors.pair().name) {
        m_pairs->clear();
        for (const CursorPair &pair : pairs)
            m_pairs->addItem(pair.name);
        m_pairs->setCurrentIndex(cursors.current());
    }
    m_add->setEnabled(pairs.size() < std::size_t(Cursors::kMostPairs));
    m_remove->setEnabled(pairs.size() > 1);
    m_distance->setText(QStringLiteral("1/\u0394t\u2002")
        + inverseTime(cursors.pair().b - cursors.pair().a, m_scope.locale()));
}

/// Exactly the heading and three lines: what is above keeps the rest.
void CursorPanel::fitHeight()
{
    const int line = fontMetrics().height() + kRowRoom;
    m_table->verticalHeader()->setMinimumSectionSize(line);
    m_table->verticalHeader()->setDefaultSectionSize(line);
    m_table->horizontalHeader()->setFixedHeight(line + 2);
    // The scroll bar of many traces has its place below them.
    const int bar = m_wide ? m_table->horizontalScrollBar()->sizeHint().height() : 0;
    m_table->setFixedHeight(line + 2 + CursorTable::kRows * line + bar);
}

void CursorPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitHeight();
}

} // namespace widgets

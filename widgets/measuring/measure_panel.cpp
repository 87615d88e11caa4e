#include "widgets/measuring/measure_panel.h"

#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/measuring/trace_box.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace widgets {

namespace {
constexpr std::array kMeasureColumns{
    120, 112, 112, 112, 104, 112, 112, 64}; // px, as in MeasureTable::Column
} // namespace

MeasurePanel::MeasurePanel(
    ScopeView &scope, const capture::Capture &capture, TriggerControl &trigger, QWidget *parent)
    : Form(parent)
    , m_scope(scope)
    , m_capture(capture)
    , m_trigger(trigger)
    , m_table(new MeasureTable(scope, capture, this))
    , m_list(new RowList("measureList", tr("Measurements"), m_table, this))
    , m_trace(new QComboBox(this))
    , m_quantity(new QComboBox(this))
    , m_against(new QComboBox(this))
    , m_range(new QComboBox(this))
{
    setObjectName(QStringLiteral("measurePanel"));
    m_list->header()->setStretchLastSection(false);
    for (int column = 0; column < MeasureTable::kColumns; ++column)
        m_list->setColumnWidth(column, // the heading whole, in every language
            std::max(kMeasureColumns[static_cast<std::size_t>(column)],
                m_list->header()->sectionSizeHint(column)));
    m_list->installEventFilter(this);
    auto *side = new QWidget(this);
    side->setFixedWidth(kSideWidth);
    makeSide(side);
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(side);
    layout->addWidget(m_list, 1);

    connect(&scope, &ScopeView::channelsChanged, this, &MeasurePanel::fillTraces);
    connect(&trigger.trigger(), &Trigger::recordCompleted, this, &MeasurePanel::recordCompleted);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &MeasurePanel::drawChosen);
    connect(m_table, &MeasureTable::dataChanged, this, &MeasurePanel::drawChosen);
    for (const auto changed : {&MeasureTable::rowsInserted, &MeasureTable::rowsRemoved})
        connect(m_table, changed, this, &MeasurePanel::enableButtons);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &MeasurePanel::enableButtons);
    enableButtons();
    fillTraces();
}

void MeasurePanel::enableButtons()
{
    m_remove->setEnabled(m_list->currentIndex().isValid());
    for (QPushButton *ofAll : {m_clear, m_copy})
        ofAll->setEnabled(m_table->rowCount() > 0);
}

void MeasurePanel::makeSide(QWidget *side)
{
    new WheelGuard(named(m_trace, "measureTrace"));
    new WheelGuard(named(m_quantity, "measureQuantity"));
    new WheelGuard(named(m_against, "measureAgainst"));
    new WheelGuard(named(m_range, "measureRange"));
    for (const scope::Quantity quantity : allQuantities()) {
        m_quantity->addItem(quantityText(quantity), static_cast<int>(quantity));
        m_quantity->setItemData(m_quantity->count() - 1, quantityHelp(quantity), Qt::ToolTipRole);
    }
    m_range->addItems({tr("the picture"), tr("between the cursors")});
    auto *add = named(new QPushButton(tr("&Add"), side), "addMeasure");
    m_remove = named(new QPushButton(tr("Rem&ove"), side), "removeMeasure");
    m_clear = named(new QPushButton(tr("&Clear statistics"), side), "clearStatistics");
    m_copy = named(new QPushButton(tr("Co&py"), side), "copyMeasures");

    auto *form = new QFormLayout;
    form->addRow(tr("T&race"), m_trace);
    form->addRow(tr("Meas&ure"), m_quantity);
    form->addRow(tr("A&gainst"), m_against);
    form->addRow(tr("&In"), m_range);
    auto *first = new QHBoxLayout;
    first->addWidget(add);
    first->addWidget(m_remove);
    auto *second = new QHBoxLayout;
    second->addWidget(m_clear);
    second->addWidget(m_copy);
    auto *layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(form);
    layout->addLayout(first);
    layout->addLayout(second);
    layout->addStretch(1);

    const auto showAgainst = [this, form] {
        const bool phase = m_quantity->currentData().toInt() == int(scope::Quantity::Phase);
        m_against->setVisible(phase);
        form->labelForField(m_against)->setVisible(phase);
    };
    connect(m_quantity, &QComboBox::currentIndexChanged, this, showAgainst);
    showAgainst();
    connect(m_range, &QComboBox::activated, this, [this](int range) {
        if (range == BetweenCursors && !m_scope.cursors().visible())
            m_scope.cursorActions().toggle();
        measureAll();
    });
    connect(add, &QPushButton::clicked, this, &MeasurePanel::addChosen);
    connect(m_remove, &QPushButton::clicked, this, &MeasurePanel::removeChosen);
    connect(m_clear, &QPushButton::clicked, m_table, &MeasureTable::clearStatistics);
    connect(m_copy, &QPushButton::clicked, this,
        [this] { QApplication::clipboard()->setText(tableText(*m_table)); });
}

void MeasurePanel::fillTraces()
{
    fillTraceBox(*m_trace, m_scope, m_capture);
    fillTraceBox(*m_against, m_scope, m_capture, static_cast<int>(m_scope.channels().size()));
    addWaiting();
}

QList<NamedMeasure> MeasurePanel::measures() const
{
    QList<NamedMeasure> all;
    for (int row = 0; row < m_table->rowCount(); ++row)
        all.append(m_table->named(row));
    return all + m_waiting;
}

void MeasurePanel::setMeasures(QList<NamedMeasure> measures)
{
    while (m_table->rowCount() > 0)
        m_table->remove(m_table->rowCount() - 1);
    m_waiting = std::move(measures);
    addWaiting();
    drawChosen();
}

void MeasurePanel::addWaiting()
{
    const auto shown = [this](const QString &name) -> std::optional<capture::ChannelInfo> {
        for (const capture::ChannelId id : m_scope.channels())
            if (m_scope.nameOf(id) == name)
                return m_capture.info(id);
        return {};
    };
    for (const NamedMeasure &measure : std::exchange(m_waiting, {})) {
        const auto first = shown(measure.signal), second = shown(measure.against);
        if (!first || (!measure.against.isEmpty() && !second)) {
            m_waiting.append(measure);
            continue;
        }
        MeasureTable::Wanted wanted{first->registerId, first->kind, measure.quantity, {}};
        if (second)
            wanted.against = second->registerId;
        if (m_table->add(wanted))
            showAdded();
    }
}

void MeasurePanel::addChosen()
{
    const auto info = m_capture.info(m_trace->currentData().toUInt());
    if (!info)
        return;
    MeasureTable::Wanted wanted{info->registerId, info->kind,
        static_cast<scope::Quantity>(m_quantity->currentData().toInt()), {}};
    if (wanted.quantity == scope::Quantity::Phase) {
        if (const auto second = m_capture.info(m_against->currentData().toUInt()))
            wanted.against = second->registerId;
    }
    add(wanted);
}

void MeasurePanel::measure(capture::ChannelId channel, scope::Quantity quantity)
{
    if (const auto info = m_capture.info(channel))
        add({info->registerId, info->kind, quantity, {}});
}

void MeasurePanel::add(const MeasureTable::Wanted &wanted)
{
    if (!m_table->add(wanted))
        return;
    measureAll();
    m_list->setCurrentIndex(m_table->index(m_table->rowCount() - 1, 0));
    showAdded();
}

void MeasurePanel::showAdded()
{
    // Names may be long; what numbers there will be is not known yet.
    for (const int column : {MeasureTable::SignalColumn, MeasureTable::QuantityColumn}) {
        const QModelIndex added = m_table->index(m_table->rowCount() - 1, column);
        m_list->setColumnWidth(
            column, std::max(m_list->columnWidth(column), m_list->sizeHintForIndex(added).width()));
    }
}

void MeasurePanel::removeChosen()
{
    m_table->remove(m_list->currentIndex().row());
    drawChosen();
}

void MeasurePanel::refresh(Milliseconds) { measureAll(); }

void MeasurePanel::focusFirst()
{
    m_trace->setFocus(Qt::ShortcutFocusReason);
    measureAll();
}

/// Counts it as it would be measured in the picture: between cursors, where they stand from the trigger.
void MeasurePanel::recordCompleted(const scope::Record &record)
{
    const scope::Record *shown = m_trigger.shown();
    capture::Nanos from = record.from;
    capture::Nanos to = record.to;
    if (betweenCursors()) {
        const capture::TimeSpan range = measuredRange();
        const capture::Nanos shift = shown ? record.trigger - shown->trigger : 0;
        from = capture::toNanos(range.from) + shift;
        to = capture::toNanos(range.to) + shift;
    }
    m_table->count(from, to, record.trigger);
    if (shown && shown->id == record.id)
        measureAll();
}

bool MeasurePanel::betweenCursors() const
{
    return m_range->currentIndex() == BetweenCursors && m_scope.cursors().visible();
}

capture::TimeSpan MeasurePanel::measuredRange() const
{
    const ScopeView::TimeRange seen = m_scope.visibleRange();
    if (!betweenCursors())
        return {seen.from, seen.to};
    const CursorPair &cursors = m_scope.cursors().pair();
    return {std::min(cursors.a, cursors.b), std::max(cursors.a, cursors.b)};
}

void MeasurePanel::measureAll()
{
    const capture::TimeSpan range = measuredRange();
    m_table->measure(range.from, range.to);
}

/// What the chosen row measured is drawn over its trace, while the table can be seen.
void MeasurePanel::drawChosen()
{
    m_scope.setMeasureMarks(
        isVisible() ? m_table->marks(m_list->currentIndex().row()) : MeasureMarks());
}

void MeasurePanel::hideEvent(QHideEvent *event)
{
    Form::hideEvent(event);
    m_scope.setMeasureMarks({});
}

bool MeasurePanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_list && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Delete) {
        removeChosen();
        return true;
    }
    return Form::eventFilter(watched, event);
}

} // namespace widgets

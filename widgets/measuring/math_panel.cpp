#include "widgets/measuring/math_panel.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/value_text.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/measuring/math_table.h"
#include "widgets/measuring/ready_formulas.h"
#include "widgets/scope/view.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

namespace {
constexpr int kEditorWidth = 430;
constexpr int kNameWidth = 130;
constexpr int kValueWidth = 150;
} // namespace

MathPanel::MathPanel(MathChannels &channels, ScopeView &scope, const capture::Capture &capture,
    ChosenMotor motor, QWidget *parent)
    : Form(parent)
    , m_channels(channels)
    , m_scope(scope)
    , m_motor(std::move(motor))
    , m_table(new MathTable(channels, capture, scope, this))
    , m_list(new RowList("mathList", tr("Math channels"), m_table, this))
    , m_name(named(new QLineEdit(this), "mathName"))
    , m_formula(named(new QLineEdit(this), "mathFormula"))
    , m_verdict(wrappedLabel("mathVerdict", this))
    , m_apply(named(new QPushButton(this), "applyMath"))
    , m_remove(named(new QPushButton(tr("&Remove"), this), "removeMath"))
    , m_record(named(new QPushButton(tr("Record it", "a signal"), this), "recordForMath"))
{
    setObjectName(QStringLiteral("mathPanel"));
    makeList();
    auto *layout = edged(new QHBoxLayout(this), kToolEdges);
    layout->addWidget(makeEditor());
    layout->addWidget(m_list, 1);

    connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &MathPanel::showChosen);
    connect(m_formula, &QLineEdit::textChanged, this, &MathPanel::check);
    connect(m_name, &QLineEdit::textChanged, this, &MathPanel::check);
    connect(m_formula, &QLineEdit::returnPressed, this, &MathPanel::apply);
    connect(m_name, &QLineEdit::returnPressed, this, &MathPanel::apply);
    connect(m_apply, &QPushButton::clicked, this, &MathPanel::apply);
    connect(m_remove, &QPushButton::clicked, this, &MathPanel::removeChosen);
    connect(m_record, &QPushButton::clicked, this, [this] {
        const QString name = m_lacking;
        m_formula->setFocus(); // what was written waits for it
        Q_EMIT signalWanted(name);
    });
    connect(&channels, &MathChannels::changed, this, &MathPanel::check);
    connect(&scope, &ScopeView::channelsChanged, this, &MathPanel::check);
    beginNew();
}

void MathPanel::makeList()
{
    m_list->header()->setStretchLastSection(false);
    m_list->header()->resizeSection(MathTable::NameColumn, kNameWidth);
    m_list->header()->resizeSection(MathTable::ValueColumn, kValueWidth);
    m_list->header()->setSectionResizeMode(MathTable::FormulaColumn, QHeaderView::Stretch);
    m_list->installEventFilter(this);
}

QWidget *MathPanel::makeEditor()
{
    auto *side = new QWidget(this);
    side->setFixedWidth(kEditorWidth);
    m_name->setMaxLength(int(kLongestMathName));
    m_name->setToolTip(tr("Letters of A to Z, digits and _; other formulas use it by this name."));
    m_formula->setMaxLength(int(scope::Formula::kMostBytes));
    m_formula->setPlaceholderText(QStringLiteral("lowpass(I_A, 100) - I_B"));
    auto *fresh = named(new QPushButton(tr("Ne&w"), side), "newMath");
    auto *ready = named(new QPushButton(tr("Read&y formulas"), side), "readyMath");
    auto *insertIt = named(new QPushButton(tr("&Insert"), side), "insertMath");
    const auto withMenu = [this](QPushButton *button, const char *name, auto fill) {
        auto *menu = named(new QMenu(button), name);
        menu->setToolTipsVisible(true);
        button->setMenu(menu);
        connect(menu, &QMenu::aboutToShow, this, [this, menu, fill] { (this->*fill)(*menu); });
    };
    withMenu(ready, "readyMathMenu", &MathPanel::fillReady);
    withMenu(insertIt, "insertMathMenu", &MathPanel::fillInsert);

    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("F&ormula"), m_formula);
    form->addRow(QString(), m_verdict);
    auto *helps = new QHBoxLayout;
    helps->addWidget(ready);
    helps->addWidget(insertIt);
    helps->addWidget(m_record);
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {fresh, m_apply, m_remove})
        buttons->addWidget(button);
    auto *layout = bare(new QVBoxLayout(side));
    layout->addLayout(form);
    layout->addLayout(helps);
    layout->addLayout(buttons);
    layout->addStretch(1);
    connect(fresh, &QPushButton::clicked, this, [this] {
        beginNew();
        m_formula->setFocus();
    });
    return side;
}

void MathPanel::fillReady(QMenu &menu)
{
    menu.clear();
    const auto selected = m_scope.selectedChannel();
    const QString chosen = selected ? m_scope.nameOf(*selected) : QString();
    const std::vector<scope::FormulaName> names = m_channels.names(chosenName());
    for (const ReadyFormula &ready : readyFormulas(names, chosen, m_motor())) {
        QAction *action = menu.addAction(ready.title);
        action->setEnabled(!ready.text.isEmpty());
        action->setToolTip(plainToolTip(ready.text.isEmpty() ? ready.missing : ready.text));
        connect(action, &QAction::triggered, this, [this, text = ready.text] {
            m_formula->setText(text);
            m_formula->setFocus();
        });
    }
}

void MathPanel::fillInsert(QMenu &menu)
{
    menu.clear();
    const auto add = [&](const QString &shown, const QString &text) {
        QString title = shown;
        title.replace(QLatin1Char('&'), QLatin1String("&&"));
        connect(menu.addAction(title), &QAction::triggered, this, [this, text] { insert(text); });
    };
    for (const scope::FormulaName &name : m_channels.names(chosenName()))
        add(deviceText(name.name), inFormula(QString::fromStdString(name.name)));
    menu.addSeparator();
    for (const scope::ColumnFunctionInfo &function : scope::columnFunctions()) {
        const QString name =
            QString::fromLatin1(function.name.data(), qsizetype(function.name.size()));
        add(name + QStringLiteral("()"), name + QLatin1Char('('));
    }
}

void MathPanel::insert(const QString &text)
{
    m_formula->insert(text);
    m_formula->setFocus();
}

void MathPanel::refresh(Milliseconds) { m_table->refresh(); }

void MathPanel::choose(const QString &name)
{
    m_list->setCurrentIndex(m_table->index(m_table->rowOf(name), MathTable::NameColumn));
}

void MathPanel::focusFirst()
{
    m_formula->setFocus(Qt::ShortcutFocusReason);
    check();
}

QString MathPanel::chosenName() const { return m_name->text().trimmed(); }

void MathPanel::beginNew()
{
    m_list->setCurrentIndex({});
    m_name->setText(m_channels.freeName());
    m_formula->clear();
    check();
}

void MathPanel::showChosen()
{
    const QModelIndex current = m_list->currentIndex();
    if (!current.isValid())
        return;
    const MathFormula formula = m_table->entry(current.row()).formula;
    m_name->setText(formula.name);
    m_formula->setText(formula.text);
}

void MathPanel::offerSignals(std::function<bool(const QString &name)> can)
{
    m_can = std::move(can);
    check();
}

void MathPanel::offer(const QString &name)
{
    m_lacking = !name.isEmpty() && m_can && m_can(name) ? name : QString();
    m_record->setEnabled(!m_lacking.isEmpty());
    m_record->setToolTip(plainToolTip(m_lacking.isEmpty()
            ? tr("Where a formula needs a signal of the board that is not on the scope, this puts "
                 "it there.")
            : tr("The board has %1: puts it on the scope.", "a signal").arg(m_lacking)));
}

/// Says what is wrong and where, or the unit of what comes out.
void MathPanel::check()
{
    const QString name = chosenName();
    const bool exists = m_table->rowOf(name) >= 0;
    const MathChannels::Check result = m_channels.check(m_formula->text(), name);
    const bool named = exists || m_channels.isFree(name);
    const bool full = !exists && m_channels.formulas().size() >= kMostMathFormulas;
    QString says;
    if (result.fault)
        says = faultText(*result.fault, m_formula->text());
    else if (result.noSignal)
        says = tr("There is no signal in it.");
    else if (!isMathName(name))
        says = tr("The name has to be of letters A to Z, digits and _.");
    else if (!named)
        says = tr("The name is taken by a signal or a function.");
    else if (full)
        says = tr("There is no room for more than %1.").arg(kMostMathFormulas);
    else if (result.unit.isEmpty())
        says = tr("Valid, unit not known or a plain number");
    else
        says = tr("Valid, unit %1").arg(unitText(result.unit));
    const bool fine = result.fine() && named && !full;
    const bool empty = m_formula->text().trimmed().isEmpty();
    // A sign as well as words, so that it is seen without reading.
    const QString sign = empty ? QString()
        : fine                 ? QStringLiteral("\u2713 ")
                               : QStringLiteral("\u2717 ");
    m_verdict->setText(sign + says);
    m_formula->setAccessibleDescription(says);
    offer(result.fault ? unknownName(*result.fault, m_formula->text()) : QString());
    m_apply->setText(exists ? tr("&Change") : tr("&Add"));
    m_apply->setEnabled(fine);
    m_remove->setEnabled(exists);
}

void MathPanel::apply()
{
    const QString name = chosenName();
    if (!m_channels.set(name, m_formula->text().trimmed()))
        return;
    m_list->setCurrentIndex(m_table->index(m_table->rowOf(name), MathTable::NameColumn));
    check();
}

void MathPanel::removeChosen()
{
    const int row = m_table->rowOf(chosenName());
    m_channels.remove(chosenName());
    const int left = m_table->rowCount();
    if (left == 0)
        beginNew();
    else
        m_list->setCurrentIndex(m_table->index(std::min(row, left - 1), MathTable::NameColumn));
    check();
}

bool MathPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_list && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Delete
        && m_list->currentIndex().isValid()) {
        showChosen();
        removeChosen();
        return true;
    }
    return Form::eventFilter(watched, event);
}

} // namespace widgets

#include "widgets/lab/identify_page.h"

#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/row_list.h"
#include "widgets/base/look/spacing.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

IdentifyPage::IdentifyPage(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_parts(parts)
    , m_facts(parts.device, parts.registers)
    , m_table(new RowList("identifyTable", tr("What was measured of the motor"), &findings(), this))
    , m_bar(new ExperimentBar(parts.lab, "identify", this))
{
    setObjectName(QStringLiteral("identifyPage"));
    makeTable();
    makeBar();
    auto *layout = edged(new QVBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0});
    layout->addWidget(m_table);
    layout->addWidget(tachometer());
    connect(&parts.registers, &RegisterModel::catalogSet, this, &IdentifyPage::boardChanged);
    connect(&findings(), &QAbstractItemModel::dataChanged, this, &IdentifyPage::enableButtons);
    connect(&parts.description, &MotorDescription::changed, this, &IdentifyPage::showKnown);
    boardChanged();
}

void IdentifyPage::makeTable()
{
    m_table->setMinimumHeight(100);
    m_table->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->header()->setSectionResizeMode(MotorFindings::NoteColumn, QHeaderView::Stretch);
}

/// What the board tells of a motor that runs, beside what its shaft does.
QWidget *IdentifyPage::tachometer()
{
    constexpr double kMost_rpm = 1e6;
    auto *row = new QWidget(this);
    auto *rpm = new NumberEdit(
        "identifyTachometer", tr("Speed by a tachometer"), tr("rpm"), 0.0, kMost_rpm, row);
    rpm->setToolTip(tr("For the pole pairs: let the motor run at a constant speed, type what a "
                       "tachometer reads at its shaft, and press Enter."));
    auto *label = new QLabel(tr("By a tach&ometer [rpm]"), row);
    label->setBuddy(rpm);
    auto *layout = edged(new QHBoxLayout(row), {});
    layout->addWidget(label);
    layout->addWidget(rpm);
    layout->addStretch();
    connect(rpm, &QLineEdit::returnPressed, this, [this, rpm] {
        if (const auto value = rpm->value(); value && *value > 0.0)
            m_bar->tell(m_parts.identification.countPolePairs(*value));
    });
    return row;
}

void IdentifyPage::makeBar()
{
    m_bar->setPollable(true);
    m_bar->add({tr("E&lectrical"), "electricalRun",
        tr("Measures resistance and dead time at rest, then inductances and flux while it turns; "
           "then the motor is as it was."),
        [this] { return m_parts.identification.electricalRun(); }});
    m_bar->add({tr("Mecha&nical"), "mechanicalRun",
        tr("Measures inertia and friction while the motor gets faster and slower; then it is as it "
           "was."),
        [this] { return m_parts.identification.mechanicalRun(m_bothWays->isChecked()); }});
    m_bar->add({tr("Po&wer"), "powerRun",
        tr("Measures what goes into the motor and what its shaft gives, at the speed that it has."),
        [this] { return m_parts.identification.powerRun(); }});
    m_bothWays = named(new QCheckBox(tr("In both di&rections"), m_bar), "identifyBothWays");
    m_bothWays->setToolTip(tr("The mechanics backwards, too, from rest: only that tells friction "
                              "from a torque that is always there. Not for loads that must not "
                              "turn backwards, or that turn the motor by themselves."));
    connect(m_bothWays, &QCheckBox::toggled, m_bar, &ExperimentBar::refresh);
    m_bar->addAside(m_bothWays);
    m_use = named(new QPushButton(tr("&Use in motor file"), m_bar), "identifyUse");
    m_use->setToolTip(tr("Puts the measured figures into the description beside the board's, in "
                         "Motor and drive; nothing is written to the board."));
    m_back = named(new QPushButton(tr("Take &back"), m_bar), "identifyBack");
    m_back->setToolTip(tr("Takes them out of it again."));
    m_bar->addAside(m_use);
    m_bar->addAside(m_back);
    connect(m_use, &QPushButton::clicked, this, [this] {
        m_parts.description.use(findings().measured(), drive::sheetOf(m_facts.facts()));
    });
    connect(m_back, &QPushButton::clicked, &m_parts.description, &MotorDescription::takeBack);
}

std::vector<catalog::RegisterId> IdentifyPage::watchedRegisters() const
{
    return m_facts.watched();
}

void IdentifyPage::refresh(Milliseconds)
{
    if (m_facts.refresh()) {
        showKnown();
        Q_EMIT watchedRegistersChanged();
    }
    m_bar->refresh();
}

void IdentifyPage::focusFirst() { m_table->setFocus(Qt::ShortcutFocusReason); }

void IdentifyPage::boardChanged()
{
    m_facts.begin();
    showKnown();
    Q_EMIT watchedRegistersChanged();
    m_bar->refresh();
}

void IdentifyPage::showKnown()
{
    findings().setKnown(drive::sheetOf(m_facts.facts()), m_parts.description.sheet());
}

void IdentifyPage::enableButtons()
{
    m_use->setEnabled(findings().any());
    m_back->setEnabled(m_parts.description.holdsMeasured());
}

} // namespace widgets

#include "widgets/forms/rev_up_form.h"

#include "drive/motor_view.h"
#include "session/files/problems.h"
#include "session/files/whole_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/file_prompt.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"
#include "widgets/forms/rev_up_chart.h"
#include "widgets/forms/rev_up_start.h"
#include "widgets/forms/rev_up_table.h"
#include "widgets/forms/rev_up_texts.h"
#include "widgets/registers/edit_bar.h"
#include "widgets/registers/entry_edit.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {
namespace {

constexpr double kKgm2PerGcm2 = 1e-7, kNmPerMnm = 1e-3;
constexpr int kRightWidth = 236;
constexpr qint64 kLargestFile = 1 << 20;

/// It takes what is left, and says what it needs: where a size is ignored, the page is made too low for the rest.
class FindingList : public QListWidget {
public:
    using QListWidget::QListWidget;
    QSize sizeHint() const override { return {QListWidget::sizeHint().width(), kLeast}; }
    QSize minimumSizeHint() const override
    {
        return {QListWidget::minimumSizeHint().width(), kLeast};
    }

private:
    static constexpr int kLeast = 60; ///< pixels
};

/// Of two limits, 0 being none.
double lowerLimit(double a, double b) { return !(a > 0.0) ? b : !(b > 0.0) ? a : std::min(a, b); }

/// The sign of the speed set-point turns the whole rev-up around.
bool turnsAgainst(const MeasuredStart &measured, const motor::RevUp &stages)
{
    double is = 0.0, planned = 0.0;
    for (const QPointF &point : measured.speed_rpm)
        is += point.y();
    for (const motor::RevUpStage &stage : stages)
        planned += stage.speed_rpm;
    return is * planned < 0.0;
}

} // namespace

RevUpForm::RevUpForm(const Parts &parts, QWidget *parent)
    : Form(parent)
    , m_device(parts.device)
    , m_registers(parts.registers)
    , m_files(parts.files)
    , m_model(new RevUpModel(parts.registers, this))
    , m_start(new RevUpStart(parts.device, parts.capture, this))
{
    setObjectName(QStringLiteral("revUpForm"));
    m_reason = wrappedLabel("revUpReason", this);
    m_reason->setFont(inBold(m_reason->font()));
    auto *row = bare(new QHBoxLayout, kGrid);
    row->addWidget(makeLeft());
    row->addWidget(makeMiddle(), 1);
    row->addWidget(makeRight());
    m_footer = makeFooter(parts);
    auto *layout = edged(new QVBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0}, kHalfGrid);
    layout->addWidget(m_reason);
    layout->addLayout(row, 1);
    connectParts();
    adoptFacts();
    showFacts();
    showFindings();
    showStart();
    enableButtons();
}

QPushButton *RevUpForm::makeButton(const QString &text, const char *name, const QString &toolTip)
{
    auto *button = named(new QPushButton(text, this), name);
    button->setToolTip(plainToolTip(toolTip));
    return button;
}

QWidget *RevUpForm::makeLeft()
{
    auto *left = new QWidget(this);
    m_add = makeButton(tr("&Add"), "revUpAdd", tr("Adds a stage after the selected one (Insert)"));
    m_remove = makeButton(tr("&Remove"), "revUpRemove", tr("Removes the selected stage (Delete)"));
    m_up = makeButton(
        tr("&Up", "move a stage"), "revUpUp", tr("Moves the selected stage up (Alt+Up)"));
    m_down = makeButton(
        tr("Dow&n", "move a stage"), "revUpDown", tr("Moves the selected stage down (Alt+Down)"));
    m_table = named(new RevUpTable(left), "revUpTable", tr("Stages of the rev-up"));
    m_table->setModel(m_model);
    auto *delegate = new RevUpDelegate(*m_model, m_table);
    m_table->setItemDelegate(delegate);
    connect(delegate, &RevUpDelegate::entryRefused, this, [this](const QString &sentence) {
        m_bar->tell(
            tr("Not taken over: %1", "what is wrong with a typed value").arg(sentence), false);
    });
    auto *buttons = bare(new QHBoxLayout, kHalfGrid);
    for (QPushButton *button : {m_add, m_remove, m_up, m_down})
        buttons->addWidget(button, 1);
    auto *layout = bare(new QVBoxLayout(left), kHalfGrid);
    layout->addLayout(buttons); // above: where the page is low, they are seen
    layout->addWidget(m_table);
    layout->addStretch(1);
    return left;
}

/// Start values and files on the left, Revert and Apply on the right.
QWidget *RevUpForm::makeFooter(const Parts &parts)
{
    auto *footer = new QWidget(this);
    m_usual = makeButton(tr("Start va&lues"), "revUpUsual",
        tr("ST's start values: 2 s of half the nominal current, then 3 s to 30 % of the highest "
           "speed"));
    m_open = makeButton(tr("&Open\u2026"), "revUpOpen",
        tr("Reads the stages from a file, as rotorscope-cli revup writes them"));
    m_save = makeButton(tr("Save\u2026"), "revUpSave",
        tr("Writes the stages to a file that rotorscope-cli revup reads"));
    m_bar = new EditBar(
        parts.edits, parts.registers, parts.apply, parts.revert, EditBar::Room::Wide, footer);
    auto *layout = bare(new QHBoxLayout(footer), kHalfGrid);
    for (QPushButton *button : {m_usual, m_open, m_save})
        layout->addWidget(button);
    layout->addWidget(m_bar, 1);
    return footer;
}

QWidget *RevUpForm::makeMiddle()
{
    auto *middle = new QWidget(this);
    m_chart = named(new RevUpChart(*m_model, middle), "revUpChart");
    m_chart->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_hint = wrappedLabel("revUpHint", middle);
    m_startText = wrappedLabel("revUpLastStart", middle);
    m_startText->setForegroundRole(QPalette::PlaceholderText);
    auto *layout = bare(new QVBoxLayout(middle), kFineGrid);
    layout->addWidget(m_chart, 1);
    layout->addWidget(m_hint);
    layout->addWidget(m_startText);
    return middle;
}

EntryEdit *RevUpForm::makeNumber(const char *name, const QString &unit, double *value)
{
    static const auto kInfo = [] {
        catalog::RegisterInfo info;
        info.type = catalog::ValueType::F32;
        info.access = catalog::Access::ReadWrite;
        return info;
    }();
    constexpr double kGreatest = 1e9;
    constexpr int kLongestNumber = 64;
    const std::string text = unit.toStdString();
    auto *edit = new EntryEdit(
        [text] {
            return EntryRules{&kInfo, {1.0, text}, {0.0, kGreatest}};
        },
        EntryEdit::As::Shown, this);
    edit->setMaxLength(kLongestNumber);
    edit->setObjectName(QLatin1String(name));
    edit->setEmptyAllowed(true);
    edit->setMaximumWidth(110);
    connect(edit, &QLineEdit::textChanged, this, [this, edit, value] {
        const auto read = edit->value();
        const auto *number = read ? std::get_if<double>(&*read) : nullptr;
        *value = number != nullptr ? *number : 0.0;
        adoptFacts();
    });
    return edit;
}

QWidget *RevUpForm::makeRight()
{
    auto *right = new QWidget(this);
    const QString gcm2 = QStringLiteral("g\u00b7cm\u00b2");
    m_inertia = makeNumber("revUpInertia", gcm2, &m_inertiaTyped_gcm2);
    m_inertia->setToolTip(plainToolTip(
        tr("Of rotor and load together. Only for the judgement here; it is not sent anywhere.")));
    connect(m_inertia, &QLineEdit::editingFinished, this, &RevUpForm::rememberInertia);
    m_friction = makeNumber("revUpFriction", QStringLiteral("mN\u00b7m"), &m_frictionTyped_mnm);
    m_friction->setToolTip(plainToolTip(tr("Torque that holds the motor back. Only for the "
                                           "judgement here; it is not sent anywhere.")));
    m_findings =
        named(new FindingList(right), "revUpFindings", tr("What is wrong with the rev-up"));
    m_findings->setWordWrap(true);
    m_findings->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *numbers = bare(new QFormLayout, kHalfGrid);
    numbers->addRow(tr("Inertia, %1").arg(gcm2), m_inertia);
    numbers->addRow(tr("Friction, mN\u00b7m"), m_friction);
    auto *layout = bare(new QVBoxLayout(right), kHalfGrid);
    m_factsText = wrappedLabel("revUpFacts", right);
    layout->addLayout(numbers);
    layout->addWidget(m_findings, 1);
    layout->addWidget(m_factsText);
    right->setFixedWidth(kRightWidth);
    return right;
}

void RevUpForm::connectParts()
{
    connect(m_model, &RevUpModel::stagesChanged, this, [this] {
        showFindings();
        showFacts();
        enableButtons();
    });
    connect(m_model, &RevUpModel::adjusted, this,
        [this](const QString &sentence) { m_bar->tell(sentence, true); });
    connect(&m_registers, &RegisterModel::catalogSet, this, &RevUpForm::adoptFacts);
    connect(&m_device, &Device::boundsChanged, this, &RevUpForm::adoptFacts);
    connect(&m_registers, &RegisterModel::catalogSet, this, &Form::watchedRegistersChanged);
    connect(
        &m_device, &Device::readingsArrived, this,
        [this](const std::vector<drive::Reading> &readings) {
            const auto ours = [this](const drive::Reading &reading) {
                return std::find(m_motorRegisters.begin(), m_motorRegisters.end(), reading.id)
                    != m_motorRegisters.end();
            };
            if (std::any_of(readings.begin(), readings.end(), ours))
                adoptFacts();
        },
        Qt::QueuedConnection); // once the registers have them
    connect(m_chart, &RevUpChart::hintChanged, this, [this] {
        m_hint->setText(m_chart->hint());
        fitHint();
    });
    m_hint->setText(m_chart->hint());
    connect(m_chart, &RevUpChart::stageSelected, this, &RevUpForm::goTo);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex &index) {
            if (index.isValid())
                m_chart->selectStage(index.row());
            enableButtons();
        });
    connect(m_findings, &QListWidget::currentRowChanged, this, [this](int row) {
        if (const auto *item = m_findings->item(row); item && item->data(Qt::UserRole).isValid())
            goTo(item->data(Qt::UserRole).toInt());
    });
    const auto add = [this] { change(m_model->addAfter(currentStage()), currentStage() + 1); };
    const auto remove = [this] { change(m_model->remove(currentStage()), currentStage()); };
    const auto move = [this](int by) {
        change(m_model->move(currentStage(), by), currentStage() + by);
    };
    connect(m_add, &QPushButton::clicked, this, add);
    connect(m_remove, &QPushButton::clicked, this, remove);
    connect(m_up, &QPushButton::clicked, this, [move] { move(-1); });
    connect(m_down, &QPushButton::clicked, this, [move] { move(1); });
    connect(m_table, &RevUpTable::addWanted, this, add);
    connect(m_table, &RevUpTable::removeWanted, this, remove);
    connect(m_table, &RevUpTable::moveWanted, this, move);
    connect(m_chart, &RevUpChart::addWanted, this, add);
    connect(m_chart, &RevUpChart::removeWanted, this, remove);
    connect(m_usual, &QPushButton::clicked, this, [this] {
        const RevUpFacts &facts = m_model->facts();
        motor::RevUp stages = motor::usualRevUp(
            facts.limits.nominalCurrent_a, facts.boardSpeed_rpm, facts.ampsPerDigit);
        for (motor::RevUpStage &stage : stages)
            stage = motor::fittedStage(
                stage, stage.speed_rpm, stage.current_digits, stage.duration_ms, m_model->bounds());
        change(m_model->setStages(stages), 0);
    });
    connect(m_open, &QPushButton::clicked, this, &RevUpForm::openFile);
    connect(m_save, &QPushButton::clicked, this, &RevUpForm::saveFile);
    connect(m_start, &RevUpStart::changed, this, &RevUpForm::showStart);
    connect(&m_device, &Device::statusChanged, this, [this, was = false](int) mutable {
        const bool now = m_start->result() == RevUpStart::Result::UnderWay;
        if (std::exchange(was, now) != now)
            Q_EMIT watchedRegistersChanged();
    });
}

// What is known of the motor ------------------------------------------------------------------------------------------

/// A field that loses the focus as the form goes has nothing left to tell it to.
RevUpForm::~RevUpForm() { m_inertia->disconnect(this); }

void RevUpForm::setInertias(const Inertias &inertias)
{
    if (inertias == m_inertias)
        return;
    m_inertias = inertias;
    adoptFacts();
}

void RevUpForm::rememberInertia()
{
    if (m_inertiaTyped_gcm2 <= 0.0 || m_motorName.isEmpty())
        return;
    m_inertias[m_motorName] = m_inertiaTyped_gcm2 * kKgm2PerGcm2;
    Q_EMIT inertiaRemembered(m_motorName, m_inertias[m_motorName]);
}

/// What was typed belongs to the motor it was typed for. A name that is not known yet is not another name.
void RevUpForm::forgetAnothersNumbers()
{
    const bool renamed = !m_typedName.isEmpty() && !m_motorName.isEmpty();
    const bool another =
        m_typedMotor != m_device.motor() || (renamed && m_typedName != m_motorName);
    m_typedMotor = m_device.motor();
    if (another || !m_motorName.isEmpty())
        m_typedName = m_motorName;
    if (another && m_inertia && m_friction) {
        m_inertia->clear(); // which takes the typed value with it
        m_friction->clear();
    }
}

void RevUpForm::adoptFacts()
{
    RevUpFacts facts;
    const auto catalog = m_registers.catalog();
    m_motorRegisters.clear();
    m_inertiaFound_kgm2 = 0.0;
    m_motorName.clear();
    if (catalog) {
        m_motorRegisters = drive::motorRegisters(*catalog, m_device.motor());
        const drive::MotorFacts motor = drive::motorFacts(*catalog, m_device.motor(),
            [this](catalog::RegisterId id) { return m_registers.known(id); });
        const auto index = static_cast<std::size_t>(m_device.motor() - 1);
        const auto &identified = m_device.identified();
        const drive::MotorLimits limits = identified && index < identified->limits.size()
            ? identified->limits[index]
            : motor.limits;
        facts.ampsPerDigit = motor.ampsPerDigit;
        facts.sixStep = motor.sixStep;
        facts.angleSensor = valueNameText(motor.angleSensor);
        const drive::UserLimits &own = m_device.userLimits();
        facts.boardSpeed_rpm = limits.maxSpeedRpm;
        facts.speedStep_rpm = limits.speedStepRpm;
        facts.limits.maxSpeed_rpm = lowerLimit(limits.maxSpeedRpm, own.maxSpeedRpm);
        facts.limits.minimumSpeed_rpm = motor::minimumStartSpeed_rpm(limits.maxSpeedRpm);
        facts.limits.nominalCurrent_a = limits.nominalCurrentAmps;
        facts.limits.maxCurrent_a = lowerLimit(limits.maxCurrentAmps, own.maxCurrentAmps);
        if (motor.motor.flux_wb > 0.0 && motor.motor.polePairs > 0.0)
            facts.limits.load.kt_nmpa =
                motor::ktOfFlux_nmpa(motor.motor.flux_wb, motor.motor.polePairs);
        m_motorName = deviceText(motor.name);
        forgetAnothersNumbers();
        m_inertiaFound_kgm2 =
            motor.inertia_kgm2 > 0.0 ? motor.inertia_kgm2 : m_inertias.value(m_motorName);
    }
    facts.limits.load.inertia_kgm2 =
        m_inertiaTyped_gcm2 > 0.0 ? m_inertiaTyped_gcm2 * kKgm2PerGcm2 : m_inertiaFound_kgm2;
    facts.limits.load.coulomb_nm = m_frictionTyped_mnm * kNmPerMnm;
    if (m_inertia)
        m_inertia->setPlaceholderText(m_inertiaFound_kgm2 > 0.0
                ? numberText(m_inertiaFound_kgm2 / kKgm2PerGcm2, 1)
                : tr("not known"));
    m_model->setFacts(facts);
}

std::vector<catalog::RegisterId> RevUpForm::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    const bool underWay = m_start->result() == RevUpStart::Result::UnderWay;
    if (const auto current = m_registers.idOf("I_Q_MEAS"); current && m_model->registerId())
        ids.push_back(*current);
    if (underWay)
        return ids; // as often as the link can
    if (m_model->registerId())
        ids.push_back(*m_model->registerId());
    for (const catalog::RegisterId id : m_motorRegisters)
        if (!m_registers.known(id) && m_registers.pollable(id))
            ids.push_back(id);
    return ids;
}

void RevUpForm::refresh(Milliseconds)
{
    m_start->refresh();
    // What never changes is asked for once.
    const bool all = std::all_of(
        m_motorRegisters.begin(), m_motorRegisters.end(), [this](catalog::RegisterId id) {
            return m_registers.known(id) || !m_registers.pollable(id);
        });
    if (!all)
        Q_EMIT watchedRegistersChanged();
}

void RevUpForm::focusFirst()
{
    if (!m_table->currentIndex().isValid() && m_model->rowCount() > 0)
        m_table->setCurrentIndex(m_model->index(0, 0));
    m_table->setFocus(Qt::ShortcutFocusReason);
}

bool RevUpForm::event(QEvent *event)
{
    // The form is as high as its parts; how much of it is seen, only what it is in knows.
    if (event->type() == QEvent::ParentChange && parentWidget() != nullptr)
        parentWidget()->installEventFilter(this);
    if (event->type() == QEvent::Resize)
        fitHint();
    return Form::event(event);
}

bool RevUpForm::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && watched == parentWidget())
        fitHint();
    return Form::eventFilter(watched, event);
}

/// Where the page would scroll for it, it gives way: the table has the numbers. Whatever it says now, so that no point
/// moves under the mouse.
void RevUpForm::fitHint()
{
    constexpr int kLines = 3;
    int wanted = 2 * kGrid + m_chart->minimumSizeHint().height()
        + kLines * m_hint->fontMetrics().lineSpacing();
    for (const QLabel *label : {m_reason, m_startText})
        if (!label->isHidden())
            wanted += label->heightForWidth(label->width());
    m_hint->setVisible((parentWidget() != nullptr ? parentWidget() : this)->height() >= wanted);
}

void RevUpForm::showFacts()
{
    const QString reason = m_model->unavailable();
    const auto catalog = m_registers.catalog();
    const QString motor = reason.isEmpty() && catalog && catalog->motors() > 1
        ? tr("Motor %1").arg(QString::number(m_device.motor()))
        : QString();
    m_reason->setText(reason.isEmpty() ? motor : reason);
    m_reason->setVisible(!m_reason->text().isEmpty());
    m_startText->setVisible(reason.isEmpty());
    const RevUpFacts &facts = m_model->facts();
    m_table->setColumnHidden(RevUpModel::CurrentColumn, m_model->currentUnit().isEmpty());
    m_table->setColumnHidden(RevUpModel::TorqueColumn, facts.sixStep);
    m_inertia->setEnabled(!facts.sixStep);
    m_friction->setEnabled(!facts.sixStep);
    QStringList lines;
    if (reason.isEmpty()) {
        lines.append(tr("Takes %1\u202fs in all")
                         .arg(numberText(motor::revUpDuration_s(m_model->stages()), 2)));
        const auto &limits = facts.limits;
        if (limits.maxSpeed_rpm > 0.0)
            lines.append(tr("Highest speed %1\u202frpm").arg(numberText(limits.maxSpeed_rpm, 0)));
        if (!facts.sixStep && limits.nominalCurrent_a > 0.0)
            lines.append(
                tr("Nominal current %1")
                    .arg(numberText(limits.nominalCurrent_a, 2) + QStringLiteral("\u202fA")));
        if (!facts.sixStep)
            lines.append(limits.load.kt_nmpa > 0.0
                    ? tr("Kt %1 per A").arg(torqueText(limits.load.kt_nmpa))
                    : tr("Torque is not judged: the board does not say its magnets' flux "
                         "(MOTOR_CONFIG)."));
        if (!facts.sixStep && limits.load.kt_nmpa > 0.0 && !(limits.load.inertia_kgm2 > 0.0))
            lines.append(tr("Torque is not judged: type the inertia."));
        if (!facts.sixStep && !(facts.ampsPerDigit > 0.0))
            lines.append(tr("The scale of the current is not known: digits only."));
    }
    m_factsText->setText(lines.join(QStringLiteral(" \u00b7 ")));
}

void RevUpForm::showFindings()
{
    const QSignalBlocker quiet(m_findings);
    QStringList texts;
    std::vector<int> stages;
    for (const auto &finding : m_model->findings()) {
        texts.append(QStringLiteral("\u26a0 ") + revUpFindingText(finding, *m_model));
        stages.push_back(static_cast<int>(finding.stage));
    }
    if (texts.isEmpty() && m_model->used() > 0) {
        texts.append(tr("\u2713 No problems found."));
        stages.push_back(-1);
    }
    // A list that is read must not be taken away under the reader.
    while (m_findings->count() > texts.size())
        delete m_findings->takeItem(m_findings->count() - 1);
    for (int i = 0; i < texts.size(); ++i) {
        if (i >= m_findings->count())
            m_findings->addItem(QString());
        QListWidgetItem *item = m_findings->item(i);
        item->setText(texts[i]);
        const int stage = stages[static_cast<std::size_t>(i)];
        item->setData(Qt::UserRole, stage >= 0 ? QVariant(stage) : QVariant());
    }
}

void RevUpForm::showStart()
{
    using Result = RevUpStart::Result;
    const QString time = numberText(m_start->duration_s(), 2);
    QString text;
    switch (m_start->result()) {
    case Result::None:
        text = tr("The next start is drawn over the plan.");
        break;
    case Result::UnderWay:
        text = tr("Start under way\u2026");
        break;
    case Result::Running:
        text = tr("Last start: the drive took over after %1\u202fs.").arg(time);
        break;
    case Result::Failed:
        text = tr("Last start: failed after %1\u202fs (%2).").arg(time, m_start->fault());
        break;
    case Result::Stopped:
        text = tr("Last start: stopped after %1\u202fs.").arg(time);
        break;
    }
    const bool over = m_start->result() != Result::None && m_start->result() != Result::UnderWay;
    const bool currentDrawn = m_start->hasCurrent() && !m_model->currentUnit().isEmpty();
    if (over && !m_start->hasSpeed())
        text += QLatin1Char(' ') + tr("No speed was recorded.");
    if (over && !currentDrawn && !m_model->facts().sixStep)
        text += QLatin1Char(' ') + tr("No Iq was recorded.");
    MeasuredStart measured = m_start->measured();
    const bool backwards = !m_model->stages().empty() && turnsAgainst(measured, m_model->stages());
    if (backwards) {
        for (QList<QPointF> *points : {&measured.speed_rpm, &measured.current_a})
            for (QPointF &point : *points)
                point.setY(-point.y());
    }
    if (over && (m_start->hasSpeed() || currentDrawn))
        text += QLatin1Char(' ')
            + (backwards ? tr("Measured: thin lines, mirrored, for it turned backwards.")
                         : tr("Measured: thin lines."));
    m_startText->setText(text);
    fitHint();
    m_chart->setMeasured(measured);
}

// Changing stages -----------------------------------------------------------------------------------------------------

int RevUpForm::currentStage() const
{
    const QModelIndex now = m_table->currentIndex();
    return now.isValid() ? now.row() : m_model->used() - 1;
}

void RevUpForm::goTo(int stage)
{
    if (stage < 0 || stage >= m_model->rowCount())
        return;
    const QModelIndex now = m_table->currentIndex();
    if (now.row() != stage)
        m_table->setCurrentIndex(
            m_model->index(stage, now.isValid() ? now.column() : int(RevUpModel::DurationColumn)));
    m_chart->selectStage(stage);
}

void RevUpForm::change(bool done, int stage)
{
    if (done)
        goTo(std::clamp(stage, 0, std::max(m_model->used() - 1, 0)));
    enableButtons();
}

void RevUpForm::enableButtons()
{
    const bool can = m_model->editable();
    const int stage = currentStage(), used = m_model->used();
    m_table->setEnabled(m_model->rowCount() > 0);
    m_chart->setEnabled(used > 0);
    m_add->setEnabled(can && used < static_cast<int>(motor::kRevUpStages));
    m_remove->setEnabled(can && stage >= 0 && stage < used);
    m_up->setEnabled(can && stage > 0 && stage < used);
    m_down->setEnabled(can && stage >= 0 && stage + 1 < used);
    const RevUpFacts &facts = m_model->facts();
    m_usual->setEnabled(can && !facts.sixStep && facts.ampsPerDigit > 0.0
        && facts.limits.nominalCurrent_a > 0.0 && facts.boardSpeed_rpm > 0.0);
    m_open->setEnabled(can);
    m_save->setEnabled(m_model->rowCount() > 0);
}

// Files ---------------------------------------------------------------------------------------------------------------

void RevUpForm::openFile()
{
    m_files.askOpen(this, {tr("Open a rev-up"), m_folder, tr("Rev-ups (*.json);;All files (*)")},
        [this](const QString &path) { readFile(path); });
}

void RevUpForm::readFile(const QString &path)
{
    const QString name = fileNameText(path);
    const auto content = session::readWholeFile(path, kLargestFile);
    if (!content)
        return Q_EMIT failed(tr("%1 cannot be read: %2.").arg(name, content.error()));
    const RevUpFacts &facts = m_model->facts();
    const auto stages = session::readRevUpJson(*content, facts.sixStep ? 0.0 : facts.ampsPerDigit);
    if (!stages)
        return Q_EMIT failed(
            session::revUpProblemText(name, stages.error(), translatedFileProblem));
    const motor::RevUpBounds bounds = m_model->bounds();
    for (std::size_t i = 0; i < stages->size(); ++i) {
        const auto &stage = (*stages)[i];
        if (std::abs(stage.speed_rpm) > bounds.speed_rpm
            || std::abs(int{stage.current_digits}) > bounds.digits
            || (bounds.pulse && stage.current_digits < 0))
            return Q_EMIT failed(tr("%1 was not taken: its stage %2 is beyond this board's limits.")
                                     .arg(name, QString::number(i + 1)));
    }
    m_folder = QFileInfo(path).path();
    change(m_model->setStages(*stages), 0);
    m_bar->tell(tr("Stages of %1. Apply writes them to the board.").arg(name), true);
}

void RevUpForm::saveFile()
{
    const SaveQuestion question{tr("Save the rev-up"), m_folder, QStringLiteral("rev-up.json"),
        tr("Rev-ups (*.json);;All files (*)"), QStringLiteral("json")};
    m_files.askSave(this, question, [this](const QString &path) {
        const RevUpFacts &facts = m_model->facts();
        const QString why = session::writeWholeFile(
            path, session::revUpJson(m_model->stages(), facts.sixStep ? 0.0 : facts.ampsPerDigit));
        const QString name = fileNameText(path);
        if (!why.isEmpty())
            return Q_EMIT failed(tr("%1 cannot be written: %2.").arg(name, why));
        m_folder = QFileInfo(path).path();
        m_bar->tell(tr("Saved as %1.").arg(name), true);
    });
}

} // namespace widgets

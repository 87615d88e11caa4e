#include "widgets/forms/ramp_form.h"

#include "drive/set_points/shaft_position.h"
#include "motor/ramp.h"
#include "widgets/base/device_text.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/value_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/control/command_box.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/setpoints/shaft_move.h"
#include "widgets/forms/ramp_preview.h"
#include "widgets/registers/model.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace widgets {
namespace {

constexpr int kBarSteps = 1000;
constexpr std::size_t kMostMeasured = 4000;
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

} // namespace

RampForm::RampForm(Device &device, RegisterModel &registers, MotionGate &motion, QWidget *parent)
    : Form(parent)
    , m_device(device)
    , m_registers(registers)
    , m_motion(motion)
{
    setObjectName(QStringLiteral("rampForm"));
    auto *left = bare(new QVBoxLayout, kGrid);
    left->addWidget(makeLines());
    left->addWidget(makePresets());
    left->addStretch(1);
    m_preview = new RampPreview(this);
    m_preview->setMinimumHeight(120);
    m_preview->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_footer = makeProgress();
    auto *layout = edged(new QHBoxLayout(this), {kGrid, kHalfGrid, kGrid, 0}, kGrid);
    layout->addLayout(left);
    layout->addWidget(m_preview, 1);

    connect(&device, &Device::linkStateChanged, this, &RampForm::updateAll);
    connect(&device, &Device::armedStateChanged, this, &RampForm::updateAll);
    connect(&device, &Device::statusChanged, this, &RampForm::updateProgress);
    connect(&device, &Device::boundsChanged, this, [this] {
        for (RampLine *one : m_lines)
            one->updateLimits();
    });
    const auto anotherMotor = [this] {
        m_progress.clear();
        m_measured.clear();
        m_showRun = false;
        m_sent.reset();
        for (RampLine *one : m_lines)
            one->updateLimits();
        updateAll();
        Q_EMIT watchedRegistersChanged();
    };
    connect(&registers, &RegisterModel::catalogSet, this, anotherMotor);
    connect(&device, &Device::wishMade, this, &RampForm::wished);
    connect(&device, &Device::wishEnded, this, &RampForm::ended);
    connect(&device, &Device::stopAdvanced, this, [this](const drive::StopProgress &stop) {
        if (stop.word != drive::StopWord::Requested)
            return;
        RampLine *const looked = m_looked;
        for (RampLine *one : m_lines)
            one->reset();
        look(*looked);
    });
    anotherMotor();
}

QWidget *RampForm::makeLines()
{
    auto *box = new QWidget(this);
    constexpr int kNote = 78; // characters: what is understood of a ramp stays on one line
    box->setMinimumWidth(kNote * fontMetrics().averageCharWidth());
    auto *grid = bare(new QGridLayout(box), kGrid, kFineGrid);
    int row = 0;
    for (const RampKind kind :
        {RampKind::Speed, RampKind::Torque, RampKind::Current, RampKind::Position}) {
        auto *one = new RampLine(kind, m_device, m_registers, *grid, row, box);
        row += 2;
        for (NumberEdit *edit : {one->first(), one->second()})
            edit->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("-00000.000")));
        connect(one, &RampLine::wanted, this, [this, one] { send(*one); });
        connect(one, &RampLine::touched, this, [this, one] { look(*one); });
        connect(one, &RampLine::changed, this, [this, one] {
            m_showRun = false;
            look(*one);
        });
        m_lines.push_back(one);
    }
    grid->setColumnStretch(6, 1);
    m_looked = m_lines.front();
    return box;
}

QWidget *RampForm::makePresets()
{
    auto *box = new QWidget(this);
    m_preset = named(new QComboBox(box), "rampPreset", tr("Name of a ramp"));
    m_preset->setEditable(true);
    m_preset->setInsertPolicy(QComboBox::NoInsert);
    m_preset->setToolTip(tr("Choosing one fills the fields; it sends nothing. To keep the ramp "
                            "that you look at, type a name and save."));
    m_preset->lineEdit()->setMaxLength(int(kLongestPresetName));
    m_preset->lineEdit()->setPlaceholderText(tr("name"));
    new WheelGuard(m_preset);
    m_save = named(new QPushButton(tr("Save", "a ramp under a name"), box), "rampPresetSave");
    m_delete = named(new QPushButton(tr("Delete", "a named ramp"), box), "rampPresetDelete");
    auto *label = new QLabel(tr("&Named"), box);
    label->setBuddy(m_preset);
    auto *layout = edged(new QHBoxLayout(box), {0, kHalfGrid, 0, 0}, kGrid);
    layout->addWidget(label);
    layout->addWidget(m_preset, 1);
    layout->addWidget(m_save);
    layout->addWidget(m_delete);
    connect(m_preset, &QComboBox::activated, this, &RampForm::choosePreset);
    connect(m_preset, &QComboBox::editTextChanged, this, &RampForm::updateAll);
    connect(m_save, &QPushButton::clicked, this, &RampForm::savePreset);
    connect(m_delete, &QPushButton::clicked, this, &RampForm::deletePreset);
    return box;
}

QWidget *RampForm::makeProgress()
{
    auto *box = new QWidget(this);
    m_bar = named(new QProgressBar(box), "rampProgress", tr("Progress of the ramp"));
    m_bar->setRange(0, kBarSteps);
    m_bar->setTextVisible(false);
    m_bar->setMaximumHeight(10);
    m_text = wrappedLabel("rampProgressText", box);
    m_stop = named(new MotorButton(tr("Stop ramp"), box), "rampStop");
    auto *grid = bare(new QGridLayout(box));
    grid->setVerticalSpacing(kFineGrid);
    grid->addWidget(m_bar, 0, 0);
    grid->addWidget(m_text, 1, 0);
    grid->addWidget(m_stop, 0, 1, 2, 1);
    grid->setColumnStretch(0, 1);
    connect(m_stop, &QPushButton::clicked, this, &RampForm::stopRamp);
    return box;
}

void RampForm::focusFirst()
{
    NumberEdit *edit = m_looked->first();
    edit->setFocus(Qt::ShortcutFocusReason);
    edit->selectAll();
}

std::vector<catalog::RegisterId> RampForm::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    for (const char *name : {"SPEED_REF", "SPEED_MEAS", "I_Q_REF", "I_Q_MEAS", "I_D_REF",
             "CONTROL_MODE", "POSITION_CTRL_STATE"})
        if (const auto id = m_registers.idOf(name))
            ids.push_back(*id);
    if (const auto catalog = m_registers.catalog())
        for (const auto id : drive::shaftRegisters(*catalog, m_device.motor()))
            ids.push_back(id);
    return ids;
}

std::optional<double> RampForm::shown(const char *name) const
{
    const auto id = m_registers.idOf(name);
    return id ? m_registers.shownValue(*id) : std::nullopt;
}

void RampForm::send(RampLine &one)
{
    look(one);
    one.update();
    if (const auto content = one.content(); content && one.button()->isEnabled())
        m_motion.want(one.title(), *content);
}

void RampForm::stopRamp()
{
    if (motionAllowed(m_device, drive::Feature::SpeedRamp).yes)
        m_motion.want(
            tr("Stop ramp"), drive::Command{drive::MotorAction::StopRamp, m_device.motor()});
}

void RampForm::look(RampLine &one)
{
    m_showRun = m_showRun && m_looked == &one;
    m_looked = &one;
    updatePreview();
    updateAll();
}

/// Wherever a ramp to this motor comes from, its progress is shown.
void RampForm::wished(const drive::Wish &wish)
{
    const int motor = m_device.motor();
    const auto ofThis = [motor](const auto *what) { return what && what->motor == motor; };
    const auto *command = std::get_if<drive::Command>(&wish.what);
    const bool ramp = ofThis(std::get_if<drive::SpeedRamp>(&wish.what))
        || ofThis(std::get_if<drive::TorqueRamp>(&wish.what))
        || ofThis(std::get_if<drive::CurrentReference>(&wish.what))
        || ofThis(std::get_if<drive::PositionRamp>(&wish.what));
    if (ramp || (ofThis(command) && command->action == drive::MotorAction::StopRamp))
        m_sent = wish;
}

void RampForm::ended(const drive::Ended &ended)
{
    if (!m_sent || m_sent->id != ended.id)
        return;
    const drive::Wish wish = *std::exchange(m_sent, std::nullopt);
    if (ended.outcome != drive::Outcome::Ok)
        return; // the gate tells
    if (std::holds_alternative<drive::Command>(wish.what)) {
        m_progress.replaced();
        updateProgress();
        return;
    }
    double target = 0.0, step = 1.0;
    Milliseconds duration{};
    if (const auto *speed = std::get_if<drive::SpeedRamp>(&wish.what)) {
        m_running = RampKind::Speed;
        target = motor::quantisedSpeed_rpm(speed->rpm, speedStair_rpm(m_device));
        duration = speed->duration;
        step = m_device.limits(m_device.motor()).speedStepRpm;
    } else if (const auto *torque = std::get_if<drive::TorqueRamp>(&wish.what)) {
        m_running = RampKind::Torque;
        target = torque->amps;
        duration = torque->duration;
    } else if (const auto *current = std::get_if<drive::CurrentReference>(&wish.what)) {
        m_running = RampKind::Current;
        target = current->iqAmps;
    } else if (const auto *position = std::get_if<drive::PositionRamp>(&wish.what)) {
        m_running = RampKind::Position;
        target = position->radians * kDegreesPerRad;
        duration = position->duration;
    }
    if (m_running != RampKind::Speed)
        step = line(m_running).first()->step();
    m_measured.clear();
    m_showRun = true;
    m_progress.begin(target, duration, step, m_now, sight());
    drawRunning();
    updateProgress();
    updatePreview();
}

/// What the ramp that was sent should do.
void RampForm::drawRunning()
{
    m_runningPicture = plannedRamp(m_running, m_progress.from(), m_progress.target(),
        double(m_progress.duration().count()) / 1000.0, speedStair_rpm(m_device));
}

RampProgress::Sight RampForm::sight() const
{
    const bool speed = m_running == RampKind::Speed;
    if (m_running == RampKind::Position) { // the board tells no set-point, only that it has arrived
        const bool there = shown("POSITION_CTRL_STATE") == double(catalog::kPositionReachedNumber);
        return {m_device.status(m_device.motor()).state, m_device.answering(),
            there ? std::optional(m_progress.target()) : std::nullopt,
            ShaftMove::degreesNow(m_device, m_registers)};
    }
    return {m_device.status(m_device.motor()).state, m_device.answering(),
        shown(speed ? "SPEED_REF" : "I_Q_REF"), shown(speed ? "SPEED_MEAS" : "I_Q_MEAS")};
}

void RampForm::refresh(Milliseconds now)
{
    m_now = now;
    updateProgress();
    updatePreview();
    updateAll();
}

void RampForm::updateProgress()
{
    const RampProgress::Sight seen = sight();
    const auto before = m_progress.phase();
    m_progress.update(m_now, seen);
    if (before == RampProgress::Phase::Waiting && m_progress.phase() != before)
        drawRunning(); // it begins where the start-up ended
    const bool goes = m_progress.phase() == RampProgress::Phase::Ramping
        || m_progress.phase() == RampProgress::Phase::Following
        || (before != m_progress.phase() && m_progress.phase() == RampProgress::Phase::Arrived);
    if (goes && seen.measured && m_measured.size() < kMostMeasured) {
        const double at = double(m_progress.elapsed().count()) / 1000.0;
        if (m_measured.empty() || at > m_measured.back().seconds)
            m_measured.push_back({at, *seen.measured});
    }
    m_bar->setValue(static_cast<int>(std::lround(m_progress.fraction() * kBarSteps)));
    m_text->setText(progressText());
}

QString RampForm::valueText(double value) const
{
    return m_running == RampKind::Speed
        ? numberText(value, 0) + QChar(0x202f) + tr("rpm")
        : numberText(value, decimalsFor(line(m_running).first()->step())) + QChar(0x202f)
            + (m_running == RampKind::Position ? QStringLiteral("\u00b0") : QStringLiteral("A"));
}

QString RampForm::progressText() const
{
    using Phase = RampProgress::Phase;
    const QString target = valueText(m_progress.target());
    const auto measured = sight().measured;
    const QString now = measured ? valueText(*measured) : QStringLiteral("\u2013");
    switch (m_progress.phase()) {
    case Phase::None:
        return tr("No ramp was sent yet.");
    case Phase::Waiting:
        return tr("To %1: taken over; it goes when the motor runs.").arg(target);
    case Phase::Ramping: {
        const double left = double((m_progress.duration() - m_progress.elapsed()).count()) / 1000.0;
        return tr("To %1: %2 % of the time, %3 s left; measured %4.", "target, number, number")
            .arg(target, QString::number(std::lround(m_progress.fraction() * 100.0)),
                numberText(std::max(0.0, left), 1), now);
    }
    case Phase::Following:
        return tr("The set-point is at %1; measured %2.").arg(target, now);
    case Phase::Arrived:
        return tr("Arrived at %1 after %2 s.")
            .arg(target, numberText(double(m_progress.elapsed().count()) / 1000.0, 1));
    case Phase::Replaced:
        return tr("The ramp to %1 was ended on its way; measured %2.").arg(target, now);
    case Phase::MotorStopped:
        return tr("The motor runs no more; the ramp to %1 has ended.").arg(target);
    case Phase::LinkLost:
        break;
    }
    return tr("The link was lost on the way to %1; what became of it is not known.").arg(target);
}

/// While a ramp runs it is shown; else the one that is typed.
void RampForm::updatePreview()
{
    if (m_progress.running()) {
        m_preview->showPlan(m_runningPicture);
        m_preview->showMeasured(m_measured,
            m_progress.phase() == RampProgress::Phase::Waiting
                ? -1.0
                : double(m_progress.elapsed().count()) / 1000.0);
        return;
    }
    m_preview->showPlan(m_showRun ? m_runningPicture : m_looked->picture());
    m_preview->showMeasured(m_showRun ? m_measured : std::vector<RampPicture::Point>(), -1.0);
}

void RampForm::updateAll()
{
    for (RampLine *one : m_lines)
        one->update();
    const MotionAllowed can = motionAllowed(m_device, drive::Feature::SpeedRamp);
    applyAllowed(m_stop, can, tr("Ends a ramp where it is; the motor goes on turning."));
    const QString name = m_preset->currentText().trimmed();
    const bool known = presetOf(name) != m_presets.end();
    const bool room = known || m_presets.size() < kMostRampPresets;
    m_save->setEnabled(!name.isEmpty() && room && m_looked->content());
    m_save->setToolTip(m_save->isEnabled()
            ? tr("Keeps this under the name: %1").arg(m_looked->title())
            : tr("Type a name first, and values that can be sent."));
    m_delete->setEnabled(known);
    m_delete->setToolTip(known ? tr("Forgets the ramp of this name.") : tr("Choose one first."));
}

void RampForm::setPresets(const QList<RampPreset> &presets)
{
    m_presets = presets;
    fillPresets({});
}

void RampForm::fillPresets(const QString &current)
{
    const QSignalBlocker quiet(m_preset);
    m_preset->clear();
    for (const RampPreset &preset : m_presets)
        m_preset->addItem(deviceText(preset.name), preset.name);
    m_preset->setCurrentIndex(m_preset->findData(current));
    m_preset->setEditText(current);
    updateAll();
}

QList<RampPreset>::iterator RampForm::presetOf(const QString &name)
{
    return std::find_if(m_presets.begin(), m_presets.end(),
        [&name](const RampPreset &preset) { return preset.name == name; });
}

void RampForm::savePreset()
{
    const QString name = m_preset->currentText().trimmed();
    if (name.isEmpty() || !m_looked->content())
        return;
    const RampPreset preset = m_looked->preset(name);
    if (const auto at = presetOf(name); at != m_presets.end())
        *at = preset;
    else if (m_presets.size() < kMostRampPresets)
        m_presets.append(preset);
    fillPresets(name);
}

void RampForm::deletePreset()
{
    const QString name = m_preset->currentText().trimmed();
    m_presets.removeIf([&name](const RampPreset &preset) { return preset.name == name; });
    fillPresets({});
}

void RampForm::choosePreset(int index)
{
    const auto at = presetOf(m_preset->itemData(index).toString());
    if (at == m_presets.end())
        return;
    RampLine &one = line(at->kind);
    one.accept(*at);
    look(one);
}

} // namespace widgets

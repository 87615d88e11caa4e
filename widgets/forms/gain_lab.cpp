#include "widgets/forms/gain_lab.h"

#include "widgets/base/device_text.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/base/wheel_guard.h"
#include "widgets/forms/gain_forecast.h"
#include "widgets/forms/gain_label.h"
#include "widgets/forms/gain_motor.h"
#include "widgets/forms/gain_texts.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace widgets {
namespace {

using motor::GainId;
using motor::GainPlan;

constexpr int kSliderSteps = 1000;
constexpr double kLeastBandwidth = 50.0, kMostBandwidth = 20000.0; ///< of the slider
constexpr double kLeastDamping = 1.5, kMostDamping = 8.0;
constexpr double kFirstBandwidth = 1500.0, kFirstDamping = 4.0;

double bandwidthAt(int position, double most)
{
    const double exact =
        kLeastBandwidth * std::pow(most / kLeastBandwidth, double(position) / kSliderSteps);
    // Two digits and a half.
    const double digit = std::pow(10.0, std::floor(std::log10(exact)) - 1.0);
    return std::round(exact / (digit / 2.0)) * (digit / 2.0);
}

int positionOf(double value, double least, double most)
{
    const double share = std::log(value / least) / std::log(most / least);
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kSliderSteps));
}

QSlider *makeSlider(const char *name, const QString &label, QWidget *parent)
{
    auto *slider = named(new QSlider(Qt::Horizontal, parent), name, label);
    slider->setRange(0, kSliderSteps);
    slider->setSingleStep(kSliderSteps / 200);
    slider->setPageStep(kSliderSteps / 20);
    new WheelGuard(slider);
    return slider;
}

QString divisorOf(GainId id) { return QLatin1String(gainRegister(id)) + QStringLiteral("_DIV"); }

} // namespace

GainLab::GainLab(RegisterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_motor(new GainMotor(this))
    , m_forecast(new GainForecast(this))
{
    setObjectName(QStringLiteral("gainLab"));
    auto *grid = edged(new QGridLayout(this), {kHalfGrid, kHalfGrid, kHalfGrid, 0});
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(kHalfGrid);
    grid->addWidget(m_motor, 0, 0);
    grid->addWidget(makeWishes(), 0, 1);
    grid->addWidget(m_forecast, 0, 2);
    grid->addWidget(makeEnd(), 1, 0, 1, 3);
    grid->setColumnStretch(1, 2);
    grid->setColumnStretch(2, 3);
    grid->setRowStretch(0, 1);
    connectWishes();
    setTabOrder(m_table, m_fromBoard);
    setTabOrder(m_fromBoard, m_preview);
    fillBandwidth(kFirstBandwidth, nullptr);
    fillDamping(kFirstDamping, nullptr);
    recompute();
}

QWidget *GainLab::makeWishes()
{
    auto *wishes = new QWidget(this);
    auto *grid = bare(new QGridLayout(wishes), kHalfGrid, kFineGrid);
    const QString bandwidth = tr("Current bandwidth"), damping = tr("Speed damping");
    auto *label = new QLabel(bandwidth, this);
    m_bandwidthSlider = makeSlider("labBandwidthSlider", bandwidth, this);
    const int digit = fontMetrics().horizontalAdvance(QLatin1Char('0'));
    const auto field = [&](const char *name, const QString &text, const QString &unit, double least,
                           double greatest) {
        auto *made = new NumberEdit(name, text, unit, least, greatest, this);
        made->setFixedWidth(digit * 8);
        return made;
    };
    m_bandwidth =
        field("labBandwidth", bandwidth, QStringLiteral("rad/s"), 0.1, kMostBandwidth * 100.0);
    m_hertz = field("labBandwidthHz", bandwidth, QStringLiteral("Hz"), 0.01, kMostBandwidth * 20.0);
    m_bandwidth->setToolTip(tr("As ST's rule counts it; the loop at the motor is 15 % faster."));
    m_hertz->setToolTip(m_bandwidth->toolTip());
    label->setBuddy(m_bandwidth);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_bandwidthSlider, 0, 1);
    grid->addWidget(m_bandwidth, 0, 2);
    grid->addWidget(new QLabel(m_bandwidth->unit(), this), 0, 3);
    grid->addWidget(m_hertz, 0, 4);
    grid->addWidget(new QLabel(m_hertz->unit(), this), 0, 5);
    m_speed = named(new QCheckBox(damping, this), "labSpeed");
    m_speed->setChecked(true);
    m_speed->setToolTip(tr("Also plan the speed loop. Damping 2 is quick and rings, 4 is calm."));
    m_dampingSlider = makeSlider("labDampingSlider", damping, this);
    m_damping = field("labDamping", damping, {}, 1.05, 20.0);
    grid->addWidget(m_speed, 1, 0);
    grid->addWidget(m_dampingSlider, 1, 1);
    grid->addWidget(m_damping, 1, 2);
    auto *delayLabel = new QLabel(tr("Delay"), this);
    m_delay = field("labDelay", tr("Delay of the measured speed"), QStringLiteral("ms"), 0, 1000);
    m_delay->setToolTip(tr("How late the measured speed is: half the length of its average. The "
                           "board does not say it; this is what ST's generator takes for its "
                           "sensor."));
    delayLabel->setBuddy(m_delay);
    grid->addWidget(delayLabel, 1, 3);
    grid->addWidget(m_delay, 1, 4);
    grid->addWidget(new QLabel(m_delay->unit(), this), 1, 5);

    m_table = new GainPlanTable(this);
    grid->addWidget(m_table, 2, 0, 1, 6);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(2, 1);
    return wishes;
}

QWidget *GainLab::makeEnd()
{
    auto *end = new QWidget(this);
    auto *grid = bare(new QGridLayout(end));
    m_findings = new GainLabel("labFindings", this);
    m_told = new GainLabel("labTold", this);
    grid->addWidget(m_findings, 0, 0);
    m_buttons = new QWidget(this);
    m_fromBoard = named(new QPushButton(tr("From the &board"), m_buttons), "labFromBoard");
    m_fromBoard->setToolTip(tr("Forgets what was typed here and what was measured, and takes the "
                               "board's numbers again."));
    m_preview = named(new QPushButton(tr("&Preview"), m_buttons), "labPreview");
    auto *buttons = bare(new QHBoxLayout(m_buttons));
    buttons->addWidget(m_fromBoard);
    buttons->addWidget(m_preview);
    grid->addWidget(m_told, 0, 1);
    grid->setColumnStretch(0, 3);
    grid->setColumnStretch(1, 2);
    connect(m_fromBoard, &QPushButton::clicked, this, &GainLab::forgetTyped);
    connect(m_preview, &QPushButton::clicked, this, &GainLab::previewWished);
    return end;
}

void GainLab::connectWishes()
{
    connect(m_motor, &GainMotor::inertiaTyped, this, &GainLab::inertiaTyped);
    connect(m_motor, &GainMotor::edited, this, [this] {
        m_told->say({});
        recompute();
    });
    connect(m_bandwidth, &NumberEdit::valueEdited, this, [this] {
        if (const auto value = m_bandwidth->value())
            fillBandwidth(*value, m_bandwidth);
        wished();
    });
    connect(m_hertz, &NumberEdit::valueEdited, this, [this] {
        const auto value = m_hertz->value();
        if (value)
            fillBandwidth(*value * 2.0 * std::numbers::pi, m_hertz);
        else
            m_bandwidth->setValue(std::nullopt);
        wished();
    });
    connect(m_damping, &NumberEdit::valueEdited, this, [this] {
        if (const auto value = m_damping->value())
            fillDamping(*value, m_damping);
        wished();
    });
    connect(m_bandwidthSlider, &QSlider::valueChanged, this, [this](int position) {
        fillBandwidth(bandwidthAt(position, sliderEnd()), m_bandwidthSlider);
        wished();
    });
    connect(m_dampingSlider, &QSlider::valueChanged, this, [this](int position) {
        const double exact =
            kLeastDamping * std::pow(kMostDamping / kLeastDamping, double(position) / kSliderSteps);
        fillDamping(std::round(exact * 100.0) / 100.0, m_dampingSlider);
        wished();
    });
    connect(m_delay, &NumberEdit::valueEdited, this, [this] {
        m_delayTyped = true;
        wished();
    });
    connect(m_speed, &QCheckBox::toggled, this, [this](bool on) {
        m_dampingSlider->setEnabled(on);
        m_damping->setEnabled(on);
        m_delay->setEnabled(on);
        wished();
    });
}

/// What the slider goes up to: what the control rate allows, if that is known.
double GainLab::sliderEnd() const
{
    const double period_s = m_motor->facts().controlPeriod_s;
    return period_s > 0.0
        ? std::max(2.0 * kLeastBandwidth, motor::bandwidthLimit_radps(1.0 / period_s))
        : kMostBandwidth;
}

void GainLab::fillBandwidth(double radps, const QWidget *except)
{
    if (except != m_bandwidth)
        m_bandwidth->setValue(radps);
    if (except != m_hertz)
        m_hertz->setValue(radps / (2.0 * std::numbers::pi));
    const QSignalBlocker quiet(m_bandwidthSlider);
    if (except != m_bandwidthSlider && radps > 0.0)
        m_bandwidthSlider->setValue(positionOf(radps, kLeastBandwidth, sliderEnd()));
    m_bandwidthSlider->setAccessibleDescription(
        significantText(radps) + QLatin1Char(' ') + m_bandwidth->unit());
}

void GainLab::fillDamping(double damping, const QWidget *except)
{
    if (except != m_damping)
        m_damping->setValue(damping);
    const QSignalBlocker quiet(m_dampingSlider);
    if (except != m_dampingSlider)
        m_dampingSlider->setValue(positionOf(damping, kLeastDamping, kMostDamping));
    m_dampingSlider->setAccessibleDescription(significantText(damping));
}

void GainLab::fillDelay()
{
    const double delay_s = m_motor->facts().speedDelay_s;
    m_delay->setValue(delay_s > 0.0 ? std::optional(delay_s * kMilli) : std::nullopt);
}

motor::GainPlant GainLab::plant() const
{
    motor::GainPlant plant = m_motor->plant();
    plant.speedDelay_s = m_delay->value().value_or(0.0) / kMilli;
    return plant;
}

void GainLab::wished()
{
    m_wished = true;
    m_told->say({});
    recompute();
}

void GainLab::setFacts(const drive::MotorFacts &facts, std::optional<double> rememberedInertia_kgm2)
{
    m_motor->setFacts(facts, rememberedInertia_kgm2);
    if (!m_delayTyped)
        fillDelay();
    if (const auto bandwidth = m_bandwidth->value())
        fillBandwidth(*bandwidth, m_bandwidth); // the slider may end elsewhere now
    useBoardsBandwidth();
    recompute();
}

void GainLab::setMeasured(const MeasuredMotor &measured)
{
    m_motor->setMeasured(measured);
    useBoardsBandwidth();
    recompute();
}

void GainLab::forgetTyped()
{
    m_motor->forgetTyped();
    m_wished = m_delayTyped = false;
    fillDelay();
    m_told->say({});
    useBoardsBandwidth();
    recompute();
}

void GainLab::refreshPresent()
{
    motor::PerGain<HeldGain> held;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const auto id = static_cast<GainId>(i);
        held[i].numerator = knownWhole(m_model, gainRegister(id));
        if (const auto exponent = knownWhole(m_model, divisorOf(id).toStdString());
            exponent && *exponent >= 0 && *exponent <= motor::kMaxExponent)
            held[i].exponent = static_cast<int>(*exponent);
    }
    if (held == m_held)
        return;
    m_held = held;
    useBoardsBandwidth();
    recompute();
}

/// Until another one is asked for, it is the bandwidth that the board has.
void GainLab::useBoardsBandwidth()
{
    const motor::GainPlant board = plant();
    const double kp = m_held[motor::indexOf(GainId::TorqueKp)].value();
    if (m_wished || !(kp > 0.0) || !(board.torque().inductance_h > 0.0)
        || !(board.stage.ruleOhms() > 0.0))
        return;
    const double now = motor::ruleBandwidth_radps(kp, board.torque(), board.stage);
    const double digit = std::pow(10.0, std::floor(std::log10(now)) - 2.0);
    fillBandwidth(std::round(now / digit) * digit, nullptr);
}

std::vector<catalog::RegisterId> GainLab::registers() const
{
    std::vector<catalog::RegisterId> ids;
    for (std::size_t i = 0; i < motor::kGainIds; ++i) {
        const auto gain = static_cast<GainId>(i);
        for (const QString &name : {QString(QLatin1String(gainRegister(gain))), divisorOf(gain)})
            if (const auto id = m_model.idOf(name.toStdString()); id && m_model.pollable(*id))
                ids.push_back(*id);
    }
    return ids;
}

void GainLab::focusFirst() { m_bandwidth->setFocus(Qt::ShortcutFocusReason); }

void GainLab::tell(const QString &sentence) { m_told->say(sentence); }

QString GainLab::obstacle() const
{
    if (!m_model.catalog())
        return tr("Connect a board: the gains are for its registers.");
    if (gainsInUnits(m_model))
        return tr(
            "This drive's gains are numbers in units, and its current loop is not the one whose "
            "rule is used here: set them among the regulators.");
    for (const motor::PlannedGain &gain : m_plan.gains)
        for (const QString &name :
            {QString(QLatin1String(gainRegister(gain.id))), divisorOf(gain.id)})
            if (const auto id = m_model.idOf(name.toStdString());
                !id || !m_model.editable(*id, RegisterModel::RawColumn))
                return tr("This board's firmware does not let %1 be written.").arg(name);
    for (const NumberEdit *field : {m_bandwidth, m_hertz})
        if (!field->value())
            return tr("Type a bandwidth.");
    if (m_speed->isChecked() && !m_delay->problem().isEmpty())
        return tr("%1: %2", "field, what is wrong with it")
            .arg(m_delay->accessibleName(), m_delay->problem());
    if (m_speed->isChecked() && !m_damping->value())
        return tr("Type a damping from 1.05 to 20, or leave the speed loop out.");
    if (const QString problem = m_motor->problem(); !problem.isEmpty())
        return problem;
    for (const motor::GainFinding &finding : m_plan.findings)
        if (motor::blocks(finding.warning))
            return gainFindingText(finding);
    return {};
}

void GainLab::recompute()
{
    const double bandwidth = m_hertz->value() && m_bandwidth->value() ? *m_bandwidth->value() : 0.0;
    const double damping = m_speed->isChecked() ? m_damping->value().value_or(0.0) : 0.0;
    motor::PerGain<std::optional<int>> divisors;
    for (std::size_t i = 0; i < divisors.size(); ++i)
        divisors[i] = m_held[i].exponent;
    const std::vector<motor::PlannedGain> before = std::move(m_plan.gains);
    m_plan =
        bandwidth > 0.0 ? motor::planGains(plant(), {bandwidth, damping}, divisors) : GainPlan();
    m_table->showPlan(m_plan, m_held);
    m_forecast->showPlan(m_plan, bandwidth, plant(), m_held);
    showFindings();
    const QString why = obstacle();
    m_preview->setEnabled(why.isEmpty());
    m_preview->setToolTip(why.isEmpty()
            ? tr("Makes edits of the new numbers, numerator and divisor together. Nothing is "
                 "written before Apply.")
            : plainToolTip(why));
    const bool same = std::equal(before.begin(), before.end(), m_plan.gains.begin(),
        m_plan.gains.end(), [](const motor::PlannedGain &a, const motor::PlannedGain &b) {
            return a.id == b.id && a.quantised.gain == b.quantised.gain;
        });
    if (!same)
        Q_EMIT planChanged();
}

void GainLab::showFindings()
{
    QStringList lines;
    for (const motor::GainFinding &finding : m_plan.findings)
        lines.append(
            (motor::blocks(finding.warning) ? QStringLiteral("\u26a0 ") : QStringLiteral("\u2022 "))
            + gainFindingText(finding));
    if (lines.isEmpty() && m_plan.gains.empty())
        lines.append(QStringLiteral("\u26a0 ") + obstacle());
    if (const QString measured = m_motor->measuredText(); !measured.isEmpty())
        lines.append(QStringLiteral("\u2022 ") + measured);
    m_findings->setFont(m_plan.blocked() ? inBold(font()) : font());
    m_findings->say(lines.join(QLatin1Char('\n')));
}

} // namespace widgets

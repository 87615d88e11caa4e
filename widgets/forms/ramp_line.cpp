#include "widgets/forms/ramp_line.h"

#include "drive/set_point_check.h"
#include "motor/ramp.h"
#include "widgets/base/device_text.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/control/command_box.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/setpoints/shaft_move.h"
#include "widgets/registers/model.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <cmath>

namespace widgets {
namespace {

constexpr double kFallbackAmps = 1000.0; // the board's own limit is enforced below, with the reason
constexpr double kFirstMs = 500.0, kNotchMs = 100.0;

QString rpmUnit() { return RampLine::tr("rpm"); }

/// What an ampere field resolves: a hundredth of the limit or better, a power of ten, and never finer than the board.
double ampStep(double limit, double digit)
{
    const double exponent = std::floor(std::log10(std::max(limit, 1e-3) / 100.0));
    return std::pow(10.0, std::max(exponent, std::ceil(std::log10(std::max(digit, 1e-6)))));
}

QString signedRate(double rate, const QString &unit)
{
    return std::isfinite(rate)
        ? plainNumberText(rate, 4) + QChar(0x202f) + RampLine::tr("%1/s", "unit").arg(unit)
        : RampLine::tr("immediately");
}

} // namespace

/// What a drive tells that has no steps is what people ask for.
double speedStair_rpm(const Device &device)
{
    const double step = device.limits(device.motor()).speedStepRpm;
    return step > drive::MotorLimits().speedStepRpm ? step : 0.0;
}

RampLine::RampLine(RampKind kind, const Device &device, const RegisterModel &registers,
    QGridLayout &grid, int row, QWidget *parent)
    : QObject(parent)
    , m_kind(kind)
    , m_device(device)
    , m_registers(registers)
    , m_first(new NumberEdit(parent))
    , m_second(new NumberEdit(parent))
    , m_note(new QLabel(parent))
    , m_send(new MotorButton(tr("Send", "a ramp to the board"), parent))
{
    const bool current = kind == RampKind::Current;
    const char *const names[] = {"rampSpeed", "rampTorque", "rampCurrent", "rampPosition"};
    const QString name = QLatin1String(names[static_cast<std::size_t>(kind)]);
    const QString labels[] = {
        tr("S&peed"), tr("&Iq (torque)"), tr("I&q immediately"), tr("Shaft (&x)")};
    const QString label = labels[static_cast<std::size_t>(kind)];
    const QString units[] = {
        rpmUnit(), QStringLiteral("A"), QStringLiteral("A"), QStringLiteral("\u00b0")};
    m_first->setObjectName(name);
    m_second->setObjectName(name + (current ? QStringLiteral("Id") : QStringLiteral("Time")));
    m_send->setObjectName(name + QStringLiteral("Send"));
    m_note->setObjectName(name + QStringLiteral("Note"));
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    const QString spoken[] = {tr("Speed to go to, in rpm"), tr("Torque current Iq to go to, in A"),
        tr("Current reference Iq, in A"), tr("Angle of the shaft to go to, in degrees")};
    m_first->setAccessibleName(spoken[static_cast<std::size_t>(kind)]);
    m_second->setAccessibleName(
        current ? tr("Current reference Id, in A") : tr("Duration of the ramp in ms"));
    m_send->setAccessibleName(tr("Send: %1", "kind of ramp").arg(title()));
    if (!current) {
        m_second->setRange(
            0.0, static_cast<double>(drive::kLongestRamp.count()), 1.0, QStringLiteral("ms"));
        m_second->setNotch(kNotchMs);
        m_second->setValue(kFirstMs);
    }

    auto *firstLabel = new QLabel(label, parent);
    firstLabel->setBuddy(m_first);
    auto *between = new QLabel(current ? tr("Id") : tr("in", "a time"), parent);
    between->setBuddy(m_second);
    auto *unit = new QLabel(units[static_cast<std::size_t>(kind)], parent);
    auto *secondUnit = new QLabel(current ? QStringLiteral("A") : QStringLiteral("ms"), parent);
    m_widgets = {firstLabel, m_first, unit, between, m_second, secondUnit, m_send};
    for (std::size_t column = 0; column < m_widgets.size(); ++column)
        grid.addWidget(m_widgets[column], row, static_cast<int>(column));
    grid.addWidget(m_note, row + 1, 1, 1, 6);
    m_widgets.push_back(m_note);
    if (kind == RampKind::Position)
        makeAngleField(*m_first);

    for (NumberEdit *edit : {m_first, m_second}) {
        edit->installEventFilter(this);
        connect(edit, &QLineEdit::textChanged, this, &RampLine::changed);
        connect(edit, &NumberEdit::committed, this, &RampLine::wanted);
    }
    connect(m_send, &QPushButton::clicked, this, &RampLine::wanted);
    updateLimits();
}

QString RampLine::title() const
{
    switch (m_kind) {
    case RampKind::Speed:
        return tr("Speed ramp");
    case RampKind::Torque:
        return tr("Torque ramp");
    case RampKind::Position:
        return tr("Position ramp");
    case RampKind::Current:
        break;
    }
    return tr("Current reference");
}

drive::Feature RampLine::feature() const
{
    return m_kind == RampKind::Speed   ? drive::Feature::SpeedRamp
        : m_kind == RampKind::Torque   ? drive::Feature::TorqueRamp
        : m_kind == RampKind::Position ? drive::Feature::PositionRamp
                                       : drive::Feature::CurrentReference;
}

bool RampLine::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusIn)
        Q_EMIT touched();
    return QObject::eventFilter(watched, event);
}

std::optional<drive::WishContent> RampLine::content() const
{
    const auto first = m_first->sentValue(), second = m_second->sentValue();
    if (!first || !second)
        return std::nullopt;
    const int motor = m_device.motor();
    const std::chrono::milliseconds time(std::llround(*second));
    switch (m_kind) {
    case RampKind::Speed:
        return drive::SpeedRamp{motor, static_cast<std::int32_t>(std::lround(*first)), time};
    case RampKind::Torque:
        return drive::TorqueRamp{motor, *first, time};
    case RampKind::Position: {
        const ShaftMove move(m_device, m_registers, *first, *second);
        return move.refusal().isEmpty() ? std::optional<drive::WishContent>(move.wish())
                                        : std::nullopt;
    }
    case RampKind::Current:
        break;
    }
    const double bound = m_device.bounds(motor).amps;
    if (bound > 0.0 && std::hypot(*first, *second) > bound)
        return std::nullopt;
    return drive::CurrentReference{motor, *first, *second};
}

std::optional<double> RampLine::reference() const
{
    if (m_kind == RampKind::Position)
        return ShaftMove::degreesNow(m_device, m_registers);
    // The set-point of a motor that rests is a left-over, of an experiment for one: nothing follows it.
    if (const int motor = m_device.motor(); m_device.statusIsNow(motor)) {
        const drive::MotorStatus status = m_device.status(motor);
        if (drive::rests(status.state))
            return m_kind == RampKind::Speed && status.speedMeasured.value_or(false)
                ? status.speedRpm.value_or(0.0)
                : 0.0;
    }
    const auto id = m_registers.idOf(m_kind == RampKind::Speed ? "SPEED_REF" : "I_Q_REF");
    return id ? m_registers.shownValue(*id) : std::nullopt;
}

RampPicture RampLine::picture() const
{
    if (!content())
        return {};
    const double seconds = m_kind == RampKind::Current ? 0.0 : *m_second->sentValue() / 1000.0;
    return plannedRamp(m_kind, reference().value_or(0.0), *m_first->sentValue(), seconds,
        speedStair_rpm(m_device));
}

RampPreset RampLine::preset(const QString &name) const
{
    return {name, m_kind, m_first->sentValue().value_or(0.0), m_second->sentValue().value_or(0.0)};
}

void RampLine::accept(const RampPreset &preset)
{
    m_first->setValue(preset.target);
    m_second->setValue(preset.second);
}

void RampLine::reset()
{
    if (m_kind == RampKind::Position)
        return m_first->setText({});
    m_first->beginAnew();
    if (m_kind == RampKind::Current)
        m_second->beginAnew();
}

double RampLine::ampsPerDigit() const
{
    const auto id = m_registers.idOf("I_Q_REF");
    const auto scale = id ? m_registers.catalog()->readScale(*id) : catalog::Scale();
    return scale.unit == "A" ? scale.factor : 0.0;
}

void RampLine::updateLimits()
{
    const drive::MotionBounds bounds = m_device.bounds(m_device.motor());
    if (m_kind == RampKind::Position) {
        const bool there =
            m_device.capability(drive::Feature::PositionRamp).available && m_device.identified();
        for (QWidget *widget : m_widgets)
            widget->setVisible(there);
    } else if (m_kind == RampKind::Speed) {
        const drive::MotorLimits told = m_device.limits(m_device.motor());
        m_first->setLimits(
            std::min(bounds.rpm > 0.0 ? bounds.rpm : drive::kHighestRpm, told.wireRpm),
            told.speedStepRpm, rpmUnit());
    } else {
        const double limit = bounds.amps > 0.0 ? bounds.amps : kFallbackAmps;
        const double step = ampStep(limit, ampsPerDigit());
        m_first->setLimits(limit, step, QStringLiteral("A"));
        if (m_kind == RampKind::Current)
            m_second->setLimits(limit, step, QStringLiteral("A"));
    }
    update();
}

QString RampLine::speedNote() const
{
    const double seconds = *m_second->sentValue() / 1000.0, to = *m_first->sentValue();
    const auto from = reference();
    QStringList parts{m_first->echo()};
    if (from) {
        const double step = speedStair_rpm(m_device);
        const double stairs =
            step > 0.0 ? std::abs(to - motor::quantisedSpeed_rpm(*from, step)) / step : 0.0;
        parts.append(
            signedRate(motor::rampAcceleration_rpmps(*from, to, seconds, step), rpmUnit()));
        if (seconds > 0.0 && stairs >= 1.0)
            parts.append(tr("%n step(s) of %1 rpm", nullptr, static_cast<int>(stairs))
                             .arg(plainNumberText(step, 4)));
    }
    return parts.join(QStringLiteral("; "));
}

QString RampLine::torqueNote() const
{
    const double seconds = *m_second->sentValue() / 1000.0, to = *m_first->sentValue();
    const auto from = reference();
    QStringList parts{m_first->echo()};
    if (from && to != *from)
        parts.append(signedRate((to - *from) / seconds, QStringLiteral("A")));
    const double perAmp = m_device.limits(m_device.motor()).torquePerAmp;
    if (perAmp > 0.0)
        parts.append(siText(to * perAmp, QStringLiteral("N m")));
    return parts.join(QStringLiteral("; "));
}

QString RampLine::currentNote() const
{
    const double iq = *m_first->sentValue(), id = *m_second->sentValue();
    const double bound = m_device.bounds(m_device.motor()).amps;
    const int decimals = decimalsFor(m_first->step());
    const QString amps = numberText(std::hypot(iq, id), decimals);
    if (bound > 0.0 && std::hypot(iq, id) > bound)
        return tr("Together %1 A: the limit is %2 A.").arg(amps, numberText(bound, decimals));
    return tr("Iq = %1 A, Id = %2 A, together %3 A, immediately")
        .arg(numberText(iq, decimals), numberText(id, decimals), amps);
}

QString RampLine::positionNote() const
{
    const ShaftMove move(m_device, m_registers, *m_first->sentValue(), *m_second->sentValue());
    if (const QString why = move.refusal(); !why.isEmpty())
        return why;
    QStringList parts{m_first->echo(), siText(move.wish().radians, QStringLiteral("rad"))};
    if (const QString outlook = move.outlook(); !outlook.isEmpty())
        parts.append(outlook);
    return parts.join(QStringLiteral("; "));
}

QString RampLine::note() const
{
    for (const NumberEdit *edit : {m_first, m_second})
        if (!edit->sentValue())
            return edit->echo();
    return m_kind == RampKind::Speed   ? speedNote()
        : m_kind == RampKind::Torque   ? torqueNote()
        : m_kind == RampKind::Position ? positionNote()
                                       : currentNote();
}

void RampLine::update()
{
    MotionAllowed can = motionAllowed(m_device, feature());
    m_first->setWheelAllowed(can.yes);
    m_second->setWheelAllowed(true);
    const QString text = note();
    m_note->setText(text);
    if (can.yes && !content())
        can = {false, text};
    applyAllowed(m_send, can, tr("Sends it (Enter in a field does the same)."));
}

} // namespace widgets

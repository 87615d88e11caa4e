#include "widgets/forms/gain_table.h"

#include "catalog/gain_rows.h"
#include "drive/board_facts.h"
#include "drive/motor_view.h"
#include "motor/smaller_loops.h"
#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/forms/gain_texts.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>

#include <array>
#include <cmath>

namespace widgets {
namespace {

using catalog::GainKind;
using enum catalog::GainKind;

constexpr int kPlaces = catalog::kGainPlaces;

/// By GainLoop.
constexpr std::array kTitles{
    QT_TRANSLATE_NOOP("widgets::GainTable", "Torque (Iq)"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Flux (Id)"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Speed"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Flux weakening"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Position"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Observer's PLL"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Observer (C1, C2)"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "CORDIC observer (C1, C2)"),
    QT_TRANSLATE_NOOP("widgets::GainTable", "Currents"),
};

constexpr int kColumnsAGain = 4; ///< numerator, slash, divisor, physical
constexpr double kPllShare = 0.5; ///< of the highest speed, where a PLL is told
constexpr int kNumeratorDigits = 6, kDivisorDigits = 2, kRealDigits = 10;

struct GainTexts {
    Q_DECLARE_TR_FUNCTIONS(GainTexts)
};

/// What stands beside a gain, and what its tool tip says.
struct Physical {
    QString text, hint;
    bool equals = false; ///< it is the gain, not a word about it
};

Physical unknown(const QString &why) { return {GainTexts::tr("unit not known"), why}; }
Physical unknown(motor::GainWarning why) { return unknown(gainFindingText({why, std::nullopt})); }

Physical loopGain(GainKind kind, double digits, const motor::GainPlant &plant)
{
    const auto id = static_cast<motor::GainId>(kind);
    const auto physical = motor::physicalGain(id, digits, plant);
    if (!physical)
        return unknown(motor::GainWarning::ScaleMissing);
    return {gainWithUnit(*physical, gainUnit(id)),
        kind == SpeedKp || kind == SpeedKi ? GainTexts::tr("Amperes of Iq for radians per second.")
                                           : GainTexts::tr("What it makes at the motor."),
        true};
}

Physical weakeningGain(GainKind kind, double digits, const motor::GainPlant &plant)
{
    if (!(plant.stage.realOhms() > 0.0) || !(plant.speedPeriod_s > 0.0))
        return unknown(motor::GainWarning::ScaleMissing);
    const auto gains =
        motor::fluxWeakeningGains({digits, digits}, plant.stage, plant.speedPeriod_s);
    const QString hint = GainTexts::tr("Amperes of Id for volts that are missing.");
    return kind == WeakeningKp
        ? Physical{gainWithUnit(gains.kp, QStringLiteral("A/V")), hint, true}
        : Physical{gainWithUnit(gains.ki, QStringLiteral("A/(V\u00b7s)")), hint, true};
}

Physical positionGain(GainKind kind, double digits, const motor::GainPlant &plant)
{
    if (!(plant.stage.digitsPerAmp > 0.0) || !(plant.speedPeriod_s > 0.0))
        return unknown(motor::GainWarning::ScaleMissing);
    const auto gains =
        motor::positionGains({digits, digits, digits}, plant.stage, plant.speedPeriod_s);
    const QString hint = GainTexts::tr("Amperes of Iq for radians of the shaft.");
    switch (kind) {
    case PositionKp:
        return {gainWithUnit(gains.kp, QStringLiteral("A/rad")), hint, true};
    case PositionKi:
        return {gainWithUnit(gains.ki, QStringLiteral("A/(rad\u00b7s)")), hint, true};
    default:
        return {gainWithUnit(gains.kd, QStringLiteral("A\u00b7s/rad")), hint, true};
    }
}

bool isReal(const RegisterModel &model, catalog::RegisterId id)
{
    const auto catalog = model.catalog();
    const catalog::RegisterInfo *info = catalog ? catalog->find(id) : nullptr;
    return info != nullptr && info->type == catalog::ValueType::F32;
}

/// As the drive's own dictionary has it.
Physical inUnits(const RegisterModel &model, std::optional<catalog::RegisterId> id)
{
    const auto catalog = model.catalog();
    const catalog::RegisterInfo *info = catalog && id ? catalog->find(*id) : nullptr;
    if (info == nullptr)
        return {};
    if (info->unit.empty())
        return unknown(deviceText(info->help));
    return {deviceText(info->unit), deviceText(info->help)};
}

/// Where ST's rule would put it for this motor.
Physical observerGain(GainKind kind, const drive::MotorFacts &facts, const motor::GainPlant &plant)
{
    const QString why = GainTexts::tr("The observer's own full scales are not told by the board.");
    const double maxBemf_v = motor::maxObserverBemf_v(facts.limits.maxSpeedRpm,
        motor::keOfFlux_vrmsPerKrpm(facts.motor.flux_wb, facts.motor.polePairs));
    if (!(maxBemf_v > 0.0) || !(plant.stage.digitsPerAmp > 0.0)
        || !(plant.stage.controlPeriod_s > 0.0) || !(facts.motor.lq_h > 0.0))
        return unknown(why);
    motor::ObserverScale scale;
    scale.maxCurrent_a = drive::kFullScaleDigits / plant.stage.digitsPerAmp;
    scale.maxBemf_v = maxBemf_v;
    const auto gains = motor::observerGains(plant.torque(), plant.stage.controlPeriod_s, scale);
    double placed = kind == Observer1 ? gains.gain1 : gains.gain2;
    while (std::abs(placed) > motor::kMaxNumerator)
        placed /= 2.0; // ST's generator halves F1 or F2 until it fits
    return {GainTexts::tr("(ST's rule: %1)").arg(numberText(std::trunc(placed), 0)),
        GainTexts::tr("Where ST's rule puts it for this motor: poles at a quarter of the motor's "
                      "own. %1")
            .arg(why)};
}

} // namespace

GainTable::GainTable(RegisterModel &model, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_none(new QLabel(tr("No gains: connect a board."), this))
{
    setObjectName(QStringLiteral("gainTable"));
    auto *grid = edged(new QGridLayout(this), {kHalfGrid, kHalfGrid, kHalfGrid, kHalfGrid});
    grid->setVerticalSpacing(kFineGrid);
    grid->setHorizontalSpacing(kHalfGrid);
    const QString heads[] = {tr("Proportional"), tr("Integral"), tr("Derivative")};
    for (int place = 0; place < kPlaces; ++place) {
        auto *head = new QLabel(heads[place], this);
        head->setForegroundRole(QPalette::PlaceholderText);
        grid->addWidget(head, 0, 1 + place * kColumnsAGain, 1, kColumnsAGain);
        grid->setColumnStretch((place + 1) * kColumnsAGain, 1);
        m_heads.push_back(head);
    }
    const int rows = static_cast<int>(catalog::gainRows().size());
    for (int row = 1; row <= rows; ++row)
        addRow(grid, row);
    grid->addWidget(m_none, rows + 1, 0, 1, 1 + kPlaces * kColumnsAGain);
    grid->setRowStretch(rows + 2, 1);
    m_soon.setSingleShot(true); // many fields change at once
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &GainTable::updateRows);
    updateRows();
}

void GainTable::addRow(QGridLayout *grid, int row)
{
    const catalog::GainRow &spec = catalog::gainRows()[static_cast<std::size_t>(row) - 1];
    auto *title = new QLabel(tr(kTitles.at(static_cast<std::size_t>(spec.loop))), this);
    grid->addWidget(title, row, 0);
    m_titles.push_back(title);
    for (int place = 0; place < kPlaces; ++place) {
        const catalog::GainRegister &gain = spec.gains[static_cast<std::size_t>(place)];
        if (gain.name)
            addGain(grid, row, place, gain.kind, gain.name, gain.divided);
    }
}

void GainTable::addGain(
    QGridLayout *grid, int row, int place, GainKind kind, const char *name, bool divided)
{
    const int first = 1 + place * kColumnsAGain;
    const int digit = fontMetrics().horizontalAdvance(QLatin1Char('0'));
    Gain gain{kind, row - 1, place, nullptr, nullptr, nullptr, new QLabel(this)};
    const auto field = [&](const QString &registerName, int digits) {
        auto *made = new RegisterField(m_model, registerName,
            divided ? RegisterModel::RawColumn : RegisterModel::ValueColumn, this);
        made->setFixedWidth(digit * (digits + 3));
        connect(made, &RegisterField::registerChanged, &m_soon, qOverload<>(&QTimer::start));
        connect(made, &RegisterField::valueChanged, &m_soon, qOverload<>(&QTimer::start));
        connect(made, &RegisterField::entryRefused, this, &GainTable::entryRefused);
        return made;
    };
    gain.numerator = field(QLatin1String(name), kind == InUnits ? kRealDigits : kNumeratorDigits);
    grid->addWidget(gain.numerator, row, first);
    if (divided) {
        auto *slash = new QLabel(QStringLiteral("/ 2^"), this);
        gain.divisor = field(QLatin1String(name) + QStringLiteral("_DIV"), kDivisorDigits);
        gain.slash = slash;
        grid->addWidget(slash, row, first + 1);
        grid->addWidget(gain.divisor, row, first + 2);
    }
    gain.physical->setTextFormat(Qt::PlainText);
    gain.physical->setTextInteractionFlags(Qt::TextSelectableByMouse);
    gain.physical->setFocusPolicy(Qt::NoFocus); // a click selects all the same
    gain.physical->setObjectName(QStringLiteral("physical_") + QLatin1String(name));
    grid->addWidget(gain.physical, row, first + 3);
    m_gains.push_back(gain);
}

void GainTable::setFacts(const drive::MotorFacts &facts)
{
    m_facts = facts;
    updatePhysical();
}

std::vector<catalog::RegisterId> GainTable::registers() const
{
    std::vector<catalog::RegisterId> ids;
    for (const Gain &gain : m_gains)
        for (const RegisterField *field : {gain.numerator, gain.divisor})
            if (field && field->id() && m_model.pollable(*field->id()))
                ids.push_back(*field->id());
    return ids;
}

void GainTable::focusFirst()
{
    for (const Gain &gain : m_gains)
        if (gain.numerator->isVisibleTo(this))
            return gain.numerator->setFocus(Qt::ShortcutFocusReason);
}

void GainTable::updateRows()
{
    std::vector<bool> rows(m_titles.size()), places(m_heads.size());
    for (const Gain &gain : m_gains) {
        // Many registers exist in the catalogue and not in this build; the board says so when asked.
        const auto id = gain.numerator->id();
        const bool there = id && m_model.supported(*id)
            && (gain.kind >= PerUnit || !isReal(m_model, *id)); // an older name of another drive's
        for (QWidget *part : std::initializer_list<QWidget *>{
                 gain.numerator, gain.slash, gain.divisor, gain.physical})
            if (part)
                part->setVisible(there);
        if (there)
            rows[static_cast<std::size_t>(gain.row)] =
                places[static_cast<std::size_t>(gain.place)] = true;
    }
    bool any = false;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        m_titles[row]->setVisible(rows[row]);
        any = any || rows[row];
    }
    for (std::size_t place = 0; place < places.size(); ++place)
        m_heads[place]->setVisible(places[place]);
    m_none->setVisible(!any);
    m_none->setText(m_model.catalog() ? tr("This board's firmware has no gains to be tuned.")
                                      : tr("No gains: connect a board."));
    updatePhysical();
}

std::optional<double> GainTable::digitsOf(const Gain &gain)
{
    const auto numerator = gain.numerator->wanted();
    const auto *whole = numerator ? std::get_if<std::int64_t>(&*numerator) : nullptr;
    if (whole == nullptr)
        return {};
    if (!gain.divisor)
        return static_cast<double>(*whole);
    const auto divisor = gain.divisor->wanted();
    const auto *exponent = divisor ? std::get_if<std::int64_t>(&*divisor) : nullptr;
    if (exponent == nullptr || *exponent < 0 || *exponent > motor::kMaxExponent)
        return {};
    return std::ldexp(static_cast<double>(*whole), -static_cast<int>(*exponent));
}

void GainTable::updatePhysical()
{
    const motor::GainPlant plant = drive::gainPlant(m_facts);
    std::array<std::optional<double>, catalog::kGainKinds> digits;
    for (const Gain &gain : m_gains)
        if (gain.numerator->id())
            digits[static_cast<std::size_t>(gain.kind)] = digitsOf(gain);
    constexpr auto kPllKp = static_cast<std::size_t>(PllKp);
    constexpr auto kPllKi = static_cast<std::size_t>(PllKi);
    const auto pll = [&]() -> Physical {
        if (!digits[kPllKp] || !digits[kPllKi] || !(plant.stage.controlPeriod_s > 0.0))
            return unknown(motor::GainWarning::PeriodMissing);
        const auto loop = motor::pllForecast(
            {*digits[kPllKp], *digits[kPllKi]}, plant.stage.controlPeriod_s, kPllShare);
        return {tr("\u2248 %1 rad/s, damping %2")
                    .arg(significantText(loop.natural_radps, 3), significantText(loop.damping, 2)),
            tr("Natural frequency of the PLL at half the highest speed, if the observer's full "
               "scale is 1.2 times that speed, as ST's generator has it.")};
    };
    for (const Gain &gain : m_gains) {
        const GainKind kind = gain.kind;
        const auto value = digitsOf(gain);
        Physical shown;
        if (kind == InUnits)
            shown = inUnits(m_model, gain.numerator->id());
        else if (kind == PerUnit)
            shown = unknown(tr("This firmware counts per unit and does not say of what."));
        else if (!value)
            shown = {QStringLiteral("\u2013"), tr("Not read yet.")};
        else if (kind <= SpeedKi)
            shown = loopGain(kind, *value, plant);
        else if (kind <= WeakeningKi)
            shown = weakeningGain(kind, *value, plant);
        else if (kind <= PositionKd)
            shown = positionGain(kind, *value, plant);
        else if (kind == PllKp)
            shown = {QString(), {}}; // told with its Ki
        else if (kind == PllKi)
            shown = pll();
        else
            shown = observerGain(kind, m_facts, plant);
        gain.physical->setText(shown.equals ? QStringLiteral("= ") + shown.text : shown.text);
        gain.physical->setToolTip(plainToolTip(shown.hint));
    }
}

} // namespace widgets

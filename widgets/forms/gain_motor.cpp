#include "widgets/forms/gain_motor.h"

#include "drive/motor_view.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/si_text.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace widgets {
namespace {

constexpr double kGcm2 = 1e7; ///< g cm2 in a kg m2

} // namespace

GainMotor::GainMotor(QWidget *parent)
    : QWidget(parent)
{
    auto *grid = bare(new QGridLayout(this), kHalfGrid, kFineGrid);
    // Typed in the usual sizes, so that no exponent is needed.
    m_rs = addInput(grid, 0, 0, "labRs", tr("Rs"), QStringLiteral("\u03a9"), 1e-5, 1e4);
    m_lq = addInput(grid, 1, 0, "labLq", tr("Lq"), QStringLiteral("mH"), 1e-5, 1e4);
    m_ld = addInput(grid, 2, 0, "labLd", tr("Ld"), QStringLiteral("mH"), 1e-5, 1e4);
    m_polePairs = addInput(grid, 3, 0, "labPolePairs", tr("Pole pairs"), {}, 1, 200);
    m_flux = addInput(grid, 4, 0, "labFlux", tr("Flux"), QStringLiteral("mWb"), 1e-3, 1e4);
    m_ke = addInput(grid, 5, 0, "labKe", tr("Ke"), QStringLiteral("V/krpm"), 1e-3, 1e4);
    m_inertia = addInput(
        grid, 6, 0, "labInertia", tr("Inertia"), QStringLiteral("g\u00b7cm\u00b2"), 1e-3, 1e9);
    m_rs->setToolTip(tr("Of a phase: half of what is measured between two wires."));
    m_lq->setToolTip(m_rs->toolTip());
    m_ld->setToolTip(m_rs->toolTip());
    m_flux->setToolTip(tr("Of the magnets, linked with a phase, peak."));
    m_ke->setToolTip(tr("Volts rms between two wires at 1000 rpm. The same as the flux: one "
                        "follows the other."));
    m_inertia->setToolTip(tr("Of rotor and load together; boards rarely know it. It is remembered "
                             "for motors of this name. 1 kg\u00b7m\u00b2 = 10,000,000 g\u00b7"
                             "cm\u00b2."));
    grid->setRowStretch(7, 1);
    for (NumberEdit *field : {m_rs, m_lq, m_ld, m_inertia})
        connect(field, &NumberEdit::valueEdited, this, [this, field] { typed(field); });
    for (NumberEdit *field : {m_flux, m_ke})
        connect(field, &NumberEdit::valueEdited, this, [this, field] { fluxTyped(field); });
    connect(m_polePairs, &NumberEdit::valueEdited, this, [this] {
        keepTyped(m_polePairs);
        if (isTyped(m_flux) || isTyped(m_ke))
            return fluxTyped(isTyped(m_ke) ? m_ke : m_flux);
        fill(); // the flux is as it was; its Ke is another
        Q_EMIT edited();
    });
}

NumberEdit *GainMotor::addInput(QGridLayout *grid, int row, int column, const char *name,
    const QString &label, const QString &unit, double least, double greatest)
{
    auto *field = new NumberEdit(name, label, unit, least, greatest, this);
    field->setFixedWidth(fontMetrics().horizontalAdvance(QLatin1Char('0')) * 9);
    auto *text = new QLabel(label, this);
    text->setBuddy(field);
    grid->addWidget(text, row, column);
    grid->addWidget(field, row, column + 1);
    grid->addWidget(new QLabel(unit, this), row, column + 2);
    return field;
}

bool GainMotor::isTyped(const NumberEdit *field) const
{
    return std::find(m_typed.begin(), m_typed.end(), field) != m_typed.end();
}

void GainMotor::keepTyped(NumberEdit *field)
{
    if (!isTyped(field))
        m_typed.push_back(field);
}

void GainMotor::typed(NumberEdit *field)
{
    keepTyped(field);
    if (field == m_inertia)
        if (const auto inertia = m_inertia->value())
            Q_EMIT inertiaTyped(*inertia / kGcm2);
    Q_EMIT edited();
}

/// Flux and Ke are the same magnets: the other one follows.
void GainMotor::fluxTyped(NumberEdit *field)
{
    const auto value = field->value(), poles = m_polePairs->value();
    NumberEdit *other = field == m_flux ? m_ke : m_flux;
    std::erase(m_typed, other);
    if (value && poles)
        other->setValue(field == m_flux ? motor::keOfFlux_vrmsPerKrpm(*value / kMilli, *poles)
                                        : motor::fluxOfKe_wb(*value, *poles) * kMilli);
    else
        other->setValue(std::nullopt);
    typed(field);
}

void GainMotor::setFacts(
    const drive::MotorFacts &facts, std::optional<double> rememberedInertia_kgm2)
{
    m_facts = facts;
    m_remembered_kgm2 = rememberedInertia_kgm2;
    fill();
}

void GainMotor::setMeasured(const MeasuredMotor &measured)
{
    m_measured = measured;
    fill();
}

void GainMotor::forgetTyped()
{
    m_typed.clear();
    m_measured = {};
    fill();
}

/// Where the board knows none, one that was typed for motors of this name stays.
std::optional<lab::Estimate> GainMotor::measuredInertia() const
{
    return m_facts.inertia_kgm2 > 0.0 || !m_remembered_kgm2 ? m_measured.inertia_kgm2
                                                            : std::nullopt;
}

void GainMotor::fill()
{
    const auto put = [this](NumberEdit *field, double value, double factor) {
        if (!isTyped(field))
            field->setValue(value > 0.0 ? std::optional(value * factor) : std::nullopt);
    };
    const auto measured = [](const std::optional<lab::Estimate> &found, double board) {
        return found ? found->value : board;
    };
    const motor::MotorParameters &motor = m_facts.motor;
    put(m_rs, measured(m_measured.rs_ohm, motor.rs_ohm), 1.0);
    put(m_lq, measured(m_measured.lq_h, motor.lq_h), kMilli);
    put(m_ld, measured(m_measured.ld_h, motor.ld_h), kMilli);
    put(m_polePairs, motor.polePairs, 1.0);
    if (!isTyped(m_flux) && !isTyped(m_ke)) {
        const double flux_wb = measured(m_measured.flux_wb, motor.flux_wb);
        put(m_flux, flux_wb, kMilli);
        const double polePairs = m_polePairs->value().value_or(0.0);
        put(m_ke, polePairs > 0.0 ? motor::keOfFlux_vrmsPerKrpm(flux_wb, polePairs) : 0.0, 1.0);
    }
    put(m_inertia,
        measured(measuredInertia(),
            m_facts.inertia_kgm2 > 0.0 ? m_facts.inertia_kgm2 : m_remembered_kgm2.value_or(0.0)),
        kGcm2);
}

QString GainMotor::measuredText() const
{
    struct Shown {
        QString name;
        std::optional<lab::Estimate> found;
        double factor;
        const char16_t *unit;
    };
    const auto unless = [](bool typed, const std::optional<lab::Estimate> &found) {
        return typed ? std::nullopt : found;
    };
    QStringList within, alone;
    for (const Shown &shown :
        {Shown{tr("Rs"), unless(isTyped(m_rs), m_measured.rs_ohm), 1.0, u"\u03a9"},
            Shown{tr("Lq"), unless(isTyped(m_lq), m_measured.lq_h), 1.0, u"H"},
            Shown{tr("Ld"), unless(isTyped(m_ld), m_measured.ld_h), 1.0, u"H"},
            Shown{tr("Flux"), unless(isTyped(m_flux) || isTyped(m_ke), m_measured.flux_wb), 1.0,
                u"Wb"},
            Shown{tr("Inertia"), unless(isTyped(m_inertia), measuredInertia()), kGcm2,
                u"g\u00b7cm\u00b2"}}) {
        if (!shown.found)
            continue;
        const auto figure = [&shown](double value) {
            return siText(value * shown.factor, QString::fromUtf16(shown.unit),
                lab::lastPlaceOf(*shown.found) * shown.factor);
        };
        if (shown.found->low && shown.found->high)
            within.append(
                tr("%1 from %2 to %3", "quantity, least and greatest value")
                    .arg(shown.name, figure(*shown.found->low), figure(*shown.found->high)));
        else
            alone.append(shown.name + QLatin1Char(' ') + figure(shown.found->value));
    }
    QStringList sentences;
    if (!within.isEmpty())
        sentences.append(tr("Measured, with 95 %: %1.").arg(within.join(QStringLiteral("; "))));
    if (!alone.isEmpty())
        sentences.append(
            tr("Measured, without an interval: %1.").arg(alone.join(QStringLiteral("; "))));
    return sentences.join(QLatin1Char(' '));
}

motor::GainPlant GainMotor::plant() const
{
    motor::GainPlant plant = drive::gainPlant(m_facts);
    const auto in = [](const NumberEdit *field, double factor) {
        return field->value().value_or(0.0) / factor;
    };
    plant.motor.rs_ohm = in(m_rs, 1.0);
    plant.motor.lq_h = in(m_lq, kMilli);
    plant.motor.ld_h = in(m_ld, kMilli);
    plant.motor.polePairs = in(m_polePairs, 1.0);
    plant.motor.flux_wb = in(m_flux, kMilli);
    plant.inertia_kgm2 = in(m_inertia, kGcm2);
    return plant;
}

QString GainMotor::problem() const
{
    for (const NumberEdit *field : {m_rs, m_lq, m_ld, m_polePairs, m_flux, m_ke, m_inertia})
        if (const QString sentence = field->problem(); !sentence.isEmpty())
            return tr("%1: %2", "field, what is wrong with it")
                .arg(field->accessibleName(), sentence);
    return {};
}

} // namespace widgets

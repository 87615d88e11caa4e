#include "widgets/lab/motor_findings.h"

#include "widgets/base/device_text.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"
#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/text.h"

#include <algorithm>
#include <array>

namespace widgets {
namespace {

constexpr double kGcm2PerKgm2 = 1e7;

/// A figure, how it is shown, and where a motor file has it. In the order of MotorFindings::Row.
struct Shown {
    const char *name;
    double factor;
    const char16_t *unit;
    std::optional<double> motor::MotorSheet::*member; ///< nullptr: it holds no such figure
};
constexpr std::array<Shown, MotorFindings::kRows> kShown{{
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Pole pairs"), 1.0, u"",
        &motor::MotorSheet::polePairs},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Resistance Rs"), 1.0, u"\u03a9",
        &motor::MotorSheet::rs_ohm},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Voltage of dead times"), 1.0, u"V", nullptr},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Inductance Ld"), 1.0, u"H",
        &motor::MotorSheet::ld_h},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Inductance Lq"), 1.0, u"H",
        &motor::MotorSheet::lq_h},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Flux of the magnets"), 1.0, u"Wb",
        &motor::MotorSheet::flux_wb},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Inertia J"), kGcm2PerKgm2, u"g cm\u00b2",
        &motor::MotorSheet::inertia_kgm2},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Viscous friction"), 1.0, u"N m s",
        &motor::MotorSheet::viscous_nms},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Dry friction"), 1.0, u"N m",
        &motor::MotorSheet::coulomb_nm},
    {QT_TRANSLATE_NOOP("widgets::MotorFindings", "Fan"), 1e6, u"\u00b5N m s\u00b2", nullptr},
}};

const QString kNone = QStringLiteral("\u2013");

/// @param place  the last one that counts, in SI units; 0: whatever there is
QString figure(std::size_t row, const std::optional<double> &value, double place = 0.0)
{
    const Shown &shown = kShown[row];
    return value
        ? siText(*value * shown.factor, QString::fromUtf16(shown.unit), place * shown.factor)
        : kNone;
}

} // namespace

MotorFindings::MotorFindings(QObject *parent)
    : RowTable(parent,
        {tr("Quantity"), tr("Measured"), tr("With 95 %"), tr("On the board"),
            tr("In the motor file"), tr("Notes")})
    , m_rows(kRows)
{
}

void MotorFindings::set(Row row, const std::optional<lab::Estimate> &value, const QString &note)
{
    m_rows[row] = {value, note};
}

void MotorFindings::accept(const lab::Electrics &found, bool complete)
{
    const QString why = labSentences(found.notes).join(QLatin1Char(' '));
    const auto put = [&](Row row, const std::optional<lab::Estimate> &value, const QString &note) {
        if (value || complete)
            set(row, value, note);
    };
    put(Resistance, found.rs_ohm,
        found.rs_ohm ? tr("of a phase with its switches, as warm as it is now") : why);
    put(DeadTime, found.deadTime_v,
        found.deadTime_v ? tr("what the bridge loses; a motor file does not hold it") : why);
    for (const auto &[row, value] :
        {std::pair(Ld, found.ld_h), std::pair(Lq, found.lq_h), std::pair(Flux, found.flux_wb)})
        put(row, value, value ? QString() : why);
    cellsChanged();
}

void MotorFindings::accept(const lab::Mechanics &found, bool /*complete*/)
{
    constexpr double kPercent = 100.0;
    const QString model =
        found.fan ? tr("viscous and dry friction and a fan") : tr("viscous and dry friction");
    QString note = tr("Model: %1; it leaves %2 % of the torque.")
                       .arg(model, plainNumberText(found.share * kPercent, 2));
    if (found.both) {
        const auto inertia = [](const lab::Estimate &one) {
            return figure(Inertia, one.value, lab::lastPlaceOf(one));
        };
        note = tr("%1 forwards, %2 backwards.", "inertia")
                   .arg(inertia(found.both->forwards_kgm2), inertia(found.both->backwards_kgm2))
            + QLatin1Char(' ') + note;
    }
    set(Inertia, found.inertia_kgm2, note);
    set(Viscous, found.viscous_nms, {});
    const QString always = found.both
        ? tr("beside it %1 that is always there; above 0 it hinders forwards", "torque")
              .arg(
                  figure(Dry, found.both->always_nm.value, lab::lastPlaceOf(found.both->always_nm)))
        : QString();
    set(Dry, found.dry_nm, always);
    set(Fan, found.fan ? std::optional(found.fan_nms2) : std::nullopt,
        found.fan ? tr("a motor file does not hold it")
                  : tr("none seen; at most %1")
                        .arg(figure(Fan, found.fan_nms2.high.value_or(0.0),
                            lab::lastPlaceOf(found.fan_nms2))));
    cellsChanged();
}

void MotorFindings::fail(bool mechanical, const QString &why)
{
    const int first = mechanical ? Inertia : Resistance, last = mechanical ? Fan : Flux;
    for (int row = first; row <= last; ++row)
        set(Row(row), std::nullopt, why);
    cellsChanged();
}

void MotorFindings::setPolePairs(const lab::PolePairs &counted)
{
    set(PolePairs, lab::Estimate{double(counted.count), {}, {}},
        tr("%1 by a tachometer", "pole pairs").arg(numberText(counted.measured, 2)));
    cellsChanged();
}

void MotorFindings::clear()
{
    m_rows.assign(kRows, {});
    cellsChanged();
}

void MotorFindings::setKnown(
    const motor::MotorSheet &board, const std::optional<motor::MotorSheet> &file)
{
    m_board = board;
    m_file = file.value_or(motor::MotorSheet());
    cellsChanged();
}

motor::MotorSheet MotorFindings::measured() const
{
    motor::MotorSheet sheet;
    for (std::size_t row = 0; row < kRows; ++row)
        if (kShown[row].member != nullptr && m_rows[row].value)
            sheet.*kShown[row].member = m_rows[row].value->value;
    return sheet;
}

double MotorFindings::torqueConstant_nm() const
{
    return motor::ktOfFlux_nmpa(m_file.flux_wb.value_or(0.0), m_file.polePairs.value_or(0.0));
}

bool MotorFindings::any() const
{
    const motor::MotorSheet sheet = measured();
    return std::any_of(kShown.begin(), kShown.end(), [&](const Shown &shown) {
        return shown.member != nullptr && (sheet.*shown.member).has_value();
    });
}

QString MotorFindings::measuredFigure(Row row, const std::optional<double> &value) const
{
    return figure(row, value, lab::lastPlaceOf(*m_rows[row].value));
}

QString MotorFindings::text(Row row, int column) const
{
    const Finding &finding = m_rows[row];
    const auto member = kShown[row].member;
    switch (column) {
    case QuantityColumn:
        return tr(kShown[row].name);
    case MeasuredColumn:
        return finding.value ? measuredFigure(row, finding.value->value) : kNone;
    case IntervalColumn:
        return finding.value && finding.value->low && finding.value->high
            ? tr("%1 to %2", "least and greatest value")
                  .arg(measuredFigure(row, finding.value->low),
                      measuredFigure(row, finding.value->high))
            : kNone;
    case BoardColumn:
        return figure(row, member != nullptr ? m_board.*member : std::nullopt);
    case FileColumn:
        return figure(row, member != nullptr ? m_file.*member : std::nullopt);
    case NoteColumn:
        return finding.note;
    default:
        return {};
    }
}

QVariant MotorFindings::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= kRows)
        return {};
    const QString shown = text(Row(index.row()), index.column());
    if (role == Qt::DisplayRole)
        return shown;
    if (role == Qt::ToolTipRole && index.column() == NoteColumn && !shown.isEmpty())
        return plainToolTip(shown);
    return {};
}

} // namespace widgets

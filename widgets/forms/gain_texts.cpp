#include "widgets/forms/gain_texts.h"

#include "catalog/gain_rows.h"
#include "widgets/base/si_text.h"
#include "widgets/registers/model.h"

#include <QCoreApplication>

namespace widgets {
namespace {

using motor::GainId;
using motor::GainWarning;

struct Gains {
    Q_DECLARE_TR_FUNCTIONS(Gains)
};

struct Row {
    const char *name;
    const char *unit;
};
constexpr motor::PerGain<Row> kRows{
    {{"I_Q_KP", "V/A"}, {"I_Q_KI", "V/(A\u00b7s)"}, {"I_D_KP", "V/A"}, {"I_D_KI", "V/(A\u00b7s)"},
        {"SPEED_KP", "A/(rad/s)"}, {"SPEED_KI", "A/rad"}}};

const Row &rowOf(GainId id) { return kRows[motor::indexOf(id)]; }

} // namespace

bool gainsInUnits(const RegisterModel &model)
{
    const auto catalog = model.catalog();
    return catalog && catalog::hasGain(*catalog, catalog::GainKind::InUnits);
}

const char *gainRegister(GainId id) { return rowOf(id).name; }

QString gainUnit(GainId id) { return QString::fromUtf8(rowOf(id).unit); }

QString gainWithUnit(double physical, const QString &unit)
{
    return significantText(physical) + QChar(0x202f) + unit;
}

QString fractionText(const motor::FixedPointGain &gain)
{
    return QStringLiteral("%1/2^%2").arg(
        QString::number(gain.numerator), QString::number(gain.exponent));
}

QString gainFindingText(const motor::GainFinding &finding)
{
    const QString name = finding.gain ? QLatin1String(gainRegister(*finding.gain)) : QString();
    const QString is = significantText(finding.is, 3), limit = significantText(finding.limit, 3);
    switch (finding.warning) {
    case GainWarning::MotorMissing:
        return Gains::tr("Rs, Lq and Ld are needed.");
    case GainWarning::ScaleMissing:
        return Gains::tr(
            "The board does not say its bus voltage or what a digit of current is worth.");
    case GainWarning::PeriodMissing:
        return Gains::tr("The board does not say its control rate.");
    case GainWarning::BandwidthBeyondLimit:
        return Gains::tr("%1 rad/s is beyond %2 rad/s, what the control rate allows.")
            .arg(is, limit);
    case GainWarning::DoesNotFit:
        return Gains::tr("%1 does not fit 16 bits with any divisor: ask for less bandwidth.")
            .arg(name);
    case GainWarning::RoundsToZero:
        return Gains::tr("%1 is so small that it rounds to zero: ask for more bandwidth or less "
                         "damping.")
            .arg(name);
    case GainWarning::ProductTooLarge:
        return Gains::tr("%1 times the largest error overflows 32 bits: ask for less bandwidth.")
            .arg(name);
    case GainWarning::SpeedNeedsFlux:
        return Gains::tr("The speed loop stays as it is: flux and pole pairs are needed.");
    case GainWarning::SpeedNeedsInertia:
        return Gains::tr("The speed loop stays as it is: type the inertia of rotor and load.");
    case GainWarning::SpeedNeedsPeriod:
        return Gains::tr("The speed loop stays as it is: the board does not say its rate.");
    case GainWarning::BandwidthBeyondGuide:
        return Gains::tr("Above %1 rad/s, boards that measure currents this way often trip: "
                         "watch for over-current.")
            .arg(limit);
    case GainWarning::CurrentMarginSmall:
        return Gains::tr("The current loop has only %1\u00b0 of phase margin: it will overshoot.")
            .arg(is);
    case GainWarning::SpeedMarginSmall:
        return Gains::tr("The speed loop has only %1\u00b0 of phase margin: it will ring.").arg(is);
    case GainWarning::CoarseRounding:
        return Gains::tr("%1 is rounded by %2 %: the loop is not quite the one asked for.")
            .arg(name, significantText(100.0 * finding.is, 2));
    case GainWarning::LdAboveLq:
        return Gains::tr("Ld is above Lq: are they swapped?");
    }
    return {};
}

} // namespace widgets

#include "widgets/base/reading_text.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

struct Readings {
    Q_DECLARE_TR_FUNCTIONS(Readings)
};

constexpr double kFinestTime = 1e-7; ///< seconds, of times below a second
constexpr double kFinestOfSeconds = 1e-6;
constexpr double kTimeDigits = 1e-8; ///< of the value
constexpr double kFrequencyDigits = 1e-5;

/// The power of ten at or above `least`.
double decade(double least) { return std::pow(10.0, std::ceil(std::log10(least) - 1e-9)); }

/// A true minus sign is as wide as a plus, and cannot be taken for a dash.
QString withMinus(QString text) { return text.replace(QLatin1Char('-'), QChar(0x2212)); }

} // namespace

QString exactTime(double seconds, const QLocale &locale)
{
    const double size = std::abs(seconds);
    const double finest = size < 1.0 ? kFinestTime : kFinestOfSeconds;
    const double step = std::max(finest, size > 0 ? decade(size * kTimeDigits) : finest);
    return withMinus(timeLabel(seconds, step, std::max(size, kFinestTime), locale));
}

QString spanTime(double seconds, const QLocale &locale)
{
    constexpr double kDigits = 1e-3, kFinest = 1e-4;
    const double size = std::max(std::abs(seconds), kFinest);
    const double step = std::max(kFinest, decade(size * kDigits));
    return withMinus(timeLabel(seconds, step, std::max(size, 1e-3), locale));
}

QString inverseTime(double seconds, const QLocale &locale)
{
    if (!(std::abs(seconds) > 0) || !std::isfinite(seconds))
        return QStringLiteral("\u2013");
    const double hertz = 1.0 / std::abs(seconds);
    struct Prefix {
        double scale;
        const char *unit;
    };
    static constexpr Prefix kPrefixes[] = {{1e-6, "MHz"}, {1e-3, "kHz"}, {1.0, "Hz"}};
    const Prefix &prefix = kPrefixes[hertz >= 1e6 ? 0 : hertz >= 1e3 ? 1 : 2];
    const double shown = hertz * prefix.scale;
    return valueLabel(shown, decade(shown * kFrequencyDigits), locale) + QChar(QChar::Nbsp)
        + QString::fromLatin1(prefix.unit);
}

QString readingText(
    std::optional<double> value, double step, const QString &unit, const QLocale &locale)
{
    if (!value)
        return Readings::tr("no sample");
    const QString number = withMinus(valueLabel(*value, step, locale));
    return unit.isEmpty() ? number : number + QChar(QChar::Nbsp) + unitText(unit);
}

} // namespace widgets

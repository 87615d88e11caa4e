#include "widgets/base/axis_ticks.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace widgets {

namespace {
struct Ticks {
    Q_DECLARE_TR_FUNCTIONS(Ticks)
};

constexpr int kMostTicks = 1000;
constexpr double kLeastDigits = 8.0;
constexpr int kFewTicks = 3; ///< fewer say nothing of the scale

int decimalsOfStep(double step)
{
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
}
} // namespace

double leastSpan(const QString &unit, double digit)
{
    struct Least {
        const char *unit;
        double span;
    };
    // What is next to nothing for any motor on a bench; finer is there by hand.
    static constexpr Least kLeast[] = {{"A", 0.1}, {"s16A", 100.0}, {"s16V", 100.0}, {"V", 0.5},
        {"rpm", 20.0}, {"Hz", 1.0}, {"\u00b0C", 5.0}, {"deg", 5.0}};
    double span = std::isfinite(digit) ? kLeastDigits * std::abs(digit) : 0.0;
    for (const Least &least : kLeast) {
        if (unit == QString::fromUtf8(least.unit))
            span = std::max(span, least.span);
    }
    return span;
}

double tickStep(double span, int most)
{
    if (!(span > 0) || !std::isfinite(span))
        return 1.0;
    const double least = span / std::max(most, 1);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1 - 1e-9))
            return factor * power;
    }
    return 10.0 * power;
}

double steppedScale(double scale, int steps)
{
    if (!(scale > 0) || !std::isfinite(scale))
        return 1.0;
    constexpr double kFactors[] = {1.0, 2.0, 5.0};
    // Numbers every step: three a decade. A scale between two of them goes to its neighbour first.
    const double decade = std::floor(std::log10(scale) + 1e-9);
    const double mantissa = scale / std::pow(10.0, decade);
    const double place = mantissa < 2.0 * (1 - 1e-9) ? (mantissa > 1.0 + 1e-9 ? 0.5 : 0.0)
        : mantissa < 5.0 * (1 - 1e-9)                ? (mantissa > 2.0 + 1e-9 ? 1.5 : 1.0)
        : mantissa > 5.0 * (1 + 1e-9)                ? 2.5
                                                     : 2.0;
    const double base = steps > 0 ? std::floor(place) : std::ceil(place);
    const int index = static_cast<int>(3.0 * decade + base) + steps;
    const int power = index >= 0 ? index / 3 : -((2 - index) / 3);
    return kFactors[index - 3 * power] * std::pow(10.0, power);
}

QVector<double> ticksIn(double from, double to, double step)
{
    QVector<double> ticks;
    if (!(step > 0) || !(to >= from))
        return ticks;
    const double first = std::ceil(from / step - 1e-9);
    const double last = std::floor(to / step + 1e-9);
    const int count = static_cast<int>(std::min(last - first + 1, double(kMostTicks)));
    for (int i = 0; i < count; ++i)
        ticks.append((first + i) * step + 0.0);
    return ticks;
}

int piecesOf(double step)
{
    const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    return std::abs(mantissa - 2.0) < 0.5 ? 4 : 5;
}

QVector<double> smallTicksIn(double from, double to, double step)
{
    QVector<double> ticks;
    if (!(step > 0) || !(to >= from))
        return ticks;
    const int pieces = piecesOf(step);
    const double small = step / pieces;
    const double first = std::ceil(from / small - 1e-9);
    const double last = std::floor(to / small + 1e-9);
    const int count = static_cast<int>(std::min(last - first + 1, double(kMostTicks)));
    for (int i = 0; i < count; ++i) {
        if (std::fmod(first + i, pieces) != 0.0)
            ticks.append((first + i) * small);
    }
    return ticks;
}

double valueStep(double from, double to, int most, int room)
{
    const double step = tickStep(to - from, most);
    if (ticksIn(from, to, step).size() >= kFewTicks)
        return step;
    const double finer = steppedScale(step, -1);
    return ticksIn(from, to, finer).size() <= room ? finer : step;
}

QString valueLabel(double value, double step, const QLocale &locale)
{
    if (std::abs(value) < step * 1e-6)
        value = 0.0; // no "-0"
    if (std::abs(value) >= 1e7 || step < 1e-6)
        return locale.toString(value, 'g', 6);
    const int decimals = decimalsOfStep(step);
    if (std::abs(value) < 0.5 * std::pow(10.0, -decimals))
        value = 0.0; // nor what would be rounded to it
    return locale.toString(value, 'f', decimals);
}

QString perDivision(double step, const QString &unit, const QLocale &locale)
{
    const QString number = valueLabel(step, step, locale);
    if (unit.isEmpty())
        return Ticks::tr("%1/div", "what is between two lines of the grid").arg(number);
    return Ticks::tr("%1 %2/div", "number, unit: what is between two lines of the grid")
        .arg(number, unit);
}

QString timePerDivision(double step, const QLocale &locale)
{
    return Ticks::tr("%1/div", "what is between two lines of the grid")
        .arg(timeLabel(step, step, step, locale));
}

QString timeLabel(double seconds, double step, double largest, const QLocale &locale)
{
    struct Prefix {
        double scale;
        const char *unit;
    };
    static constexpr Prefix kPrefixes[] = {{1.0, "s"}, {1e3, "ms"}, {1e6, "\u00b5s"}};
    const Prefix &prefix = kPrefixes[largest >= 1.0 ? 0 : largest >= 1e-3 ? 1 : 2];
    return valueLabel(seconds * prefix.scale, step * prefix.scale, locale) + QChar(0x2009)
        + QString::fromUtf8(prefix.unit);
}

} // namespace widgets

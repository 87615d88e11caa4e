#include "widgets/base/si_text.h"

#include "widgets/base/value_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace widgets {
namespace {

constexpr int kSignificant = 5;
constexpr std::array kPrefixed{u"A", u"V", u"\u03a9", u"H", u"s", u"Wb", u"Hz", u"N m", u"N m/A",
    u"N m s", u"A/digit", u"V/digit"};

struct Prefix {
    double factor;
    const char16_t *sign;
};
constexpr std::array kPrefixes{Prefix{1e-9, u"n"}, Prefix{1e-6, u"\u00b5"}, Prefix{1e-3, u"m"},
    Prefix{1.0, u""}, Prefix{1e3, u"k"}, Prefix{1e6, u"M"}};

const Prefix &prefixFor(double value)
{
    const auto *best = &kPrefixes[3];
    if (value == 0.0)
        return *best;
    // A value that rounds up to the next prefix is shown with it: 1 m, not 1000 u.
    const double shown = std::abs(value) * (1.0 + 0.5 * std::pow(10.0, -kSignificant + 1) / 10.0);
    best = &kPrefixes.front();
    for (const Prefix &prefix : kPrefixes)
        if (shown >= prefix.factor)
            best = &prefix;
    return *best;
}

/// The point; less than 1 where zeros follow it.
int digitsBefore(double value)
{
    return value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
}

} // namespace

QString plainNumberText(double value, int significant)
{
    if (!std::isfinite(value))
        return QStringLiteral("\u2013");
    const QLocale locale = plainLocale();
    const int decimals = std::clamp(significant - digitsBefore(value), 0, 12);
    QString text = locale.toString(value + 0.0, 'f', decimals);
    const QString point = locale.decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(locale.zeroDigit()))
            text.chop(1);
        if (text.endsWith(point))
            text.chop(point.size());
    }
    return text;
}

QString significantText(double value, int digits)
{
    return std::isfinite(value) ? plainNumberText(value, digits) : QString();
}

QString siText(double value, const QString &unit, double place)
{
    if (!std::isfinite(value))
        return QStringLiteral("\u2013");
    if (place > 0.0)
        value = std::round(value / place) * place; // which may be of the next prefix
    const bool prefixed = std::any_of(
        kPrefixed.begin(), kPrefixed.end(), [&](const auto *known) { return unit == known; });
    const Prefix &prefix = prefixed ? prefixFor(value) : kPrefixes[3];
    const double shown = value / prefix.factor;
    // Zeros at its end count where the place is known.
    const QString number = place > 0.0 && value != 0.0
        ? numberText(shown,
            std::clamp(static_cast<int>(std::round(-std::log10(place / prefix.factor))), 0,
                std::max(0, kSignificant - digitsBefore(shown))))
        : plainNumberText(shown, kSignificant);
    return unit.isEmpty() ? number
                          : number + QChar(0x202f) + QString::fromUtf16(prefix.sign) + unit;
}

} // namespace widgets

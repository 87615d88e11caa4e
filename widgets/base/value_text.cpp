#include "widgets/base/value_text.h"

#include "drive/wish.h"
#include "widgets/base/device_text.h"
#include "widgets/base/register_texts.h"

#include <bit>
#include <cmath>
#include <limits>

namespace widgets {
namespace {

constexpr std::size_t kShownBytes = 24;

QString hexText(std::int64_t value, std::size_t width)
{
    const std::uint64_t mask =
        width == 0 || width >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * width)) - 1;
    return QStringLiteral("0x")
        + QString::number(static_cast<std::uint64_t>(value) & mask, 16).toUpper();
}

QString bytesText(const Bytes &bytes)
{
    const auto shown = static_cast<qsizetype>(std::min(bytes.size(), kShownBytes));
    QString text = QString::fromLatin1(
        QByteArray(reinterpret_cast<const char *>(bytes.data()), shown).toHex(' '));
    if (bytes.size() > kShownBytes)
        text += QStringLiteral(" \u2026");
    return text;
}

QString withUnit(const QString &number, const std::string &unit)
{
    const QString text = unitText(unit);
    return text.isEmpty() || text == QLatin1String("-") ? number : number + QChar(0x202f) + text;
}

QString joined(const std::vector<std::string> &names)
{
    return valueNameTexts(names).join(QLatin1String(" | "));
}

/// By name; in hexadecimal digits where no bit has one.
QString flagsText(const catalog::RegisterInfo &info, std::int64_t bits)
{
    if (catalog::namedFlags(info.name).empty())
        return hexText(bits, catalog::widthOf(info.type));
    if (bits == 0)
        return QObject::tr("none", "no flag is set");
    const auto all = static_cast<std::uint32_t>(bits);
    if (!catalog::holdsPastFaults(info.name))
        return joined(catalog::flagNames(info.name, all));
    QStringList parts;
    if (const QString now = joined(catalog::faultNames(static_cast<std::uint16_t>(all >> 16)));
        !now.isEmpty())
        parts.append(QObject::tr("now: %1", "faults that are present").arg(now));
    if (const QString past = joined(catalog::faultNames(static_cast<std::uint16_t>(all)));
        !past.isEmpty())
        parts.append(QObject::tr("past: %1", "faults that occurred").arg(past));
    return parts.join(QLatin1String("; "));
}

/// What is only read is measured, and no better than to a thousandth.
QString measuredText(double value, int digits)
{
    constexpr int kMeasured = 4;
    const double size = std::abs(value);
    if (!(size < 1e6))
        return floatText(value, digits);
    if (size < 1e-3 || digits <= kMeasured)
        return floatText(value, std::min(digits, kMeasured));
    return numberText(
        value, std::max(kMeasured - 1 - static_cast<int>(std::floor(std::log10(size))), 0));
}

} // namespace

QString booleanText(bool yes) { return yes ? QObject::tr("yes") : QObject::tr("no"); }

int decimalsFor(double factor)
{
    const double step = std::abs(factor);
    if (!(step > 0.0) || !std::isfinite(step))
        return 0;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 4);
}

QLocale plainLocale(QLocale locale)
{
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

QString floatText(double value, int digits)
{
    return std::isfinite(value) ? plainLocale().toString(value, 'g', digits)
                                : QStringLiteral("\u2013");
}

QString numberText(double value, int decimals)
{
    if (!std::isfinite(value))
        return QStringLiteral("\u2013");
    if (std::abs(value) < 0.5 * std::pow(10.0, -decimals))
        value = 0.0; // never "-0"
    return plainLocale().toString(value, 'f', decimals);
}

QString unitText(const QString &unit)
{
    for (const char *raw : {"s16A", "s16V", "s16degree"})
        if (unit == QLatin1String(raw))
            return QObject::tr("digits", "unit of a raw number");
    return deviceText(unit);
}

QString unitText(std::string_view unit)
{
    return unitText(QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size())));
}

QString unitHelp(std::string_view unit)
{
    return unit == "s16A" ? QObject::tr("%1 digits are the full scale of the current sensor, "
                                        "which this board does not tell.")
                                .arg(numberText(drive::kFullScaleDigits, 0))
                          : QString();
}

double rawNumber(const catalog::Value &value)
{
    if (const auto *integer = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*integer);
    if (const auto *real = std::get_if<double>(&value))
        return *real;
    return std::numeric_limits<double>::quiet_NaN();
}

QString shownText(const catalog::RegisterInfo &info, const catalog::Value &value,
    const catalog::Scale &scale, int digits)
{
    if (const auto *text = std::get_if<std::string>(&value))
        return deviceText(*text);
    if (const auto *bytes = std::get_if<Bytes>(&value))
        return QObject::tr("%n byte(s)", nullptr, static_cast<int>(bytes->size()));
    if (const auto *real = std::get_if<double>(&value)) {
        const double shown = *real * scale.factor;
        return withUnit(
            info.writable() ? floatText(shown, digits) : measuredText(shown, digits), scale.unit);
    }
    const auto integer = std::get<std::int64_t>(value);
    switch (info.meaning) {
    case catalog::Meaning::Flags:
        return flagsText(info, integer);
    case catalog::Meaning::Boolean:
        return booleanText(integer != 0);
    case catalog::Meaning::Enumeration:
        return valueNameText(catalog::valueName(info.name, integer));
    case catalog::Meaning::Number:
        break;
    }
    return withUnit(
        numberText(static_cast<double>(integer) * scale.factor, decimalsFor(scale.factor)),
        scale.unit);
}

QString hexText(catalog::ValueType type, const catalog::Value &value)
{
    const std::size_t width = catalog::widthOf(type);
    const auto digits = [width](std::int64_t bits) {
        return QStringLiteral("0x")
            + hexText(bits, width)
                  .mid(2)
                  .rightJustified(2 * static_cast<qsizetype>(width), QLatin1Char('0'));
    };
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return digits(*whole);
    if (const auto *number = std::get_if<double>(&value))
        return digits(std::bit_cast<std::uint32_t>(static_cast<float>(*number)));
    return rawText(value);
}

QString rawText(const catalog::Value &value, int digits)
{
    if (const auto *text = std::get_if<std::string>(&value))
        return deviceText(*text);
    if (const auto *bytes = std::get_if<Bytes>(&value))
        return bytesText(*bytes);
    if (const auto *real = std::get_if<double>(&value))
        return floatText(*real, digits);
    const auto integer = std::get<std::int64_t>(value);
    return QString::number(integer);
}

} // namespace widgets

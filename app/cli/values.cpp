#include "values.h"

#include "base/overloaded.h"
#include "base/text.h"
#include "catalog/limits.h"
#include "catalog/names.h"
#include "option_values.h"
#include "sentences.h"

#include <QJsonArray>

#include <cmath>

namespace cli {

using catalog::Catalog;
using catalog::Meaning;
using catalog::RegisterId;
using catalog::RegisterInfo;
using catalog::Value;
using catalog::ValueType;

namespace {

/// Seven digits: more than a scale of a 16-bit number needs, without the noise of a product of two binary fractions.
QString shownText(double value) { return QString::number(value, 'g', 7); }

QStringList flagsOf(const RegisterInfo &info, std::int64_t number)
{
    QStringList names;
    const auto add = [&names](const std::vector<std::string> &list) {
        for (const std::string &name : list)
            names.append(utf8Text(name));
    };
    if (info.name == "FAULTS_FLAGS") {
        add(catalog::faultNames(static_cast<std::uint16_t>(number & 0xFFFF)));
        add(catalog::faultNames(static_cast<std::uint16_t>((number >> 16) & 0xFFFF)));
        names.removeDuplicates();
    } else {
        add(catalog::flagNames(info.name, static_cast<std::uint32_t>(number)));
    }
    return names;
}

/// As they are on the wire.
std::int64_t digitsOf(const RegisterInfo &info, std::int64_t number)
{
    return std::get<std::int64_t>(catalog::onWire(info, Value(number)));
}

QString integerText(const Catalog &catalog, RegisterId id, std::int64_t number, Digits digits)
{
    const RegisterInfo *info = catalog.find(id);
    const std::int64_t wire = info == nullptr ? number : digitsOf(*info, number);
    if (info == nullptr || digits == Digits::Raw)
        return QString::number(wire);
    if (info->meaning == Meaning::Enumeration)
        return QStringLiteral("%1 (%2)").arg(
            utf8Text(catalog::valueName(info->name, number)), QString::number(wire));
    if (info->meaning == Meaning::Flags) {
        const QStringList flags = flagsOf(*info, number);
        return flags.isEmpty() ? QStringLiteral("none") : flags.join(QStringLiteral(", "));
    }
    const catalog::Scale scale = catalog.readScale(id);
    const QString text = scale.factor == 1.0
        ? QString::number(number)
        : shownText(static_cast<double>(number) * scale.factor);
    return scale.unit.empty() ? text : text + QLatin1Char(' ') + utf8Text(scale.unit);
}

std::optional<double> numberOf(const QString &text)
{
    const std::string bytes = text.trimmed().toLatin1().toStdString();
    if (bytes.starts_with("0x") || bytes.starts_with("0X"))
        return numberIn<std::uint32_t>(std::string_view(bytes).substr(2), 16);
    return plainNumber(text);
}

} // namespace

QString idText(RegisterId id)
{
    return QStringLiteral("0x%1").arg(
        QString::number(id, 16).toUpper().rightJustified(4, QLatin1Char('0')));
}

QString valueText(const Catalog &catalog, RegisterId id, const Value &value, Digits digits)
{
    return std::visit(
        Overloaded{
            [&](std::int64_t number) { return integerText(catalog, id, number, digits); },
            [&](double number) {
                const catalog::Scale scale = catalog.readScale(id);
                const QString text =
                    digits == Digits::Raw ? numberText(number) : shownText(number * scale.factor);
                return digits == Digits::Raw || scale.unit.empty()
                    ? text
                    : text + QLatin1Char(' ') + utf8Text(scale.unit);
            },
            [](const std::string &text) { return plainText(text); },
            [](const Bytes &bytes) { return bytesText(bytes); },
        },
        value);
}

QJsonObject valueJson(const Catalog &catalog, RegisterId id, const Value &value, Digits digits)
{
    QJsonObject object{
        {QStringLiteral("name"), utf8Text(catalog.nameOf(id))}, {QStringLiteral("id"), idText(id)}};
    const RegisterInfo *info = catalog.find(id);
    const catalog::Scale scale = digits == Digits::Raw ? catalog::Scale{} : catalog.readScale(id);
    std::visit(
        Overloaded{
            [&](std::int64_t number) {
                const std::int64_t wire = info == nullptr ? number : digitsOf(*info, number);
                object[QStringLiteral("raw")] = static_cast<qint64>(wire);
                if (scale.factor == 1.0)
                    object[QStringLiteral("value")] = static_cast<qint64>(number);
                else
                    object[QStringLiteral("value")] = static_cast<double>(number) * scale.factor;
                if (info && info->meaning == Meaning::Enumeration)
                    object[QStringLiteral("text")] =
                        utf8Text(catalog::valueName(info->name, number));
                if (info && info->meaning == Meaning::Flags)
                    object[QStringLiteral("flags")] =
                        QJsonArray::fromStringList(flagsOf(*info, number));
            },
            [&](double number) {
                object[QStringLiteral("raw")] = number;
                object[QStringLiteral("value")] = number * scale.factor;
            },
            [&](const std::string &text) { object[QStringLiteral("value")] = plainText(text); },
            [&](const Bytes &bytes) { object[QStringLiteral("value")] = bytesText(bytes); },
        },
        value);
    object[QStringLiteral("unit")] = utf8Text(scale.unit);
    return object;
}

Outcome<Value> parseValue(const Catalog &catalog, RegisterId id, const QString &text, Digits digits)
{
    const RegisterInfo *info = catalog.find(id);
    const QString name = utf8Text(catalog.nameOf(id));
    if (info == nullptr)
        return failure(kUsage, QStringLiteral("%1 is not known and cannot be written.").arg(name));
    if (info->type == ValueType::Text)
        return Value(text.toStdString());
    if (info->type == ValueType::Raw) {
        auto bytes = bytesIn(text.toStdString());
        if (!bytes || bytes->empty())
            return failure(kUsage,
                QStringLiteral("%1 is a structure: write it as hexadecimal bytes, such as 01FF.")
                    .arg(name));
        return Value(std::move(*bytes));
    }
    const std::optional<double> number = numberOf(text);
    if (!number)
        return failure(kUsage,
            QStringLiteral("\"%1\" is no number for %2; the decimal sign is a point.")
                .arg(text, name));
    const double factor = digits == Digits::Raw ? 1.0 : catalog.readScale(id).factor;
    if (!catalog::isInteger(info->type))
        return Value(factor == 0.0 ? *number : *number / factor);
    const double raw = std::round(factor == 0.0 ? *number : *number / factor);
    const catalog::Limits limits = catalog::typeLimits(info->type);
    if (!limits.holds(raw)) {
        const double low = limits.least * factor;
        const double high = limits.greatest * factor;
        return failure(kUsage,
            QStringLiteral("%1 holds %2 to %3, not %4.")
                .arg(name, shownText(std::min(low, high)), shownText(std::max(low, high)), text));
    }
    const Value value(static_cast<std::int64_t>(raw));
    const auto meant = digits == Digits::Raw ? catalog::fromWire(*info, value) : value;
    if (!meant)
        return failure(kUsage, QStringLiteral("%1 has no digits %2.").arg(name, text));
    return *meant;
}

Outcome<RegisterId> resolveName(const Catalog &catalog, const QString &name)
{
    if (const auto id = catalog.resolve(name.toStdString()))
        return *id;
    return failure(kUsage,
        QStringLiteral(
            "This board has no register \"%1\"; rotorscope-cli registers lists what it has.")
            .arg(name));
}

Outcome<std::vector<RegisterId>> resolveNames(const Catalog &catalog, const QStringList &names)
{
    std::vector<RegisterId> ids;
    for (const QString &name : names) {
        const auto id = resolveName(catalog, name);
        if (!id)
            return tl::make_unexpected(id.error());
        ids.push_back(*id);
    }
    return ids;
}

QString bytesText(const Bytes &bytes)
{
    return QString::fromStdString(hexOf(bytes, " ", kLowerHex));
}

QString utf8Text(std::string_view utf8) { return QString::fromUtf8(utf8); }

} // namespace cli

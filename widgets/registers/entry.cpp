#include "widgets/registers/entry.h"

#include "base/text.h"
#include "catalog/names.h"
#include "drive/motion_limits.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <charconv>
#include <cmath>

namespace widgets {
namespace {

using catalog::Meaning;
using catalog::Value;
using catalog::ValueType;

constexpr qsizetype kLongestNumber = 64;
constexpr std::size_t kMostBytes = 512;
constexpr double kExactWhole = 9007199254740992.0; // 2^53

struct Entry {
    Q_DECLARE_TR_FUNCTIONS(Entry)
};

// What is wrong with a plain number is wrong with an entry, too: the same words in the same order.
static_assert(EntryError::TooLong == static_cast<EntryError>(SetpointError::TooLong)
    && EntryError::TwoPoints == static_cast<EntryError>(SetpointError::TwoPoints)
    && EntryError::NotANumber == static_cast<EntryError>(SetpointError::NotANumber));

Result<double, EntryError> readNumber(const QString &text)
{
    const auto number = readPlainNumber(text, kLongestNumber);
    if (!number)
        return fail(static_cast<EntryError>(number.error()));
    return *number;
}

/// "0x1F" of a width in bytes; nothing if it is not written so or does not fit.
std::optional<std::uint64_t> readHex(const QString &text, std::size_t width)
{
    if (!text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive) || text.size() > 18)
        return {};
    const auto bits = numberIn<std::uint64_t>(text.mid(2).toStdString(), 16);
    return bits && (width >= 8 || *bits >> (8 * width) == 0) ? bits : std::nullopt;
}

bool isSigned(ValueType type)
{
    return type == ValueType::S8 || type == ValueType::S16 || type == ValueType::S32;
}

Result<Value, EntryError> bounded(double raw, const EntryRules &rules)
{
    if (!std::isfinite(raw))
        return fail(EntryError::NotANumber);
    const bool whole = catalog::isInteger(rules.info->type);
    const double nearest = whole ? std::nearbyint(raw) : double(static_cast<float>(raw));
    if (!rules.limits.holds(nearest) || std::abs(nearest) > (whole ? kExactWhole : 3.5e38))
        return fail(EntryError::OutOfRange);
    const Value value = whole ? Value(static_cast<std::int64_t>(nearest)) : Value(nearest + 0.0);
    if (!catalog::refuseValue(*rules.info, value).empty())
        return fail(EntryError::NoSuchName);
    return value;
}

/// The text without the register's unit; fails on any other.
Result<QString, EntryError> withoutUnit(const QString &text, const EntryRules &rules)
{
    static const QRegularExpression kNumberAndRest(
        QStringLiteral("^([-+\u2212]?[0-9.,]*[0-9][.,]?)\\s*(.*)$"));
    const auto match = kNumberAndRest.match(text);
    if (!match.hasMatch() || match.captured(2).isEmpty())
        return text;
    const QString rest = match.captured(2).trimmed();
    const QString unit = QString::fromStdString(rules.scale.unit);
    for (const QString &known : {unit, unitText(unit)})
        if (!known.isEmpty() && rest.compare(known, Qt::CaseInsensitive) == 0)
            return match.captured(1);
    const bool looksLikeUnit =
        rest.front().isLetter() || rest.front() == QLatin1Char('%') || rest.front() == QChar(0xb0);
    static const QRegularExpression kExponent(QStringLiteral("^[eEpPxX][-+0-9]"));
    return fail(looksLikeUnit && !kExponent.match(rest).hasMatch() ? EntryError::OtherUnit
                                                                   : EntryError::NotANumber);
}

Result<Value, EntryError> readFlags(const QString &text, const EntryRules &rules)
{
    std::int64_t bits = 0;
    const auto names = catalog::namedFlags(rules.info->name);
    static const QRegularExpression kBetween(QStringLiteral("[,|+;]"));
    for (const QString &part : text.split(kBetween)) {
        const QString word = part.trimmed();
        const auto flag = valueNamed(names, word);
        if (!flag
            && !(word == Entry::tr("none", "no flag is set") || word == QLatin1String("none")))
            return fail(word.isEmpty() ? EntryError::Empty : EntryError::NoSuchName);
        bits |= flag.value_or(0);
    }
    return bounded(static_cast<double>(bits), rules);
}

/// Names of enumerations, flags and booleans; empty if the text is to be read as a number.
std::optional<Result<Value, EntryError>> readName(const QString &text, const EntryRules &rules)
{
    const bool startsAsNumber = text.front().isDigit() || text.front() == QLatin1Char('-')
        || text.front() == QLatin1Char('+');
    if (startsAsNumber && rules.info->meaning != Meaning::Enumeration
        && rules.info->meaning != Meaning::Flags)
        return {};
    switch (rules.info->meaning) {
    case Meaning::Boolean:
        for (const int yes : {0, 1})
            if (text.compare(booleanText(yes != 0), Qt::CaseInsensitive) == 0)
                return Value(std::int64_t{yes});
        return fail(EntryError::NoSuchName);
    case Meaning::Enumeration:
        if (const auto value = valueNamed(catalog::namedValues(rules.info->name), text))
            return bounded(static_cast<double>(*value), rules);
        break;
    case Meaning::Flags:
        if (!startsAsNumber || valueNamed(catalog::namedFlags(rules.info->name), text))
            return readFlags(text, rules);
        break;
    case Meaning::Number:
        return {};
    }
    return startsAsNumber ? std::nullopt
                          : std::optional<Result<Value, EntryError>>(fail(EntryError::NoSuchName));
}

/// As many as read back to the same number, without an exponent.
template <class Number>
QString plainDigits(Number number)
{
    char buffer[512];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed).ptr;
    return QString::fromLatin1(buffer, end - buffer);
}

QString flagsEntryText(std::int64_t bits, const catalog::RegisterInfo &info)
{
    QStringList words;
    for (const catalog::NamedValue &flag : catalog::namedFlags(info.name))
        if ((bits & flag.value) != 0) {
            words.append(valueNameText(flag.name));
            bits &= ~flag.value;
        }
    if (bits != 0)
        return {};
    return words.isEmpty() ? Entry::tr("none", "no flag is set") : words.join(QLatin1String(" | "));
}

/// Digits or bytes, as they are typed.
Result<Value, EntryError> readDigits(const QString &text, const EntryRules &rules)
{
    const QString typed = text.trimmed();
    if (rules.info->type == ValueType::Text)
        return fail(EntryError::CannotBeTyped);
    if (typed.isEmpty())
        return fail(EntryError::Empty);
    if (rules.info->type == ValueType::Raw) {
        static const QRegularExpression kBytes(QStringLiteral("^(?:[0-9A-Fa-f]{2}\\s*)+$"));
        if (!kBytes.match(typed).hasMatch())
            return fail(EntryError::NotBytes);
        const QByteArray content = QByteArray::fromHex(typed.toLatin1());
        if (static_cast<std::size_t>(content.size()) > kMostBytes)
            return fail(EntryError::TooLong);
        return Value(Bytes(content.begin(), content.end()));
    }
    const std::size_t width = catalog::widthOf(rules.info->type);
    if (typed.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) {
        const auto bits = readHex(typed, width);
        if (!bits || !catalog::isInteger(rules.info->type))
            return fail(EntryError::NotANumber);
        auto value = static_cast<std::int64_t>(*bits);
        if (isSigned(rules.info->type) && (*bits >> (8 * width - 1)) != 0)
            value -= std::int64_t{1} << (8 * width);
        return bounded(static_cast<double>(value), rules);
    }
    const auto number = readNumber(typed);
    if (!number)
        return fail(number.error());
    if (catalog::isInteger(rules.info->type) && *number != std::nearbyint(*number))
        return fail(EntryError::NotANumber);
    return bounded(*number, rules);
}

} // namespace

EntryRules entryRules(
    const catalog::RegisterInfo &info, const catalog::Scale &scale, const drive::MotorLimits &motor)
{
    EntryRules rules{&info, scale, catalog::writeLimits(info)};
    if (const double perDigit = drive::setPointPerDigit(info, scale, motor); perDigit > 0.0) {
        // What the board does not tell does not bound an entry: whether it may be sent is decided below.
        const drive::MotionBounds bounds = drive::boundsOf(motor, {}, true);
        const double greatest =
            info.setPoint == catalog::SetPoint::Speed ? bounds.rpm : bounds.amps;
        const double raw = std::floor(greatest / perDigit);
        rules.limits.least = std::max(rules.limits.least, -raw);
        rules.limits.greatest = std::min(rules.limits.greatest, raw);
    }
    return rules;
}

Result<Value, EntryError> readShownEntry(const QString &text, const EntryRules &rules)
{
    if (rules.info->type == ValueType::Text || rules.info->type == ValueType::Raw)
        return fail(EntryError::CannotBeTyped);
    const QString typed = text.trimmed();
    if (typed.isEmpty())
        return fail(EntryError::Empty);
    if (typed.size() > 4 * kLongestNumber)
        return fail(EntryError::TooLong);
    if (rules.info->meaning != Meaning::Number) {
        if (const auto value = readName(typed, rules))
            return *value;
        return readDigits(typed, rules);
    }
    const auto bare = withoutUnit(typed, rules);
    if (!bare)
        return fail(bare.error());
    const auto number = readNumber(*bare);
    if (!number)
        return fail(number.error());
    if (!(std::abs(rules.scale.factor) > 0.0) || !std::isfinite(rules.scale.factor))
        return fail(EntryError::CannotBeTyped);
    return bounded(*number / rules.scale.factor, rules);
}

Result<Value, EntryError> readRawEntry(const QString &text, const EntryRules &rules)
{
    const auto digits = readDigits(text, rules);
    if (!digits)
        return digits;
    const auto value = catalog::fromWire(*rules.info, *digits);
    return value ? Result<Value, EntryError>(*value) : fail(EntryError::NoSuchName);
}

QString shownEntryText(const Value &value, const EntryRules &rules)
{
    if (const auto *real = std::get_if<double>(&value))
        return std::isfinite(*real) ? plainDigits(static_cast<float>(*real * rules.scale.factor))
                                    : QString();
    const auto *whole = std::get_if<std::int64_t>(&value);
    if (whole == nullptr)
        return {};
    switch (rules.info->meaning) {
    case Meaning::Boolean:
        return *whole == 0 || *whole == 1 ? booleanText(*whole == 1) : QString::number(*whole);
    case Meaning::Enumeration:
        return valueNameText(catalog::valueName(rules.info->name, *whole));
    case Meaning::Flags: {
        const QString words = flagsEntryText(*whole, *rules.info);
        return words.isEmpty() ? QString::number(*whole) : words;
    }
    case Meaning::Number:
        break;
    }
    if (rules.scale.factor == 1.0)
        return QString::number(*whole);
    // As few digits as read back to the same raw number.
    const double shown = static_cast<double>(*whole) * rules.scale.factor;
    for (int decimals = decimalsFor(rules.scale.factor); decimals < 12; ++decimals) {
        const QString text = QString::number(shown, 'f', decimals);
        if (readShownEntry(text, {rules.info, rules.scale, catalog::writeLimits(*rules.info)})
            == Result<Value, EntryError>(value))
            return text;
    }
    return plainDigits(shown);
}

QString rawEntryText(const Value &value)
{
    if (const auto *bytes = std::get_if<Bytes>(&value))
        return QString::fromLatin1(QByteArray(
            reinterpret_cast<const char *>(bytes->data()), static_cast<qsizetype>(bytes->size()))
                                       .toHex(' '));
    if (const auto *real = std::get_if<double>(&value))
        return std::isfinite(*real) ? plainDigits(static_cast<float>(*real)) : QString();
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return QString::number(*whole);
    return {};
}

std::optional<Value> stepped(const Value &value, int steps, const EntryRules &rules)
{
    if (rules.info->meaning == Meaning::Flags)
        return {};
    double raw = rawNumber(value);
    if (!std::isfinite(raw))
        return {};
    const double step = catalog::isInteger(rules.info->type)
        ? 1.0
        : std::pow(10.0, std::floor(std::log10(std::max(std::abs(raw), 1e-6))) - 1.0);
    raw = std::clamp(raw + steps * step, rules.limits.least, rules.limits.greatest);
    const auto next = bounded(raw, rules);
    return next ? std::optional(*next) : std::nullopt;
}

QString entryErrorText(EntryError error, const EntryRules &rules)
{
    switch (error) {
    case EntryError::Empty:
    case EntryError::NotANumber:
    case EntryError::TwoPoints:
    case EntryError::TooLong:
        return setpointErrorText(static_cast<SetpointError>(error));
    case EntryError::OtherUnit:
        return Entry::tr("The unit here is %1.")
            .arg(rules.scale.unit.empty() ? Entry::tr("none", "no unit")
                                          : unitText(rules.scale.unit));
    case EntryError::OutOfRange: {
        const int decimals = decimalsFor(rules.scale.factor);
        const QString least = numberText(rules.limits.least * rules.scale.factor, decimals);
        if (rules.info->type == ValueType::F32)
            return rules.limits.least > -1e30 ? Entry::tr("Not less than %1.").arg(least)
                                              : Entry::tr("Too large a number.");
        return Entry::tr("From %1 to %2.", "the range of a value")
            .arg(least, numberText(rules.limits.greatest * rules.scale.factor, decimals));
    }
    case EntryError::NoSuchName:
        return Entry::tr("It has no such value.");
    case EntryError::NotBytes:
        return Entry::tr("Write pairs of hexadecimal digits, one pair for each byte.");
    case EntryError::CannotBeTyped:
        return Entry::tr("It cannot be edited here.");
    }
    return {};
}

} // namespace widgets

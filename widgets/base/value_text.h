// Numbers as the window shows them: in the unit people read, with digits that fit the resolution, so that a changing
// value keeps its width. Display only; files use capture's own writer.
#pragma once

#include "catalog/register_info.h"

#include <QLocale>
#include <QString>

#include <string_view>

namespace widgets {

/// Digits behind the point that one raw step of `factor` deserves, 0 to 4.
int decimalsFor(double factor);

/// The same without group marks, which take room and have another meaning elsewhere.
QLocale plainLocale(QLocale locale = {});

/// `value` in the locale's manner, group marks left out.
QString numberText(double value, int decimals);

/// The same with so many digits that count, and an exponent where they need one.
QString floatText(double value, int digits);

/// A unit as people read it: raw numbers, whose unit files and the command line call s16A, s16V or s16degree, are in
/// digits.
QString unitText(const QString &unit);
QString unitText(std::string_view unit);
/// What a digit of this unit is worth, one sentence; empty where the unit says it, or nothing does.
QString unitHelp(std::string_view unit);

/// Of a floating-point number, which has no step of its own.
constexpr int kFloatDigits = 6;

/// A register's value as shown, unit included; enumerations, flags, text and structures in their own manner.
/// @param digits  that count, of a floating-point number
QString shownText(const catalog::RegisterInfo &info, const catalog::Value &value,
    const catalog::Scale &scale, int digits = kFloatDigits);

/// A boolean register's value in words.
QString booleanText(bool yes);

/// The same value as the wire has it: digits, hexadecimal bytes for structures.
QString rawText(const catalog::Value &value, int digits = kFloatDigits);

/// Digits in hexadecimal, as many as the type has; the bits of a floating-point number; bytes as rawText() has them.
QString hexText(catalog::ValueType type, const catalog::Value &value);

/// The value as a number, raw; NaN for text and structures.
double rawNumber(const catalog::Value &value);

} // namespace widgets

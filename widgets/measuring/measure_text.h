// Measurements as text: their names, what they mean, a value with its unit, and why there is none; and
// their tables for the clipboard.
#pragma once

#include "capture/channel.h"
#include "scope/measurement.h"

#include <QList>
#include <QLocale>
#include <QString>

namespace widgets {

class RowTable;

/// A measurement by the names of its traces, so that it can be kept and asked for again.
struct NamedMeasure {
    QString signal;
    scope::Quantity quantity = scope::Quantity::Mean;
    QString against; ///< phase only
    bool operator==(const NamedMeasure &) const = default;
};

constexpr int kMostMeasures = 32;

/// In the order of a list to choose from.
QList<scope::Quantity> allQuantities();
QString quantityText(scope::Quantity quantity);
QString quantityWord(scope::Quantity quantity); ///< the same in every language, for files
std::optional<scope::Quantity> quantityOf(const QString &word);
QString quantityHelp(scope::Quantity quantity); ///< its definition in one sentence
QString whyNotText(scope::WhyNot why);

/// @param step  in which the channel's values are written
QString measuredText(double value, scope::UnitKind unit, const capture::ChannelInfo &channel,
    double step, const QLocale &locale);

/// The headings and every row as shown, tabs between columns, each line ended.
QString tableText(const RowTable &table);

} // namespace widgets

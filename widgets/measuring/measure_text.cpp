#include "widgets/measuring/measure_text.h"

#include "widgets/base/axis_ticks.h"
#include "widgets/base/reading_text.h"
#include "widgets/base/row_table.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace widgets {

namespace {
struct Measures {
    Q_DECLARE_TR_FUNCTIONS(Measures)
};

using scope::Quantity;

struct Entry {
    Quantity quantity;
    const char *name;
    const char *help;
};

constexpr Entry kEntries[] = {
    {Quantity::Min, QT_TRANSLATE_NOOP("Measures", "Minimum"),
        QT_TRANSLATE_NOOP("Measures", "The smallest sample")},
    {Quantity::Max, QT_TRANSLATE_NOOP("Measures", "Maximum"),
        QT_TRANSLATE_NOOP("Measures", "The largest sample")},
    {Quantity::PeakToPeak, QT_TRANSLATE_NOOP("Measures", "Peak to peak"),
        QT_TRANSLATE_NOOP("Measures", "Maximum minus minimum")},
    {Quantity::Mean, QT_TRANSLATE_NOOP("Measures", "Mean"),
        QT_TRANSLATE_NOOP("Measures", "The mean of all samples")},
    {Quantity::Rms, QT_TRANSLATE_NOOP("Measures", "RMS"),
        QT_TRANSLATE_NOOP("Measures", "The root of the mean square of all samples")},
    {Quantity::CycleMean, QT_TRANSLATE_NOOP("Measures", "Cycle mean"),
        QT_TRANSLATE_NOOP("Measures", "The mean over whole periods")},
    {Quantity::CycleRms, QT_TRANSLATE_NOOP("Measures", "Cycle RMS"),
        QT_TRANSLATE_NOOP("Measures", "The RMS over whole periods")},
    {Quantity::Frequency, QT_TRANSLATE_NOOP("Measures", "Frequency"),
        QT_TRANSLATE_NOOP("Measures", "Of whole periods, between upward crossings of the middle")},
    {Quantity::Period, QT_TRANSLATE_NOOP("Measures", "Period"),
        QT_TRANSLATE_NOOP("Measures", "The mean of whole periods")},
    {Quantity::Duty, QT_TRANSLATE_NOOP("Measures", "Duty"),
        QT_TRANSLATE_NOOP("Measures", "Share of a period above the middle level")},
    {Quantity::Rise, QT_TRANSLATE_NOOP("Measures", "Rise time"),
        QT_TRANSLATE_NOOP("Measures", "10 to 90 % of the first complete upward edge")},
    {Quantity::Fall, QT_TRANSLATE_NOOP("Measures", "Fall time"),
        QT_TRANSLATE_NOOP("Measures", "90 to 10 % of the first complete downward edge")},
    {Quantity::Overshoot, QT_TRANSLATE_NOOP("Measures", "Overshoot"),
        QT_TRANSLATE_NOOP("Measures", "Past the final value, in percent of the step")},
    {Quantity::Undershoot, QT_TRANSLATE_NOOP("Measures", "Undershoot"),
        QT_TRANSLATE_NOOP(
            "Measures", "To the wrong side of the initial value, in percent of the step")},
    {Quantity::PeakTime, QT_TRANSLATE_NOOP("Measures", "Peak time"),
        QT_TRANSLATE_NOOP("Measures", "From the step to the largest deviation")},
    {Quantity::Settling, QT_TRANSLATE_NOOP("Measures", "Settling time"),
        QT_TRANSLATE_NOOP("Measures",
            "From the step to the last entry into 2 % of the step around the final value, which is "
            "the mean of the last 20 %")},
    {Quantity::DeadTime, QT_TRANSLATE_NOOP("Measures", "Dead time"),
        QT_TRANSLATE_NOOP("Measures", "From the step to 5 % of it")},
    {Quantity::Ripple, QT_TRANSLATE_NOOP("Measures", "Ripple"),
        QT_TRANSLATE_NOOP("Measures", "Peak to peak once settled")},
    {Quantity::RippleRms, QT_TRANSLATE_NOOP("Measures", "Ripple RMS"),
        QT_TRANSLATE_NOOP("Measures", "RMS around the mean once settled")},
    {Quantity::Phase, QT_TRANSLATE_NOOP("Measures", "Phase"),
        QT_TRANSLATE_NOOP("Measures", "By how much the second trace is ahead of the first")},
};

/// In the order of scope::WhyNot.
constexpr std::array kWhyNot{QT_TRANSLATE_NOOP("Measures", "no samples"),
    QT_TRANSLATE_NOOP("Measures", "samples are missing inside"),
    QT_TRANSLATE_NOOP("Measures", "no full period"),
    QT_TRANSLATE_NOOP("Measures", "no complete edge"), QT_TRANSLATE_NOOP("Measures", "no step"),
    QT_TRANSLATE_NOOP("Measures", "not settled"),
    QT_TRANSLATE_NOOP("Measures", "no set-point given"),
    QT_TRANSLATE_NOOP("Measures", "not the same frequency")};

const Entry *entryOf(Quantity quantity)
{
    const auto *found = std::find_if(std::begin(kEntries), std::end(kEntries),
        [quantity](const Entry &entry) { return entry.quantity == quantity; });
    return found == std::end(kEntries) ? nullptr : found;
}

/// Four digits of it, whatever its size.
double digits(double value)
{
    const double size = std::abs(value);
    return size > 0 && std::isfinite(size) ? std::pow(10.0, std::floor(std::log10(size)) - 3.0)
                                           : 0.001;
}

/// With them as well: between two samples an edge is a guess.
QString readTime(double seconds, const QLocale &locale)
{
    const double size = std::abs(seconds);
    const QString text = timeLabel(seconds, digits(seconds), size, locale);
    return QString(text).replace(QLatin1Char('-'), QChar(0x2212));
}
} // namespace

QList<Quantity> allQuantities()
{
    QList<Quantity> all;
    for (const Entry &entry : kEntries)
        all.append(entry.quantity);
    return all;
}

QString quantityText(Quantity quantity)
{
    const Entry *entry = entryOf(quantity);
    return entry ? Measures::tr(entry->name) : QString();
}

QString quantityWord(Quantity quantity)
{
    const Entry *entry = entryOf(quantity);
    return entry ? QLatin1String(entry->name) : QString();
}

std::optional<Quantity> quantityOf(const QString &word)
{
    for (const Entry &entry : kEntries)
        if (word == QLatin1String(entry.name))
            return entry.quantity;
    return {};
}

QString quantityHelp(Quantity quantity)
{
    const Entry *entry = entryOf(quantity);
    return entry ? Measures::tr(entry->help) : QString();
}

QString whyNotText(scope::WhyNot why)
{
    return Measures::tr(kWhyNot.at(static_cast<std::size_t>(why)));
}

QString measuredText(double value, scope::UnitKind unit, const capture::ChannelInfo &channel,
    double step, const QLocale &locale)
{
    const QString own = unitText(channel.unit);
    switch (unit) {
    case scope::UnitKind::Channel: // a tenth of a digit means something in a mean
        return readingText(value, step / 10.0, own, locale);
    case scope::UnitKind::Seconds:
        return readTime(value, locale);
    case scope::UnitKind::Hertz:
        return inverseTime(1.0 / value, locale);
    case scope::UnitKind::Percent:
        return readingText(value, 0.01, QStringLiteral("%"), locale);
    case scope::UnitKind::Degrees:
        return readingText(value, 0.01, QStringLiteral("\u00b0"), locale);
    case scope::UnitKind::ChannelSeconds:
        return readingText(value, digits(value), own + QStringLiteral(" s"), locale);
    case scope::UnitKind::ChannelSecondsSquared:
        return readingText(value, digits(value), own + QStringLiteral(" s\u00b2"), locale);
    }
    return {};
}

QString tableText(const RowTable &table)
{
    QString text = table.titlesText() + QLatin1Char('\n');
    for (int row = 0; row < table.rowCount(); ++row)
        text += rowText(table.index(row, 0)) + QLatin1Char('\n');
    return text;
}

} // namespace widgets

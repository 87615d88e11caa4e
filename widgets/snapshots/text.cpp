#include "widgets/snapshots/text.h"

#include "catalog/names.h"
#include "session/files/problems.h"
#include "widgets/base/device_text.h"
#include "widgets/base/register_texts.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>
#include <cmath>

namespace widgets {
namespace {

const QString kDash = QStringLiteral("\u2013");

struct SnapshotText {
    Q_DECLARE_TR_FUNCTIONS(Snapshot)
};

QString joined(const std::vector<std::string> &names)
{
    const QStringList words = valueNameTexts(names);
    return words.isEmpty() ? SnapshotText::tr("none", "no flag is set")
                           : words.join(QStringLiteral(" | "));
}

QString wholeText(const snapshots::Entry &entry, std::int64_t raw)
{
    if (!catalog::namedValues(entry.name).empty())
        return valueNameText(catalog::valueName(entry.name, raw));
    if (!catalog::namedFlags(entry.name).empty() && !catalog::holdsPastFaults(entry.name))
        return joined(catalog::flagNames(entry.name, static_cast<std::uint32_t>(raw)));
    const double shown = entry.shown.value_or(static_cast<double>(raw));
    const double factor = raw != 0 ? shown / static_cast<double>(raw) : 1.0;
    return std::isfinite(shown) ? numberText(shown, decimalsFor(factor)) : kDash;
}

/// In the order of snapshots::NotRestored.
constexpr std::array kNotRestored{
    QT_TRANSLATE_NOOP("Snapshot", "This board does not have it, or it cannot be written there."),
    QT_TRANSLATE_NOOP("Snapshot", "It holds something else in this firmware."),
    QT_TRANSLATE_NOOP("Snapshot", "Not restored: it moves a motor."),
    QT_TRANSLATE_NOOP("Snapshot", "Writing it can move something, and its motor is not idle."),
    QT_TRANSLATE_NOOP("Snapshot", "Firmware gives it in another form than it takes it.")};

} // namespace

QString snapshotValueText(const snapshots::Entry *entry)
{
    if (entry == nullptr)
        return kDash;
    if (const auto *whole = std::get_if<std::int64_t>(&entry->value))
        return wholeText(*entry, *whole);
    if (const auto *number = std::get_if<double>(&entry->value))
        return floatText(entry->shown.value_or(*number), 7);
    return snapshotRawText(entry);
}

QString snapshotRawText(const snapshots::Entry *entry)
{
    return entry != nullptr ? deviceText(rawText(entry->value)) : kDash;
}

QString snapshotFileErrorText(const QString &file, session::SnapshotFileError error)
{
    error.name = deviceText(error.name);
    return session::snapshotProblemText(
        fileNameText(file), error, [](const char *english) { return SnapshotText::tr(english); });
}

QString notRestoredText(snapshots::NotRestored why)
{
    return SnapshotText::tr(kNotRestored.at(static_cast<std::size_t>(why)));
}

QString suggestedFileName(const QDateTime &now, const QString &what)
{
    return QLocale::c().toString(now, QStringLiteral("yyyy-MM-dd_HH-mm-ss"))
        + QStringLiteral("_motor_") + what;
}

} // namespace widgets

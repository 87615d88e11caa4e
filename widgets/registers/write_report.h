// What became of a list of writes, register by register, in words. Nothing is rounded off: what was sent and never
// answered is neither written nor not written.
#pragma once

#include "drive/event.h"

#include <QMetaType>
#include <QStringList>

namespace widgets {

struct WriteReport {
    QStringList written; ///< and read back as written
    QStringList unproved; ///< taken, not read back or shown only later; the reason if there is one
    QStringList different; ///< taken, but another value is read back
    QStringList notWritten; ///< certainly; with the reason behind each
    QStringList unknown; ///< sent, and the answer never came
    QString text; ///< what the list was called, see RegisterEdits::write()
    QString sentence; ///< all of it, long lists cut short

    bool good() const { return different.isEmpty() && notWritten.isEmpty() && unknown.isEmpty(); }
};

enum class WriteSense : std::uint8_t { Forward, Back };

/// @param asked    what was to be written; what the end does not name shares its outcome
/// @param catalog  for the names; nullptr: ids are shown
/// @param sense    Back: it was an undo
WriteReport writeReport(const drive::Ended &ended, const std::vector<drive::RegisterWrite> &asked,
    const catalog::Catalog *catalog, WriteSense sense);

} // namespace widgets

Q_DECLARE_METATYPE(widgets::WriteReport)

// Snapshots between the board, files and the screen.
#pragma once

#include "commands.h"
#include "tuning/snapshot.h"

namespace cli {

struct BoardSnapshot {
    tuning::Snapshot snapshot;
    QStringList unanswered; ///< registers that may be there and whose answer never came
    TimePoint at; ///< of the newest value
};

/// What the board holds now.
Outcome<BoardSnapshot> readBoard(Desk &desk, tuning::Scope scope);

/// Puts the file in place, whole or not at all.
Outcome<int> saveFile(const QString &path, const QByteArray &content);
/// The content of a text file that a person made.
Outcome<QByteArray> loadFile(const QString &path);
Outcome<tuning::Snapshot> loadSnapshot(const QString &path);

/// -o, which must be there.
Outcome<bool> takeOutput(const Given &given, Arguments &arguments);
/// --only, of groups and registers.
Outcome<bool> takeOnly(const Given &given, Arguments &arguments);

/// What --only names; a usage failure if something in it fits no register of either snapshot.
Outcome<tuning::Selection> selectionOf(
    const Arguments &arguments, const tuning::Snapshot &a, const tuning::Snapshot &b);

} // namespace cli

// Snapshots between the board, files and the screen.
#pragma once

#include "commands.h"
#include "snapshots/snapshot.h"

namespace cli {

struct BoardSnapshot {
    snapshots::Snapshot snapshot;
    QStringList unanswered; ///< registers that may be there and whose answer never came
    TimePoint at; ///< of the newest value
};

/// What the board holds now.
Outcome<BoardSnapshot> readBoard(Desk &desk, snapshots::Scope scope);

/// Puts the file in place, whole or not at all.
Outcome<int> saveFile(const QString &path, const QByteArray &content);
/// The content of a text file that the user made.
Outcome<QByteArray> loadFile(const QString &path);
Outcome<snapshots::Snapshot> loadSnapshot(const QString &path);

/// -o, which must be there.
Outcome<bool> parseOutput(const Given &given, Arguments &arguments);
/// --only, of groups and registers.
Outcome<bool> parseOnly(const Given &given, Arguments &arguments);

/// What --only names; a usage failure if something in it fits no register of either snapshot.
Outcome<snapshots::Selection> selectionOf(
    const Arguments &arguments, const snapshots::Snapshot &a, const snapshots::Snapshot &b);

} // namespace cli

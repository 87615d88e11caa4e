// Snapshots as JSON text, for files that people compare and keep in version control. One register a line, in a
// stable order, no time in it: the same values give the same bytes. docs/snapshot.md describes the form.
#pragma once

#include "base/result.h"
#include "snapshots/snapshot.h"

#include <QByteArray>
#include <QString>

namespace session {

QByteArray snapshotJson(const snapshots::Snapshot &snapshot);

/// What is wrong with a file.
enum class SnapshotProblem : std::uint8_t {
    NotJson,
    NotASnapshot,
    NewerVersion,
    NoRegisters, ///< no list of them
    TooManyRegisters,
    // Of one register:
    NoName,
    NoMotor, ///< none from 0 to 7
    NoId,
    NoType,
    NumberDoesNotFit, ///< its type
    NoNumber, ///< a float without bits and without digits
    NoText,
    NotBytes, ///< no hexadecimal digits
    Twice,
};

struct SnapshotFileError {
    SnapshotProblem problem = SnapshotProblem::NotJson;
    int line = 0; ///< in the file, from 1; 0: nowhere in particular
    int number = 0; ///< of the register in the list, from 1; 0: of none
    QString name; ///< of the register, if it has one: text of the file
    QString parserText; ///< of NotJson: the parser's words
};

/// The snapshot in a file's content, or what is wrong and where. Members that are not known are passed over; a register
/// that does not make sense is an error.
Result<snapshots::Snapshot, SnapshotFileError> readSnapshotJson(const QByteArray &text);

} // namespace session

// What became of a list of writes, register by register, also when the connection broke in the middle.
#pragma once

#include "commands.h"
#include "values.h"

namespace cli {

/// Writes a list and prints each as old -> new, as read back; without --json none of which nothing is known. The motor
/// is armed for it.
/// @param what  begins the sentence about a broken connection, e.g. "The restore"
/// @return  kDone if every one was written and, where it can be read, read back as written, or shows only later
Outcome<int> writeAndReport(
    Desk &desk, const drive::Write &write, Digits digits, const QString &what);

} // namespace cli

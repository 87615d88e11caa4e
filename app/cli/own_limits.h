// The limits that a person has set in the window hold for the command line, too, unless it is given others.
#pragma once

#include "arguments.h"

namespace cli {

/// Adds those of the file to the arguments of a command that can move a motor, and says so on standard error. A file that
/// cannot be read ends such a command, unless both limits are given.
Outcome<bool> addOwnLimits(Arguments &arguments, const QString &file);

} // namespace cli

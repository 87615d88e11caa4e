// A clock that goes on while the computer sleeps, which the one that timers run by does not. Only differences count.
#pragma once

#include "base/time.h"

namespace session {

/// Since some fixed time; from any thread.
TimePoint elapsedTime();

} // namespace session

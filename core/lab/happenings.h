// What happened while an experiment was recorded, and its signals, as a recording has them.
#pragma once

#include "capture/capture.h"
#include "record/entry.h"

#include <string>
#include <utility>
#include <vector>

namespace lab {

using capture::Nanos;

/// By their time.
using Happenings = std::vector<std::pair<Nanos, record::Happening>>;

/// Nothing reached the board any more. One that is out of step for a moment goes on with what it was told.
bool endsLink(const record::Happening &what);

/// Without what was asked for and not sent, or refused: it moved nothing, whether or not it was asked for again.
Happenings carriedOut(const Happenings &all);

/// The signal of this name that was recorded at the control rate; nullptr: none, or the name is empty.
const capture::Channel *fastChannel(const capture::Capture &capture, const std::string &name);

} // namespace lab

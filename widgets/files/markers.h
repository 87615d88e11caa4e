// Markers by their times: what a recording or a list has of them, or should have.
#pragma once

#include "capture/tick_time.h"

#include <QString>

#include <map>

namespace widgets {

class EventLog;

using Markers = std::map<capture::Nanos, QString>;

Markers markersOf(const EventLog &events);

/// As comma-separated text: a heading, then seconds and words, a line each; what a spreadsheet would take for a formula
/// gets a leading apostrophe (docs/csv.md).
QByteArray markerList(const Markers &markers);

} // namespace widgets

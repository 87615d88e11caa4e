// One decoded packet as a JSON object. Its keys are those of the recorded sessions' `expect`, so that the two can be
// compared; numbers are as they are on the wire.
#pragma once

#include "mcp/trace_decoder.h"

#include <QByteArray>
#include <QString>

namespace cli {

/// @param packet  0-based number of the packet in its file
QByteArray traceJson(
    const mcp::TraceItem &item, qint64 packet, double time_ms, const QString &direction);

} // namespace cli

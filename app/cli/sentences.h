// One sentence for each way a connection or a file can fail, which says what to do. In English: scripts and logs read
// them.
#pragma once

#include "arguments.h"
#include "drive/event.h"
#include "session/files/whole_file.h"
#include "session/transports/endpoint.h"

namespace cli {

QString sentenceOf(const session::PortError &error, const Arguments &arguments);
QString sentenceOf(drive::LinkReason reason, const Arguments &arguments);
/// Of a file that was not written.
QString sentenceOf(const session::FileResult &file, const QString &path);
/// Names of states and faults, e.g. "FAULT_NOW (SPEED_FDBK)".
QString stateText(const drive::MotorStatus &status);
/// Device text for one line: without control characters, bounded.
QString plainText(const std::string &text);

} // namespace cli

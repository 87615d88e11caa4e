// A rev-up as a file, the same for the window and the command line: what `rotorscope-cli revup --json` prints and
// `revup --set` reads. Amperes are for people; digits, where they are there, count.
#pragma once

#include "analysis/rev_up.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>

namespace session {

/// One object a stage: speed_rpm, current_a (if the scale is known), current_digits, duration_ms.
/// @param ampsPerDigit  0: not known
QJsonArray revUpStagesJson(const analysis::RevUp &stages, double ampsPerDigit);
/// The whole file: {"stages": [...], "duration_s": ...}, indented.
QByteArray revUpJson(const analysis::RevUp &stages, double ampsPerDigit);

/// The stages in a file's content, as many as it has; or one sentence without a full stop that says what is wrong.
/// Members that are not known are passed over; a number that does not fit the register is an error.
Result<analysis::RevUp, QString> readRevUpJson(const QByteArray &text, double ampsPerDigit);

} // namespace session

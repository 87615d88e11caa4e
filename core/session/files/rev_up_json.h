// A rev-up as a file, the same for the window and the command line: what `rotorscope-cli revup --json` prints and
// `revup --set` reads. Amperes are for people; digits, where they are there, count.
#pragma once

#include "motor/rev_up.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>

namespace session {

/// One object a stage: speed_rpm, current_a (if the scale is known), current_digits, duration_ms.
/// @param ampsPerDigit  0: not known
QJsonArray revUpStagesJson(const motor::RevUp &stages, double ampsPerDigit);
/// The whole file: {"stages": [...], "duration_s": ...}, indented.
QByteArray revUpJson(const motor::RevUp &stages, double ampsPerDigit);

struct RevUpFileError {
    enum class Kind : std::uint8_t {
        NotJson,
        NoStages, ///< or more than five
        BadStage, ///< a number of it is missing or does not fit the register
    } kind = Kind::NotJson;
    int stage = 0; ///< of BadStage, from 1
};

/// The stages in a file's content, as many as it has, or what is wrong with it. Members that are not known are passed
/// over.
Result<motor::RevUp, RevUpFileError> readRevUpJson(const QByteArray &text, double ampsPerDigit);

} // namespace session

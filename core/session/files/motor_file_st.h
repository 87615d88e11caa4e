// What ST's tools save of a motor: a flat JSON object, read for motor_file.h. Facts: docs/motor-file.md.
#pragma once

#include "session/files/motor_file.h"

class QJsonObject;

namespace session {

/// By the keys that only ST's files have.
bool isStMotor(const QJsonObject &object);

/// What it says, laid over the first preset. Unknown keys are passed over.
Result<MotorFile, MotorFileError> readStMotor(const QJsonObject &object);

} // namespace session

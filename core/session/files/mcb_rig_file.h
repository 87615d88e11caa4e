// A static MCB slave as a JSON file: docs/simulator.md describes it. A file is taken whole or not at all.
#pragma once

#include "base/result.h"
#include "simulation/mcb/registers.h"

#include <QByteArray>
#include <QString>

namespace session {

/// The rig, or one sentence that names the key that is wrong. Members that are not known are passed over.
Result<simulation::McbRig, QString> readMcbRig(const QByteArray &json);
Result<simulation::McbRig, QString> readMcbRigFile(const QString &path);

} // namespace session

// Rigs of the older serial protocol from JSON files: what a static simulated board is and holds. A file is taken whole
// or not at all; keys that are not known are passed over.
#pragma once

#include "base/result.h"
#include "simulation/fcp/server.h"

#include <QByteArray>
#include <QString>

#include <string>

namespace session {

/// The rig, or one sentence about what is wrong and where.
Result<simulation::FcpRig, std::string> readFcpRig(const QByteArray &json);
Result<simulation::FcpRig, std::string> readFcpRigFile(const QString &path);

} // namespace session

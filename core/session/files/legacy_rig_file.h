// Rigs of the older serial protocol from JSON files: what a static simulated board is and holds. A file is taken whole or
// not at all; keys that are not known are passed over.
#pragma once

#include "base/result.h"
#include "simulation/legacy/rig.h"

#include <QByteArray>
#include <QString>

#include <string>

namespace session {

/// The rig, or one sentence about what is wrong and where.
Result<simulation::LegacyRig, std::string> readLegacyRig(const QByteArray &json);
Result<simulation::LegacyRig, std::string> readLegacyRigFile(const QString &path);

} // namespace session

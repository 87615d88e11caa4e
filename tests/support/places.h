// Where the tests find what is not compiled into them.
#pragma once

#include <QString>

namespace support {

QString dataFile(const QString &name); ///< of tests/data, as "vectors/legacy.jsonl"
QString sourceFile(const QString &name); ///< of the tree, as "translations/rotorscope_de.ts"
QString programFile(const QString &name); ///< of this build, as "rotorscope-cli"
QString capturesFolder(); ///< captures of real boards; empty where there are none

} // namespace support

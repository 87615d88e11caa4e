#include "places.h"

namespace support {

QString dataFile(const QString &name) { return sourceFile(QStringLiteral("tests/data/") + name); }

QString sourceFile(const QString &name) { return QStringLiteral(ROTORSCOPE_SOURCE "/") + name; }

QString programFile(const QString &name) { return QStringLiteral(ROTORSCOPE_BUILD "/bin/") + name; }

QString capturesFolder() { return QStringLiteral(ROTORSCOPE_CAPTURES); }

} // namespace support

// Register values as people write and read them: shown in A, V, rpm and degrees, or as the digits on the wire.
#pragma once

#include "catalog/catalog.h"
#include "drive/event.h"
#include "output.h"

#include <QJsonObject>

namespace cli {

enum class Digits : std::uint8_t { Shown, Raw };

/// "1.25 A", "RUN", "0x12 0x34": in one line.
QString valueText(const catalog::Catalog &catalog, catalog::RegisterId id,
    const catalog::Value &value, Digits digits);
/// name, id, value, unit, raw, text (of an enumeration), faults or flags.
QJsonObject valueJson(const catalog::Catalog &catalog, catalog::RegisterId id,
    const catalog::Value &value, Digits digits);

/// What to write for `text`; a usage failure if it is no such value.
Outcome<catalog::Value> parseValue(
    const catalog::Catalog &catalog, catalog::RegisterId id, const QString &text, Digits digits);

/// The register of NAME or NAME@MOTOR; a usage failure if there is none.
Outcome<catalog::RegisterId> resolveName(const catalog::Catalog &catalog, const QString &name);
/// Several of them, in order.
Outcome<std::vector<catalog::RegisterId>> resolveNames(
    const catalog::Catalog &catalog, const QStringList &names);

QString utf8Text(std::string_view utf8);
QString bytesText(const Bytes &bytes); ///< "12 34"
QString idText(catalog::RegisterId id); ///< "0x08D1"

} // namespace cli

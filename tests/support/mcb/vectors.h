// The rows of tests/data/vectors/mcb.jsonl, and the slave that they speak with.
#pragma once

#include "mcb/value.h"
#include "simulation/mcb/registers.h"
#include "support/places.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <bit>
#include <optional>
#include <vector>

namespace support {

inline Bytes bytesOfHex(const QString &hex)
{
    const QByteArray bytes = QByteArray::fromHex(hex.toLatin1());
    return {bytes.begin(), bytes.end()};
}

inline QString hexOf(ByteView bytes)
{
    return QString::fromLatin1(
        QByteArray(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size())).toHex());
}

inline mcb::Words wordsOfHex(const QJsonArray &list)
{
    mcb::Words words;
    for (const auto &one : list)
        words.push_back(static_cast<std::uint16_t>(one.toString().toUInt(nullptr, 16)));
    return words;
}

/// Row 0 describes the slave. Empty if the file cannot be read.
inline std::vector<QJsonObject> mcbVectors()
{
    QFile file(support::dataFile(QStringLiteral("vectors/mcb.jsonl")));
    std::vector<QJsonObject> rows;
    if (file.open(QIODevice::ReadOnly)) {
        while (!file.atEnd())
            rows.push_back(QJsonDocument::fromJson(file.readLine()).object());
    }
    return rows;
}

namespace detail {

/// "u16 rx rw 0", "string 16 r 0.1.2": type, perhaps size and direction, access, value.
inline simulation::McbRegister mcbRegister(const QString &address, const QString &text)
{
    const QStringList parts = text.split(QLatin1Char(' '));
    const QString kind = parts.first(), value = parts.last();
    mcb::Info info;
    info.access = parts.contains(QLatin1String("rw")) ? catalog::Access::ReadWrite
        : parts.contains(QLatin1String("w"))          ? catalog::Access::Write
                                                      : catalog::Access::Read;
    info.cyclic = parts.contains(QLatin1String("rx")) ? mcb::Cyclic::Rx
        : parts.contains(QLatin1String("tx"))         ? mcb::Cyclic::Tx
                                                      : mcb::Cyclic::ConfigOnly;
    info.type = kind == QLatin1String("string") ? mcb::Type::Text
        : kind == QLatin1String("float")        ? mcb::Type::Float
        : kind == QLatin1String("s16")          ? mcb::Type::Int16
        : kind == QLatin1String("u16")          ? mcb::Type::UInt16
        : kind == QLatin1String("s32")          ? mcb::Type::Int32
                                                : mcb::Type::UInt32;
    info.size = static_cast<std::uint8_t>(kind == QLatin1String("string") ? parts[1].toUInt()
            : kind.endsWith(QLatin1String("16"))                          ? 2
                                                                          : 4);
    catalog::Value content = std::int64_t{value.toLongLong(nullptr, 0)};
    if (info.type == mcb::Type::Text)
        content = value.toStdString();
    else if (info.type == mcb::Type::Float)
        content = value.toDouble();
    const auto order = address == QLatin1String("0x6E5") ? mcb::TextOrder::LowByteFirst
                                                         : mcb::TextOrder::HighByteFirst;
    return {info, mcb::encodeValue(info, content, order).value_or(mcb::Words())};
}

} // namespace detail

/// The slave of row 0 with what `row` says besides.
inline simulation::McbRig mcbRig(const QJsonObject &head, const QJsonObject &row)
{
    simulation::McbRig rig;
    rig.replyDelay = row[QLatin1String("slave_delay")].toInt();
    const QJsonObject slave = head[QLatin1String("slave")].toObject();
    for (auto it = slave.begin(); it != slave.end(); ++it) {
        if (!it.key().contains(QLatin1Char('-'))) // the mapping registers are always there
            rig.registers[static_cast<std::uint16_t>(it.key().toUInt(nullptr, 0))] =
                detail::mcbRegister(it.key(), it.value().toString());
    }
    const QJsonObject extra = row[QLatin1String("extra_registers")].toObject();
    for (auto it = extra.begin(); it != extra.end(); ++it) {
        const QJsonObject object = it.value().toObject();
        rig.registers[static_cast<std::uint16_t>(it.key().toUInt(nullptr, 0))] = {
            {static_cast<std::uint8_t>(object[QLatin1String("size")].toInt()), mcb::Type::Text,
                mcb::Cyclic::ConfigOnly, catalog::Access::ReadWrite},
            wordsOfHex(object[QLatin1String("words")].toArray())};
    }
    return rig;
}

} // namespace support

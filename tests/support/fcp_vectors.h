// The vectors of the older serial protocol, read from tests/data/vectors/legacy.jsonl: conversations of requests,
// answers and events, and what they mean.
#pragma once

#include "base/bytes.h"
#include "fcp/protocol.h"
#include "support/places.h"

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include <vector>

namespace support {

inline Bytes bytesOfHex(const QString &hex)
{
    const QByteArray bytes = QByteArray::fromHex(hex.toLatin1());
    return {bytes.begin(), bytes.end()};
}

struct FcpVector {
    QString name;
    fcp::Dialect dialect = fcp::Dialect::Stm32;
    bool exchange = true; ///< false: a frame that the board sends unasked
    QString rig; ///< "A", "B", "P"
    QString event; ///< what happens to the board before it
    Bytes request, reply;
    QJsonObject decoded;
    bool openError = false; ///< documents allow more than one code
};

/// Rows that belong together, in order; the rig is filled in.
using FcpConversation = std::vector<FcpVector>;

inline std::vector<FcpConversation> readFcpVectors()
{
    QFile file(support::dataFile(QStringLiteral("vectors/legacy.jsonl")));
    std::vector<FcpConversation> conversations;
    if (!file.open(QIODevice::ReadOnly))
        return conversations;
    QString group;
    while (!file.atEnd()) {
        const QJsonObject line = QJsonDocument::fromJson(file.readLine()).object();
        const auto text = [&](const char *key) { return line[QLatin1String(key)].toString(); };
        if (text("kind") == QLatin1String("meta") || line.isEmpty())
            continue;
        FcpVector row;
        row.name = text("name");
        row.exchange = text("kind") == QLatin1String("exchange");
        if (text("dialect") == QLatin1String("powerpc"))
            row.dialect = fcp::Dialect::PowerPc;
        row.event = text("event");
        row.request = bytesOfHex(text("request"));
        row.reply = bytesOfHex(text("reply"));
        row.decoded = line[QLatin1String("decoded")].toObject();
        row.openError = row.decoded.value(QLatin1String("error")).isArray();
        row.rig = text("rig");
        if (group.isEmpty() || text("group") != group)
            conversations.emplace_back();
        group = text("group");
        conversations.back().push_back(row);
    }
    for (FcpConversation &rows : conversations) {
        QString common = rows.front().dialect == fcp::Dialect::PowerPc ? QStringLiteral("P")
                                                                       : QStringLiteral("A");
        for (const FcpVector &row : rows) {
            if (!row.rig.isEmpty())
                common = row.rig;
        }
        for (FcpVector &row : rows)
            row.rig = common;
    }
    return conversations;
}

} // namespace support

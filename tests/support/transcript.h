// A recorded session between a Controller and a board, read from tests/data/transcripts.
#pragma once

#include "base/bytes.h"
#include "base/time.h"
#include "simulation/simulated_board.h"

#include <QByteArray>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QString>

#include <optional>
#include <vector>

namespace support {

struct TranscriptRow {
    enum class From { Controller, Board, Person };
    From from = From::Controller;
    Duration time{};
    Bytes bytes;
    QString note;
    QString type; ///< BEACON, PING, ERROR, REQUEST, RESPONSE, ASYNC, "not a valid packet", "event"
    bool partial = false; ///< ASYNC: shorter than a full packet
};

struct Transcript {
    simulation::BoardOptions board;
    std::vector<TranscriptRow> rows;
};

namespace detail {

inline simulation::BoardOptions boardOptions(const QJsonObject &performer)
{
    const QString firmware = performer[QLatin1String("firmware")].toString();
    const auto number = [&](const char *key, int usual) {
        return performer[QLatin1String(key)].toInt(usual);
    };
    simulation::BoardOptions options;
    const auto version = QRegularExpression(QStringLiteral("MCSDK (\\d+\\.\\d+)")).match(firmware);
    options.profile = "mcsdk-" + version.captured(1).toStdString();
    options.nullCheck = firmware.contains(QLatin1String("NULL_PTR_CHECK"));
    options.rxMax = static_cast<std::size_t>(number("rx_max", 256));
    options.txSyncMax = static_cast<std::size_t>(number("txs_max", 256));
    options.txAsyncMax = static_cast<std::size_t>(number("txa_max", 2048));
    options.dataCrc = number("crc", 0) != 0;
    options.version = number("version", 0);
    options.linkId = number("liid", 0);
    options.streams = number("streams", 10);
    options.baud = static_cast<std::uint32_t>(number("baud", 1843200));
    options.hfHz = number("hf_hz", 20000);
    options.firstTimestamp =
        static_cast<std::uint32_t>(performer[QLatin1String("ts0")].toDouble(0));
    const QJsonValue wide = performer[QLatin1String("wide")];
    options.wide = wide.toBool() || wide.toInt() != 0;
    options.userCallbacks = number("user_cb", 0);
    return options;
}

} // namespace detail

/// Empty if the file cannot be read or is none.
inline std::optional<Transcript> readTranscript(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    const QJsonObject head = QJsonDocument::fromJson(file.readLine()).object();
    if (!head.contains(QLatin1String("performer")))
        return std::nullopt;
    Transcript transcript;
    transcript.board = detail::boardOptions(head[QLatin1String("performer")].toObject());
    const QJsonArray expect = head[QLatin1String("expect")].toArray();
    while (!file.atEnd()) {
        const QJsonObject line = QJsonDocument::fromJson(file.readLine()).object();
        if (line.isEmpty())
            continue;
        const QJsonObject meant = expect[static_cast<qsizetype>(transcript.rows.size())].toObject();
        TranscriptRow row;
        const QString dir = line[QLatin1String("dir")].toString();
        row.from = dir == QLatin1String("C>P") ? TranscriptRow::From::Controller
            : dir == QLatin1String("P>C")      ? TranscriptRow::From::Board
                                               : TranscriptRow::From::Person;
        row.time = fromSeconds(line[QLatin1String("t_ms")].toDouble() / 1000.0);
        const QByteArray bytes =
            QByteArray::fromHex(line[QLatin1String("hex")].toString().toLatin1());
        row.bytes.assign(bytes.begin(), bytes.end());
        row.note = line[QLatin1String("note")].toString();
        row.type = meant[QLatin1String("type")].toString();
        row.partial = meant[QLatin1String("partial")].toBool();
        transcript.rows.push_back(row);
    }
    return transcript;
}

} // namespace support

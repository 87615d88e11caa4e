#include "catalog/catalog.h"
#include "catalog/tables.h"
#include "commands.h"
#include "trace_json.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace cli {

namespace {

constexpr qint64 kLongestLine = 1 << 20;
/// Names and formats are those of this firmware; older ones differ in a few registers only.
constexpr std::uint32_t kNamesOfVersion = 0x060400;

mcp::TraceLookup lookupOf(const catalog::Catalog &catalog)
{
    return [&catalog](mcp::RegisterId id) -> std::optional<mcp::TraceNote> {
        const catalog::RegisterInfo *info = catalog.find(id.bits);
        if (info == nullptr)
            return std::nullopt;
        return mcp::TraceNote{info->name, info->type};
    };
}

mcp::TraceDirection directionOf(const QString &word)
{
    if (word == QLatin1String("C>P"))
        return mcp::TraceDirection::FromController;
    if (word == QLatin1String("P>C"))
        return mcp::TraceDirection::FromPerformer;
    return mcp::TraceDirection::Event;
}

} // namespace

Outcome<int> runDecode(const Arguments &arguments, Output &out)
{
    const QString &path = arguments.words.first();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(kFileError,
            QStringLiteral("%1 cannot be read: %2; check its name.").arg(path, file.errorString()));
    auto table = catalog::readTable(catalog::builtInTable("mcp"), "std", kNamesOfVersion);
    const catalog::Catalog catalog(
        table ? std::move(*table) : std::vector<catalog::RegisterInfo>{}, 1, {});
    mcp::TraceDecoder decoder(lookupOf(catalog));
    qint64 packet = 0;
    for (int number = 1; !file.atEnd(); ++number) {
        const QByteArray text = file.readLine(kLongestLine).trimmed();
        if (text.isEmpty())
            continue;
        const QJsonDocument document = QJsonDocument::fromJson(text);
        const QJsonObject line = document.object();
        if (number == 1 && document.isObject() && !line.contains(QLatin1String("dir")))
            continue; // the header
        if (!line.contains(QLatin1String("dir")))
            return failure(kFileError,
                QStringLiteral("%1, line %2 is no recorded packet; a packet is a JSON object with "
                               "dir, hex and t_ms.")
                    .arg(path, QString::number(number)));
        const QString direction = line.value(QLatin1String("dir")).toString();
        const QByteArray hex =
            QByteArray::fromHex(line.value(QLatin1String("hex")).toString().toLatin1());
        const ByteView bytes(reinterpret_cast<const std::uint8_t *>(hex.constData()),
            static_cast<std::size_t>(hex.size()));
        const double time_ms = line.value(QLatin1String("t_ms")).toDouble();
        out.write(
            traceJson(decoder.next(directionOf(direction), bytes), packet++, time_ms, direction));
    }
    if (packet == 0)
        return failure(kFileError, QStringLiteral("%1 holds no recorded packet.").arg(path));
    return kDone;
}

} // namespace cli

#include "base/text.h"
#include "catalog/catalog.h"
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

constexpr Word<mcp::TraceDirection> kDirections[] = {{"C>P", mcp::TraceDirection::FromController},
    {"P>C", mcp::TraceDirection::FromPerformer}, {"--", mcp::TraceDirection::Event}};

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
        const QString word = line.value(QLatin1String("dir")).toString();
        const auto *direction = findWord(kDirections, word.toStdString());
        const bool event = direction != nullptr && *direction == mcp::TraceDirection::Event;
        const QString hex = line.value(QLatin1String("hex")).toString(QStringLiteral("?"));
        const auto bytes = event ? Bytes() : bytesIn(hex.toStdString());
        if (direction == nullptr || !bytes)
            return failure(kFileError,
                QStringLiteral("%1, line %2 is no recorded packet; a packet is a JSON object with "
                               "dir (C>P, P>C or --), hex and t_ms.")
                    .arg(path, QString::number(number)));
        const double time_ms = line.value(QLatin1String("t_ms")).toDouble();
        out.json(traceJson(decoder.next(*direction, *bytes), packet++, time_ms, word));
    }
    if (packet == 0)
        return failure(kFileError, QStringLiteral("%1 holds no recorded packet.").arg(path));
    return kDone;
}

} // namespace

const Command kDecode{.name = "decode",
    .words = "TRACE.jsonl",
    .help = "Decodes a recorded session and prints one JSON object per packet.",
    .least = 1,
    .most = 1,
    .needsPort = false,
    .runAlone = runDecode};

} // namespace cli

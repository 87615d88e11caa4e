#include "trace_json.h"

#include "session/files/json_text.h"
#include "values.h"

namespace cli {

using namespace mcp;
using session::JsonText;

namespace {

QString text(std::string_view utf8) { return QString::fromUtf8(utf8); }

QString hexOf(ByteView bytes)
{
    return QString::fromLatin1(QByteArray::fromRawData(
        reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()))
                                   .toHex());
}

QString nameOf(const TraceRegister &reg)
{
    return reg.name.empty() ? idText(reg.id.bits) : text(reg.name);
}

qint64 whole(std::uint64_t number) { return static_cast<qint64>(number); }

class ItemWriter {
public:
    explicit ItemWriter(JsonText &json)
        : m_json(json)
    {
    }

    void operator()(const TraceEvent &) { m_json.member("type", "event"); }
    void operator()(const TraceInvalid &item)
    {
        m_json.member("type", "invalid");
        m_json.member("reason", text(item.reason));
    }
    void operator()(const TraceBeacon &item)
    {
        m_json.member("type", "BEACON");
        m_json.member("version", whole(item.version));
        m_json.member("crc", whole(item.crc));
        m_json.member("rxs_max", whole(item.rxsMax));
        m_json.member("txs_max", whole(item.txsMax));
        m_json.member("txa_max", whole(item.txaMax));
    }
    void operator()(const TracePing &item)
    {
        m_json.member("type", "PING");
        m_json.member("c", whole(item.c));
        m_json.member("c2", whole(item.c2));
        m_json.member("n", whole(item.n));
        m_json.member("n2", whole(item.n2));
        m_json.member("liid", whole(item.liid));
        m_json.member("number", whole(item.number));
    }
    void operator()(const TraceError &item)
    {
        m_json.member("type", "ERROR");
        m_json.member("code", whole(item.code));
        m_json.member("code2", whole(item.code2));
    }
    void operator()(const TraceRequest &item);
    void operator()(const TraceResponse &item);
    void operator()(const TraceAsync &item);

private:
    void registers(const std::vector<TraceRegister> &list, const char *idKey, const char *nameKey);
    void values(const char *key, const std::vector<TraceValue> &list);
    void value(const TraceValue &entry);
    void configuration(const DatalogConfig &config);
    void ids(const char *key, const std::vector<RegisterId> &list);

    JsonText &m_json;
};

void ItemWriter::operator()(const TraceRequest &item)
{
    m_json.member("type", "REQUEST");
    m_json.member("length", whole(item.length));
    if (!item.hasCommand)
        return;
    m_json.member("command", whole(item.command));
    m_json.member("command_name", text(item.commandName));
    m_json.member("motor", whole(item.motor));
    if (item.command == static_cast<std::uint16_t>(mcp::CommandId::GetRegister))
        registers(item.registers, "registers", "names");
    if (!item.writes.empty())
        values("writes", item.writes);
    if (item.datalog)
        configuration(*item.datalog);
}

void ItemWriter::operator()(const TraceResponse &item)
{
    m_json.member("type", "RESPONSE");
    m_json.member("length", whole(item.length));
    m_json.member("status", whole(item.status));
    m_json.member("status_name", text(item.statusName));
    m_json.member("data", hexOf(item.data));
    if (item.values)
        values("values", *item.values);
    if (item.registerStatus) {
        m_json.key(QStringLiteral("register_status"));
        m_json.beginArray();
        for (const std::uint8_t status : *item.registerStatus) {
            const std::string_view name = statusName(status);
            if (name.empty())
                m_json.value(whole(status));
            else
                m_json.value(text(name));
        }
        m_json.endArray();
    }
    if (item.version)
        m_json.member("version", whole(*item.version));
}

void ItemWriter::operator()(const TraceAsync &item)
{
    m_json.member("type", "ASYNC");
    m_json.member("length", whole(item.length));
    m_json.member("timestamp", whole(item.timestamp));
    m_json.member("mark", whole(item.mark));
    m_json.member("async_id", whole(item.asyncId));
    m_json.member("decoded", item.decoded);
    if (!item.decoded)
        return;
    m_json.member("partial", item.partial);
    registers(item.fast, "hf_ids", "hf_names");
    m_json.key(QStringLiteral("hf"));
    m_json.beginArray();
    for (const std::vector<std::int32_t> &samples : item.fastSamples) {
        m_json.beginArray();
        for (const std::int32_t sample : samples)
            m_json.value(qint64{sample});
        m_json.endArray();
    }
    m_json.endArray();
    if (!item.slow.empty())
        registers(item.slow, "mf_ids", "mf_names");
    m_json.key(QStringLiteral("mf"));
    m_json.beginArray();
    for (const TraceSlowGroup &group : item.slowGroups) {
        m_json.beginObject();
        m_json.member("block", whole(group.block));
        m_json.key(QStringLiteral("values"));
        m_json.beginArray();
        for (const std::int64_t number : group.values)
            m_json.value(qint64{number});
        m_json.endArray();
        m_json.endObject();
    }
    m_json.endArray();
    m_json.member("hf_blocks", whole(item.fastBlocks));
    if (item.lostTicks)
        m_json.member("lost_ticks", whole(*item.lostTicks));
}

void ItemWriter::registers(
    const std::vector<TraceRegister> &list, const char *idKey, const char *nameKey)
{
    m_json.key(QString::fromLatin1(idKey));
    m_json.beginArray();
    for (const TraceRegister &reg : list)
        m_json.value(idText(reg.id.bits));
    m_json.endArray();
    m_json.key(QString::fromLatin1(nameKey));
    m_json.beginArray();
    for (const TraceRegister &reg : list)
        m_json.value(nameOf(reg));
    m_json.endArray();
}

void ItemWriter::ids(const char *key, const std::vector<RegisterId> &list)
{
    m_json.key(QString::fromLatin1(key));
    m_json.beginArray();
    for (const RegisterId id : list)
        m_json.value(idText(id.bits));
    m_json.endArray();
}

void ItemWriter::configuration(const DatalogConfig &config)
{
    m_json.key(QStringLiteral("datalog"));
    m_json.beginObject();
    m_json.member("buffer_size", whole(config.bufferSize));
    m_json.member("hf_rate", whole(config.fastRate));
    m_json.member("mf_rate", whole(config.slowRate));
    ids("hf_ids", config.fast);
    ids("mf_ids", config.slow);
    m_json.member("mark", whole(config.mark));
    m_json.endObject();
}

void ItemWriter::values(const char *key, const std::vector<TraceValue> &list)
{
    m_json.key(QString::fromLatin1(key));
    m_json.beginArray();
    for (const TraceValue &entry : list)
        value(entry);
    m_json.endArray();
}

void ItemWriter::value(const TraceValue &entry)
{
    m_json.beginObject();
    m_json.member("register", idText(entry.reg.id.bits));
    m_json.member("name", nameOf(entry.reg));
    if (const auto *integer = std::get_if<std::int64_t>(&entry.value))
        m_json.member("value", qint64{*integer});
    else if (const auto *real = std::get_if<double>(&entry.value))
        m_json.member("value", *real);
    else if (const auto *string = std::get_if<std::string>(&entry.value))
        m_json.member("value", text(*string));
    else
        m_json.member("raw", hexOf(std::get<Bytes>(entry.value)));
    if (!entry.fields.empty()) {
        m_json.key(QStringLiteral("fields"));
        m_json.beginObject();
        for (const Field &field : entry.fields) {
            m_json.key(text(field.name));
            if (const auto *integer = std::get_if<std::int64_t>(&field.value))
                m_json.value(qint64{*integer});
            else if (const auto *real = std::get_if<double>(&field.value))
                m_json.value(*real);
            else
                m_json.value(text(std::get<std::string>(field.value)));
        }
        m_json.endObject();
    }
    m_json.endObject();
}

} // namespace

QByteArray traceJson(const TraceItem &item, qint64 packet, double time_ms, const QString &direction)
{
    JsonText json;
    json.beginObject();
    json.member("packet", packet);
    json.member("t_ms", time_ms);
    json.member("dir", direction);
    std::visit(ItemWriter(json), item);
    json.endObject();
    return json.text();
}

} // namespace cli
